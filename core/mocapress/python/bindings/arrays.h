// SPDX-License-Identifier: MIT
// NumPy arrays over the library's memory.
#pragma once

#include <pybind11/numpy.h>
#include <Eigen/Core>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace mocapress::python {

namespace py = pybind11;

/// An argument as doubles in C order. NumPy converts other arrays to a copy in this form.
using Doubles = py::array_t<double, py::array::c_style | py::array::forcecast>;

/// A read-only view of memory that `owner` keeps alive. Nothing is copied. `strides` count values,
/// not bytes.
template <typename T>
py::array view(const T* data, const std::vector<py::ssize_t>& shape,
               std::vector<py::ssize_t> strides, py::handle owner) {
  for (py::ssize_t& stride : strides) stride *= static_cast<py::ssize_t>(sizeof(T));
  py::array array(py::dtype::of<T>(), shape, strides, data, owner);
  array.attr("setflags")(py::arg("write") = false);
  return array;
}

/// Turns a matrix of frames x (points * values) into an array of frames x points x values, which
/// takes over its memory. Nothing is copied; the frames of a value stay contiguous in memory.
template <typename Matrix>
py::array take_over(Matrix matrix, py::ssize_t values) {
  using T = typename Matrix::Scalar;
  const auto frames = static_cast<py::ssize_t>(matrix.rows());
  const py::ssize_t points = static_cast<py::ssize_t>(matrix.cols()) / values;
  constexpr auto kSize = static_cast<py::ssize_t>(sizeof(T));
  auto kept = std::make_unique<Matrix>(std::move(matrix));
  const T* const data = kept->data();
  const py::capsule owner(kept.get(), [](void* held) { delete static_cast<Matrix*>(held); });
  kept.release();  // NOLINT(bugprone-unused-return-value): the capsule owns it now
  return py::array(py::dtype::of<T>(), {frames, points, values},
                   {kSize, kSize * values * frames, kSize * frames}, data, owner);
}

}  // namespace mocapress::python
