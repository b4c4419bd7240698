// SPDX-License-Identifier: MIT
#include "core/codec/format/container.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <functional>
#include <numeric>
#include <optional>

#include "core/base/byte_cursor.h"
#include "core/base/error.h"
#include "core/base/file.h"
#include "core/codec/format/axes_section.h"
#include "core/codec/format/format_limits.h"
#include "core/codec/format/room.h"
#include "core/codec/format/section.h"
#include "core/codec/format/skeleton_section.h"

namespace mocapress {
namespace {

constexpr std::string_view kMagic = "MCPR";
constexpr std::string_view kEnds = "ENDS";
constexpr std::string_view kLoop = "loop";
constexpr std::string_view kOrders = "ordr";
constexpr std::uint16_t kVersion = 1;
constexpr std::size_t kSectionHead = 12;  // tag, size, checksum
constexpr std::size_t kSections = 6;      // where the file has their number

std::span<const std::byte> bytes_of(std::string_view text) {
  return std::as_bytes(std::span(text));
}

constexpr auto kNoCoding = static_cast<Coding>(0);  // of a comparison method
constexpr auto kNoMethod = static_cast<Method>(0);

std::vector<std::byte> write_description(const Container& container) {
  const CompressedClip& clip = container.clip;
  const bool wavelets = !container.of_comparison;
  ByteWriter writer;
  writer.write(clip.sample_rate_hz);
  writer.write(static_cast<std::uint32_t>(clip.frames));
  writer.write(static_cast<std::uint8_t>(wavelets ? clip.basis : Basis{}));
  writer.write(static_cast<std::uint8_t>(wavelets ? clip.coding : kNoCoding));
  writer.write(static_cast<std::uint8_t>(wavelets ? clip.provenance.method : kNoMethod));
  writer.write(static_cast<std::uint8_t>(clip.provenance.weighting));
  writer.write(clip.provenance.seed);
  writer.write(clip.provenance.eps_cm);
  writer.write(clip.provenance.max_error_cm);
  return writer.release();
}

template <typename Enum>
Enum read_enum(ByteReader& reader, Enum first, Enum last, const char* what) {
  const auto value = reader.read<std::uint8_t>();
  if (value < static_cast<std::uint8_t>(first) || value > static_cast<std::uint8_t>(last))
    reader.fail("unknown " + std::string(what) + " " + std::to_string(value));
  return static_cast<Enum>(value);
}

void read_description(std::span<const std::byte> payload, std::size_t offset,
                      Container& container) {
  CompressedClip& clip = container.clip;
  ByteReader reader(payload, offset);
  clip.sample_rate_hz = reader.read<double>();
  if (!std::isfinite(clip.sample_rate_hz) || clip.sample_rate_hz <= 0)
    reader.fail("the sample rate is no positive number");
  const auto frames = reader.read<std::uint32_t>();
  if (frames > runtime::kMostFrames) reader.fail("more than 2^22 frames");
  clip.frames = static_cast<int>(frames);
  clip.basis = read_enum(reader, Basis::Haar, Basis::Cubic, "basis");
  const auto coding = read_enum(reader, kNoCoding, Coding::Adaptive, "coding");
  container.of_comparison = coding == kNoCoding;
  if (container.of_comparison) {
    if (clip.basis != Basis{}) reader.fail("a basis without wavelets");
    read_enum(reader, kNoMethod, kNoMethod, "method");
    clip.basis = CompressedClip().basis;
  } else {
    clip.coding = coding;
    clip.provenance.method = read_enum(reader, Method::PerChannel, Method::ClosedLoop, "method");
  }
  clip.provenance.weighting = read_enum(reader, Weighting::BoneEnds, Weighting::Shell, "weighting");
  clip.provenance.seed = reader.read<std::uint64_t>();
  clip.provenance.eps_cm = reader.read<float>();
  clip.provenance.max_error_cm = reader.read<float>();
  reader.expect_end();
}

std::vector<std::byte> write_correction(const CodedCorrection& correction) {
  ByteWriter writer;
  writer.write(static_cast<std::uint8_t>(correction.solver));
  writer.write(static_cast<std::uint8_t>(correction.effectors.size()));
  for (const Effector& effector : correction.effectors) {
    writer.write(static_cast<std::uint16_t>(effector.joint));
    writer.write(static_cast<std::uint16_t>(effector.chain.front()));
  }
  return writer.release();
}

CodedCorrection read_correction(std::span<const std::byte> payload, std::size_t offset,
                                const Skeleton& skeleton) {
  ByteReader reader(payload, offset);
  CodedCorrection correction;
  correction.solver =
      read_enum(reader, IkSolver::CyclicDescent, IkSolver::NearestPose, "IK solver");
  const int effectors = reader.read<std::uint8_t>();
  if (effectors == 0 || effectors > runtime::kMostEffectors) reader.fail("effectors: not 1 to 32");
  try {
    for (int e = 0; e < effectors; ++e) {
      const int joint = reader.read<std::uint16_t>();
      const int top = reader.read<std::uint16_t>();
      if (joint >= skeleton.joint_count()) reader.fail("an effector is no joint of the skeleton");
      correction.effectors.push_back(effector_between(skeleton, top, joint));
    }
    check_effectors(skeleton, correction.effectors);
  } catch (const FormatError&) {
    throw;
  } catch (const Error& error) {
    reader.fail(error.what());
  }
  reader.expect_end();
  return correction;
}

std::vector<std::byte> write_segments(const CodedSegments& segments) {
  ByteWriter writer;
  writer.write(static_cast<std::uint32_t>(segments.length));
  writer.write(static_cast<std::uint32_t>(segments.overlap));
  writer.write(static_cast<std::uint32_t>(segments.bytes.size()));
  for (const std::uint32_t bytes : segments.bytes) writer.write(bytes);
  return writer.release();
}

CodedSegments read_segments(std::span<const std::byte> payload, std::size_t offset, int frames) {
  ByteReader reader(payload, offset);
  const auto length = reader.read<std::uint32_t>();
  const auto overlap = reader.read<std::uint32_t>();
  if (!runtime::may_be_segments(static_cast<std::uint32_t>(frames), length, overlap))
    throw FormatError(offset, "segments of impossible length");
  CodedSegments segments{static_cast<int>(length), static_cast<int>(overlap), {}};
  const SegmentLayout layout{frames, segments.length, segments.overlap};
  const std::size_t at = reader.offset();
  const auto count = reader.read<std::uint32_t>();
  if (count != static_cast<std::uint32_t>(layout.count()))
    throw FormatError(at, "not as many segments as frames need");
  if (reader.remaining() != 4 * std::size_t{count}) reader.fail("SEGS of another size");
  for (std::uint32_t k = 0; k < count; ++k) segments.bytes.push_back(reader.read<std::uint32_t>());
  return segments;
}

bool turns_axes(const CompressedClip& clip) {
  return std::any_of(clip.forms.begin(), clip.forms.end(),
                     [](const RotationForm& form) { return form.has_fixed_turns(); });
}

/// Whether any joint's angles are coded in another order than the source has them.
bool reorders(const CompressedClip& clip) {
  if (clip.forms.empty()) return false;
  const RotationForms source = rotation_forms(clip.skeleton);
  return !std::equal(
      source.begin(), source.end(), clip.forms.begin(), clip.forms.end(),
      [](const RotationForm& a, const RotationForm& b) { return a.order == b.order; });
}

/// The orders that a source's angles have, those of joints that turn freely: one, or each one's.
std::vector<std::byte> write_orders(const Skeleton& source) {
  std::vector<std::byte> orders;
  for (const Joint& joint : source.joints())
    if (turns_freely(joint)) orders.push_back(static_cast<std::byte>(rotation_order(joint)));
  if (std::adjacent_find(orders.begin(), orders.end(), std::not_equal_to<>()) == orders.end())
    orders.resize(std::min<std::size_t>(orders.size(), 1));
  return orders;
}

RotationForms read_orders(const Section& section, const Skeleton& coded) {
  ByteReader reader(section.payload, section.payload_offset);
  const bool all_alike = section.payload.size() == 1;
  RotationForms orders = rotation_forms(coded);
  std::optional<RotationOrder> last;
  for (int j = 0; j < coded.joint_count(); ++j) {
    if (!turns_freely(coded.joint(j))) continue;
    if (!last || !all_alike)
      last = read_enum(reader, RotationOrder::Xyz, RotationOrder::Zyx, "order of rotations");
    orders[static_cast<std::size_t>(j)].order = *last;
  }
  reader.expect_end();
  return orders;
}

std::string_view motion_tag(const Container& container) {
  return container.of_comparison ? "COMP" : "MOTN";
}

bool is_adaptive(const Container& container) {
  return !container.of_comparison && container.clip.coding == Coding::Adaptive;
}

/// Reads sections in their fixed order, skipping optional ones.
class SectionReader {
 public:
  SectionReader(ByteReader& file, int count) : file_(file), left_(count) {}

  Section expect(std::string_view tag, std::string_view or_tag = "") {
    while (left_ > 0) {
      --left_;
      const std::size_t start = file_.offset();
      Section section = read_section(file_);
      if (section.tag == tag || section.tag == or_tag) return section;
      if (!take_optional(section))
        throw FormatError(start,
                          "section " + section.tag + " where " + std::string(tag) + " is expected");
    }
    file_.fail("section " + std::string(tag) + " is missing");
  }

  /// Those of the tags that stand here, in this order. Beside them only optional ones follow.
  template <std::size_t count>
  std::array<std::optional<Section>, count> take_last(
      const std::array<std::string_view, count>& tags) {
    std::array<std::optional<Section>, count> found;
    std::size_t next = 0;
    for (; left_ > 0; --left_) {
      const std::size_t start = file_.offset();
      Section section = read_section(file_);
      const auto place = static_cast<std::size_t>(
          std::find(tags.begin() + static_cast<std::ptrdiff_t>(next), tags.end(), section.tag) -
          tags.begin());
      if (place < count) {
        found[place] = std::move(section);
        next = place + 1;
      } else if (!take_optional(section)) {
        throw FormatError(start, "unknown section " + section.tag);
      }
    }
    return found;
  }

  /// The optional ones that are known here, once all have been read.
  const std::optional<Section>& loop() const { return loop_; }
  const std::optional<Section>& orders() const { return orders_; }

 private:
  bool take_optional(const Section& section) {
    if (section.tag == kLoop) keep(section, loop_);
    if (section.tag == kOrders) keep(section, orders_);
    return std::islower(static_cast<unsigned char>(section.tag[0])) != 0;
  }

  static void keep(const Section& section, std::optional<Section>& place) {
    if (place) throw FormatError(section.payload_offset, "a second section " + section.tag);
    place = section;
  }

  ByteReader& file_;
  int left_;
  std::optional<Section> loop_;
  std::optional<Section> orders_;
};

/// Those of all segments. A clip without signals counts as one signal.
std::uint64_t sample_count(const CompressedClip& clip) {
  const int signals =
      clip.skeleton.channel_count() + (clip.correction ? clip.correction->signal_count() : 0);
  return static_cast<std::uint64_t>(clip.segment_layout().coded_frames()) *
         static_cast<std::uint64_t>(std::max(signals, 1));
}

/// Makes a file as long as its samples ask for: FORMAT.md, Limits.
std::vector<std::byte> with_room(ByteWriter file, std::uint64_t samples) {
  const std::size_t size = file.bytes().size();
  if (samples <= runtime::most_values_of(size)) return file.release();
  std::size_t zeros = 0;
  while (samples > runtime::most_values_of(size + kSectionHead + zeros)) ++zeros;
  write_section(file, "room", std::vector<std::byte>(zeros));
  std::vector<std::byte> bytes = file.release();
  bytes[kSections] = static_cast<std::byte>(std::to_integer<int>(bytes[kSections]) + 1);
  return bytes;
}

}  // namespace

std::vector<std::byte> write_container(const CompressedClip& clip) {
  return write_container(Container{clip});
}

std::vector<std::byte> write_container(const Container& container) {
  const CompressedClip& clip = container.clip;
  check_room({clip.skeleton, clip.sample_rate_hz, clip.segment_layout(),
              clip.correction ? static_cast<int>(clip.correction->effectors.size()) : 0});
  ByteWriter file;
  file.append(bytes_of(kMagic));
  file.write(kVersion);
  file.write(static_cast<std::uint16_t>(3 + (clip.segments ? 1 : 0) + (clip.correction ? 1 : 0) +
                                        (clip.ends ? 1 : 0) + (clip.loop != Loop::None ? 1 : 0) +
                                        (turns_axes(clip) ? 1 : 0) + (reorders(clip) ? 1 : 0)));
  if (is_adaptive(container))
    write_section(file, "JNTS", encode_joints(clip.coded_skeleton()));
  else
    write_section(file, "SKEL", encode_skeleton(clip.coded_skeleton()));
  write_section(file, "CLIP", write_description(container));
  if (clip.segments) write_section(file, "SEGS", write_segments(*clip.segments));
  write_section(file, motion_tag(container), clip.motion);
  if (clip.correction) write_section(file, "IKCO", write_correction(*clip.correction));
  if (clip.ends) write_section(file, kEnds, clip.ends->write());
  if (turns_axes(clip)) write_section(file, kAxes, write_axes(clip.skeleton, clip.forms));
  if (clip.loop != Loop::None)
    write_section(file, kLoop, std::vector{static_cast<std::byte>(clip.loop)});
  if (reorders(clip)) write_section(file, kOrders, write_orders(clip.skeleton));
  return with_room(std::move(file), sample_count(clip));
}

namespace {

Container read(std::span<const std::byte> bytes, bool wavelets_only) {
  ByteReader file(bytes);
  const auto magic = file.take(kMagic.size());
  if (!std::equal(magic.begin(), magic.end(), bytes_of(kMagic).begin()))
    throw FormatError(0, "not a Mocapress file");
  const auto version = file.read<std::uint16_t>();
  if (version != kVersion)
    throw FormatError(4, "version " + std::to_string(version) +
                             " is not known here: a newer Mocapress is needed");
  SectionReader sections(file, file.read<std::uint16_t>());
  Container container;
  CompressedClip& clip = container.clip;
  const Section joints = sections.expect("SKEL", "JNTS");
  const bool for_adaptive = joints.tag == "JNTS";
  clip.skeleton = for_adaptive ? decode_joints(joints.payload, joints.payload_offset)
                               : decode_skeleton(joints.payload);
  const Section description = sections.expect("CLIP");
  read_description(description.payload, description.payload_offset, container);
  if (wavelets_only && container.of_comparison)
    file.fail("the motion is no wavelets but of a comparison method (section COMP)");
  if (for_adaptive && !is_adaptive(container))
    file.fail("section JNTS without the coding adaptive");
  Section motion = sections.expect(motion_tag(container), is_adaptive(container) ? "SEGS" : "");
  if (motion.tag == "SEGS") {
    const Section segments = std::move(motion);
    clip.segments = read_segments(segments.payload, segments.payload_offset, clip.frames);
    motion = sections.expect(motion_tag(container));
    const auto& sizes = clip.segments->bytes;
    if (std::accumulate(sizes.begin(), sizes.end(), std::size_t{0}) != motion.payload.size())
      throw FormatError(segments.payload_offset + 12, "the segments are not as large as MOTN");
  }
  clip.motion.assign(motion.payload.begin(), motion.payload.end());
  const bool adaptive = is_adaptive(container);
  const auto [correction, ends, axes] = sections.take_last<3>(
      {container.of_comparison ? "" : "IKCO", adaptive ? kEnds : "", adaptive ? kAxes : ""});
  if (correction)
    clip.correction =
        read_correction(correction->payload, correction->payload_offset, clip.skeleton);
  if (ends)
    clip.ends =
        read_ends(ends->payload, ends->payload_offset, clip.frames, clip.skeleton.channel_count());
  file.expect_end();
  if (const std::optional<Section>& loop = sections.loop()) {
    ByteReader reader(loop->payload, loop->payload_offset);
    clip.loop = read_enum(reader, Loop::Repeats, Loop::Follows, "kind of loop");
    reader.expect_end();
  }
  if (axes || sections.orders()) clip.forms = rotation_forms(clip.skeleton);
  if (axes) read_axes(axes->payload, axes->payload_offset, clip.skeleton, clip.forms);
  if (sections.orders())
    clip.skeleton = with_forms(clip.skeleton, read_orders(*sections.orders(), clip.skeleton));
  const std::uint64_t samples = sample_count(clip);
  if (samples > runtime::kMostValues)
    throw FormatError(description.payload_offset + 8, "more than 2^26 values");
  if (samples > runtime::most_values_of(bytes.size()))
    throw FormatError(motion.payload_offset, "more samples than so few bytes may stand for");
  return container;
}

}  // namespace

CompressedClip read_container(std::span<const std::byte> bytes) {
  return read(bytes, true).clip;
}

Container read_any_container(std::span<const std::byte> bytes) {
  return read(bytes, false);
}

CompressedClip load_mcpr(const std::filesystem::path& path) {
  try {
    return read_container(read_bytes(path));
  } catch (const FormatError& error) {
    throw InputError(path.string(), 0, 0, error.what());
  }
}

void save_mcpr(const std::filesystem::path& path, const CompressedClip& clip) {
  write_bytes(path, write_container(clip));
}

}  // namespace mocapress
