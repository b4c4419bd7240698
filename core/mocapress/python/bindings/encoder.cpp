// SPDX-License-Identifier: MIT
#include <exception>

#include "core/mocapress/encode.h"
#include "core/mocapress/python/bindings/clip.h"
#include "core/mocapress/python/bindings/motion.h"
#include "core/mocapress/python/bindings/text.h"

namespace mocapress::python {
namespace {

using namespace py::literals;

/// Reports the progress of an encode to Python, and stops the encode if Python raises an exception,
/// in the callback or by Ctrl-C.
class ProgressCall {
 public:
  explicit ProgressCall(py::object callback) : callback_(std::move(callback)) {}

  bool operator()(const EncodeProgress& progress) {
    const py::gil_scoped_acquire with_gil;
    try {
      if (PyErr_CheckSignals() != 0) throw py::error_already_set();
      if (!callback_.is_none()) callback_(progress);
      return true;
    } catch (...) {
      raised_ = std::current_exception();
      return false;
    }
  }

  void rethrow() const {
    if (raised_) std::rethrow_exception(raised_);
  }

 private:
  py::object callback_;
  std::exception_ptr raised_;
};

std::shared_ptr<CodedClip> encoded(const ClipEncoder& encoder, const std::string& settings_json,
                                   const py::object& callback) {
  const Settings settings = settings_from_json(settings_json);
  ProgressCall progress(callback);
  std::shared_ptr<CodedClip> clip;
  {
    const py::gil_scoped_release without_gil;
    Encoded made =
        encoder.encode(settings, [&](const EncodeProgress& state) { return progress(state); });
    if (made.complete)
      clip = std::make_shared<CodedClip>(std::move(made.file), std::move(made.measurement));
  }
  progress.rethrow();
  return clip;
}

}  // namespace

void bind_encoder(py::module_& module) {
  py::class_<EncodeProgress>(module, "Progress", "The state of an encode that runs.")
      .def_readonly("trial", &EncodeProgress::pass, "From 0: a target takes several trials.")
      .def_readonly("iteration", &EncodeProgress::iteration, "Within this trial.")
      .def_readonly("error_cm", &EncodeProgress::eps_cm,
                    "The error by the encoder's model, in the chosen weighting.")
      .def("__repr__", [](const EncodeProgress& progress) {
        return py::str("<mocapress.Progress: trial {}, iteration {}, {:.3f} cm>")
            .format(progress.pass, progress.iteration, progress.eps_cm);
      });
  py::class_<ClipEncoder>(module, "Encoder")
      .def(py::init([](const MotionFile& motion) {
             // Not a call guard, which would also release the lock while pybind11 registers the new
             // object.
             const py::gil_scoped_release without_lock;
             return std::make_unique<ClipEncoder>(motion);
           }),
           "motion"_a)
      .def("encode", &encoded, "settings_json"_a, "progress"_a = py::none());
  module.def(
      "preset_json",
      [](const std::string& preset) { return to_str(settings_to_json(find_preset(preset))); },
      "preset"_a);
}

}  // namespace mocapress::python
