// SPDX-License-Identifier: MIT
#include "core/runtime/pose/pose_sampler.h"

#include <algorithm>
#include <bit>
#include <bitset>
#include <cmath>
#include <cstring>
#include <iterator>
#include <new>

#include "core/runtime/decode/row_kernels.h"
#include "core/runtime/format/end_poses.h"
#include "core/runtime/format/joint_model.h"
#include "core/runtime/format/trigonometry.h"
#include "core/runtime/pose/conventions.h"
#include "core/runtime/pose/instant_weights.h"
#include "core/runtime/pose/pose_cursor.h"
#include "core/runtime/pose/pose_packing.h"
#include "core/runtime/pose/pose_selection.h"

namespace mocapress::runtime {
namespace {

/// The kind of each column. A loop of kind Follows has a table of kinds. For other clips, the
/// tables that use the columns tell which are half angles.
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

/// Columns are made in sets of kMostGroupsOfPart groups, so that the work space is small.
constexpr int kSetColumns = kGroup * kMostGroupsOfPart;

/// Work space for making a pose, besides its columns.
struct PoseWork {
  InstantWeights weights;
  alignas(32) std::int32_t entries[kSetColumns];
  float later[kSetColumns];
  float next[kSetColumns];
  float before[kSetColumns];
};

class Sampler {
 public:
  /// `columns` has room for all columns of the clip. `cursor` has cached the frames that are
  /// needed; null: sample without a cursor.
  Sampler(const mcpr_cooked& clip, const PoseKernels& kernels, const mcpr_sample_request& request,
          const mcpr_selection* selection, const mcpr_cursor* cursor, PoseWork& work,
          float* columns)
      : clip_(clip),
        kernels_(kernels),
        request_(request),
        selection_(selection),
        cursor_(cursor),
        left_out_(static_cast<int>(request.bands_left_out)),
        work_(work),
        columns_(columns) {
    for (int p = 0; p < clip.parts; ++p)
      kept_bands_ = std::max<int>(kept_bands_, clip.part(p).kept_bands);
    for (int p = 0; p < clip.parts; ++p) wanted_samples_ |= 1U << clip.part(p).kept_bands;
  }

  void run(const PlaceInClip& place, float* out) {
    make(place);
    put_rest(out);
    put_moving(out);
  }

  /// Overwrites the moving parts of the selected joints, in a pose that is complete already.
  void run_over(const PlaceInClip& place, float* out) {
    make(place);
    put_moving(out);
  }

 private:
  bool is_wanted(int group) const {
    return selection_ == nullptr || selection_->wanted[static_cast<std::size_t>(group)];
  }

  GroupRange groups_of_set(int set) const {
    const int first = kMostGroupsOfPart * set;
    return {static_cast<std::uint16_t>(first),
            static_cast<std::uint16_t>(
                std::min(static_cast<int>(clip_.row_groups) - first, kMostGroupsOfPart))};
  }

  /// Makes the columns of a part, as far as its groups are in the set `set`. `columns` are the
  /// columns of the set.
  void make_part(int segment, int p, GroupRange set, float* columns) const {
    const InstantWeights& weights = work_.weights;
    const CookedPart& part = clip_.part(p);
    const GroupRange wanted =
        selection_ == nullptr ? GroupRange{0, part.groups} : selection_->parts[p];
    const int first = std::max<int>(part.first_group + wanted.first, set.first);
    const int end = std::min(part.first_group + wanted.first + wanted.count, set.first + set.count);
    if (first >= end) return;
    const CookedRows& rows = clip_.rows_of(segment, p);
    const int kept = std::min<int>(part.kept_bands, weights.levels);
    const SampleWeights& samples = weights.samples[kept];
    const std::ptrdiff_t row_bytes = part.sample_place(part.groups);
    const int column = kGroup * (first - set.first);
    kernels_.make_columns(
        {.clip = clip_.at<std::byte>(std::uint32_t{0}),
         .bands = clip_.at<CookedBand>(rows.bands),
         .weights_of_bands = weights.band,
         .first_band = left_out_,
         .kept_bands = kept,
         .samples = clip_.at<std::byte>(rows.samples) + samples.first_row * row_bytes +
                    part.sample_place(first - part.first_group),
         .row_bytes = row_bytes,
         .weights = samples.of_row,
         .groups_of_part = part.groups,
         .first_group = first - part.first_group,
         .groups = end - first,
         .narrow = part.narrow_within(first - part.first_group, end - part.first_group),
         .wide = part.is_wide != 0,
         .unit = weights.unit * rows.unit,
         .entries = work_.entries + column,
         .scales = clip_.at<std::byte>(rows.scales),
         .columns = columns + column});
  }

  /// Makes the columns of a set from one segment, with the weights in the work space.
  void make_set(int segment, int set, float* columns) const {
    const InstantWeights& weights = work_.weights;
    const GroupRange groups = groups_of_set(set);
    kernels_.sum_entries(clip_.at<std::byte>(std::uint32_t{0}),
                         &clip_.entries_of(segment, set, left_out_), weights.band + left_out_,
                         weights.levels - left_out_, groups.count, work_.entries);
    for (int p = 0; p < clip_.parts; ++p) make_part(segment, p, groups, columns);
  }

  void set_weights(int segment, int frame, float share) const {
    const SegmentLayout layout = clip_.layout();
    work_.weights.set(kernels_, clip_.wavelet, layout.frames_of(segment),
                      frame - layout.first(segment), share, kept_bands_, wanted_samples_);
  }

  void make_segment(int segment, int frame, float share) const {
    set_weights(segment, frame, share);
    for (int set = 0; set < clip_.entry_parts(); ++set)
      make_set(segment, set, columns_ + kSetColumns * set);
  }

  /// Makes the columns of a set at a frame, which may lie in the overlap of two segments.
  void make_frame(int frame, int set, float* columns) const {
    const SegmentLayout layout = clip_.layout();
    const SegmentLayout::Stretch stretch = layout.stretch_at(frame);
    if (stretch.shared >= 0) {
      set_weights(stretch.segment - 1, frame, 0);
      make_set(stretch.segment - 1, set, columns);
    }
    set_weights(stretch.segment, frame, 0);
    make_set(stretch.segment, set, stretch.shared < 0 ? columns : work_.later);
    if (stretch.shared >= 0) mix(set, work_.later, share_of_later(layout, stretch.shared), columns);
  }

  /// columns += share * (others - columns), for the wanted groups of a set.
  void mix(int set, const float* others, float share, float* columns) const {
    const GroupRange groups = groups_of_set(set);
    for (int g = 0; g < groups.count; ++g) {
      if (!is_wanted(groups.first + g)) continue;
      for (int c = kGroup * g; c < kGroup * g + kGroup; ++c)
        columns[c] += share * (others[c] - columns[c]);
    }
  }

  void make(const PlaceInClip& place) {
    if (place.across > 0)
      make_columns_across(place.across);
    else
      make_columns(place.frame);
    add_columns();
  }

  void make_columns(double frame) {
    const SegmentLayout layout = clip_.layout();
    const auto [before, share] = between_frames(layout.frames, frame);
    if (cursor_ != nullptr) {
      blend_kept(before, share);
    } else if (const SegmentLayout::Stretch stretch = layout.stretch_at(before);
               is_liftable(stretch, {before, share})) {
      make_segment(stretch.segment, before, share);
    } else {
      for (int set = 0; set < clip_.entry_parts(); ++set) {
        float* const columns = columns_ + kSetColumns * set;
        make_frame(before, set, columns);
        if (share == 0) continue;
        make_frame(before + 1, set, work_.next);
        mix(set, work_.next, share, columns);
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

  /// The weight of an end correction at a frame.
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
      const auto* const steps = clip_.at<float>(rows.scales) + kGroup * part.groups;
      const auto* const halves = clip_.at<std::uint16_t>(rows.scales) + 2 * kGroup * part.groups;
      for (int g = 0; g < part.groups; ++g)
        for (unsigned left = clip_.end_marks(end)[part.first_group + g]; left != 0;
             left &= left - 1) {
          const int c = kGroup * g + std::countr_zero(left);
          const float step = part.is_wide != 0 ? steps[c] : from_upper_half(halves[c]);
          columns[c] += unit * step * static_cast<float>(*lacking++);
        }
    }
  }

  /// Makes the columns between the last frame and the first: angles go the shorter way round, and
  /// roots of a loop repeat their last step.
  void make_columns_across(float share) {
    constexpr float kHalfTurn = 3.14159265F;
    const int last = static_cast<int>(clip_.frames) - 1;
    const ColumnKinds kinds(clip_);
    for (int set = 0; set < clip_.entry_parts(); ++set) {
      const int first_column = kSetColumns * set;
      float* const columns = columns_ + first_column;
      make_frame(last, set, columns);
      make_frame(0, set, work_.next);
      make_frame(std::max(last - 1, 0), set, work_.before);
      for (int c = 0; c < kGroup * groups_of_set(set).count; ++c) {
        float way = work_.next[c] - columns[c];
        switch (kinds.of(first_column + c)) {
          case ColumnKind::Straight:
            break;
          case ColumnKind::HalfAngle:
            way = std::remainder(way, kHalfTurn);
            break;
          case ColumnKind::Root:
            way = columns[c] - work_.before[c];
            break;
        }
        columns[c] += share * way;
      }
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

  void put_moving(float* out) {
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

  /// Writes the constant parts of all transforms.
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
  const mcpr_cursor* const cursor_;
  const int left_out_;  // finest bands left out
  int kept_bands_ = 0;
  unsigned wanted_samples_ = 0;  // bit n: some part keeps n bands
  PoseWork& work_;
  float* const columns_;
};

}  // namespace

PlaceInClip place_in_clip(const mcpr_cooked& clip, const mcpr_sample_request& request,
                          double time) {
  return clip.wrapping(request.wrap).place(frame_of(clip, request.unit, time));
}

std::uint32_t sampled_joints(const mcpr_cooked& clip, const mcpr_sample_request& request) {
  if (request.selection != nullptr) return request.selection->joint_count;
  return request.joints == nullptr ? clip.joints : request.joint_count;
}

namespace {

/// Size of the work space on the stack. It suffices for all clips but those with thousands of
/// columns or joints. A whole call takes at most 16 KiB of stack.
constexpr std::size_t kRoomOnStack = 7680;
static_assert(sizeof(PoseWork) >= sizeof(std::int16_t) * mcpr_cursor::kFewestNumbers);

/// Makes an empty selection, for the time of one call.
mcpr_selection* take_selection(Memory& memory, const mcpr_cooked& clip) {
  auto* const place = memory.take<mcpr_selection>(1);
  if (place != nullptr) return new (place) mcpr_selection(memory, clip);
  const mcpr_selection measured(memory, clip);
  return nullptr;
}

PoseWork* take_work(Memory& memory) {
  auto* const place = memory.take<PoseWork>(1);
  return place == nullptr ? nullptr : new (place) PoseWork;
}

float* take_columns(Memory& memory, const mcpr_cooked& clip) {
  return memory.take<float>(std::uint64_t{kGroup} * clip.groups);
}

void sample_in(void* room, std::size_t size, const mcpr_cooked& clip, const PoseKernels& kernels,
               const PlaceInClip& place, const mcpr_sample_request& request, float* out,
               mcpr_cursor* cursor) {
  const bool is_across = place.across > 0;
  bool is_kept = false;
  const BetweenFrames between = between_frames(static_cast<int>(clip.frames), place.frame);
  const bool has_steps = request.stepped_count > 0 && (is_across || between.share > 0);
  // The cursor uses the work space first. Afterwards it is free for the rest of this function.
  if (cursor != nullptr && (!is_across || has_steps) &&
      is_liftable(clip.layout().stretch_at(between.before), between))
    is_kept = cursor->keep(kernels, between.before, between.share > 0,
                           static_cast<int>(request.bands_left_out),
                           {static_cast<std::int16_t*>(room), size / sizeof(std::int16_t)});
  Memory memory(room, size);
  PoseWork& work = *take_work(memory);
  float* const columns = take_columns(memory, clip);
  const mcpr_selection* selection = request.selection;
  if (request.joints != nullptr) {
    mcpr_selection* const made = take_selection(memory, clip);
    made->select(request.joints, request.joint_count);
    selection = made;
  }
  Sampler(clip, kernels, request, selection, is_kept && !is_across ? cursor : nullptr, work,
          columns)
      .run(place, out);
  if (has_steps) {
    mcpr_selection* const stepped = take_selection(memory, clip);
    stepped->select_within(selection, request.stepped, request.stepped_count);
    Sampler(clip, kernels, request, stepped, is_kept ? cursor : nullptr, work, columns)
        .run_over({static_cast<double>(between.before), 0}, out);
  }
  const std::uint32_t joints = selection == nullptr ? clip.joints : selection->joint_count;
  if (request.parents != nullptr) place_in_model(request.layout, request.parents, joints, out);
  if (request.convention != nullptr)
    runtime::convert(*request.convention, request.layout, joints, out);
}

/// Samples transforms, and makes the packed layouts from them.
void sample_packed(void* room, std::size_t size, const mcpr_cooked& clip,
                   const PoseKernels& kernels, const PlaceInClip& place,
                   const mcpr_sample_request& request, void* out, mcpr_cursor* cursor) {
  const std::uint32_t joints = sampled_joints(clip, request);
  Memory memory(room, size);
  auto* const pose = memory.take<mcpr_transform>(joints);
  const auto taken = static_cast<std::size_t>(memory.used());
  mcpr_sample_request unpacked = request;
  unpacked.layout = MCPR_TRANSFORMS;
  sample_in(static_cast<std::byte*>(room) + taken, size - taken, clip, kernels, place, unpacked,
            pose->rotation, cursor);
  pack(request, pose, joints, out);
}

}  // namespace

/// Upper bound for the size of a selection, for any clip.
constexpr std::size_t kMostOfSelection =
    sizeof(mcpr_selection) + sizeof(std::uint16_t) * kMostJoints +
    sizeof(RotorPlaces) * (kMostJoints / kGroup) + sizeof(GroupRange) * (kMostColumns / kGroup) +
    4 * kAlignment;
static_assert(sizeof(PoseWork) + sizeof(float) * kMostColumns + 2 * kMostOfSelection +
                  sizeof(mcpr_transform) * kMostJoints + 3 * kAlignment <=
              kMostScratchOfPose);

std::size_t scratch_of(const mcpr_cooked& clip, const mcpr_sample_request& request) {
  Memory memory;
  if (is_packed(request.layout)) memory.take<mcpr_transform>(sampled_joints(clip, request));
  take_work(memory);
  take_columns(memory, clip);
  if (request.joints != nullptr) take_selection(memory, clip);
  if (request.stepped_count > 0) take_selection(memory, clip);
  return memory.used() <= kRoomOnStack ? 0 : static_cast<std::size_t>(memory.used());
}

void sample(const mcpr_cooked& clip, const PoseKernels& kernels, const PlaceInClip& place,
            const mcpr_sample_request& request, void* out, mcpr_cursor* cursor) {
  const auto sample_with = [&](void* room, std::size_t size) {
    if (is_packed(request.layout))
      sample_packed(room, size, clip, kernels, place, request, out, cursor);
    else
      sample_in(room, size, clip, kernels, place, request, static_cast<float*>(out), cursor);
  };
  if (scratch_of(clip, request) > 0) return sample_with(request.scratch, request.scratch_size);
  alignas(kAlignment) std::byte room[kRoomOnStack];
  sample_with(room, sizeof room);
}

}  // namespace mocapress::runtime
