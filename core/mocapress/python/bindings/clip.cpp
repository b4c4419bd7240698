// SPDX-License-Identifier: MIT
#include "core/mocapress/python/bindings/clip.h"

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>
#include <algorithm>
#include <cstring>

#include "core/base/file.h"
#include "core/base/utf8_path.h"
#include "core/codec/methods/compared_file.h"
#include "core/mocapress/measure.h"
#include "core/mocapress/python/bindings/instants.h"
#include "core/mocapress/python/bindings/motion.h"
#include "core/mocapress/python/bindings/text.h"
#include "core/report/measurement_json.h"

namespace mocapress::python {

using namespace py::literals;

CodedClip::CodedClip(std::vector<std::byte> file, std::optional<Measurement> measurement)
    : file_(std::move(file)), measurement_(std::move(measurement)) {
  OpenedMcpr opened = read_coded_mcpr(file_);
  skeleton_ = std::move(opened.compressed.skeleton);
  method_ = std::move(opened.method);
  weighting_ = opened.compressed.provenance.weighting;
  frames_ = opened.compressed.frames;
  sample_rate_hz_ = opened.compressed.sample_rate_hz;
}

const Player& CodedClip::player() const {
  std::call_once(opened_, [&] { player_.emplace(file_); });
  return *player_;
}

std::shared_ptr<CodedClip> open_clip(const std::filesystem::path& path) {
  try {
    return std::make_shared<CodedClip>(read_bytes(path));
  } catch (const FormatError& error) {
    throw InputError(utf8(path), 0, 0, error.what());
  }
}

namespace {

std::shared_ptr<CodedClip> from_bytes(const py::buffer& buffer) {
  const py::buffer_info info = buffer.request();
  if (info.ndim != 1 || info.itemsize != 1 || (info.size > 1 && info.strides[0] != 1))
    throw std::invalid_argument("a clip is made of contiguous bytes");
  std::vector<std::byte> file(info.size);
  if (!file.empty()) std::memcpy(file.data(), info.ptr, file.size());
  const py::gil_scoped_release without_gil;
  return std::make_shared<CodedClip>(std::move(file));
}

py::object to_dict(const Measurement& measurement, Weighting weighting) {
  Json json;
  add_measurement(json, measurement, weighting);
  return to_object(json);
}

py::object measured(const CodedClip& clip, const MotionFile& original, const py::object& by) {
  const SightLimits limits = to_limits(by);
  Measurement measurement;
  {
    const py::gil_scoped_release without_gil;
    measurement = measure(original.motion, clip.file(), limits);
  }
  return to_dict(measurement, clip.weighting());
}

AtEnds at_ends(bool loop) {
  return loop ? AtEnds::Loop : AtEnds::Hold;
}

const Player& player_without_gil(const CodedClip& clip) {
  const py::gil_scoped_release without_gil;
  return clip.player();
}

py::array_t<float> sample(const CodedClip& clip, const Doubles& seconds, bool loop) {
  const Player& player = player_without_gil(clip);
  check_wrap(loop, player.is_loop());
  return at_instants(seconds, clip.skeleton().joint_count(), 7, [&](double instant, float* out) {
    const LocalPose pose = player.sample(instant, at_ends(loop));
    std::copy_n(pose.joints.data(), pose.joints.size(), out);
  });
}

py::array_t<float> positions(const CodedClip& clip, const Doubles& seconds, bool loop) {
  const Player& player = player_without_gil(clip);
  check_wrap(loop, player.is_loop());
  return at_instants(seconds, clip.skeleton().joint_count(), 3, [&](double instant, float* out) {
    const Eigen::Matrix3Xf places = player.positions(instant, at_ends(loop));
    std::copy_n(places.data(), places.size(), out);
  });
}

}  // namespace

void bind_clip(py::module_& module) {
  py::class_<CodedClip, std::shared_ptr<CodedClip>>(
      module, "Clip", py::buffer_protocol(),
      "A compressed motion: the bytes of a .mcpr file, which bytes(clip) copies and "
      "memoryview(clip) shows as they lie.")
      .def(py::init(&from_bytes), "data"_a,
           "A clip from the bytes of a .mcpr, which it copies. Raises FormatError.")
      .def_buffer([](const CodedClip& clip) {
        return py::buffer_info(
            const_cast<std::uint8_t*>(reinterpret_cast<const std::uint8_t*>(clip.file().data())),
            static_cast<py::ssize_t>(clip.file().size()), true);
      })
      .def("__bytes__",
           [](const CodedClip& clip) {
             return py::bytes(reinterpret_cast<const char*>(clip.file().data()),
                              clip.file().size());
           })
      .def_property_readonly(
          "nbytes", [](const CodedClip& clip) { return clip.file().size(); }, "Bytes of the file.")
      .def_property_readonly("method", &CodedClip::method,
                             "The name of the method, such as closed-loop.")
      .def_property_readonly("frames", &CodedClip::frames, "The number of frames.")
      .def_property_readonly("rate", &CodedClip::sample_rate_hz, "Frames a second.")
      .def_property_readonly(
          "seconds", [](const CodedClip& clip) { return player_without_gil(clip).seconds(); },
          "The time of one turn of a loop; else from the first frame to the last.")
      .def_property_readonly(
          "is_loop", [](const CodedClip& clip) { return player_without_gil(clip).is_loop(); },
          "True if its last frame goes over into its first.")
      .def_property_readonly(
          "names",
          [](const CodedClip& clip) {
            py::list all;
            for (const Joint& joint : clip.skeleton().joints()) all.append(to_str(joint.name));
            return all;
          },
          "The joints' names; parents come first.")
      .def_property_readonly(
          "measurement",
          [](const CodedClip& clip) -> py::object {
            if (!clip.measurement())
              throw Error("the clip was not encoded here: measure(original) measures it");
            return to_dict(*clip.measurement(), clip.weighting());
          },
          "The measurement that encode() made, with the keys of `mocapress measure --json`. Raises "
          "Error for a clip that was opened: measure(original) measures that.")
      .def(
          "decode",
          [](const CodedClip& clip) {
            return std::make_shared<MotionFile>(decompress(clip.file()));
          },
          py::call_guard<py::gil_scoped_release>(),
          "The whole motion, in the channels of its source.")
      .def("sample", &sample, "seconds"_a, py::kw_only(), "loop"_a = false,
           "Poses at any instants: float32, (joints, 7) for a number, (instants, joints, 7) for a "
           "list. Each joint has its quaternion w x y z and its place x y z, cm, in its parent.\n\n"
           "Before the first frame and after the last a clip stands; with loop it goes round, and "
           "a clip that is no loop raises Error. So do methods for comparison, which no engine "
           "plays: decode() them.")
      .def("positions", &positions, "seconds"_a, py::kw_only(), "loop"_a = false,
           "Places of joints in the world at any instants: float32, (joints, 3) or (instants, "
           "joints, 3), cm.")
      .def(
          "measure", &measured, "original"_a, py::kw_only(), "limits"_a = py::none(),
          "A dict with the keys of `mocapress measure --json`: errors in cm, bytes, ratio, how far "
          "feet slide, and what viewers notice by limits, as visibility() takes them. Raises Error "
          "where the original has another shape.")
      .def(
          "save",
          [](const CodedClip& clip, const std::filesystem::path& path) {
            write_bytes(path, clip.file());
          },
          py::call_guard<py::gil_scoped_release>(), "path"_a,
          "Writes the .mcpr, whole or not at all. Raises WriteError.")
      .def("__repr__", [](const CodedClip& clip) {
        return "<mocapress.Clip: " + std::to_string(clip.file().size()) + " bytes, " +
               std::to_string(clip.frames()) + " frames>";
      });
  module.def("write_bytes", [](const std::filesystem::path& path, const py::bytes& bytes) {
    write_text(path, std::string_view(bytes));
  });
  module.def("open_clip", &open_clip, py::call_guard<py::gil_scoped_release>(), "path"_a);
}

}  // namespace mocapress::python
