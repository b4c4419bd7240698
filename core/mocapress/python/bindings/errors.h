// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/pybind11.h>

namespace mocapress::python {

/// Adds the exceptions Error, InputError, FormatError, WriteError and TargetMissed. Every failure
/// of the library is raised as one of them, with its message.
void bind_errors(pybind11::module_& module);

}  // namespace mocapress::python
