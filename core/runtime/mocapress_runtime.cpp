// SPDX-License-Identifier: MIT
// The C interface: checks the arguments, then calls the implementation.
#include "core/runtime/mocapress_runtime.h"

#include <cmath>
#include <cstring>
#include <limits>
#include <new>

#include "core/runtime/decode/file_loader.h"
#include "core/runtime/decode/frame_decoder.h"
#include "core/runtime/format/format_limits.h"

using namespace mocapress::runtime;

static_assert(MCPR_ALIGNMENT == kAlignment);
static_assert(MCPR_TIERS_HEAD_BYTES == kFileHead + kSectionHead + 1 + kMostTierBytes * kMostTiers);

namespace {

constexpr mcpr_result argument(const char* message) {
  return failure(MCPR_ARGUMENT, 0, message);
}

bool is_aligned(const void* memory) {
  return reinterpret_cast<std::uintptr_t>(memory) % kAlignment == 0;
}

mcpr_result check_file(const void* file, std::size_t size, const mcpr_limits& limits,
                       FileSections& sections, std::uint64_t& read_bytes) {
  if (file == nullptr && size > 0) return argument("no file");
  const mcpr_result result = read_sections(file, size, limits, sections);
  return failed(result) ? result : find_read_bytes(sections, limits, read_bytes);
}

bool is_clip(const mcpr_clip* clip) {
  return clip != nullptr && clip->block.mark == ClipBlock::kMark;
}

mcpr_result check_request(const mcpr_clip* clip, const mcpr_request* request) {
  if (!is_clip(clip)) return argument("no clip");
  if (request == nullptr || !is_possible(clip->block, *request))
    return argument("unsupported output, path or channel list");
  return kOk;
}

mcpr_result check_scratch(const mcpr_clip* clip, const mcpr_request* request, const void* scratch,
                          std::size_t size) {
  return check_memory(scratch, size, mcpr_scratch_bytes(clip, request),
                      "too little scratch memory");
}

}  // namespace

const char* mcpr_status_message(mcpr_status status) {
  switch (status) {
    case MCPR_OK:
      return "done";
    case MCPR_NOT_A_CLIP:
      return "not a Mocapress file";
    case MCPR_UNKNOWN_VERSION:
      return "unknown version";
    case MCPR_DAMAGED:
      return "damaged file";
    case MCPR_INVALID:
      return "invalid file";
    case MCPR_UNSUPPORTED:
      return "the coding is not adaptive";
    case MCPR_LIMIT:
      return "beyond the limits";
    case MCPR_MEMORY:
      return "too little memory";
    case MCPR_ARGUMENT:
      return "impossible request";
    case MCPR_NO_MEMORY:
      return "no memory";
    case MCPR_MISALIGNED:
      return "memory not aligned";
  }
  return "unknown status";
}

void mcpr_default_limits(mcpr_limits* out) {
  if (out == nullptr) return;
  *out = {.frames = kMostFrames,
          .joints = kMostJoints,
          .channels = kMostChannels,
          .values = kMostValues,
          .scratch_bytes = kMostScratchBytes,
          .resident_bytes = kMostResidentBytes,
          .solver_iterations = kMostSweeps,
          .tiers = 0};
}

mcpr_status mcpr_inspect(const void* file, size_t size, const mcpr_limits* limits, mcpr_info* info,
                         mcpr_result* report) {
  if (info == nullptr) return tell(report, argument("no place was given for what the file holds"));
  const mcpr_limits applied = or_default(limits);
  FileSections sections;
  std::uint64_t bytes = 0;
  const mcpr_result result = check_file(file, size, applied, sections, bytes);
  if (!failed(result)) *info = info_of(sections, bytes);
  return tell(report, result);
}

mcpr_status mcpr_tier_of(const void* file, size_t size, uint32_t tier, mcpr_tier* out,
                         mcpr_result* report) {
  if (out == nullptr || (file == nullptr && size > 0))
    return tell(report, argument("no file, or no output"));
  Cursor cursor(static_cast<const std::uint8_t*>(file), size);
  std::uint16_t count = 0;
  mcpr_result result = read_head(cursor, count);
  if (failed(result)) return tell(report, result);
  Cursor tag = cursor;
  const std::uint8_t* const first = tag.take(4);
  if (first == nullptr || std::memcmp(first, "TIER", 4) != 0)
    return tell(report, argument("the file has no tiers"));
  Section section;
  TierTable tiers;
  if (failed(result = read_section(cursor, section))) return tell(report, result);
  if (failed(result = read_tiers(section.payload, tiers))) return tell(report, result);
  if (tier >= static_cast<std::uint32_t>(tiers.count))
    return tell(report, argument("no such tier"));
  const Tier& found = tiers.tier[tier];
  *out = {.bytes = tiers.file_bytes(static_cast<int>(tier)),
          .bands_left_out = static_cast<std::uint32_t>(found.bands_left_out),
          .error = found.eps_cm,
          .max_error = found.max_error_cm};
  return tell(report, kOk);
}

mcpr_status mcpr_read(const void* file, size_t size, const mcpr_limits* limits, void* scratch,
                      size_t scratch_size, size_t* resident_bytes, mcpr_result* report) {
  if (resident_bytes == nullptr)
    return tell(report, argument("no place was given for the size of the clip"));
  const mcpr_limits applied = or_default(limits);
  FileSections sections;
  std::uint64_t bytes = 0;
  const mcpr_result result = check_file(file, size, applied, sections, bytes);
  if (failed(result)) return tell(report, result);
  return tell(report, read_into(sections, bytes, applied, scratch, scratch_size, *resident_bytes));
}

mcpr_status mcpr_build(void* scratch, size_t scratch_size, void* resident, size_t resident_size,
                       const mcpr_clip** clip, mcpr_result* report) {
  if (clip == nullptr) return tell(report, argument("no place was given for the clip"));
  if (scratch == nullptr || !is_aligned(scratch) || scratch_size < sizeof(FileLoader))
    return tell(report, argument("not the scratch memory of mcpr_read"));
  auto* const opening = std::launder(static_cast<FileLoader*>(scratch));
  if (opening->mark != FileLoader::kMark)
    return tell(report, argument("mcpr_read did not succeed"));
  const std::uint64_t bytes = opening->resident_size();
  const mcpr_result result =
      check_memory(resident, resident_size, bytes, "too little memory for the clip");
  if (failed(result)) return tell(report, result);
  std::memset(resident, 0, static_cast<std::size_t>(bytes));
  *clip = opening->build(static_cast<std::byte*>(resident));
  return tell(report, kOk);
}

void mcpr_clip_describe(const mcpr_clip* clip, mcpr_clip_info* out) {
  if (out == nullptr) return;
  *out = {};
  if (!is_clip(clip)) return;
  const ClipBlock& block = clip->block;
  *out = {.sample_rate = block.sample_rate,
          .frames = static_cast<std::uint32_t>(block.segments.frames),
          .joints = block.joint_count,
          .channels = block.channel_count,
          .effectors = block.effector_count,
          .bands = static_cast<std::uint32_t>(block.motion(0).band_count() - 1),
          .resident_bytes = static_cast<std::size_t>(block.total_bytes),
          .skeleton_bytes = static_cast<std::size_t>(block.skeleton_bytes),
          .loop_frames = static_cast<std::uint32_t>(block.turn_frames()),
          .tracks = mcpr_track_count(block.scalar_tracks())};
}

mcpr_status mcpr_clip_joint(const mcpr_clip* clip, uint32_t joint, mcpr_joint* out,
                            mcpr_result* report) {
  if (!is_clip(clip) || out == nullptr || joint >= clip->block.joint_count)
    return tell(report, argument("no such joint"));
  const JointModel& model = clip->block.joint_models()[joint];
  *out = {};
  out->name = clip->block.at<char>(clip->block.names) + model.name;
  out->parent = model.parent;
  out->first_channel = model.first_channel;
  out->channels = model.channels;
  out->has_end_site = model.has_end_site ? 1 : 0;
  for (int i = 0; i < 3; ++i) {
    out->offset[i] = static_cast<float>(model.offset[i]);
    out->end_site[i] = model.end_site[i];
  }
  std::memcpy(out->kinds, model.kinds, sizeof out->kinds);
  return tell(report, kOk);
}

int32_t mcpr_find_joint(const mcpr_clip* clip, const char* name) {
  if (!is_clip(clip) || name == nullptr) return -1;
  const char* const names = clip->block.at<char>(clip->block.names);
  for (std::uint32_t j = 0; j < clip->block.joint_count; ++j)
    if (std::strcmp(names + clip->block.joint_models()[j].name, name) == 0)
      return static_cast<std::int32_t>(j);
  return -1;
}

int mcpr_path_exists(mcpr_path path) {
  return rows_of(path) != nullptr ? 1 : 0;
}

size_t mcpr_frame_values(const mcpr_clip* clip, const mcpr_request* request) {
  return failed(check_request(clip, request)) ? 0 : values_of_frame(clip->block, *request);
}

size_t mcpr_scratch_bytes(const mcpr_clip* clip, const mcpr_request* request) {
  if (failed(check_request(clip, request))) return 0;
  Memory memory;
  const FrameDecoder measured(memory, clip->block, *request);
  return static_cast<std::size_t>(memory.used());
}

mcpr_status mcpr_decode_frames(const mcpr_clip* clip, const mcpr_request* request, uint32_t first,
                               uint32_t count, float* out, void* scratch, size_t scratch_size,
                               mcpr_result* report) {
  mcpr_result result = check_request(clip, request);
  if (failed(result)) return tell(report, result);
  const auto frames = static_cast<std::uint32_t>(clip->block.segments.frames);
  if (first > frames || count > frames - first || (out == nullptr && count > 0))
    return tell(report, argument("frames outside the clip, or no output"));
  if (failed(result = check_scratch(clip, request, scratch, scratch_size)))
    return tell(report, result);
  Memory memory(scratch, scratch_size);
  FrameDecoder(memory, clip->block, *request)
      .decode(static_cast<int>(first), static_cast<int>(count), out);
  return tell(report, kOk);
}

mcpr_status mcpr_decode_moment(const mcpr_clip* clip, const mcpr_request* request, double time,
                               float* out, void* scratch, size_t scratch_size,
                               mcpr_result* report) {
  mcpr_result result = check_request(clip, request);
  if (failed(result)) return tell(report, result);
  const Wrapping wrapping{clip->block.segments.frames, clip->block.loop, request->wrap};
  if (!wrapping.is_possible() || request->unit < MCPR_FRAMES || request->unit > MCPR_SECONDS)
    return tell(report, argument("no such unit or wrap, or the clip is not a loop"));
  const double frame = request->unit == MCPR_SECONDS ? time * clip->block.sample_rate : time;
  if (!std::isfinite(frame) || out == nullptr)
    return tell(report, argument("no finite instant, or no output"));
  if (failed(result = check_scratch(clip, request, scratch, scratch_size)))
    return tell(report, result);
  Memory memory(scratch, scratch_size);
  FrameDecoder(memory, clip->block, *request).sample_at(wrapping.place(frame), out);
  return tell(report, kOk);
}
