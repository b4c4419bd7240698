// SPDX-License-Identifier: MIT
#include <algorithm>
#include <charconv>
#include <cstdint>
#include <limits>
#include <numbers>
#include <unordered_map>
#include <vector>

#include "core/base/memory_limit.h"
#include "core/formats/amc.h"
#include "core/formats/text_cursor.h"
#include "core/formats/text_writer.h"
#include "core/formats/value_repair.h"
#include "core/motion/clip.h"

namespace mocapress {
namespace {

constexpr double kMissing = std::numeric_limits<double>::quiet_NaN();

/// The columns of a joint's values in a row, set by the first frame.
struct Columns {
  std::size_t first = 0;
  std::size_t count = 0;
  std::size_t frames = 0;  // frames up to the last with this joint; 0: none
};

class AmcReader {
 public:
  AmcReader(const std::string& file, std::string_view text, const AsfSkeleton& skeleton,
            const ReadOptions& options);
  MotionFile read();

 private:
  void read_header();
  bool read_frame();
  bool at_frame_number() const;
  void take_frame_number();
  bool read_joint();
  bool take_values(int line);
  void place_first(std::size_t joint);
  void make_3dof(AsfJoint& joint);
  bool close_frame(const Token& number);
  bool drop_frame(const Token& number);

  Motion to_motion();
  void fill(Clip& clip, int first_channel, const RawRows& rows, std::size_t joint) const;
  void warn_of_counts();
  void warn(int line, std::string message) {
    warnings_.push_back({cursor_.file(), line, std::move(message)});
  }

  TextCursor cursor_;
  AsfSkeleton skeleton_;
  double sample_rate_hz_;
  bool rate_is_given_;
  bool rate_is_stated_ = false;
  UpAxis up_;
  double radians_per_unit_;
  bool forced_3dof_ = false;
  Warnings warnings_;

  std::unordered_map<std::string_view, std::size_t> joint_named_;
  std::vector<Columns> columns_;  // one for each joint
  std::size_t row_size_ = 0;
  std::size_t frames_ = 0;
  std::size_t joints_a_frame_ = 0;   // in the first frame
  std::size_t joints_in_frame_ = 0;  // so far, in the frame being read
  std::vector<double> joint_values_;
  std::vector<double> values_;  // rows of row_size_, file units

  std::uint64_t next_number_ = 1;
  int first_jump_line_ = 0;
  long missing_joints_ = 0;
  long missing_values_ = 0;
  int joints_made_3dof_ = 0;
};

AmcReader::AmcReader(const std::string& file, std::string_view text, const AsfSkeleton& skeleton,
                     const ReadOptions& options)
    : cursor_(file, text, "", '#'),
      skeleton_(skeleton),
      sample_rate_hz_(options.sample_rate_hz.value_or(kUsualAmcRate)),
      rate_is_given_(options.sample_rate_hz.has_value()),
      up_(options.up.value_or(UpAxis::Y)),
      radians_per_unit_(skeleton.radians_per_unit),
      columns_(skeleton.joints.size()) {
  for (std::size_t j = 0; j < columns_.size(); ++j)
    joint_named_.emplace(skeleton_.joints[j].joint.name, j);
}

MotionFile AmcReader::read() {
  read_header();
  while (!cursor_.at_end() && read_frame()) {
  }
  if (frames_ == 0) cursor_.fail(cursor_.peek(), "expected a complete frame, found none");
  Motion motion = to_motion();
  // Does not test row_size_: rows also hold bones' lengths, which have no channel.
  if (motion.skeleton.channel_count() == 0)
    cursor_.fail(cursor_.peek(), "no bone has a value: nothing moves");
  unwrap_angles(motion.skeleton, motion.clip);
  warn_of_counts();
  return {with_up_axis(motion, up_, UpAxis::Y),
          std::move(warnings_),
          {.kind = SourceFormat::Kind::Acclaim, .cm_per_unit = skeleton_.cm_per_unit, .up = up_},
          rate_is_stated_};
}

void AmcReader::read_header() {
  while (cursor_.peek().text.starts_with(':')) {
    const Token key = cursor_.take();
    if (equals_ignoring_case(key.text, ":DEGREES")) {
      radians_per_unit_ = std::numbers::pi / 180;
    } else if (equals_ignoring_case(key.text, ":RADIANS")) {
      radians_per_unit_ = 1;
    } else if (equals_ignoring_case(key.text, ":FORCE-ALL-JOINTS-BE-3DOF")) {
      forced_3dof_ = true;
    } else if (equals_ignoring_case(key.text, ":SAMPLES-PER-SECOND")) {
      const Token at = cursor_.peek();
      const double rate = cursor_.take_measure("samples per second");
      if (rate < 1) cursor_.fail(at, "expected one sample per second or more, found " + quoted(at));
      if (!rate_is_given_) sample_rate_hz_ = rate;
      rate_is_stated_ = true;
    }
    cursor_.skip_line(key.line);
  }
}

/// Reads a frame. False: the file ends within it, and the frame is dropped.
bool AmcReader::read_frame() {
  const Token number = cursor_.peek();
  take_frame_number();
  joints_in_frame_ = 0;
  // Frames may leave out joints, so even a short file can ask for many values.
  require_memory(cursor_.file(), kBytesOfReadValue * (frames_ + 1) * row_size_);
  values_.resize((frames_ + 1) * row_size_, kMissing);
  while (!cursor_.at_end() && !at_frame_number())
    if (!read_joint()) return drop_frame(number);
  return close_frame(number);
}

bool AmcReader::at_frame_number() const {
  const std::string_view text = cursor_.peek().text;
  return std::ranges::all_of(text, [](char c) { return c >= '0' && c <= '9'; });
}

void AmcReader::take_frame_number() {
  if (cursor_.at_end() || !at_frame_number()) cursor_.fail_expecting("a frame number");
  const Token at = cursor_.take();
  std::uint64_t number = 0;
  std::from_chars(at.text.data(), at.text.data() + at.text.size(), number);
  if (number != next_number_ && first_jump_line_ == 0) first_jump_line_ = at.line;
  next_number_ = number + 1;
}

/// Reads a joint's line. False: the file ends within it.
bool AmcReader::read_joint() {
  const Token name = cursor_.take();
  const auto found = joint_named_.find(name.text);
  if (found == joint_named_.end()) {
    if (cursor_.at_end()) return false;
    cursor_.fail(name, "expected a bone of " + skeleton_.file + ", found " + quoted(name));
  }
  if (!take_values(name.line)) return false;
  Columns& columns = columns_[found->second];
  if (columns.frames == frames_ + 1) cursor_.fail(name, quoted(name) + " twice in one frame");
  if (frames_ == 0) place_first(found->second);
  if (columns.frames == 0) cursor_.fail(name, quoted(name) + " is not in the first frame");
  if (joint_values_.size() < columns.count && cursor_.at_end()) return false;
  if (joint_values_.size() != columns.count)
    cursor_.fail(name, "expected " + std::to_string(columns.count) + " values for " + quoted(name) +
                           ", found " + std::to_string(joint_values_.size()));
  std::ranges::copy(joint_values_, values_.begin() + static_cast<std::ptrdiff_t>(
                                                         frames_ * row_size_ + columns.first));
  columns.frames = frames_ + 1;
  ++joints_in_frame_;
  return true;
}

/// Reads the values on a line. False: the file's last word is not a number, since the file was cut
/// there.
bool AmcReader::take_values(int line) {
  joint_values_.clear();
  while (cursor_.on_line(line)) {
    const Token word = cursor_.take();
    const auto value = parse_number(word.text);
    if (!value && cursor_.at_end()) return false;
    if (!value) cursor_.fail_expecting_number(word, "a number");
    joint_values_.push_back(*value);
  }
  return true;
}

/// Assigns columns to a joint, in the first frame.
void AmcReader::place_first(std::size_t index) {
  AsfJoint& joint = skeleton_.joints[index];
  const bool only_rotations = rotation_axes(joint.dof).size() == joint.dof.size();
  if (joint_values_.size() == 3 && joint.dof.size() < 3 && only_rotations) make_3dof(joint);
  columns_[index] = {row_size_, joint.dof.size(), 1};
  row_size_ += joint.dof.size();
  values_.resize(row_size_, kMissing);
}

void AmcReader::make_3dof(AsfJoint& joint) {
  ++joints_made_3dof_;
  if (!forced_3dof_) joint.dof.clear();
  for (int axis = 0; axis < 3; ++axis)
    if (std::ranges::find(joint.dof, rotation_about(axis)) == joint.dof.end())
      joint.dof.push_back(rotation_about(axis));
  joint.feed_channels({0, 1, 2});
}

bool AmcReader::close_frame(const Token& number) {
  if (frames_ == 0) joints_a_frame_ = joints_in_frame_;
  if (joints_in_frame_ < joints_a_frame_ && cursor_.at_end()) return drop_frame(number);
  if (joints_in_frame_ == 0 || 2 * joints_in_frame_ < joints_a_frame_)
    cursor_.fail(number, "frame " + quoted(number) + " has only " +
                             std::to_string(joints_in_frame_) + " bones");
  ++frames_;
  missing_joints_ += static_cast<long>(joints_a_frame_ - joints_in_frame_);
  if (joints_in_frame_ < joints_a_frame_)
    for (const Columns& columns : columns_)
      if (columns.frames > 0 && columns.frames < frames_)
        missing_values_ += static_cast<long>(columns.count);
  return true;
}

bool AmcReader::drop_frame(const Token& number) {
  if (frames_ == 0) cursor_.fail(cursor_.peek(), "the file ends within its first frame");
  values_.resize(frames_ * row_size_);
  warn(number.line, kTruncated);
  return false;
}

Motion AmcReader::to_motion() {
  RawRows rows(values_.data(), static_cast<Eigen::Index>(frames_),
               static_cast<Eigen::Index>(row_size_));
  if (const long repaired = repair_values(rows) - missing_values_; repaired > 0)
    warn(0, counted(repaired, "value") + kRepaired);
  Motion motion;
  for (std::size_t j = 0; j < columns_.size(); ++j) {
    Joint joint = skeleton_.joints[j].joint;
    if (columns_[j].frames == 0) joint.channels.clear();
    motion.skeleton.add(std::move(joint));
  }
  motion.clip.sample_rate_hz = sample_rate_hz_;
  motion.clip.channels.resize(rows.rows(), motion.skeleton.channel_count());
  for (std::size_t j = 0; j < columns_.size(); ++j)
    if (columns_[j].frames > 0)
      fill(motion.clip, motion.skeleton.first_channel(static_cast<int>(j)), rows, j);
  return motion;
}

/// Fills the channels of one joint from its columns, in cm and radians.
void AmcReader::fill(Clip& clip, int first_channel, const RawRows& rows, std::size_t index) const {
  const AsfJoint& joint = skeleton_.joints[index];
  for (std::size_t i = 0; i < joint.columns.size(); ++i) {
    auto channel = clip.channels.col(first_channel + static_cast<Eigen::Index>(i));
    if (joint.columns[i] < 0) {
      channel.setZero();
      continue;
    }
    const auto first_column = static_cast<Eigen::Index>(columns_[index].first);
    channel = rows.col(first_column + joint.columns[i]) *
              (is_rotation(joint.joint.channels[i]) ? radians_per_unit_ : skeleton_.cm_per_unit);
  }
  if (joint.translates_along_axes)
    clip.channels.middleCols<3>(first_channel) *= joint.joint.joint_from_axes.transpose();
}

void AmcReader::warn_of_counts() {
  if (first_jump_line_ > 0)
    warn(first_jump_line_,
         "frame numbers do not run 1, 2, 3 from here: frames are taken as they come");
  if (missing_joints_ > 0) warn(0, counted(missing_joints_, "bone") + kRepeated);
  if (joints_made_3dof_ > 0)
    warn(0, counted(joints_made_3dof_, "bone") +
                " with three values where the skeleton names fewer, read as " +
                (forced_3dof_ ? "its dof and the axes missing from it" : "rx ry rz"));
  int never_seen = 0;
  int stretching = 0;
  for (std::size_t j = 0; j < columns_.size(); ++j) {
    const auto& dof = skeleton_.joints[j].dof;
    never_seen += columns_[j].frames == 0 && !dof.empty();
    stretching +=
        columns_[j].frames > 0 && std::find(dof.begin(), dof.end(), std::nullopt) != dof.end();
  }
  if (never_seen > 0)
    warn(0, counted(never_seen, "bone") + " with dof but without values, left at rest");
  if (stretching > 0)
    warn(0, counted(stretching, "bone") + " with a length that changes (dof l), which is ignored");
}

}  // namespace

MotionFile read_amc(const std::string& file, std::string_view text, const AsfSkeleton& skeleton,
                    const ReadOptions& options) {
  return AmcReader(file, text, skeleton, options).read();
}

}  // namespace mocapress
