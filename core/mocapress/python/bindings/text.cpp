// SPDX-License-Identifier: MIT
#include "core/mocapress/python/bindings/text.h"

#include "core/metrics/sight_limits_json.h"

namespace mocapress::python {

py::str to_str(std::string_view text) {
  PyObject* const decoded =
      PyUnicode_DecodeUTF8(text.data(), static_cast<Py_ssize_t>(text.size()), "surrogateescape");
  if (!decoded) throw py::error_already_set();
  return py::reinterpret_steal<py::str>(decoded);
}

std::string from_str(py::handle text) {
  if (!PyUnicode_Check(text.ptr())) throw py::type_error("a name is not a str");
  const auto encoded = py::reinterpret_steal<py::bytes>(
      PyUnicode_AsEncodedString(text.ptr(), "utf-8", "surrogateescape"));
  if (!encoded) throw py::error_already_set();
  return encoded;
}

py::object to_object(const Json& json) {
  return py::module_::import("json").attr("loads")(to_str(dumped(json)));
}

SightLimits to_limits(const py::object& limits) {
  if (limits.is_none()) return {};
  return limits_from_text("limits", from_str(py::module_::import("json").attr("dumps")(limits)));
}

}  // namespace mocapress::python
