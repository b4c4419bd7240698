// SPDX-License-Identifier: MIT
#include "core/mocapress/python/bindings/errors.h"

#include <exception>

#include "core/base/error.h"
#include "core/mocapress/python/bindings/text.h"

namespace mocapress::python {
namespace {

/// The exception types. They live as long as the interpreter.
struct ErrorTypes {
  py::handle error;
  py::handle input;
  py::handle format;
  py::handle write;
  py::handle target_missed;
};

ErrorTypes& types() {
  static ErrorTypes types;
  return types;
}

py::handle add_type(py::module_& module, const char* name, const char* text, py::handle base,
                    const py::dict& attributes = {}) {
  const std::string full = std::string("mocapress.") + name;
  PyObject* const type =
      PyErr_NewExceptionWithDoc(full.c_str(), text, base.ptr(), py::dict(attributes).ptr());
  if (!type) throw py::error_already_set();
  module.add_object(name, type);
  return type;
}

py::object make(py::handle type, const Error& error) {
  return type(to_str(error.what()));
}

void raise(py::handle type, const py::object& exception) {
  PyErr_SetObject(type.ptr(), exception.ptr());
}

void translate(std::exception_ptr thrown) {
  try {
    if (thrown) std::rethrow_exception(thrown);
  } catch (const InputError& error) {
    py::object exception = make(types().input, error);
    exception.attr("line") = error.line();
    exception.attr("column") = error.column();
    raise(types().input, exception);
  } catch (const FormatError& error) {
    py::object exception = make(types().format, error);
    exception.attr("byte_offset") = error.byte_offset();
    raise(types().format, exception);
  } catch (const WriteError& error) {
    raise(types().write, make(types().write, error));
  } catch (const TargetMissed& error) {
    raise(types().target_missed, make(types().target_missed, error));
  } catch (const Error& error) {
    raise(types().error, make(types().error, error));
  }
}

}  // namespace

void bind_errors(py::module_& module) {
  using namespace py::literals;
  ErrorTypes& all = types();
  all.error = add_type(module, "Error",
                       "A failure, in one sentence that can be shown: the base of all others.",
                       PyExc_Exception);
  all.input = add_type(module, "InputError",
                       "A file that cannot be read. line, column: from 1; 0: the file as a whole.",
                       all.error, py::dict("line"_a = 0, "column"_a = 0));
  all.format = add_type(module, "FormatError",
                        "Bytes that are no .mcpr. byte_offset: of the first offending byte.",
                        all.error, py::dict("byte_offset"_a = 0));
  all.write = add_type(module, "WriteError", "A file that cannot be written.", all.error);
  all.target_missed =
      add_type(module, "TargetMissed",
               "A target that nothing meets; the sentence tells the best result.", all.error);
  py::register_exception_translator(&translate);
}

}  // namespace mocapress::python
