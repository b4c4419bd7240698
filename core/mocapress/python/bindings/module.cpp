// SPDX-License-Identifier: MIT
#include "core/mocapress/python/bindings/clip.h"
#include "core/mocapress/python/bindings/errors.h"
#include "core/mocapress/python/bindings/motion.h"

PYBIND11_MODULE(_core, module) {
  module.doc() = "The library of Mocapress; the package mocapress is its face.";
  module.attr("__version__") = MOCAPRESS_VERSION;
  mocapress::python::bind_errors(module);
  mocapress::python::bind_motion(module);
  mocapress::python::bind_visibility(module);
  mocapress::python::bind_clip(module);
  mocapress::python::bind_encoder(module);
  mocapress::python::bind_bank(module);
}
