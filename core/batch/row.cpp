// SPDX-License-Identifier: MIT
#include "core/batch/row.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/fnv1a.h"
#include "core/base/open_file.h"
#include "core/base/utf8_path.h"
#include "core/batch/format_options_json.h"
#include "core/formats/motion_file.h"
#include "core/mocapress/settings_json.h"
#include "core/report/measurement_json.h"
#include "core/report/verdict.h"

namespace mocapress {

namespace {

namespace fs = std::filesystem;

/// All source files of a clip. If there is a character, it comes last.
std::vector<fs::path> files_of(const BatchItem& item, const ReadOptions& reading) {
  std::optional<fs::path> skeleton;
  if (!item.skeleton.empty()) skeleton = utf8_path(item.skeleton);
  return files_of_motion(utf8_path(item.input), skeleton, reading);
}

void add_file(Fnv1a& hash, const fs::path& file) {
  const FileDescriptor opened = open_to_read(file);
  std::string buffer(1 << 16, '\0');
  for (std::uint64_t at = 0; !buffer.empty(); at += buffer.size()) {
    if (!read_all(opened.number(), at, buffer))
      throw InputError(utf8(file), 0, 0, std::string("cannot be read: ") + std::strerror(errno));
    hash.add(buffer);
  }
}

/// Makes a stamp without hashes, which needs no reading.
InputStamp quick_stamp(const std::vector<fs::path>& files) {
  InputStamp quick;
  for (const fs::path& file : files) {
    const std::optional<FileStatus> found = status_of(file);
    if (!found) throw InputError(utf8(file), 0, 0, std::strerror(errno));
    quick.bytes += found->size;
    quick.newest_ns = std::max(quick.newest_ns, found->written_ns);
  }
  return quick;
}

std::string hash_of_all(const std::vector<fs::path>& files) {
  Fnv1a hash;
  for (const fs::path& file : files) add_file(hash, file);
  return hash.text();
}

/// Adds the hashes to a stamp; reads each file once.
void add_hashes(InputStamp& stamp, const std::vector<fs::path>& files, const ReadOptions& reading) {
  Fnv1a hash;
  for (const fs::path& file : files) {
    if (reading.character && &file == &files.back()) stamp.source = hash.text();
    add_file(hash, file);
  }
  stamp.hash = hash.text();
  if (!reading.character) stamp.source = stamp.hash;
}

}  // namespace

InputStamp stamp(const BatchItem& item, const ReadOptions& reading) {
  const std::vector<fs::path> files = files_of(item, reading);
  InputStamp whole = quick_stamp(files);
  add_hashes(whole, files, reading);
  return whole;
}

InputStamp stamp_again(const BatchItem& item, const ReadOptions& reading,
                       const InputStamp& earlier) {
  const std::vector<fs::path> files = files_of(item, reading);
  InputStamp now = quick_stamp(files);
  if (now.bytes == earlier.bytes && now.newest_ns == earlier.newest_ns && !earlier.hash.empty())
    return earlier;
  add_hashes(now, files, reading);
  return now;
}

bool unchanged(const BatchItem& item, const ReadOptions& reading, const InputStamp& stamp) {
  try {
    const std::vector<fs::path> files = files_of(item, reading);
    const InputStamp quick = quick_stamp(files);
    if (quick.bytes != stamp.bytes) return false;
    return quick.newest_ns == stamp.newest_ns || hash_of_all(files) == stamp.hash;
  } catch (const InputError&) {
    return false;
  }
}

std::string hash_of(const fs::path& file) {
  return hash_of_all({file});
}

std::optional<std::string> stale_reason(const BatchRow& row) {
  if (row.stamp.source.empty()) return std::nullopt;
  return stale_reason(row.review, row.stamp.source, settings_hash(row.preset, row.reading));
}

std::optional<std::string> stale_reason(const BatchRow& row, const FrameNote& note) {
  if (row.stamp.source.empty()) return std::nullopt;
  return stale_reason(note, row.stamp.source, settings_hash(row.preset, row.reading));
}

std::string settings_hash(const Settings& settings, const ReadOptions& reading) {
  Json json = to_json(settings);
  json.erase("name");
  if (settings.target.kind != Target::Kind::Visibility) json.erase("limits");
  put(json["reading"] = Json::object(), reading);
  json["reading"].erase("character");
  Fnv1a hash;
  hash.add(dumped(json));
  return hash.text();
}

namespace {

constexpr double kUnit = 100;  // units per cm in stored poses

double bits_per_joint_sample(const BatchRow& row) {
  if (!row.measured) return 0;
  const double joint_samples =
      std::max(1.0, static_cast<double>(row.measured->frames) * row.joints);
  return 8.0 * static_cast<double>(row.measured->motion_bytes) / joint_samples;
}

Json report_json(const BatchRow& row, const ReportStamp& stamp = {}) {
  Json json = {{"input", row.input},
               {"output", row.output},
               {"done", row.done()},
               {"preset", row.preset.name}};
  json.update(row_json(row.preset));
  add_measurement(json, row.measured, row.preset.weighting);
  const auto add = [&](const char* key, Json value) {
    json[key] = row.measured ? std::move(value) : Json();
  };
  add("joints", row.joints);
  add("bits_per_joint_sample", bits_per_joint_sample(row));
  add("worst_point", row.worst ? Json(row.worst->landmark) : Json());
  add("ik_ratio_used", row.measured ? or_null(row.measured->ik_ratio_used) : Json());
  add("verified_by", row.verified_by);
  json["files"] = Json::array();
  for (const WrittenFile& file : row.files) json["files"].push_back(file.name);
  json["warnings"] = row.warnings;
  put(json, row.review);
  for (std::size_t i = 0; i < row.review.notes.size(); ++i)
    json["notes"][i]["stale"] = or_null(stale_reason(row, row.review.notes[i]));
  json["stale"] = or_null(stale_reason(row));
  json["error"] = text_or_null(row.error);
  json["program"] = text_or_null(stamp.program);
  json["reported"] = text_or_null(stamp.time);
  return json;
}

Json points_json(const PosePoints& points) {
  Json numbers = Json::array();
  for (const Eigen::Vector3d& point : points)
    for (const double cm : point) numbers.push_back(std::llround(kUnit * cm));
  return numbers;
}

PosePoints points_from(const Json& numbers) {
  PosePoints points;
  for (std::size_t i = 0; i + 2 < numbers.size(); i += 3)
    points.emplace_back(numbers.at(i).get<double>() / kUnit,
                        numbers.at(i + 1).get<double>() / kUnit,
                        numbers.at(i + 2).get<double>() / kUnit);
  return points;
}

Json to_json(const WorstPose& pose) {
  Json bones = Json::array();
  for (const DrawnBone& bone : pose.bones)
    bones.push_back({bone.from, bone.to, std::llround(kUnit * bone.from_radius),
                     std::llround(kUnit * bone.to_radius)});
  return {{"frame", pose.frame},
          {"landmark", pose.landmark},
          {"point", pose.point},
          {"off_cm", pose.off_cm},
          {"ground_cm", pose.ground_cm},
          {"facing", {pose.facing.x(), pose.facing.y(), pose.facing.z()}},
          {"bones", bones},
          {"original", points_json(pose.original)},
          {"decoded", points_json(pose.decoded)}};
}

/// Throws Error if an index is outside its array: somebody may have edited the journal.
void check(const WorstPose& pose) {
  const auto points = static_cast<int>(pose.original.size());
  const auto is_point = [&](int index) { return index >= 0 && index < points; };
  bool whole = is_point(pose.point) && pose.decoded.size() == pose.original.size();
  for (const DrawnBone& bone : pose.bones)
    whole = whole && is_point(bone.from) && is_point(bone.to);
  if (!whole) throw Error("not a pose");
}

WorstPose pose_from(const Json& json) {
  WorstPose pose;
  json.at("frame").get_to(pose.frame);
  json.at("landmark").get_to(pose.landmark);
  json.at("point").get_to(pose.point);
  json.at("off_cm").get_to(pose.off_cm);
  json.at("ground_cm").get_to(pose.ground_cm);
  for (int axis = 0; axis < 3; ++axis) pose.facing[axis] = json.at("facing").at(axis).get<double>();
  for (const Json& bone : json.at("bones"))
    pose.bones.push_back({bone.at(0).get<int>(), bone.at(1).get<int>(),
                          bone.at(2).get<double>() / kUnit, bone.at(3).get<double>() / kUnit});
  pose.original = points_from(json.at("original"));
  pose.decoded = points_from(json.at("decoded"));
  check(pose);
  return pose;
}

BatchRow row_from(const Json& json) {
  BatchRow row;
  json.at("index").get_to(row.index);
  json.at("input").get_to(row.input);
  json.at("output").get_to(row.output);
  row.preset = preset_from(json.at("settings"));
  for (const Json& format : json.at("formats"))
    if (const auto known = output_format(format.get_ref<const std::string&>()))
      row.formats.push_back(*known);
  row.reading = format_options(json.at("reading"));
  row.writing = format_options(json.at("writing"));
  json.at("stamp").at("bytes").get_to(row.stamp.bytes);
  json.at("stamp").at("newest_ns").get_to(row.stamp.newest_ns);
  json.at("stamp").at("hash").get_to(row.stamp.hash);
  json.at("stamp").at("source").get_to(row.stamp.source);
  if (!json.at("frames").is_null()) {
    row.measured = measurement_of(json);
    row.measured->ik_ratio_used = optional_at<double>(json, "ik_ratio_used");
    json.at("joints").get_to(row.joints);
    json.at("verified_by").get_to(row.verified_by);
  }
  for (const Json& file : json.at("written"))
    row.files.push_back({file.at("name").get<std::string>(), file.at("bytes").get<std::uintmax_t>(),
                         file.at("hash").get<std::string>()});
  json.at("warnings").get_to(row.warnings);
  row.review = review_from(json);
  row.error = optional_at<std::string>(json, "error").value_or("");
  for (const Json& line : json.at("sights"))
    row.sights.push_back({line.at(0).get<std::string>(), line.at(1).get<std::string>()});
  if (!json.at("worst").is_null()) row.worst = pose_from(json.at("worst"));
  return row;
}

std::string csv_text(const Json& value) {
  if (value.is_null()) return "";
  if (value.is_string()) return value.get<std::string>();
  if (!value.is_array()) return dumped(value);
  std::string all;
  if (!value.empty() && value.front().is_object()) {
    const std::vector<FrameNote> notes = frame_notes_from(value);
    for (std::size_t i = 0; i < notes.size(); ++i)
      all += (all.empty() ? "" : "; ") +
             note_text(notes[i], optional_at<std::string>(value[i], "stale"));
    return all;
  }
  for (const Json& one : value) all += (all.empty() ? "" : "; ") + one.get<std::string>();
  return all;
}

}  // namespace

bool keeps_promise(const Settings& preset, const Measurement& measured) {
  return reached(preset.target, measured.quantity(preset.target.kind, preset.weighting));
}

std::string to_report_line(const BatchRow& row, const ReportStamp& stamp) {
  return dumped(report_json(row, stamp));
}

std::string to_journal_line(const BatchRow& row) {
  Json json = report_json(row);
  json["index"] = row.index;
  json["settings"] = to_json(row.preset);
  json["formats"] = Json::array();
  for (const OutputFormat format : row.formats) json["formats"].push_back(name(format));
  put(json["reading"] = Json::object(), row.reading);
  put(json["writing"] = Json::object(), row.writing);
  json["stamp"] = {{"bytes", row.stamp.bytes},
                   {"newest_ns", row.stamp.newest_ns},
                   {"hash", row.stamp.hash},
                   {"source", row.stamp.source}};
  json["written"] = Json::array();
  for (const WrittenFile& file : row.files)
    json["written"].push_back({{"name", file.name}, {"bytes", file.bytes}, {"hash", file.hash}});
  json["encode_seconds"] = row.measured ? Json(row.measured->encode_seconds) : Json();
  json["worst"] = row.worst ? to_json(*row.worst) : Json();
  json["sights"] = Json::array();
  for (const SightLine& line : row.sights) json["sights"].push_back({line.joint, line.sights});
  return dumped(json);
}

std::optional<BatchRow> parse_batch_row(std::string_view line) {
  try {
    return row_from(parse_json("", line));
  } catch (const Json::exception&) {
    return std::nullopt;
  } catch (const Error&) {
    return std::nullopt;
  }
}

std::string csv_head() {
  const Json json = report_json({});
  std::string text;
  for (const auto& [key, value] : json.items()) text += (text.empty() ? "" : ",") + key;
  return text + '\n';
}

std::string to_csv_line(const BatchRow& row, const ReportStamp& stamp) {
  const Json json = report_json(row, stamp);
  std::string text;
  for (const auto& [key, value] : json.items())
    text += (key == "input" ? "" : ",") + csv_quoted(csv_text(value));
  return text + '\n';
}

}  // namespace mocapress
