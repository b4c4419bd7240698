// SPDX-License-Identifier: MIT
#include "core/mocapress/python/bindings/motion.h"

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>
#include <array>
#include <filesystem>
#include <stdexcept>

#include "core/base/utf8_path.h"
#include "core/formats/bvh.h"
#include "core/mocapress/python/bindings/arrays.h"
#include "core/mocapress/python/bindings/local_transforms.h"
#include "core/mocapress/python/bindings/text.h"

namespace mocapress::python {
namespace {

using namespace py::literals;
using Path = std::filesystem::path;
using WithoutGil = py::call_guard<py::gil_scoped_release>;

// Not const, since pybind11 requires that; no function in the bindings changes a motion.
using HeldMotion = std::shared_ptr<MotionFile>;

py::list names(const Skeleton& skeleton) {
  py::list all;
  for (const Joint& joint : skeleton.joints()) all.append(to_str(joint.name));
  return all;
}

py::list names_in_bvh(const Skeleton& skeleton) {
  py::list all;
  for (const std::string& word : bvh_names(skeleton)) all.append(to_str(word));
  return all;
}

py::array_t<std::int32_t> parents(const Skeleton& skeleton) {
  py::array_t<std::int32_t> all(skeleton.joint_count());
  for (int j = 0; j < skeleton.joint_count(); ++j) all.mutable_at(j) = skeleton.joint(j).parent;
  return all;
}

py::array_t<double> offsets(const Skeleton& skeleton) {
  py::array_t<double> all({py::ssize_t{skeleton.joint_count()}, py::ssize_t{3}});
  for (int j = 0; j < skeleton.joint_count(); ++j)
    for (int axis = 0; axis < 3; ++axis) all.mutable_at(j, axis) = skeleton.joint(j).offset(axis);
  return all;
}

py::dict end_sites(const Skeleton& skeleton) {
  py::dict all;
  for (int j = 0; j < skeleton.joint_count(); ++j)
    if (const auto& site = skeleton.joint(j).end_site)
      all[py::int_(j)] = py::make_tuple(site->x(), site->y(), site->z());
  return all;
}

py::list channel_names(const Skeleton& skeleton) {
  py::list all;
  for (int c = 0; c < skeleton.channel_count(); ++c) all.append(to_str(skeleton.channel_name(c)));
  return all;
}

py::list warning_texts(const Warnings& warnings) {
  py::list all;
  for (const Warning& warning : warnings)
    all.append(to_str(warning.file.empty() ? warning.message : warning.text()));
  return all;
}

py::list contacts(const Motion& motion) {
  std::vector<ContactSpan> spans;
  {
    const py::gil_scoped_release without_gil;
    spans = find_foot_contacts(motion);
  }
  const std::vector<Landmark> points = landmarks(motion.skeleton);
  py::list all;
  for (const ContactSpan& span : spans)
    all.append(py::dict("joint"_a = to_str(points[span.landmark].name),
                        "first_frame"_a = span.first_frame, "last_frame"_a = span.last_frame));
  return all;
}

template <typename Value>
std::optional<Value> choice(const std::optional<std::string>& word,
                            std::initializer_list<Value> all, const std::string& argument) {
  if (!word) return std::nullopt;
  std::string known;
  for (const Value value : all) {
    if (name(value) == *word) return value;
    known += (known.empty() ? "" : ", ") + std::string(name(value));
  }
  throw std::invalid_argument(argument + " is none of " + known + ": " + *word);
}

ReadOptions read_options(const std::optional<double>& rate,
                         const std::optional<double>& cm_per_unit,
                         const std::optional<std::string>& up,
                         const std::optional<std::string>& bvh_root) {
  ReadOptions options{.sample_rate_hz = rate, .cm_per_unit = cm_per_unit};
  options.up = choice(up, {UpAxis::Y, UpAxis::Z}, "up");
  options.bvh_root =
      choice(bvh_root, {TranslationConvention::Adds, TranslationConvention::Replaces}, "bvh_root");
  return options;
}

HeldMotion read(const Path& path, const std::optional<Path>& skeleton,
                const std::optional<double>& rate, const std::optional<double>& cm_per_unit,
                const std::optional<std::string>& up, const std::optional<std::string>& bvh_root,
                const std::optional<std::string>& take, const std::optional<Path>& character,
                const std::optional<Path>& tracks) {
  ReadOptions options = read_options(rate, cm_per_unit, up, bvh_root);
  options.take = take;
  if (character) options.character = utf8(*character);
  if (tracks) options.tracks = utf8(*tracks);
  return std::make_shared<MotionFile>(read_motion(path, skeleton, options));
}

py::list write(const MotionFile& motion, const Path& path, const std::optional<Path>& skeleton,
               const std::optional<double>& rate, const std::optional<double>& cm_per_unit,
               const std::optional<std::string>& up, const std::optional<std::string>& bvh_root) {
  const WriteOptions options = read_options(rate, cm_per_unit, up, bvh_root);
  Warnings warnings;
  {
    const py::gil_scoped_release without_gil;
    warnings = write_motion(path, motion.motion, skeleton, motion.source, options, motion.tracks);
  }
  return warning_texts(warnings);
}

/// An array as a matrix: the first dimension gives the rows, all others together the columns.
Eigen::Map<const RowMajor> rows(const Doubles& array) {
  const py::ssize_t count = array.shape(0);
  return {array.data(), count, count > 0 ? array.size() / count : 0};
}

HeldMotion from_numpy(const py::sequence& joint_names, const std::vector<int>& joint_parents,
                      const Doubles& joint_offsets, const Doubles& rotations,
                      const std::optional<Doubles>& translations, double rate,
                      const std::map<int, std::array<double, 3>>& sites,
                      const std::vector<std::string>& warnings) {
  const auto joints = static_cast<py::ssize_t>(joint_parents.size());
  if (joint_offsets.ndim() != 2) throw std::invalid_argument("offsets are not joints x 3");
  if (rotations.ndim() != 3 || rotations.shape(1) != joints || rotations.shape(2) != 4)
    throw std::invalid_argument("rotations are not frames x joints x 4");
  const bool of_root = translations && translations->ndim() == 2 && translations->shape(1) == 3;
  const bool of_all = translations && translations->ndim() == 3 &&
                      translations->shape(1) == joints && translations->shape(2) == 3;
  if (translations && !of_root && !of_all)
    throw std::invalid_argument("translations are neither frames x 3 nor frames x joints x 3");
  const Doubles none(std::vector<py::ssize_t>{0, 0});
  LocalTransforms given{.names = {},
                        .parents = joint_parents,
                        .offsets = rows(joint_offsets),
                        .rotations = rows(rotations),
                        .translations = rows(translations.value_or(none)),
                        .end_sites = {},
                        .sample_rate_hz = rate};
  for (const py::handle joint : joint_names) given.names.push_back(from_str(joint));
  for (const auto& [joint, site] : sites)
    given.end_sites.emplace(joint, Eigen::Vector3d(site[0], site[1], site[2]));
  const py::gil_scoped_release without_gil;
  auto made = std::make_shared<MotionFile>(MotionFile{.motion = motion_of(given)});
  for (const std::string& warning : warnings) made->warnings.push_back({"", 0, warning});
  return made;
}

/// Channels in the library's memory order, with the frames of a channel contiguous. A view of
/// another motion's channels has that order and needs no conversion.
using TimeContiguous = py::array_t<double, py::array::f_style | py::array::forcecast>;

HeldMotion with_channels(const MotionFile& motion, const TimeContiguous& channels,
                         const std::optional<double>& rate) {
  const Skeleton& skeleton = motion.motion.skeleton;
  if (channels.ndim() != 2 || channels.shape(1) != skeleton.channel_count() ||
      channels.shape(0) == 0)
    throw std::invalid_argument("channels are not frames x " +
                                std::to_string(skeleton.channel_count()));
  if (!motion.tracks.empty() && channels.shape(0) != motion.motion.clip.frames())
    throw std::invalid_argument("the motion has tracks of another number of frames");
  const Eigen::Map<const Eigen::MatrixXd> given(channels.data(), channels.shape(0),
                                                channels.shape(1));
  if (!given.allFinite()) throw std::invalid_argument("a value is not finite");
  const double own_rate = rate.value_or(motion.motion.clip.sample_rate_hz);
  if (!std::isfinite(own_rate) || own_rate <= 0)
    throw std::invalid_argument("the rate is not above 0");
  const py::gil_scoped_release without_gil;
  return std::make_shared<MotionFile>(MotionFile{.motion = {skeleton, {own_rate, given}},
                                                 .warnings = {},
                                                 .source = motion.source,
                                                 .skin = motion.skin,
                                                 .tracks = motion.tracks});
}

py::list track_list(const py::object& self) {
  py::list all;
  for (const ScalarTrack& track : self.cast<const MotionFile&>().tracks)
    all.append(py::cast(&track, py::return_value_policy::reference_internal, self));
  return all;
}

void bind_track(py::module_& module) {
  py::class_<ScalarTrack>(module, "Track",
                          "A number over time beside the joints: a morph weight, a property or a "
                          "scale. Without a unit.")
      .def_property_readonly(
          "kind", [](const ScalarTrack& track) { return name(track.kind); },
          "property, morph-weight, scale-x, scale-y or scale-z.")
      .def_property_readonly(
          "label", [](const ScalarTrack& t) { return to_str(label(t)); },
          "Node and name: Face.smile.")
      .def_property_readonly(
          "node", [](const ScalarTrack& t) { return to_str(t.node); },
          "The node or joint that has it.")
      .def_property_readonly(
          "name", [](const ScalarTrack& t) { return to_str(t.name); }, "Its name in the node.")
      .def_readonly("steps", &ScalarTrack::steps,
                    "True: values hold until the next frame; else they are linear in between.")
      .def_property_readonly(
          "values",
          [](const py::object& self) {
            const auto& values = self.cast<const ScalarTrack&>().values;
            return view(values.data(), {std::ssize(values)}, {1}, self);
          },
          "float32, (frames,): a read-only view, not a copy.");
}

}  // namespace

void bind_motion(py::module_& module) {
  bind_track(module);
  const auto skeleton = [](auto get) {
    return [get](const MotionFile& motion) { return get(motion.motion.skeleton); };
  };
  py::class_<MotionFile, HeldMotion>(
      module, "Motion",
      "A skeleton and its motion: centimetres, radians, seconds; right-handed, y up.\n\n"
      "It never changes: arrays of it are read-only. Make another by from_numpy() or "
      "with_channels().")
      .def_static("from_numpy", &from_numpy, "names"_a, "parents"_a, "offsets"_a, "rotations"_a,
                  "translations"_a = py::none(), py::kw_only(), "rate"_a,
                  "end_sites"_a = py::dict(), "warnings"_a = py::list(),
                  "A motion from local transforms, which it copies.\n\n"
                  "names: one for each joint. parents: the index of each joint's parent, which "
                  "comes before it; -1: a root.\n"
                  "offsets: (joints, 3), cm, each joint's place in its parent.\n"
                  "rotations: (frames, joints, 4), quaternions w x y z from a joint's frame to its "
                  "parent's, of any length but 0.\n"
                  "translations: (frames, 3), cm, where joint 0 is; or (frames, joints, 3), where "
                  "each joint is in its parent; one whose places differ by at most 1e-4 cm stands "
                  "still. Left out: at the offsets.\n"
                  "rate: frames a second. end_sites: {joint: (x, y, z)}, cm, the tips of bones "
                  "without children.\n\n"
                  "Arrays of another type or order than float64, C are copied twice. Raises "
                  "ValueError.")
      .def("with_channels", &with_channels, "channels"_a, py::kw_only(), "rate"_a = py::none(),
           "The same skeleton in another motion. channels: (frames, channels), cm and radians; it "
           "is copied. Raises ValueError.")
      .def_property_readonly(
          "channels",
          [](const py::object& self) {
            const Eigen::MatrixXd& channels = self.cast<const MotionFile&>().motion.clip.channels;
            return view(channels.data(), {channels.rows(), channels.cols()}, {1, channels.rows()},
                        self);
          },
          "float64, (frames, channels), cm and radians: a read-only view, not a copy. Time is "
          "contiguous (Fortran order).")
      .def_property_readonly("channel_names", skeleton(channel_names),
                             "Hips.tx ... Head.rz: joint and kind of each channel.")
      .def_property_readonly("names", skeleton(names), "The joints' names; parents come first.")
      .def_property_readonly("bvh_names", skeleton(names_in_bvh),
                             "The joints' names as write() has them in a BVH: one word each, no "
                             "two alike.")
      .def_property_readonly("parents", skeleton(parents),
                             "int32, (joints,): the index of each joint's parent; -1: a root.")
      .def_property_readonly("offsets", skeleton(offsets),
                             "float64, (joints, 3), cm: each joint in its parent at rest. A copy.")
      .def_property_readonly("end_sites", skeleton(end_sites),
                             "{joint: (x, y, z)}, cm: the tips of bones without children.")
      .def_property_readonly(
          "rate", [](const MotionFile& m) { return m.motion.clip.sample_rate_hz; },
          "Frames a second.")
      .def_property_readonly(
          "frames", [](const MotionFile& m) { return m.motion.clip.frames(); },
          "The number of frames.")
      .def_property_readonly(
          "seconds", [](const MotionFile& m) { return m.motion.clip.seconds(); },
          "Frames by rate: the last frame lasts as long as the others.")
      .def_property_readonly(
          "warnings", [](const MotionFile& m) { return warning_texts(m.warnings); },
          "Sentences: what was repaired or guessed when it was read.")
      .def_property_readonly("tracks", &track_list,
                             "Morph weights, properties and scales beside the joints.")
      .def(
          "local_rotations",
          [](const MotionFile& motion) {
            Eigen::MatrixXd rotations;
            {
              const py::gil_scoped_release without_gil;
              rotations = local_rotations(motion.motion);
            }
            return take_over(std::move(rotations), 4);
          },
          "float64, (frames, joints, 4): unit quaternions w x y z from each joint's frame to its "
          "parent's, without jumps of sign. Computed at each call; time is contiguous.")
      .def(
          "local_translations",
          [](const MotionFile& motion) {
            Eigen::MatrixXd translations;
            {
              const py::gil_scoped_release without_gil;
              translations = local_translations(motion.motion);
            }
            return take_over(std::move(translations), 3);
          },
          "float64, (frames, joints, 3), cm: where each joint is in its parent's frame. Computed "
          "at each call; time is contiguous.")
      .def(
          "world_positions",
          [](const MotionFile& motion) {
            const Skeleton& joints = motion.motion.skeleton;
            Eigen::MatrixXd places;
            {
              const py::gil_scoped_release without_gil;
              places = point_tracks(joints, joint_origins(joints), motion.motion.clip);
            }
            return take_over(std::move(places), 3);
          },
          "float64, (frames, joints, 3), cm: where each joint is in the world. Computed at each "
          "call; time is contiguous.")
      .def(
          "contacts", [](const MotionFile& motion) { return contacts(motion.motion); },
          "Spans in which a foot stands: dicts of joint, first_frame and last_frame (included), as "
          "encode() "
          "takes them for contacts.")
      .def("__repr__", [](const MotionFile& m) {
        return "<mocapress.Motion: " + std::to_string(m.motion.skeleton.joint_count()) +
               " joints, " + std::to_string(m.motion.clip.frames()) + " frames>";
      });
  module.def("read_motion", &read, WithoutGil(), "path"_a, py::kw_only(), "skeleton"_a = py::none(),
             "rate"_a = py::none(), "cm_per_unit"_a = py::none(), "up"_a = py::none(),
             "bvh_root"_a = py::none(), "take"_a = py::none(), "character"_a = py::none(),
             "tracks"_a = py::none());
  module.def("write_motion", &write, "motion"_a, "path"_a, py::kw_only(), "skeleton"_a = py::none(),
             "rate"_a = py::none(), "cm_per_unit"_a = py::none(), "up"_a = py::none(),
             "bvh_root"_a = py::none());
}

}  // namespace mocapress::python
