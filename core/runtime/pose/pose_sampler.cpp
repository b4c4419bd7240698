// SPDX-License-Identifier: MIT
#include "core/runtime/pose/pose_sampler.h"

#include <algorithm>
#include <bit>
#include <bitset>
#include <cmath>
#include <cstring>
#include <iterator>

#include "core/runtime/decode/row_kernels.h"
#include "core/runtime/format/end_poses.h"
#include "core/runtime/format/joint_model.h"
#include "core/runtime/format/trigonometry.h"
#include "core/runtime/pose/conventions.h"
#include "core/runtime/pose/instant_weights.h"
#include "core/runtime/pose/pose_cursor.h"
#include "core/runtime/pose/pose_selection.h"

namespace mocapress::runtime {
namespace {

/// The kinds of a clip's columns: as a loop has them, else found by what reads them.
class ColumnKinds {
 public:
  explicit ColumnKinds(const mcpr_cooked& clip)
      : listed_(clip.loop == LoopKind::Follows ? clip.at<ColumnKind>(clip.column_kinds) : nullptr) {
    if (listed_ != nullptr) return;
    const auto* const rotors = clip.at<RotorGroup>(clip.rotors);
    for (int g = 0; g < clip.rotor_groups; ++g)
      for (int a = 0; a < rotors[g].angles; ++a)
        for (int i = 0; i < kGroup; ++i)
          angles_[static_cast<std::size_t>(kGroup * rotors[g].vector[a] + i)] = true;
    const auto* const turns = clip.at<OtherTurn>(clip.turns);
    for (int i = 0; i < clip.other_turns; ++i)
      if (turns[i].axis != OtherTurn::kConstant) angles_[turns[i].column] = true;
    const auto* const added = clip.at<AddedColumn>(clip.added);
    for (int i = 0; i < clip.added_columns; ++i)
      if (angles_[added[i].to]) angles_[added[i].from] = true;
  }

  ColumnKind of(int column) const {
    if (listed_ != nullptr) return listed_[column];
    return angles_[static_cast<std::size_t>(column)] ? ColumnKind::HalfAngle : ColumnKind::Straight;
  }

 private:
  const ColumnKind* listed_;
  std::bitset<kMostColumns> angles_;
};

class Sampler {
 public:
  Sampler(const mcpr_cooked& clip, const PoseKernels& kernels, const mcpr_sample_request& request,
          const mcpr_selection* selection, mcpr_cursor* cursor)
      : clip_(clip),
        kernels_(kernels),
        request_(request),
        selection_(selection),
        cursor_(cursor),
        left_out_(static_cast<int>(request.bands_left_out)) {
    for (int p = 0; p < clip.parts; ++p)
      kept_bands_ = std::max<int>(kept_bands_, clip.part(p).kept_bands);
    for (int p = 0; p < clip.parts; ++p) wanted_samples_ |= 1U << clip.part(p).kept_bands;
  }

  void run(const PlaceInClip& place, float* out) {
    if (place.across > 0)
      make_columns_across(place.across);
    else
      make_columns(place.frame);
    add_columns();
    put_out(out);
  }

 private:
  bool is_wanted(int group) const {
    return selection_ == nullptr || selection_->wanted[static_cast<std::size_t>(group)];
  }

  /// Sums the entries of a segment for each column.
  void sum_entries(int segment, const InstantWeights& weights, std::int32_t* whole) const {
    for (int e = 0; e < clip_.entry_parts(); ++e) {
      const int first = kMostGroupsOfPart * e;
      kernels_.sum_entries(clip_.at<std::byte>(std::uint32_t{0}),
                           &clip_.entries_of(segment, e, left_out_), weights.band + left_out_,
                           weights.levels - left_out_,
                           std::min(static_cast<int>(clip_.row_groups) - first, kMostGroupsOfPart),
                           whole + kGroup * first);
    }
  }

  void make_part(int segment, int p, const InstantWeights& weights, const std::int32_t* entries,
                 float* columns) const {
    const CookedPart& part = clip_.part(p);
    const GroupRange groups =
        selection_ == nullptr ? GroupRange{0, part.groups} : selection_->parts[p];
    if (groups.count == 0) return;
    const CookedRows& rows = clip_.rows_of(segment, p);
    const int kept = std::min<int>(part.kept_bands, weights.levels);
    const SampleWeights& samples = weights.samples[kept];
    const int first = kGroup * (part.first_group + groups.first);
    kernels_.make_columns({.clip = clip_.at<std::byte>(std::uint32_t{0}),
                           .bands = clip_.at<CookedBand>(rows.bands),
                           .weights_of_bands = weights.band,
                           .first_band = left_out_,
                           .kept_bands = kept,
                           .samples = clip_.at<std::byte>(rows.samples),
                           .first_sample = samples.first_row,
                           .weights = samples.of_row,
                           .groups_of_part = part.groups,
                           .first_group = groups.first,
                           .groups = groups.count,
                           .wide = part.wide_samples != 0,
                           .unit = weights.unit * rows.unit,
                           .entries = entries + first,
                           .scales = clip_.at<std::byte>(rows.scales),
                           .columns = columns + first});
  }

  void make_segment(int segment, int frame, float share, float* columns) const {
    const SegmentLayout layout = clip_.layout();
    InstantWeights weights;
    weights.set(kernels_, clip_.wavelet, layout.frames_of(segment), frame - layout.first(segment),
                share, kept_bands_, wanted_samples_);
    alignas(32) std::int32_t entries[kMostColumns];
    sum_entries(segment, weights, entries);
    for (int p = 0; p < clip_.parts; ++p) make_part(segment, p, weights, entries, columns);
  }

  /// Makes a frame, which may lie in an overlap of two segments.
  void make_frame(int frame, float* columns) const {
    const SegmentLayout layout = clip_.layout();
    const SegmentLayout::Stretch stretch = layout.stretch_at(frame);
    if (stretch.shared < 0) return make_segment(stretch.segment, frame, 0, columns);
    float later[kMostColumns];
    make_segment(stretch.segment - 1, frame, 0, columns);
    make_segment(stretch.segment, frame, 0, later);
    mix(later, share_of_later(layout, stretch.shared), columns);
  }

  /// columns += share * (others - columns), for the wanted groups.
  void mix(const float* others, float share, float* columns) const {
    for (int g = 0; g < static_cast<int>(clip_.row_groups); ++g) {
      if (!is_wanted(g)) continue;
      for (int c = kGroup * g; c < kGroup * g + kGroup; ++c)
        columns[c] += share * (others[c] - columns[c]);
    }
  }

  void make_columns(double frame) {
    const SegmentLayout layout = clip_.layout();
    const auto [before, share] = between_frames(layout.frames, frame);
    if (const SegmentLayout::Stretch stretch = layout.stretch_at(before);
        is_liftable(stretch, {before, share})) {
      if (cursor_ != nullptr && cursor_->keep(kernels_, before, share > 0, left_out_))
        blend_kept(before, share);
      else
        make_segment(stretch.segment, before, share, columns_);
    } else {
      make_frame(before, columns_);
      if (share > 0) {
        float next[kMostColumns];
        make_frame(before + 1, next);
        mix(next, share, columns_);
      }
    }
    add_ends(before, share);
  }

  void blend_kept(int frame, float share) {
    const float* const at = cursor_->frame(frame);
    if (share == 0) {
      std::memcpy(columns_, at, sizeof *at * kGroup * clip_.row_groups);
      return;
    }
    kernels_.blend(at, cursor_->frame(frame + 1), share,
                   kGroup * static_cast<int>(clip_.row_groups), columns_);
  }

  /// Weight of an end correction at a frame.
  float end_share_of(int end, int frame) const {
    return clip_.end_reaches.share_at(end, frame, static_cast<int>(clip_.frames));
  }

  void add_ends(int frame, float share) {
    for (int end = 0; end < kMostEnds && clip_.end_reaches.frames[end] > 0; ++end) {
      float lacking = end_share_of(end, frame);
      if (share > 0) lacking += share * (end_share_of(end, frame + 1) - lacking);
      if (lacking > 0) add_end(end, lacking);
    }
  }

  void add_end(int end, float share) {
    const int segment = end == kFirstPose ? 0 : clip_.segments - 1;
    const auto* lacking = clip_.at<std::int16_t>(clip_.end_values()) + clip_.lacking_before(end);
    for (int p = 0; p < clip_.parts; ++p) {
      const CookedPart& part = clip_.part(p);
      const CookedRows& rows = clip_.rows_of(segment, p);
      const float unit = share * clip_.end_units[end] * rows.unit;
      float* const columns = columns_ + kGroup * part.first_group;
      const auto* const steps = clip_.at<float>(rows.scales);
      const auto* const halves = clip_.at<std::uint16_t>(rows.scales) + 2 * kGroup * part.groups;
      for (int g = 0; g < part.groups; ++g)
        for (unsigned left = clip_.end_marks(end)[part.first_group + g]; left != 0;
             left &= left - 1) {
          const int c = kGroup * g + std::countr_zero(left);
          const float step = part.wide_samples != 0 ? steps[c] : from_upper_half(halves[c]);
          columns[c] += unit * step * static_cast<float>(*lacking++);
        }
    }
  }

  /// Makes the columns between the last frame and the first: angles go the shorter way, and roots
  /// of a loop continue their last step.
  void make_columns_across(float share) {
    constexpr float kHalfTurn = 3.14159265F;
    const int last = static_cast<int>(clip_.frames) - 1;
    float first[kMostColumns];
    float before[kMostColumns];
    make_frame(last, columns_);
    make_frame(0, first);
    make_frame(std::max(last - 1, 0), before);
    const ColumnKinds kinds(clip_);
    for (int c = 0; c < kGroup * static_cast<int>(clip_.row_groups); ++c) {
      float way = first[c] - columns_[c];
      switch (kinds.of(c)) {
        case ColumnKind::Straight:
          break;
        case ColumnKind::HalfAngle:
          way = std::remainder(way, kHalfTurn);
          break;
        case ColumnKind::Root:
          way = columns_[c] - before[c];
          break;
      }
      columns_[c] += share * way;
    }
    if (!clip_.end_reaches.any()) return;
    add_end(0, share);
    add_end(1, 1 - share);
  }

  void add_columns() {
    std::copy_n(clip_.at<float>(clip_.bases), kGroup * (clip_.groups - clip_.row_groups),
                columns_ + kGroup * clip_.row_groups);
    const auto* const added = clip_.at<AddedColumn>(clip_.added);
    if (selection_ == nullptr) {
      for (int i = 0; i < clip_.added_columns; ++i)
        columns_[added[i].to] += columns_[added[i].from];
      return;
    }
    for (int i = 0; i < clip_.added_columns; ++i)
      if (is_wanted(added[i].to / kGroup)) columns_[added[i].to] += columns_[added[i].from];
  }

  void put_out(float* out) {
    put_rest(out);
    const std::uint32_t groups =
        selection_ == nullptr ? std::uint32_t{clip_.rotor_groups} : selection_->rotor_groups;
    for (std::uint32_t i = 0; i < groups; ++i) {
      const std::uint32_t g = selection_ == nullptr ? i : selection_->rotors[i].group;
      const RotorGroup& group = clip_.at<RotorGroup>(clip_.rotors)[g];
      const std::uint16_t* const places =
          selection_ == nullptr ? group.joint : selection_->rotors[i].place;
      const int joints = selection_ == nullptr ? group.joints : selection_->rotors[i].joints;
      const auto* const around = clip_.at<float>(group.around);
      if (request_.layout == MCPR_TRANSFORMS) {
        kernels_.turn_into(group, columns_, around, places, joints, out);
        continue;
      }
      RotorQuaternions quaternions;
      kernels_.turn(group, columns_, around, quaternions);
      for (int k = 0; k < joints; ++k) {
        const float wxyz[4] = {quaternions.of[0][k], quaternions.of[1][k], quaternions.of[2][k],
                               quaternions.of[3][k]};
        put_rotation(places[k], wxyz, out);
      }
    }
    put_other_turns(out);
    const auto* const moving = clip_.at<MovingAxis>(clip_.moving);
    for (int i = 0; i < clip_.moving_axes; ++i)
      if (const std::uint32_t at = place_of(moving[i].joint); at != mcpr_selection::kNowhere)
        put_translation(at, moving[i].axis, columns_[moving[i].column], out);
  }

  /// Writes the constant values.
  void put_rest(float* out) const {
    const auto* const rest = clip_.at<mcpr_transform>(clip_.rest);
    if (request_.layout == MCPR_TRANSFORMS && selection_ == nullptr) {
      std::memcpy(out, rest, sizeof *rest * clip_.joints);
      return;
    }
    if (request_.layout == MCPR_TRANSFORMS && selection_ != nullptr &&
        selection_->rest != nullptr) {
      std::memcpy(out, selection_->rest, sizeof *rest * selection_->joint_count);
      return;
    }
    for (std::uint32_t i = 0; i < joint_count(); ++i) {
      const mcpr_transform& joint = rest[selection_ == nullptr ? i : selection_->joints[i]];
      if (request_.layout == MCPR_TRANSFORMS) {
        std::memcpy(out + std::size_t{8} * i, &joint, sizeof joint);
        continue;
      }
      put_rotation(i, joint.rotation, out);
      for (int axis = 0; axis < 3; ++axis) put_translation(i, axis, joint.translation[axis], out);
    }
  }

  /// Writes the rotations of joints with more than three angles, or two about one axis.
  void put_other_turns(float* out) {
    for (int i = 0; i < clip_.other_turns;) {
      const auto* const turns = clip_.at<OtherTurn>(clip_.turns);
      const std::uint16_t joint = turns[i].joint;
      double q[4] = {1, 0, 0, 0};
      for (; i < clip_.other_turns && turns[i].joint == joint; ++i) {
        double by[4] = {1, 0, 0, 0};
        if (turns[i].axis == OtherTurn::kConstant) {
          for (int k = 0; k < 4; ++k)
            by[k] = static_cast<double>(clip_.at<float>(TableOffset{turns[i].column})[k]);
        } else {
          const double half = static_cast<double>(columns_[turns[i].column]);
          const auto [sine, cosine] = sine_and_cosine(half);
          by[0] = cosine;
          by[1 + turns[i].axis] = sine;
        }
        const double a[4] = {q[0], q[1], q[2], q[3]};
        q[0] = a[0] * by[0] - a[1] * by[1] - a[2] * by[2] - a[3] * by[3];
        q[1] = a[0] * by[1] + a[1] * by[0] + a[2] * by[3] - a[3] * by[2];
        q[2] = a[0] * by[2] - a[1] * by[3] + a[2] * by[0] + a[3] * by[1];
        q[3] = a[0] * by[3] + a[1] * by[2] - a[2] * by[1] + a[3] * by[0];
      }
      const float wxyz[4] = {static_cast<float>(q[0]), static_cast<float>(q[1]),
                             static_cast<float>(q[2]), static_cast<float>(q[3])};
      if (const std::uint32_t at = place_of(joint); at != mcpr_selection::kNowhere)
        put_rotation(at, wxyz, out);
    }
  }

  /// Position of a joint in the output, or kNowhere.
  std::uint32_t place_of(std::uint32_t joint) const {
    return selection_ == nullptr ? joint : selection_->places[joint];
  }
  std::uint32_t joint_count() const {
    return selection_ == nullptr ? clip_.joints : selection_->joint_count;
  }

  void put_rotation(std::uint32_t at, const float (&wxyz)[4], float* out) const {
    if (request_.layout == MCPR_TRANSFORMS) {
      for (int k = 0; k < 4; ++k) out[8 * at + static_cast<std::uint32_t>(k)] = wxyz[k];
    } else if (request_.layout == MCPR_ARRAYS) {
      for (std::uint32_t k = 0; k < 4; ++k) out[k * joint_count() + at] = wxyz[k];
    } else {
      const auto [w, x, y, z] = wxyz;
      const float m[3][3] = {{1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)},
                             {2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)},
                             {2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)}};
      for (std::uint32_t row = 0; row < 3; ++row) std::copy_n(m[row], 3, out + 12 * at + 4 * row);
    }
  }

  void put_translation(std::uint32_t at, int axis, float value, float* out) const {
    const auto a = static_cast<std::uint32_t>(axis);
    if (request_.layout == MCPR_TRANSFORMS)
      out[8 * at + 4 + a] = value;
    else if (request_.layout == MCPR_ARRAYS)
      out[(4 + a) * joint_count() + at] = value;
    else
      out[12 * at + 4 * a + 3] = value;
  }

  const mcpr_cooked& clip_;
  const PoseKernels& kernels_;
  const mcpr_sample_request& request_;
  const mcpr_selection* const selection_;  // null: all joints
  mcpr_cursor* const cursor_;
  const int left_out_;  // finest bands left out
  int kept_bands_ = 0;
  unsigned wanted_samples_ = 0;  // bit n: some part keeps n bands
  alignas(32) float columns_[kMostColumns];
};

}  // namespace

PlaceInClip place_in_clip(const mcpr_cooked& clip, const mcpr_sample_request& request,
                          double time) {
  return clip.wrapping(request.wrap).place(frame_of(clip, request.unit, time));
}

std::size_t values_of_joint(mcpr_layout layout) {
  if (layout == MCPR_TRANSFORMS) return 8;
  return layout == MCPR_ARRAYS ? 7 : 12;
}

namespace {

/// Overwrites the joints that step with their transforms at the earlier frame.
void hold_stepped(const mcpr_cooked& clip, const PoseKernels& kernels, const PlaceInClip& place,
                  const mcpr_sample_request& request, const mcpr_selection* selection, float* out) {
  const BetweenFrames between = between_frames(static_cast<int>(clip.frames), place.frame);
  if (between.share == 0 && place.across == 0) return;
  const std::size_t joints = selection == nullptr ? clip.joints : selection->joint_count;
  for (std::uint32_t i = 0; i < request.stepped_count; ++i) {
    const std::uint16_t joint = request.stepped[i];
    const std::size_t at = selection == nullptr ? joint : selection->places[joint];
    if (at == mcpr_selection::kNowhere) continue;
    mcpr_sample_request one = request;
    one.joints = &joint;
    one.joint_count = 1;
    one.selection = nullptr;
    one.convention = nullptr;
    one.parents = nullptr;
    one.stepped_count = 0;
    float values[12];
    sample(clip, kernels, {static_cast<double>(between.before), 0}, one, values);
    const std::size_t count = values_of_joint(request.layout);
    const bool is_apart = request.layout == MCPR_ARRAYS;
    for (std::size_t k = 0; k < count; ++k)
      out[is_apart ? k * joints + at : at * count + k] = values[k];
  }
}

}  // namespace

void sample(const mcpr_cooked& clip, const PoseKernels& kernels, const PlaceInClip& place,
            const mcpr_sample_request& request, float* out, mcpr_cursor* cursor) {
  const auto run = [&](const mcpr_selection* selection) {
    Sampler(clip, kernels, request, selection, cursor).run(place, out);
    if (request.stepped_count > 0) hold_stepped(clip, kernels, place, request, selection, out);
    const std::uint32_t joints = selection == nullptr ? clip.joints : selection->joint_count;
    if (request.parents != nullptr) place_in_model(request.layout, request.parents, joints, out);
    if (request.convention != nullptr) convert(*request.convention, request.layout, joints, out);
  };
  if (request.joints == nullptr) return run(request.selection);
  // Upper bound for places, rotors and parts.
  constexpr std::size_t kMost = sizeof(std::uint16_t) * kMostJoints +
                                sizeof(RotorPlaces) * (kMostJoints / kGroup) +
                                sizeof(GroupRange) * (kMostColumns / kGroup) + 3 * kAlignment;
  alignas(kAlignment) std::byte bytes[kMost];
  Memory memory(bytes, kMost);
  mcpr_selection selection(memory, clip);
  selection.select(request.joints, request.joint_count);
  run(&selection);
}

}  // namespace mocapress::runtime
