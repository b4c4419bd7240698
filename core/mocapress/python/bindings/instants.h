// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/error.h"
#include "core/mocapress/python/bindings/arrays.h"

namespace mocapress::python {

inline void check_wrap(bool loop, bool clip_is_loop) {
  if (loop && !clip_is_loop) throw Error("the clip is no loop, and stands after its last frame");
}

/// Samples poses at instants. For a number, returns one pose (points, values); for a list,
/// (instants, points, values). Calls sample(instant, out) for each instant, without the
/// interpreter's lock.
template <typename Sample>
py::array_t<float> at_instants(const Doubles& instants, py::ssize_t points, py::ssize_t values,
                               const Sample& sample) {
  if (instants.ndim() > 1) throw std::invalid_argument("instants are not one number or a list");
  std::vector<py::ssize_t> shape = {points, values};
  if (instants.ndim() == 1) shape.insert(shape.begin(), instants.size());
  py::array_t<float> poses(shape);
  float* out = poses.mutable_data();
  const double* const first = instants.data();
  const py::ssize_t count = instants.size();
  {
    const py::gil_scoped_release without_gil;
    for (py::ssize_t i = 0; i < count; ++i, out += points * values) sample(first[i], out);
  }
  return poses;
}

}  // namespace mocapress::python
