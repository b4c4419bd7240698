// SPDX-License-Identifier: MIT
#include <algorithm>
#include <numbers>
#include <unordered_set>
#include <vector>

#include "core/base/memory_limit.h"
#include "core/formats/bvh.h"
#include "core/formats/bvh_conventions.h"
#include "core/formats/text_cursor.h"
#include "core/formats/text_writer.h"
#include "core/formats/value_repair.h"
#include "core/motion/clip.h"
#include "core/runtime/format/format_limits.h"

namespace mocapress {
namespace {

constexpr double kFallbackRate = 30;  // Hz, for a file whose Frame Time is nonsense

std::string number(double value) {
  std::string text;
  append_number(text, value, 4);
  return text;
}

/// A column that scales a joint along an axis. Joints have no channel for that.
struct ScaleChannel {
  std::size_t column = 0;  // in the file's rows
  int joint = 0;
  int axis = 0;
};

std::optional<int> scale_axis_named(std::string_view name) {
  constexpr std::string_view kAxes = "xyz";
  for (int axis = 0; axis < 3; ++axis)
    if (equals_ignoring_case(name, std::string(1, kAxes[axis]) + "scale")) return axis;
  return std::nullopt;
}

std::optional<ChannelKind> channel_named(std::string_view name) {
  constexpr std::string_view kAxes = "xyz";
  for (int axis = 0; axis < 3; ++axis) {
    const std::string letter(1, kAxes[axis]);
    if (equals_ignoring_case(name, letter + "position")) return translation_about(axis);
    if (equals_ignoring_case(name, letter + "rotation")) return rotation_about(axis);
  }
  return std::nullopt;
}

class BvhReader {
 public:
  BvhReader(const std::string& file, std::string_view text, const ReadOptions& options)
      : cursor_(file, text, "{}", '#'), options_(options) {
    source_.kind = SourceFormat::Kind::Bvh;
    source_.up = options.up.value_or(UpAxis::Y);
  }

  MotionFile read();

 private:
  void read_hierarchy();
  void read_tree();
  void open_joint(std::vector<int>& open);
  void read_offset(Joint& joint);
  void read_channels(Joint& joint);
  void read_end_site(Joint& joint);
  void keep_end_sites_of_leaves();
  void warn_of_duplicate_names();

  void read_header();
  bool read_row();
  void read_rows();
  Eigen::MatrixXd without_scales(const RawRows& rows);
  Motion motion_in_file_units();
  void settle_rate(Clip& clip);
  void settle_translation(Motion& motion);
  void settle_translation(Motion& motion, const TranslationGuess& guess, bool of_roots);
  Motion in_centimetres(const Motion& motion);

  void warn(int line, std::string message) {
    warnings_.push_back({cursor_.file(), line, std::move(message)});
  }

  TextCursor cursor_;
  ReadOptions options_;
  Warnings warnings_;
  SourceFormat source_;
  std::vector<Joint> joints_;  // offsets in file units
  int dropped_end_sites_ = 0;
  std::size_t columns_ = 0;
  std::vector<ScaleChannel> scales_;  // in the order of their columns
  std::vector<double> values_;        // rows of columns_, file units and degrees
  ScalarTracks tracks_;
  double stated_frames_ = 0;
  double frame_time_ = 0;
  int frames_line_ = 0;
  int frame_time_line_ = 0;
};

MotionFile BvhReader::read() {
  read_hierarchy();
  keep_end_sites_of_leaves();
  warn_of_duplicate_names();
  read_header();
  read_rows();
  Motion motion = motion_in_file_units();
  settle_rate(motion.clip);
  settle_translation(motion);
  if (!options_.up && stands_along_z(motion))
    warn(0,
         "the figure stands along Z, but Y is taken to point up: --up z, or the import options of "
         "the studio, read it upright");
  motion = with_up_axis(in_centimetres(motion), source_.up, UpAxis::Y);
  unwrap_angles(motion.skeleton, motion.clip);
  return {.motion = std::move(motion),
          .warnings = std::move(warnings_),
          .source = source_,
          .tracks = std::move(tracks_)};
}

void BvhReader::read_hierarchy() {
  cursor_.expect("HIERARCHY");
  if (!cursor_.next_is("ROOT")) cursor_.fail_expecting("ROOT");
  while (cursor_.next_is("ROOT")) read_tree();
  if (columns_ == scales_.size())
    cursor_.fail(cursor_.peek(), "no joint has a channel: nothing moves");
  if (!cursor_.next_is("MOTION")) cursor_.fail_expecting("MOTION");
  cursor_.treat_as_space(':');
  cursor_.take();
}

void BvhReader::read_tree() {
  std::vector<int> open;  // path from the root to the joint being read
  open_joint(open);
  while (!open.empty()) {
    Joint& joint = joints_[open.back()];
    if (cursor_.skip("}"))
      open.pop_back();
    else if (cursor_.skip("OFFSET"))
      read_offset(joint);
    else if (cursor_.skip("CHANNELS"))
      read_channels(joint);
    else if (cursor_.next_is("JOINT"))
      open_joint(open);
    else if (cursor_.next_is("End") || cursor_.next_is("EndSite"))
      read_end_site(joint);
    else
      cursor_.fail_expecting("OFFSET, CHANNELS, JOINT, End Site or }");
  }
}

void BvhReader::open_joint(std::vector<int>& open) {
  const Token keyword = cursor_.take();
  if (open.size() == runtime::kMostDepth)
    cursor_.fail(keyword, "joints are nested deeper than " + std::to_string(runtime::kMostDepth));
  if (joints_.size() == runtime::kMostJoints)
    cursor_.fail(keyword, "more than " + std::to_string(runtime::kMostJoints) + " joints");
  if (cursor_.at_end() || cursor_.next_is("{")) cursor_.fail_expecting("the name of the joint");
  Joint joint;
  const Token name = cursor_.take_line('{');
  if (name.text.size() > runtime::kMostNameBytes)
    cursor_.fail(name, "the name of a joint has more than " +
                           std::to_string(runtime::kMostNameBytes) + " bytes");
  joint.name = name.text;
  joint.parent = open.empty() ? -1 : open.back();
  cursor_.expect("{");
  open.push_back(static_cast<int>(joints_.size()));
  joints_.push_back(std::move(joint));
}

void BvhReader::read_offset(Joint& joint) {
  for (double& coordinate : joint.offset)
    coordinate = cursor_.take_measure("a coordinate of OFFSET");
}

void BvhReader::read_channels(Joint& joint) {
  const Token at = cursor_.peek();
  const double count = cursor_.take_measure("the number of channels");
  if (!joint.channels.empty()) cursor_.fail(at, "a second CHANNELS line for one joint");
  const auto index = static_cast<int>(&joint - joints_.data());
  std::size_t read = 0;
  for (;; ++read) {
    const auto kind = channel_named(cursor_.peek().text);
    const auto axis = scale_axis_named(cursor_.peek().text);
    if (!kind && !axis) break;
    const bool is_known = kind ? std::ranges::find(joint.channels, *kind) != joint.channels.end()
                               : std::ranges::any_of(scales_, [&](const ScaleChannel& scale) {
                                   return scale.joint == index && scale.axis == *axis;
                                 });
    if (is_known)
      cursor_.fail(cursor_.peek(), "channel " + quoted(cursor_.peek()) + " twice in one joint");
    if (kind)
      joint.channels.push_back(*kind);
    else
      scales_.push_back({columns_ + read, index, *axis});
    cursor_.take();
  }
  if (static_cast<double>(read) != count)
    cursor_.fail_expecting(number(count) + " channels such as Xposition or Zrotation");
  columns_ += read;
}

void BvhReader::read_end_site(Joint& joint) {
  cursor_.take_line('{');
  cursor_.expect("{");
  Joint end;
  if (cursor_.skip("OFFSET")) read_offset(end);
  if (!cursor_.skip("}")) cursor_.fail_expecting("OFFSET or the } of the End Site");
  if (joint.end_site)
    ++dropped_end_sites_;
  else if (end.offset.norm() > 0)
    joint.end_site = end.offset;
}

void BvhReader::keep_end_sites_of_leaves() {
  for (const Joint& joint : joints_) {
    if (joint.parent < 0) continue;
    Joint& parent = joints_[joint.parent];
    dropped_end_sites_ += parent.end_site.has_value();
    parent.end_site.reset();
  }
  if (dropped_end_sites_ > 0)
    warn(0, counted(dropped_end_sites_, "End Site") + " beside other children left out");
}

void BvhReader::warn_of_duplicate_names() {
  std::unordered_set<std::string_view> seen;
  int duplicates = 0;
  for (const Joint& joint : joints_) duplicates += !seen.insert(joint.name).second;
  if (duplicates > 0) warn(0, counted(duplicates, "joint") + " with the name of another joint");
}

void BvhReader::read_header() {
  cursor_.expect("Frames");
  frames_line_ = cursor_.peek().line;
  stated_frames_ = cursor_.take_number("the number of frames");
  cursor_.expect("Frame");
  cursor_.expect("Time");
  frame_time_line_ = cursor_.peek().line;
  frame_time_ = cursor_.take_number("the time of a frame in seconds");
}

/// Reads a row. False: the file ends within it, and the row is dropped.
bool BvhReader::read_row() {
  const int first_line = cursor_.peek().line;
  const std::size_t row_begin = values_.size();
  require_memory(cursor_.file(), kBytesOfReadValue * (row_begin + columns_));
  int line = first_line;
  for (std::size_t c = 0; c < columns_; ++c) {
    const Token word = cursor_.take();
    const auto value = parse_number(word.text);
    if (!value && !cursor_.at_end()) cursor_.fail_expecting_number(word, "a channel's value");
    if (!value) {
      values_.resize(row_begin);
      warn(first_line, kTruncated);
      return false;
    }
    values_.push_back(*value);
    line = word.line;
  }
  if (cursor_.on_line(line))
    cursor_.fail(cursor_.peek(), "expected a new line after the " + std::to_string(columns_) +
                                     " values of the frame that begins in line " +
                                     std::to_string(first_line) + ", found " +
                                     quoted(cursor_.peek()));
  return true;
}

void BvhReader::read_rows() {
  while (!cursor_.at_end() && read_row()) {
  }
  const std::size_t frames = values_.size() / columns_;
  if (frames == 0) cursor_.fail(cursor_.peek(), "no complete frame follows");
  if (static_cast<double>(frames) != stated_frames_)
    warn(frames_line_, "the header says " + number(stated_frames_) + " frames, " +
                           std::to_string(frames) + kOtherFrames);
}

/// The rows without the columns of scales, which become tracks unless they stay at 1.
Eigen::MatrixXd BvhReader::without_scales(const RawRows& rows) {
  const auto left = rows.cols() - std::ssize(scales_);
  Eigen::MatrixXd kept(rows.rows(), left);
  auto scale = scales_.begin();
  for (Eigen::Index c = 0, to = 0; c < rows.cols(); ++c) {
    if (scale == scales_.end() || static_cast<Eigen::Index>(scale->column) != c) {
      kept.col(to++) = rows.col(c);
      continue;
    }
    if ((rows.col(c).array() != 1).any()) {
      if (tracks_.size() == runtime::kMostTracks)
        cursor_.fail(cursor_.peek(), "more than " + std::to_string(runtime::kMostTracks) +
                                         " channels of scale that change");
      ScalarTrack track{.kind = scale_along(scale->axis),
                        .node = joints_[scale->joint].name,
                        .name = {},
                        .values = {}};
      for (const double value : rows.col(c)) track.values.push_back(static_cast<float>(value));
      tracks_.push_back(std::move(track));
    }
    ++scale;
  }
  if (!tracks_.empty())
    warn(0,
         counted(std::ssize(tracks_), "channel") + " of scale kept as tracks, which move no joint");
  return kept;
}

Motion BvhReader::motion_in_file_units() {
  const auto columns = static_cast<Eigen::Index>(columns_);
  RawRows rows(values_.data(), static_cast<Eigen::Index>(values_.size()) / columns, columns);
  if (const long repaired = repair_values(rows); repaired > 0)
    warn(0, counted(repaired, "value") + kRepaired);
  Motion motion;
  motion.clip.channels = without_scales(rows);
  for (Joint& joint : joints_) motion.skeleton.add(std::move(joint));
  for (int c = 0; c < motion.skeleton.channel_count(); ++c)
    if (is_rotation(motion.skeleton.channel_kind(c)))
      motion.clip.channels.col(c) *= std::numbers::pi / 180;
  return motion;
}

void BvhReader::settle_rate(Clip& clip) {
  const auto stated = rate_from_frame_time(frame_time_);
  clip.sample_rate_hz = options_.sample_rate_hz.value_or(stated.value_or(kFallbackRate));
  if (options_.sample_rate_hz || (stated && frame_time_ <= 1)) return;
  warn(frame_time_line_, "a Frame Time of " + number(frame_time_) +
                             " s cannot be right: taken as " + number(clip.sample_rate_hz) +
                             " frames per second");
}

void BvhReader::settle_translation(Motion& motion) {
  const auto [roots, others] = guess_translation(motion, source_.up);
  if (others) settle_translation(motion, *others, false);
  if (!roots) return;
  source_.root = options_.bvh_root.value_or(roots->convention);
  if (!options_.bvh_root)
    settle_translation(motion, *roots, true);
  else if (*source_.root == TranslationConvention::Replaces)
    subtract_offsets(motion.skeleton, true, motion.clip);
}

void BvhReader::settle_translation(Motion& motion, const TranslationGuess& guess, bool of_roots) {
  if (guess.convention == TranslationConvention::Adds) return;
  subtract_offsets(motion.skeleton, of_roots, motion.clip);
  warn(0, std::string("translation channels of the ") +
              (of_roots ? "root" : "joints below the root") + " are taken to replace OFFSET, as " +
              (guess.clear ? "their values suggest"
                           : "Blender and MotionBuilder do: their values do not tell"));
}

Motion BvhReader::in_centimetres(const Motion& motion) {
  const double height = rest_height(motion.skeleton);
  const double cm_per_unit = options_.cm_per_unit.value_or(guess_cm_per_unit(height));
  source_.cm_per_unit = cm_per_unit;
  if (cm_per_unit == 1) return motion;
  if (!options_.cm_per_unit)
    warn(0, "no unit of length is given: a rest pose " + number(height) +
                " units tall is taken to have " + number(cm_per_unit) + " cm to the unit");
  Motion scaled{{}, motion.clip};
  for (Joint joint : motion.skeleton.joints()) {
    joint.offset *= cm_per_unit;
    if (joint.end_site) *joint.end_site *= cm_per_unit;
    scaled.skeleton.add(std::move(joint));
  }
  for (int c = 0; c < scaled.skeleton.channel_count(); ++c)
    if (!is_rotation(scaled.skeleton.channel_kind(c))) scaled.clip.channels.col(c) *= cm_per_unit;
  return scaled;
}

}  // namespace

MotionFile read_bvh(const std::string& file, std::string_view text, const ReadOptions& options) {
  return BvhReader(file, text, options).read();
}

}  // namespace mocapress
