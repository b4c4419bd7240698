// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/pybind11.h>
#include <memory>

#include "core/mocapress/motion.h"

namespace mocapress::python {

/// Motions never change once they are made, so views of them are safe, also in several threads.
using SharedMotion = std::shared_ptr<const MotionFile>;

/// Adds Motion, Track, read_motion() and write_motion().
void bind_motion(pybind11::module_& module);

/// Adds Visibility and visibility().
void bind_visibility(pybind11::module_& module);

}  // namespace mocapress::python
