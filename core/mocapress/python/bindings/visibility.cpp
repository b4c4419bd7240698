// SPDX-License-Identifier: MIT
#include "core/metrics/comparison.h"
#include "core/mocapress/python/bindings/arrays.h"
#include "core/mocapress/python/bindings/motion.h"
#include "core/mocapress/python/bindings/text.h"
#include "core/motion/body_tracks.h"

namespace mocapress::python {
namespace {

using namespace py::literals;

/// The visibility of a motion's errors, and its worst error in words.
struct Verdict {
  Visibility visibility;
  Seen seen;
};

Verdict look(const MotionFile& original, const MotionFile& decoded) {
  const Motion& motion = original.motion;
  require_same_shape(motion.clip, decoded.motion.clip);
  Verdict verdict;
  verdict.visibility =
      measure_visibility(motion.skeleton, body_tracks(motion.skeleton, motion.clip),
                         body_tracks(motion.skeleton, decoded.motion.clip),
                         motion.clip.sample_rate_hz, find_foot_contacts(motion));
  verdict.seen = seen_in(verdict.visibility, motion.skeleton);
  return verdict;
}

}  // namespace

void bind_visibility(py::module_& module) {
  py::class_<Verdict>(module, "Visibility",
                      "Whether people who watch a decoded motion notice its errors.")
      .def_property_readonly(
          "verdict", [](const Verdict& v) { return name(v.seen.sight()); },
          "not-visible, borderline or visible.")
      .def_property_readonly(
          "times_noticed", [](const Verdict& v) { return v.seen.times_noticed; },
          "The worst error as a multiple of the noticeable threshold.")
      .def_property_readonly(
          "visible_share", [](const Verdict& v) { return v.seen.visible_share; },
          "The share of frames with visible errors, 0 to 1.")
      .def_property_readonly(
          "reason", [](const Verdict& v) { return to_str(v.seen.reason); },
          "The most visible error, with joint and frame; empty if nothing differs.")
      .def_property_readonly(
          "window_frames", [](const Verdict& v) { return v.visibility.table.window_frames; },
          "Frames in each window of the table.")
      .def_property_readonly(
          "table",
          [](const py::object& self) {
            const Eigen::MatrixXf& table =
                self.cast<const Verdict&>().visibility.table.times_noticed;
            return view(table.data(), {table.rows(), table.cols()}, {1, table.rows()}, self);
          },
          "float32, (windows, joints): times noticed. A read-only view, not a copy.");
  module.def("visibility", &look, py::call_guard<py::gil_scoped_release>(), "original"_a,
             "decoded"_a,
             "Judges whether people notice the errors of a decoded motion. Raises Error if the "
             "motions differ in shape.");
}

}  // namespace mocapress::python
