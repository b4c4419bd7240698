// SPDX-License-Identifier: MIT
// Text between Python and the library. Names of joints and files may hold bytes that are not UTF-8:
// these become lone surrogates, as in Python's own names of files, and come back as they were.
#pragma once

#include <pybind11/pybind11.h>
#include <string>
#include <string_view>

#include "core/base/json_text.h"
#include "core/metrics/sight_limits.h"

namespace mocapress::python {

namespace py = pybind11;

py::str to_str(std::string_view text);

/// The inverse. Throws py::type_error for what is no text.
std::string from_str(py::handle text);

/// A JSON value as Python has it: dict, list, str, float, int, bool, None.
py::object to_object(const Json& json);

/// Limits of visibility from a dict, as settings have them; the built-in ones from None. Throws
/// InputError.
SightLimits to_limits(const py::object& limits);

}  // namespace mocapress::python
