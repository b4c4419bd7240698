// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "app/cli/commands.h"
#include "app/cli/motion_input.h"
#include "app/cli/report.h"
#include "app/cli/terminal.h"
#include "core/base/file.h"
#include "core/base/number_text.h"
#include "core/base/utf8_path.h"
#include "core/codec/decode/track_decoding.h"
#include "core/codec/format/byte_costs.h"
#include "core/codec/format/container.h"
#include "core/codec/format/source_section.h"
#include "core/codec/methods/compared_file.h"
#include "core/formats/bvh.h"
#include "core/metrics/rate.h"

namespace mocapress::cli {
namespace {

bool is_mcpr(const std::string& path) {
  std::string extension = utf8(utf8_path(path).extension());
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension == ".mcpr";
}

Json name_of(SourceFormat::Kind kind) {
  switch (kind) {
    case SourceFormat::Kind::None:
      break;
    case SourceFormat::Kind::Bvh:
      return "bvh";
    case SourceFormat::Kind::Acclaim:
      return "acclaim";
    case SourceFormat::Kind::Fbx:
      return "fbx";
    case SourceFormat::Kind::Gltf:
      return "gltf";
  }
  return {};
}

/// Format, unit and axes of the source file; null if unknown.
Json describe(const SourceFormat& source) {
  if (source.kind == SourceFormat::Kind::None) return {};
  return {{"format", name_of(source.kind)},
          {"cm_per_unit", source.cm_per_unit},
          {"up", name(source.up)},
          {"bvh_root", source.root ? Json(name(*source.root)) : Json()}};
}

/// Maps the names of joints that BVH has to rename from BVH's name to the original one.
Json describe_bvh_names(const Skeleton& skeleton) {
  const std::vector<std::string> words = bvh_names(skeleton);
  Json renamed = Json::object();
  for (int j = 0; j < skeleton.joint_count(); ++j)
    if (const std::string& word = words[static_cast<std::size_t>(j)];
        word != skeleton.joint(j).name)
      renamed[word] = skeleton.joint(j).name;
  return renamed;
}

/// Lists the tracks by their owners and names.
Json describe_tracks(const ScalarTracks& tracks) {
  Json described = Json::array();
  for (const ScalarTrack& track : tracks)
    described.push_back({{"kind", name(track.kind)},
                         {"node", track.node},
                         {"name", track.name},
                         {"steps", track.steps}});
  return described;
}

Json describe_motion(const std::string& path, const MotionFile& file) {
  Json warnings = Json::array();
  for (const Warning& warning : file.warnings) warnings.push_back(warning.text());
  const Clip& clip = file.motion.clip;
  return {{"input", path},
          {"joints", file.motion.skeleton.joint_count()},
          {"channels", clip.channels.cols()},
          {"frames", clip.frames()},
          {"sample_rate_hz", clip.sample_rate_hz},
          {"seconds", clip.seconds()},
          {"loop", name(find_loop(file.motion))},
          {"raw_bytes", raw_bytes(clip)},
          {"source", describe(file.source)},
          {"tracks", describe_tracks(file.tracks)},
          {"warnings", warnings}};
}

/// Lists the tiers of a file: the bytes up to the end of each, and the error reached with them.
Json describe_tiers(std::span<const std::byte> file) {
  const runtime::TierTable table = sections_of(file).tiers;
  Json described = Json::array();
  for (int t = 0; t < table.count; ++t)
    described.push_back({{"file_bytes", table.file_bytes(t)},
                         {"bands_left_out", table.tier[t].bands_left_out},
                         {"eps_x_cm", table.tier[t].eps_cm},
                         {"max_error_cm", table.tier[t].max_error_cm}});
  return described;
}

/// Divides the bytes of the file by joint, by second and by its other parts.
Json describe_bytes(std::span<const std::byte> file, const CompressedClip& clip) {
  const int second = std::max(1, static_cast<int>(std::lround(clip.sample_rate_hz)));
  const ByteCosts costs = byte_costs(file, second);
  const Eigen::RowVectorXd of_joints = costs.by_joint();
  const Eigen::VectorXd of_seconds = costs.by_slice();
  Json described = {{"frames_per_second", second}};
  described["joints"] = Json::array();
  for (int j = 0; j < clip.skeleton.joint_count(); ++j)
    described["joints"].push_back(
        {{"joint", clip.skeleton.joint(j).name}, {"bytes", of_joints(j)}});
  described["seconds"] = std::vector(of_seconds.begin(), of_seconds.end());
  described["rest"] = Json::array();
  for (const ByteCosts::Part& part : costs.rest)
    described["rest"].push_back({{"part", part.name}, {"bytes", part.bytes}});
  return described;
}

/// Prints the bytes as a table, the joints with the most bytes first.
void print_bytes(const Json& bytes) {
  const auto row = [](const std::string& name, const Json& value) {
    std::printf("    %-24s %10s\n", printable(name).c_str(),
                fixed_text(value.get<double>(), 1).c_str());
  };
  std::vector<std::pair<double, std::string>> joints;
  for (const Json& one : bytes["joints"])
    joints.emplace_back(one["bytes"].get<double>(), one["joint"].get<std::string>());
  std::stable_sort(joints.begin(), joints.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  std::printf("  bytes by joint\n");
  for (const auto& [cost, name] : joints) row(name, cost);
  std::printf("  bytes by second\n");
  for (std::size_t s = 0; s < bytes["seconds"].size(); ++s)
    row(std::to_string(s) + " s", bytes["seconds"][s]);
  std::printf("  bytes of no joint\n");
  for (const Json& one : bytes["rest"]) row(one["part"].get<std::string>(), one["bytes"]);
}

Json describe_compressed(const std::string& path, bool with_bytes) {
  const OpenedMcpr opened = open_mcpr(utf8_path(path));
  const std::vector<std::byte> bytes = read_bytes(utf8_path(path));
  const CompressedClip& clip = opened.compressed;
  const auto of_wavelets = [&](const Json& value) { return opened.of_wavelets ? value : Json(); };
  const int channels = clip.skeleton.channel_count();
  const double raw = 4.0 * clip.frames * channels;
  Json described = {
      {"input", path},
      {"joints", clip.skeleton.joint_count()},
      {"channels", channels},
      {"frames", clip.frames},
      {"sample_rate_hz", clip.sample_rate_hz},
      {"seconds", clip.frames / clip.sample_rate_hz},
      {"loop", name(clip.loop)},
      {"raw_bytes", raw},
      {"motion_bytes", clip.motion_bytes()},
      {"file_bytes", bytes.size()},
      {"ratio", raw / static_cast<double>(std::max<std::size_t>(clip.motion_bytes(), 1))},
      {"method", opened.method},
      {"basis", of_wavelets(name(clip.basis))},
      {"coding", of_wavelets(name(clip.coding))},
      {"segments", of_wavelets(clip.segment_layout().count())},
      {"tiers", describe_tiers(bytes)},
      {"weighting", name(clip.provenance.weighting)},
      {"seed", of_wavelets(clip.provenance.seed)},
      {"eps_x_cm", clip.provenance.eps_cm},
      {"max_error_cm", clip.provenance.max_error_cm},
      {"source", describe(load_source(utf8_path(path)))},
      {"tracks", describe_tracks(tracks_of(bytes))},
      {"track_bytes", track_bytes_of(bytes)},
      {"bvh_names", describe_bvh_names(clip.skeleton)}};
  if (with_bytes) described["bytes"] = describe_bytes(bytes, clip);
  return described;
}

/// Formats a value for people: short numbers, and an object as a list of its known parts.
std::string shown(const Json& value) {
  if (value.is_string()) return value.get<std::string>();
  if (value.is_number_float()) {
    const auto number = value.get<double>();
    return number == std::round(number) ? fixed_text(number, 0) : significant_text(number, 5);
  }
  if (value.is_null()) return "-";
  if (!value.is_object()) return dumped(value);
  std::string parts;
  for (const auto& [key, part] : value.items())
    if (!part.is_null()) parts += (parts.empty() ? "" : ", ") + key + " " + shown(part);
  return parts;
}

void print_lines(const Json& description) {
  std::printf("%s\n", printable(description["input"].get<std::string>()).c_str());
  for (const auto& [key, value] : description.items()) {
    if (key == "input" || key == "warnings" || key == "bvh_names") continue;
    if (key == "bytes") {
      print_bytes(value);
      continue;
    }
    if (key == "tiers") {
      for (const Json& tier : value)
        std::printf("  %-16s %s bytes, eps_x %s cm\n", "tier", shown(tier["file_bytes"]).c_str(),
                    shown(tier["eps_x_cm"]).c_str());
      continue;
    }
    if (key == "tracks") {
      std::printf("  %-16s %zu\n", key.c_str(), value.size());
      continue;
    }
    std::printf("  %-16s %s\n", key.c_str(), printable(shown(value)).c_str());
  }
}

}  // namespace

void add_info(CLI::App& app) {
  struct Info {
    std::vector<std::string> files;
    MotionInput source;
    bool bytes = false;
    bool json = false;
  };
  CLI::App* command = app.add_subcommand("info", "Describe the contents of files");
  const auto call = std::make_shared<Info>();
  command->add_option("files", call->files, ".bvh, .amc, .fbx, .gltf, .glb or .mcpr files")
      ->required()
      ->type_name("FILE...");
  call->source.add_options(*command);
  command->add_flag("--bytes", call->bytes,
                    "Divide the bytes of .mcpr files by joint and by second");
  command->add_flag("--json", call->json, "Print a JSON array, one object a file");
  command->callback([call] {
    Json all = Json::array();
    for (const std::string& path : call->files) {
      if (is_mcpr(path)) {
        all.push_back(describe_compressed(path, call->bytes));
      } else {
        all.push_back(describe_motion(path, call->source.read_file(path)));
      }
      if (!call->json) print_lines(all.back());
    }
    if (call->json) print(all);
  });
}

}  // namespace mocapress::cli
