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

Verdict look(const MotionFile& original, const MotionFile& decoded, const py::object& by) {
  const SightLimits limits = to_limits(by);
  const py::gil_scoped_release without_gil;
  const Motion& motion = original.motion;
  require_same_shape(motion.clip, decoded.motion.clip);
  Verdict verdict;
  verdict.visibility =
      measure_visibility(motion.skeleton, body_tracks(motion.skeleton, motion.clip),
                         body_tracks(motion.skeleton, decoded.motion.clip),
                         motion.clip.sample_rate_hz, find_foot_contacts(motion), limits);
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
          "distance_m", [](const Verdict& v) { return v.seen.limits.distance_m; },
          "The viewing distance that the verdict is for, in metres.")
      .def_property_readonly(
          "unnoticed_from_m", [](const Verdict& v) { return v.seen.unnoticed_from_m; },
          "The viewing distance in metres from which nothing is noticed.")
      .def_property_readonly(
          "reason", [](const Verdict& v) { return to_str(v.seen.reason); },
          "The most visible error in words, with joint and frame (the first is 1); empty if "
          "nothing differs.")
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
  module.def("visibility", &look, "original"_a, "decoded"_a, py::kw_only(), "limits"_a = py::none(),
             "Judges whether people notice the errors of a decoded motion.\n\n"
             "limits: a dict as settings have it, such as {\"distance_m\": 15}; left out: the "
             "built-in ones, from 5 m. Raises InputError for limits that do not exist, Error if "
             "the motions differ in shape.");
}

}  // namespace mocapress::python
