// SPDX-License-Identifier: MIT
#include "core/runtime/pose/pose_crowd.h"

#include <algorithm>
#include <cstring>
#include <new>
#include <utility>

#include "core/runtime/pose/pose_sampler.h"
#include "core/runtime/pose/prefetch.h"

namespace mocapress::runtime {
namespace {

/// Sorts by clip, then by bands left out, then by whole frame. A finer order would save no time.
std::uint64_t sort_key_of(const mcpr_crowd_request& request, const mcpr_character& character) {
  const PlaceInClip place =
      place_in_clip(*character.clip, request_of(request, character), character.time);
  static_assert(MCPR_MOST_BANDS_LEFT_OUT < 8);
  const auto clip = reinterpret_cast<std::uintptr_t>(character.clip) / kAlignment;
  return static_cast<std::uint64_t>(clip) << 32 | std::uint64_t{character.bands_left_out} << 29 |
         static_cast<std::uint64_t>(place.frame);
}

}  // namespace

mcpr_sample_request request_of(const mcpr_crowd_request& request, const mcpr_character& character) {
  return {.layout = request.layout,
          .unit = request.unit,
          .wrap = character.wrap,
          .path = request.path,
          .joints = nullptr,
          .joint_count = 0,
          .selection = character.selection,
          .bands_left_out = character.bands_left_out,
          .convention = request.convention,
          .parents = character.parents,
          .stepped = character.stepped,
          .stepped_count = character.stepped_count,
          .scratch = nullptr,
          .scratch_size = 0};
}

CrowdSorter::CrowdSorter(Memory& memory, std::uint32_t count)
    : count_(count),
      keys_(memory.take<Key>(count)),
      other_keys_(memory.take<Key>(count)),
      sorted_(memory.take<mcpr_character>(count)) {}

void CrowdSorter::sort(const mcpr_crowd_request& request, mcpr_character* characters) {
  bool is_sorted = true;
  for (std::uint32_t i = 0; i < count_; ++i) {
    keys_[i] = {sort_key_of(request, characters[i]), i};
    is_sorted = is_sorted && (i == 0 || keys_[i - 1].order <= keys_[i].order);
  }
  if (is_sorted) return;
  sort_keys();
  for (std::uint32_t i = 0; i < count_; ++i) sorted_[i] = characters[keys_[i].number];
  std::copy_n(sorted_, count_, characters);
}

/// Sorts by radix, from the lowest byte on. Skips bytes that are equal in all keys.
void CrowdSorter::sort_keys() {
  constexpr int kBytes = sizeof keys_->order;
  std::uint32_t counts[kBytes][256] = {};
  for (std::uint32_t i = 0; i < count_; ++i)
    for (int b = 0; b < kBytes; ++b) ++counts[b][keys_[i].order >> (8 * b) & 0xFF];
  for (int b = 0; b < kBytes; ++b) {
    std::uint32_t(&places)[256] = counts[b];
    if (places[keys_[0].order >> (8 * b) & 0xFF] == count_) continue;
    std::uint32_t next = 0;
    for (std::uint32_t& place : places) next += std::exchange(place, next);
    for (std::uint32_t i = 0; i < count_; ++i)
      other_keys_[places[keys_[i].order >> (8 * b) & 0xFF]++] = keys_[i];
    std::swap(keys_, other_keys_);
  }
}

PoseCrowd::PoseCrowd(Memory& memory)
    : frames_(
          reinterpret_cast<mcpr_cursor*>(memory.take<std::byte>(mcpr_cursor::kHead + kFrameBytes))),
      lifting_(memory.take<std::int16_t>(kLiftingNumbers)),
      posing_(memory.take<std::byte>(kMostScratchOfPose)),
      spots_(memory.take<Spot>(kAhead)) {}

PoseCrowd::Spot PoseCrowd::spot_of(const mcpr_crowd_request& request,
                                   const mcpr_character& character) {
  const mcpr_cooked& clip = *character.clip;
  const PlaceInClip place = place_in_clip(clip, request_of(request, character), character.time);
  Spot spot{place.frame, place.across, 0, -1};
  if (place.across > 0 || request.exact != 0) return spot;
  const SegmentLayout layout = clip.layout();
  const BetweenFrames between = between_frames(layout.frames, place.frame);
  const SegmentLayout::Stretch stretch = layout.stretch_at(between.before);
  spot.before = between.before;
  if (is_liftable(stretch, between)) spot.last = between.before + (between.share > 0 ? 1 : 0);
  return spot;
}

/// Chooses how many characters, from `first` on, share lifted frames, so that most time is saved.
PoseCrowd::Together PoseCrowd::together(const mcpr_character* characters, std::uint32_t first,
                                        std::uint32_t end) const {
  // Instructions per group of columns: saved for each character whose frames are lifted; the fixed
  // cost of lifting; the cost of each lifted frame.
  constexpr int kSaved = 470;
  constexpr int kLifting = 1600;
  constexpr int kFrame = 65;
  const mcpr_cooked& clip = *characters[first].clip;
  const int from = spots_[first].before;
  Together best;
  if (spots_[first].last < from) return best;
  const SegmentLayout::Stretch stretch = clip.layout().stretch_at(from);
  const int most =
      std::min(stretch.frames, mcpr_cursor::capacity_for(clip, kFrameBytes, kFewestLifted));
  int last = from;
  int most_saved = 0;
  int saved = -kLifting;
  for (std::uint32_t i = first; i < end; ++i) {
    const Spot& spot = spots_[i];
    if (characters[i].clip != &clip ||
        characters[i].bands_left_out != characters[first].bands_left_out || spot.before < from ||
        spot.last < spot.before || spot.last >= from + most)
      break;
    last = std::max(last, spot.last);
    saved += kSaved;
    if (const int now = saved - kFrame * (last - from + 1); now > most_saved) {
      most_saved = now;
      best = {i - first + 1, last};
    }
  }
  return best;
}

void PoseCrowd::pose(const mcpr_crowd_request& request, const mcpr_character* characters,
                     std::uint32_t count) {
  const PoseKernels& kernels = *poses_of(request.path);
  const auto pose_one = [&](std::uint32_t i, mcpr_cursor* frames) {
    const mcpr_character& character = characters[i];
    mcpr_sample_request one = request_of(request, character);
    one.scratch = posing_;
    one.scratch_size = kMostScratchOfPose;
    sample(*character.clip, kernels, {spots_[i].frame, spots_[i].across}, one, character.out,
           frames);
  };
  for (std::uint32_t begin = 0; begin < count;) {
    const std::uint32_t ahead = std::min(count - begin, kAhead);
    for (std::uint32_t i = 0; i < ahead; ++i) spots_[i] = spot_of(request, characters[i]);
    for (std::uint32_t i = 0; i < ahead;) {
      const Together lifted = together(characters, i, ahead);
      if (lifted.count == 0) {
        if (i + 1 < ahead && characters[i + 1].clip != characters[i].clip)
          prefetch_next(*characters[i + 1].clip);
        pose_one(i++, nullptr);
        continue;
      }
      const mcpr_cooked& clip = *characters[i].clip;
      const int first = spots_[i].before;
      new (frames_) mcpr_cursor(mcpr_cursor::empty(clip, kFrameBytes, kFewestLifted));
      frames_->keep_run(kernels, first, lifted.last - first + 1,
                        static_cast<int>(characters[i].bands_left_out),
                        {lifting_, kLiftingNumbers});
      for (const std::uint32_t end = i + lifted.count; i < end; ++i) pose_one(i, frames_);
    }
    begin += ahead;
    characters += ahead;
  }
}

}  // namespace mocapress::runtime
