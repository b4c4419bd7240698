// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/pybind11.h>

namespace mocapress::python {

/// Adds the exceptions Error, InputError, FormatError, WriteError and TargetMissed, and has every
/// failure of the library raised as one of them, with its sentence.
void bind_errors(pybind11::module_& module);

}  // namespace mocapress::python
