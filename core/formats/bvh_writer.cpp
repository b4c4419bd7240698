// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <numbers>
#include <string_view>
#include <unordered_set>
#include <vector>

#include "core/formats/bvh.h"
#include "core/formats/text_cursor.h"
#include "core/formats/text_writer.h"
#include "core/formats/zyx_angles.h"

namespace mocapress {
namespace {

constexpr double kDegrees = 180 / std::numbers::pi;

bool translates(const Joint& joint) {
  return std::ranges::any_of(joint.channels, [](ChannelKind kind) { return !is_rotation(kind); });
}

/// True if a joint's rotation channels turn about different axes, as a BVH requires.
bool has_an_order(const Joint& joint) {
  std::array<int, kChannelKinds> times{};
  for (const ChannelKind kind : joint.channels) ++times[static_cast<std::size_t>(kind)];
  return std::all_of(times.begin() + 3, times.end(), [](int count) { return count <= 1; });
}

/// The axes of a joint's three rotations, the leftmost first. Rotations that it lacks stay at zero.
std::array<int, 3> rotation_order(const Joint& joint) {
  std::vector<int> order;
  for (const ChannelKind kind : joint.channels)
    if (is_rotation(kind)) order.push_back(axis_of(kind));
  for (const int axis : {2, 1, 0})
    if (std::ranges::find(order, axis) == order.end()) order.push_back(axis);
  return {order[0], order[1], order[2]};
}

/// The number of bytes of the first character of `text`. 0: the character is not UTF-8, or is white
/// space beyond ASCII's, at which some readers end a word.
std::size_t character_size(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const std::size_t size = byte(0) < 0x80 ? 1 : byte(0) < 0xE0 ? 2 : byte(0) < 0xF0 ? 3 : 4;
  constexpr std::array<unsigned, 5> kSmallest = {0, 0, 0x80, 0x800, 0x10000};
  if (size == 1) return 1;
  if (byte(0) < 0xC2 || byte(0) > 0xF4 || text.size() < size) return 0;
  unsigned code = byte(0) & (0x7FU >> size);
  for (std::size_t i = 1; i < size; ++i) {
    if ((byte(i) & 0xC0U) != 0x80U) return 0;
    code = code << 6 | (byte(i) & 0x3FU);
  }
  if (code < kSmallest[size] || code > 0x10FFFF || (code >= 0xD800 && code <= 0xDFFF)) return 0;
  constexpr std::array<unsigned, 8> kSpaces = {0x85,   0xA0,   0x1680, 0x2028,
                                               0x2029, 0x202F, 0x205F, 0x3000};
  const bool is_space =
      (code >= 0x2000 && code <= 0x200A) || std::ranges::find(kSpaces, code) != kSpaces.end();
  return is_space ? 0 : size;
}

/// A joint's name as one word: UTF-8 that is no keyword, without white space, braces, quotes or
/// backslashes (some programs put names into paths).
std::string joint_word(const std::string& name) {
  const std::string plain = as_word(name, "{}\"'\\");
  std::string word;
  for (std::string_view rest = plain; !rest.empty();) {
    const std::size_t size = character_size(rest);
    if (size == 0)
      word += '_';
    else
      word += rest.substr(0, size);
    rest.remove_prefix(std::max<std::size_t>(size, 1));
  }
  for (const char* keyword : {"HIERARCHY", "ROOT", "JOINT", "OFFSET", "CHANNELS", "End", "EndSite",
                              "Site", "MOTION", "Frames:", "Frame", "Time:"})
    if (equals_ignoring_case(word, keyword)) return '_' + word;
  return word.starts_with('#') ? '_' + word : word;  // a comment would hide the rest of the line
}

struct Place {
  int joint;
  std::size_t depth;
};

/// Joints in depth-first order, in which a BVH nests them.
std::vector<Place> depth_first(const Skeleton& skeleton) {
  std::vector<std::vector<int>> children(skeleton.joint_count());
  std::vector<Place> waiting;
  for (int j = skeleton.joint_count() - 1; j >= 0; --j) {
    const int parent = skeleton.joint(j).parent;
    if (parent < 0)
      waiting.push_back({j, 0});
    else
      children[parent].push_back(j);
  }
  std::vector<Place> order;
  while (!waiting.empty()) {
    const Place place = waiting.back();
    waiting.pop_back();
    order.push_back(place);
    for (const int child : children[place.joint]) waiting.push_back({child, place.depth + 1});
  }
  return order;
}

class BvhWriter {
 public:
  BvhWriter(const Motion& motion, const BvhStyle& style)
      : motion_(motion),
        style_(style),
        decimals_(length_decimals(style.cm_per_unit)),
        names_(bvh_names(motion.skeleton)),
        order_(depth_first(motion.skeleton)) {}
  std::string write();

 private:
  void open_joint(const Place& place);
  void close_joints(std::size_t from_depth, std::size_t to_depth);
  void write_channels(const Joint& joint);
  void write_values(int joint, int frame);
  void append_length(const Eigen::Vector3d& cm, int decimals) {
    append_vector(text_, cm / style_.cm_per_unit, decimals);
  }
  /// Appends an offset with one digit less than positions have. A .mcpr keeps offsets as 32-bit
  /// floats, and an artist's round number must come back unchanged.
  void append_offset(const Eigen::Vector3d& cm) { append_length(cm, decimals_ - 1); }
  void begin_line(std::size_t depth, const char* text) { text_.append(depth, '\t') += text; }

  const Motion& motion_;  // joint_from_axes is identity everywhere
  BvhStyle style_;
  int decimals_;
  std::vector<std::string> names_;
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
    const std::size_t line = text_.size();
    for (const Place& place : order_) write_values(place.joint, t);
    text_.erase(line, 1);  // the leading space
    text_ += '\n';
  }
  return std::move(text_);
}

void BvhWriter::open_joint(const Place& place) {
  const Joint& joint = motion_.skeleton.joint(place.joint);
  begin_line(place.depth, joint.parent < 0 ? "ROOT " : "JOINT ");
  text_ += names_[place.joint] + '\n';
  begin_line(place.depth, "{\n");
  begin_line(place.depth + 1, "OFFSET");
  const bool at_zero = joint.parent < 0 && translates(joint) && !style_.root;
  append_offset(at_zero ? Eigen::Vector3d::Zero() : joint.offset);
  text_ += '\n';
  begin_line(place.depth + 1, "CHANNELS ");
  write_channels(joint);
  if (!joint.end_site) return;
  begin_line(place.depth + 1, "End Site\n");
  begin_line(place.depth + 1, "{\n");
  begin_line(place.depth + 2, "OFFSET");
  append_offset(*joint.end_site);
  text_ += '\n';
  begin_line(place.depth + 1, "}\n");
}

void BvhWriter::close_joints(std::size_t from_depth, std::size_t to_depth) {
  for (std::size_t depth = from_depth; depth > to_depth; --depth) begin_line(depth - 1, "}\n");
}

/// Writes the list of a joint's channels. A joint with any translation channel gets all three
/// positions, since these may have to repeat its offset.
void BvhWriter::write_channels(const Joint& joint) {
  text_ += translates(joint) ? "6 Xposition Yposition Zposition" : "3";
  for (const int axis : rotation_order(joint)) text_ += std::string(" ") + "XYZ"[axis] + "rotation";
  text_ += '\n';
}

void BvhWriter::write_values(int index, int frame) {
  const Joint& joint = motion_.skeleton.joint(index);
  const int first = motion_.skeleton.first_channel(index);
  const bool adds = joint.parent < 0 && style_.root == TranslationConvention::Adds;
  Eigen::Vector3d position = adds ? Eigen::Vector3d::Zero() : joint.offset;
  Eigen::Vector3d angles = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < joint.channels.size(); ++i) {
    const ChannelKind kind = joint.channels[i];
    const double value = motion_.clip.channels(frame, first + static_cast<int>(i));
    (is_rotation(kind) ? angles : position)(axis_of(kind)) += value;
  }
  if (translates(joint)) append_length(position, decimals_);
  for (const int axis : rotation_order(joint)) {
    text_ += ' ';
    append_number(text_, angles(axis) * kDegrees);
  }
}

}  // namespace

BvhStyle bvh_style(const SourceFormat& source, const ReadOptions& options) {
  const bool bvh = source.kind == SourceFormat::Kind::Bvh;
  BvhStyle style{.cm_per_unit = options.cm_per_unit.value_or(bvh ? source.cm_per_unit : 1),
                 .root = options.bvh_root};
  if (!style.root && source.root == TranslationConvention::Replaces) style.root = source.root;
  return style;
}

std::vector<std::string> bvh_names(const Skeleton& skeleton) {
  std::vector<std::string> names;
  std::unordered_set<std::string> taken;
  for (const Joint& joint : skeleton.joints())
    names.push_back(unique_word(joint_word(joint.name), taken));
  return names;
}

std::string bvh_text(const Motion& motion, const BvhStyle& style) {
  const Motion plain = with_zyx_angles(motion, [](const Joint& joint) {
    return !joint.joint_from_axes.isIdentity(0) || !has_an_order(joint);
  });
  return BvhWriter(plain, style).write();
}

}  // namespace mocapress
