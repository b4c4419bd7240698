// SPDX-License-Identifier: MIT
#include <algorithm>
#include <numbers>
#include <vector>

#include "core/formats/bvh.h"
#include "core/formats/text_writer.h"
#include "core/formats/zyx_angles.h"

namespace mocapress {
namespace {

constexpr double kDegrees = 180 / std::numbers::pi;

bool translates(const Joint& joint) {
  return std::any_of(joint.channels.begin(), joint.channels.end(),
                     [](ChannelKind kind) { return !is_rotation(kind); });
}

struct Place {
  int joint;
  std::size_t depth;
};

/// Every joint straight before its first child: the order in which braces nest.
std::vector<Place> depth_first(const Skeleton& skeleton) {
  std::vector<std::vector<int>> children(static_cast<std::size_t>(skeleton.joint_count()));
  std::vector<Place> waiting;
  for (int j = skeleton.joint_count() - 1; j >= 0; --j) {
    const int parent = skeleton.joint(j).parent;
    if (parent < 0)
      waiting.push_back({j, 0});
    else
      children[static_cast<std::size_t>(parent)].push_back(j);
  }
  std::vector<Place> order;
  while (!waiting.empty()) {
    const Place place = waiting.back();
    waiting.pop_back();
    order.push_back(place);
    for (const int child : children[static_cast<std::size_t>(place.joint)])
      waiting.push_back({child, place.depth + 1});
  }
  return order;
}

class BvhWriter {
 public:
  explicit BvhWriter(const Motion& motion)
      : motion_(motion), order_(depth_first(motion.skeleton)) {}
  std::string write();

 private:
  void open_joint(const Place& place);
  void close_joints(std::size_t from_depth, std::size_t to_depth);
  void write_channels(const Joint& joint);
  void write_values(int joint, int frame);
  void begin_line(std::size_t depth, const char* text) { text_.append(depth, '\t') += text; }

  const Motion& motion_;  // every joint_from_axes is identity
  std::vector<Place> order_;
  std::string text_;
};

std::string BvhWriter::write() {
  text_ = "HIERARCHY\n";
  std::size_t open = 0;
  for (const Place& place : order_) {
    close_joints(open, place.depth);
    open_joint(place);
    open = place.depth + 1;
  }
  close_joints(open, 0);
  text_ += "MOTION\nFrames: " + std::to_string(motion_.clip.frames()) + "\nFrame Time: ";
  append_number(text_, 1 / motion_.clip.sample_rate_hz, 10);
  text_ += '\n';
  for (int t = 0; t < motion_.clip.frames(); ++t) {
    for (const Place& place : order_) write_values(place.joint, t);
    text_.back() = '\n';
  }
  return std::move(text_);
}

void BvhWriter::open_joint(const Place& place) {
  const Joint& joint = motion_.skeleton.joint(place.joint);
  begin_line(place.depth, joint.parent < 0 ? "ROOT " : "JOINT ");
  text_ += as_word(joint.name, "{}") + '\n';
  begin_line(place.depth, "{\n");
  begin_line(place.depth + 1, "OFFSET");
  const bool moving_root = joint.parent < 0 && translates(joint);
  append_vector(text_, moving_root ? Eigen::Vector3d::Zero() : joint.offset);
  text_ += '\n';
  begin_line(place.depth + 1, "CHANNELS ");
  write_channels(joint);
  if (!joint.end_site) return;
  begin_line(place.depth + 1, "End Site\n");
  begin_line(place.depth + 1, "{\n");
  begin_line(place.depth + 2, "OFFSET");
  append_vector(text_, *joint.end_site);
  text_ += '\n';
  begin_line(place.depth + 1, "}\n");
}

void BvhWriter::close_joints(std::size_t from_depth, std::size_t to_depth) {
  for (std::size_t depth = from_depth; depth > to_depth; --depth) begin_line(depth - 1, "}\n");
}

/// A joint that moves along any axis gets all three positions: they are absolute.
void BvhWriter::write_channels(const Joint& joint) {
  std::string names = translates(joint) ? " Xposition Yposition Zposition" : "";
  long count = translates(joint) ? 3 : 0;
  for (const ChannelKind kind : joint.channels) {
    if (!is_rotation(kind)) continue;
    names += std::string(" ") + "XYZ"[axis_of(kind)] + "rotation";
    ++count;
  }
  text_ += std::to_string(count) + names + '\n';
}

void BvhWriter::write_values(int index, int frame) {
  const Joint& joint = motion_.skeleton.joint(index);
  const int first = motion_.skeleton.first_channel(index);
  Eigen::Vector3d position = joint.offset;
  std::string angles;
  for (std::size_t i = 0; i < joint.channels.size(); ++i) {
    const ChannelKind kind = joint.channels[i];
    const double value = motion_.clip.channels(frame, first + static_cast<int>(i));
    if (!is_rotation(kind)) {
      position(axis_of(kind)) += value;
      continue;
    }
    append_number(angles, value * kDegrees);
    angles += ' ';
  }
  if (translates(joint))
    for (const double coordinate : position) {
      append_number(text_, coordinate);
      text_ += ' ';
    }
  text_ += angles;
}

}  // namespace

std::string bvh_text(const Motion& motion) {
  return BvhWriter(
             with_zyx_angles(
                 motion, [](const Joint& joint) { return !joint.joint_from_axes.isIdentity(0); }))
      .write();
}

}  // namespace mocapress
