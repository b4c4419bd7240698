// SPDX-License-Identifier: MIT
// Converts text between Python and the library. Names of joints and files may have bytes that are
// not UTF-8. They become lone surrogates, as in Python's own file names, and are converted back to
// the same bytes.
#pragma once

#include <pybind11/pybind11.h>
#include <string>
#include <string_view>

#include "core/base/json_text.h"
#include "core/metrics/sight_limits.h"

namespace mocapress::python {

namespace py = pybind11;

py::str to_str(std::string_view text);

/// Converts what to_str() made back. Throws py::type_error for an object that is not text.
std::string from_str(py::handle text);

/// Converts JSON to Python: dict, list, str, float, int, bool, None.
py::object to_object(const Json& json);

/// Reads limits of visibility from a dict, in the form that settings have. None gives the built-in
/// limits. Throws InputError.
SightLimits to_limits(const py::object& limits);

}  // namespace mocapress::python
