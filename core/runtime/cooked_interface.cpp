// SPDX-License-Identifier: MIT
// The part of the C interface that cooks and samples: checks the arguments, then calls the
// implementation.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <new>

#include "core/runtime/format/result.h"
#include "core/runtime/mocapress_runtime.h"
#include "core/runtime/pose/conventions.h"
#include "core/runtime/pose/cooked_builder.h"
#include "core/runtime/pose/cooked_check.h"
#include "core/runtime/pose/pose_crowd.h"
#include "core/runtime/pose/pose_cursor.h"
#include "core/runtime/pose/pose_packing.h"
#include "core/runtime/pose/pose_sampler.h"
#include "core/runtime/pose/pose_selection.h"
#include "core/runtime/pose/prefetch.h"

namespace mocapress::runtime {
namespace {

constexpr mcpr_result refused(const char* message) {
  return failure(MCPR_ARGUMENT, 0, message);
}

bool is_a_clip(const mcpr_clip* clip) {
  return clip != nullptr && clip->block.mark == ClipBlock::kMark;
}

mcpr_cook_options options_or_none(const mcpr_cook_options* options) {
  return options != nullptr ? *options : mcpr_cook_options{};
}

/// Scratch memory that cooking needs: the builder and its work space.
std::uint64_t cooking_bytes(const mcpr_clip& clip, const mcpr_cook_options& options) {
  Memory memory;
  memory.take<CookedBuilder>(1);
  const CookedBuilder measured(memory, clip, options);
  return memory.used();
}

/// Constructs a builder in scratch memory, which chooses the layout of the cooked clip. Sets
/// `bytes` to the size of that clip.
mcpr_result prepare(const mcpr_clip* clip, const mcpr_cook_options* options, void* scratch,
                    std::size_t scratch_size, CookedBuilder*& builder, std::uint64_t& bytes) {
  if (!is_a_clip(clip)) return refused("no clip");
  const mcpr_cook_options wanted = options_or_none(options);
  if (!(wanted.ik_error >= 0)) return refused("an error below zero");
  if (wanted.detail_bands > MCPR_MOST_DETAIL_BANDS)
    return refused("more detail bands than a cooked clip keeps");
  mcpr_result result = check_memory(scratch, scratch_size, cooking_bytes(*clip, wanted),
                                    "too little scratch memory");
  if (failed(result)) return result;
  Memory memory(scratch, scratch_size);
  builder = new (memory.take<CookedBuilder>(1)) CookedBuilder(memory, *clip, wanted);
  if (failed(result = builder->prepare())) return result;
  bytes = builder->lay_out(nullptr);
  if (bytes > std::numeric_limits<std::uint32_t>::max())
    return failure(MCPR_LIMIT, 0, "the cooked clip would take more than 4 GiB");
  return kOk;
}

mcpr_result check_joints(const mcpr_cooked& clip, const std::uint16_t* joints,
                         std::uint32_t count) {
  if (count > clip.joints) return refused("more joints than there are");
  return are_joints_of(clip, joints, count)
             ? kOk
             : refused("a joint that the clip does not have, or one twice");
}

mcpr_result check_sample_request(const mcpr_cooked* clip, const mcpr_sample_request* request) {
  if (!is_cooked(clip)) return refused("no cooked clip");
  if (request == nullptr || request->layout < MCPR_TRANSFORMS || request->layout > MCPR_WRITER ||
      request->unit < MCPR_FRAMES || request->unit > MCPR_SECONDS ||
      poses_of(request->path) == nullptr)
    return refused("unsupported layout, unit or path");
  if (!clip->wrapping(request->wrap).is_possible())
    return refused("no such wrap, or the clip is not a loop");
  if (request->bands_left_out > MCPR_MOST_BANDS_LEFT_OUT)
    return refused("more bands left out than may be");
  if (request->selection != nullptr &&
      (request->selection->clip != clip || request->joints != nullptr || request->joint_count != 0))
    return refused("a selection of another clip, or a list of joints beside it");
  if (request->convention != nullptr && !is_convention(*request->convention))
    return refused(
        "a convention whose axes are not three different ones, or whose length is not finite");
  if (request->joints == nullptr && request->joint_count != 0) return refused("no list of joints");
  if (request->joints != nullptr) {
    const mcpr_result result = check_joints(*clip, request->joints, request->joint_count);
    if (failed(result)) return result;
  }
  if (request->parents != nullptr &&
      !are_parents(request->parents, sampled_joints(*clip, *request)))
    return refused("a parent that does not come before its joint");
  if (request->stepped == nullptr && request->stepped_count != 0)
    return refused("no list of stepped joints");
  for (std::uint32_t i = 0; i < request->stepped_count; ++i)
    if (request->stepped[i] >= clip->joints)
      return refused("a stepped joint that the clip does not have");
  return kOk;
}

/// Size of a selection: its struct, its list of joints, their constant transforms and its tables.
std::uint64_t selection_bytes(const mcpr_cooked& clip, std::uint32_t joint_count) {
  Memory memory;
  memory.take<mcpr_selection>(1);
  memory.take<std::uint16_t>(joint_count);
  memory.take<mcpr_transform>(joint_count);
  const mcpr_selection measured(memory, clip);
  return memory.used();
}

mcpr_result check_scratch_of(const mcpr_cooked& clip, const mcpr_sample_request& request) {
  const std::size_t needed = scratch_of(clip, request);
  return needed == 0 ? kOk
                     : check_memory(request.scratch, request.scratch_size, needed,
                                    "too little scratch memory");
}

/// Checks the instant and the output of a sample request that is valid otherwise.
mcpr_result check_instant(const mcpr_cooked& clip, const mcpr_sample_request& request, double time,
                          const void* out) {
  if (!std::isfinite(frame_of(clip, request.unit, time)) || out == nullptr)
    return refused("no finite instant, or no output");
  if (request.layout == MCPR_WRITER && static_cast<const mcpr_writer*>(out)->write == nullptr)
    return refused("a writer without a function");
  return kOk;
}

mcpr_result sample_checked(const mcpr_cooked* clip, const mcpr_sample_request* request, double time,
                           void* out, mcpr_cursor* cursor) {
  if (cursor == nullptr) prefetch_clip(clip);
  mcpr_result result = check_sample_request(clip, request);
  if (!failed(result)) result = check_instant(*clip, *request, time, out);
  if (failed(result)) return result;
  if (const mcpr_result scratch = check_scratch_of(*clip, *request); failed(scratch))
    return scratch;
  sample(*clip, *poses_of(request->path), place_in_clip(*clip, *request, time), *request, out,
         cursor);
  return kOk;
}

/// Checks all characters. If one is invalid, the offset of the failure is its index.
mcpr_result check_crowd(const mcpr_crowd_request* request, const mcpr_character* characters,
                        std::uint32_t count) {
  if (request == nullptr) return refused("no request");
  if (characters == nullptr && count > 0) return refused("no characters");
  for (std::uint32_t i = 0; i < count; ++i) {
    const mcpr_character& character = characters[i];
    const mcpr_sample_request one = request_of(*request, character);
    mcpr_result result = check_sample_request(character.clip, &one);
    if (!failed(result))
      result = check_instant(*character.clip, one, character.time, character.out);
    if (!failed(result)) continue;
    result.offset = i;
    return result;
  }
  return kOk;
}

struct Rigid {
  Matrix3 rotation;
  Vector3 translation;  // cm
};

Rigid operator*(const Rigid& a, const Rigid& b) {
  return {a.rotation * b.rotation, a.translation + a.rotation * b.translation};
}

Rigid inverse(const Rigid& a) {
  const Matrix3 back = transposed(a.rotation);
  return {back, back * (Vector3() - a.translation)};
}

/// The motion of one joint between two instants. With `on_ground`, only the part of it that moves
/// on the ground and turns about the vertical axis.
class JointMotion {
 public:
  JointMotion(const mcpr_cooked& clip, const mcpr_sample_request& request, std::uint16_t joint,
              bool on_ground)
      : clip_(clip), joint_(joint), on_ground_(on_ground), request_(request) {
    request_.layout = MCPR_TRANSFORMS;
    request_.unit = MCPR_FRAMES;
    request_.joints = &joint_;
    request_.joint_count = 1;
    request_.selection = nullptr;
    request_.parents = nullptr;
    request_.convention = nullptr;
    // In a clip that is not a loop of kind Follows, MCPR_LOOP_BLEND takes the root straight back to
    // its place in the first frame. That is no part of the motion: hold the last frame instead.
    if (request_.wrap == MCPR_LOOP_BLEND && clip.loop != LoopKind::Follows)
      request_.wrap = MCPR_LOOP_HOLD;
  }

  mcpr_result check_scratch() const { return check_scratch_of(clip_, request_); }

  Rigid between(double from, double to) const {
    const int frames = clip_.wrapping(request_.wrap).cycle();
    if (frames == 0 || request_.wrap == MCPR_PING_PONG) return inverse(at(from)) * at(to);
    const double first = std::floor(from / frames);
    const double last = std::floor(to / frames);
    const Rigid turns = power(inverse(at(0)) * end_of_turn(), last - first);
    return inverse(at(from)) * at(0) * turns * inverse(at(0)) * at(to);
  }

 private:
  Rigid placed(const mcpr_transform& transform) const {
    const float* const q = transform.rotation;
    const Rigid place{rotation_of(static_cast<double>(q[0]), static_cast<double>(q[1]),
                                  static_cast<double>(q[2]), static_cast<double>(q[3])),
                      vector_of(transform.translation)};
    return on_ground_ ? ground_of(place) : place;
  }

  static Rigid ground_of(const Rigid& place) {
    constexpr double kFacesNowhere = 1e-6;
    double wxyz[4];
    quaternion_of(place.rotation, wxyz);
    const double size = std::sqrt(wxyz[0] * wxyz[0] + wxyz[2] * wxyz[2]);
    const Rigid still{{}, {{place.translation[0], 0, place.translation[2]}}};
    if (size < kFacesNowhere) return still;
    return {rotation_of(wxyz[0] / size, 0, wxyz[2] / size, 0), still.translation};
  }

  Rigid at(double frame) const {
    mcpr_transform out;
    sample(clip_, *poses_of(request_.path), place_in_clip(clip_, request_, frame), request_,
           out.rotation);
    return placed(out);
  }

  /// The joint's transform where the next cycle starts. With MCPR_LOOP or MCPR_LOOP_BLEND in a loop
  /// of kind Follows, that is one frame after the last, where a root has repeated its last step.
  /// Otherwise it is the last frame's transform.
  Rigid end_of_turn() const {
    mcpr_transform out;
    const bool goes_on = clip_.loop == LoopKind::Follows &&
                         (request_.wrap == MCPR_LOOP || request_.wrap == MCPR_LOOP_BLEND);
    const PlaceInClip place{clip_.frames - 1.0, goes_on ? 1.0F : 0.0F};
    mcpr_sample_request moving = request_;
    moving.stepped_count = 0;  // a stepped root, too, moves on to the next cycle
    sample(clip_, *poses_of(request_.path), place, moving, out.rotation);
    return placed(out);
  }

  /// `turn` to the power of a whole number, which may be negative.
  static Rigid power(Rigid turn, double count) {
    if (count < 0) {
      turn = inverse(turn);
      count = -count;
    }
    Rigid all{};
    for (auto left = static_cast<std::uint64_t>(std::min(count, 1e15)); left > 0; left /= 2) {
      if (left % 2 != 0) all = all * turn;
      turn = turn * turn;
    }
    return all;
  }

  const mcpr_cooked& clip_;
  const std::uint16_t joint_;
  const bool on_ground_;
  mcpr_sample_request request_;
};

}  // namespace
}  // namespace mocapress::runtime

namespace runtime = mocapress::runtime;

size_t mcpr_cook_scratch_bytes(const mcpr_clip* clip, const mcpr_cook_options* options) {
  if (!runtime::is_a_clip(clip)) return 0;
  return static_cast<size_t>(runtime::cooking_bytes(*clip, runtime::options_or_none(options)));
}

mcpr_status mcpr_cook_size(const mcpr_clip* clip, const mcpr_cook_options* options, void* scratch,
                           size_t scratch_size, size_t* bytes, mcpr_result* report) {
  if (bytes == nullptr)
    return runtime::tell(report, runtime::refused("no place was given for the size"));
  runtime::CookedBuilder* builder = nullptr;
  std::uint64_t needed = 0;
  const mcpr_result result =
      runtime::prepare(clip, options, scratch, scratch_size, builder, needed);
  *bytes = static_cast<size_t>(needed);
  return runtime::tell(report, result);
}

mcpr_status mcpr_cook(const mcpr_clip* clip, const mcpr_cook_options* options, void* scratch,
                      size_t scratch_size, void* memory, size_t size, const mcpr_cooked** cooked,
                      mcpr_result* report) {
  if (cooked == nullptr)
    return runtime::tell(report, runtime::refused("no place was given for the clip"));
  runtime::CookedBuilder* builder = nullptr;
  std::uint64_t needed = 0;
  mcpr_result result = runtime::prepare(clip, options, scratch, scratch_size, builder, needed);
  if (!runtime::failed(result))
    result = runtime::check_memory(memory, size, needed, "too little memory for the clip");
  if (runtime::failed(result)) return runtime::tell(report, result);
  std::memset(memory, 0, static_cast<size_t>(needed));
  builder->lay_out(static_cast<std::byte*>(memory));
  *cooked = std::launder(static_cast<const mcpr_cooked*>(memory));
  return runtime::tell(report, runtime::kOk);
}

mcpr_status mcpr_open_cooked(const void* memory, size_t size, int check, const mcpr_cooked** cooked,
                             mcpr_result* report) {
  if (cooked == nullptr)
    return runtime::tell(report, runtime::refused("no place was given for the clip"));
  mcpr_result result = runtime::check_memory(memory, size, 0, "");
  if (runtime::failed(result)) return runtime::tell(report, result);
  if (size < sizeof(mcpr_cooked))
    return runtime::tell(report,
                         runtime::failure(MCPR_DAMAGED, size, "the cooked clip is cut short"));
  const auto* const clip = static_cast<const mcpr_cooked*>(memory);
  result = runtime::check_cooked_head(*clip, size);
  if (!runtime::failed(result) && clip->tables != 0)
    result = runtime::failure(MCPR_INVALID, offsetof(mcpr_cooked, tables),
                              "a clip of a bank: the bank is what is opened");
  if (!runtime::failed(result) && check != 0)
    result = runtime::check_cooked(*clip, runtime::TableRange::within(*clip));
  if (!runtime::failed(result)) *cooked = clip;
  return runtime::tell(report, result);
}

void mcpr_cooked_describe(const mcpr_cooked* cooked, mcpr_cooked_info* out) {
  if (out == nullptr) return;
  *out = {};
  if (cooked == nullptr) return;
  *out = {.sample_rate = cooked->sample_rate,
          .frames = cooked->frames,
          .joints = cooked->joints,
          .loop_frames = static_cast<std::uint32_t>(cooked->turn_frames()),
          .bytes = static_cast<std::size_t>(cooked->bytes),
          .skeleton_bytes = cooked->skeleton_bytes};
}

size_t mcpr_sample_values(const mcpr_cooked* cooked, const mcpr_sample_request* request) {
  if (runtime::failed(runtime::check_sample_request(cooked, request))) return 0;
  return runtime::values_of_pose(request->layout, runtime::sampled_joints(*cooked, *request));
}

size_t mcpr_sample_scratch_bytes(const mcpr_cooked* cooked, const mcpr_sample_request* request) {
  if (runtime::failed(runtime::check_sample_request(cooked, request))) return 0;
  return runtime::scratch_of(*cooked, *request);
}

mcpr_status mcpr_convention_of(mcpr_engine engine, mcpr_convention* out, mcpr_result* report) {
  if (out == nullptr)
    return runtime::tell(report, runtime::refused("no place was given for the convention"));
  switch (engine) {
    case MCPR_MOCAPRESS:
      *out = {};
      return runtime::tell(report, runtime::kOk);
    case MCPR_GLTF:
    case MCPR_GODOT:
      *out = {{1, 2, 3}, 1, 0.01F};
      return runtime::tell(report, runtime::kOk);
    case MCPR_UNITY:
      *out = {{-1, 2, 3}, 1, 0.01F};
      return runtime::tell(report, runtime::kOk);
    case MCPR_UNREAL:
      *out = {{1, 3, 2}, 1, 1};
      return runtime::tell(report, runtime::kOk);
    case MCPR_BLENDER:
      *out = {{1, -3, 2}, 0, 0.01F};
      return runtime::tell(report, runtime::kOk);
  }
  return runtime::tell(report, runtime::refused("no such engine"));
}

size_t mcpr_selection_bytes(const mcpr_cooked* cooked, uint32_t joint_count) {
  if (!runtime::is_cooked(cooked) || joint_count > cooked->joints) return 0;
  return static_cast<size_t>(runtime::selection_bytes(*cooked, joint_count));
}

mcpr_status mcpr_make_selection(const mcpr_cooked* cooked, const uint16_t* joints,
                                uint32_t joint_count, void* memory, size_t size,
                                const mcpr_selection** selection, mcpr_result* report) {
  if (!runtime::is_cooked(cooked) || joints == nullptr || selection == nullptr)
    return runtime::tell(
        report,
        runtime::refused("no cooked clip, no joints, or no place was given for the selection"));
  mcpr_result result = runtime::check_joints(*cooked, joints, joint_count);
  if (!runtime::failed(result))
    result = runtime::check_memory(memory, size, runtime::selection_bytes(*cooked, joint_count),
                                   "too little memory for the selection");
  if (runtime::failed(result)) return runtime::tell(report, result);
  runtime::Memory pieces(memory, size);
  auto* const place = pieces.take<mcpr_selection>(1);
  auto* const own_joints = pieces.take<std::uint16_t>(joint_count);
  auto* const rest = pieces.take<mcpr_transform>(joint_count);
  std::copy_n(joints, joint_count, own_joints);
  for (std::uint32_t i = 0; i < joint_count; ++i)
    rest[i] = cooked->at<mcpr_transform>(cooked->rest)[joints[i]];
  auto* const made = new (place) mcpr_selection(pieces, *cooked);
  made->rest = rest;
  made->select(own_joints, joint_count);
  *selection = made;
  return runtime::tell(report, runtime::kOk);
}

mcpr_status mcpr_sample(const mcpr_cooked* cooked, const mcpr_sample_request* request, double time,
                        void* out, mcpr_result* report) {
  return runtime::tell(report, runtime::sample_checked(cooked, request, time, out, nullptr));
}

void mcpr_prefetch_hint(const mcpr_cooked* cooked, size_t bytes) {
  if (cooked != nullptr) runtime::prefetch(reinterpret_cast<const std::byte*>(cooked), bytes);
}

size_t mcpr_cursor_bytes(const mcpr_cooked* cooked) {
  return runtime::is_cooked(cooked) ? mcpr_cursor::bytes_for(*cooked) : 0;
}

mcpr_status mcpr_make_cursor(const mcpr_cooked* cooked, void* memory, size_t size,
                             mcpr_cursor** cursor, mcpr_result* report) {
  if (!runtime::is_cooked(cooked) || cursor == nullptr)
    return runtime::tell(report,
                         runtime::refused("no cooked clip, or no place was given for the cursor"));
  const mcpr_result result = runtime::check_memory(memory, size, mcpr_cursor::bytes_for(*cooked),
                                                   "too little memory for the cursor");
  if (runtime::failed(result)) return runtime::tell(report, result);
  *cursor = new (memory) mcpr_cursor(mcpr_cursor::empty(*cooked));
  return runtime::tell(report, runtime::kOk);
}

mcpr_status mcpr_sample_next(mcpr_cursor* cursor, const mcpr_sample_request* request, double time,
                             void* out, mcpr_result* report) {
  if (cursor == nullptr) return runtime::tell(report, runtime::refused("no cursor"));
  return runtime::tell(report, runtime::sample_checked(cursor->clip, request, time, out, cursor));
}

size_t mcpr_sort_crowd_scratch_bytes(uint32_t count) {
  runtime::Memory memory;
  const runtime::CrowdSorter measured(memory, count);
  return static_cast<size_t>(memory.used());
}

mcpr_status mcpr_sort_crowd(const mcpr_crowd_request* request, mcpr_character* characters,
                            uint32_t count, void* scratch, size_t scratch_size,
                            mcpr_result* report) {
  mcpr_result result = runtime::check_crowd(request, characters, count);
  if (runtime::failed(result) || count == 0) return runtime::tell(report, result);
  result = runtime::check_memory(scratch, scratch_size, mcpr_sort_crowd_scratch_bytes(count),
                                 "too little scratch memory");
  if (runtime::failed(result)) return runtime::tell(report, result);
  runtime::Memory memory(scratch, scratch_size);
  runtime::CrowdSorter sorter(memory, count);
  sorter.sort(*request, characters);
  return runtime::tell(report, runtime::kOk);
}

size_t mcpr_crowd_scratch_bytes(void) {
  runtime::Memory memory;
  const runtime::PoseCrowd measured(memory);
  return static_cast<size_t>(memory.used());
}

mcpr_status mcpr_sample_crowd(const mcpr_crowd_request* request, const mcpr_character* characters,
                              uint32_t count, void* scratch, size_t scratch_size,
                              mcpr_result* report) {
  mcpr_result result = runtime::check_crowd(request, characters, count);
  if (runtime::failed(result) || count == 0) return runtime::tell(report, result);
  result = runtime::check_memory(scratch, scratch_size, mcpr_crowd_scratch_bytes(),
                                 "too little scratch memory");
  if (runtime::failed(result)) return runtime::tell(report, result);
  runtime::Memory memory(scratch, scratch_size);
  runtime::PoseCrowd crowd(memory);
  crowd.pose(*request, characters, count);
  return runtime::tell(report, runtime::kOk);
}

namespace mocapress::runtime {
namespace {

mcpr_result sample_motion(const mcpr_cooked* cooked, const mcpr_sample_request* request,
                          std::uint32_t joint, double from, double to, bool on_ground,
                          mcpr_transform* out) {
  const mcpr_result result = check_sample_request(cooked, request);
  if (failed(result)) return result;
  if (joint >= cooked->joints) return refused("no such joint");
  const double first = frame_of(*cooked, request->unit, from);
  const double last = frame_of(*cooked, request->unit, to);
  if (!std::isfinite(first) || !std::isfinite(last) || out == nullptr)
    return refused("no finite instants, or no output");
  const JointMotion of_joint(*cooked, *request, static_cast<std::uint16_t>(joint), on_ground);
  const mcpr_result scratch = of_joint.check_scratch();
  if (failed(scratch)) return scratch;
  const Rigid moved = of_joint.between(first, last);
  double wxyz[4];
  quaternion_of(moved.rotation, wxyz);
  *out = {};
  for (int i = 0; i < 4; ++i) out->rotation[i] = static_cast<float>(wxyz[i]);
  for (int i = 0; i < 3; ++i) out->translation[i] = static_cast<float>(moved.translation[i]);
  if (request->convention != nullptr)
    runtime::convert(*request->convention, MCPR_TRANSFORMS, 1, out->rotation);
  return kOk;
}

}  // namespace
}  // namespace mocapress::runtime

mcpr_status mcpr_sample_motion(const mcpr_cooked* cooked, const mcpr_sample_request* request,
                               uint32_t joint, double from, double to, mcpr_transform* out,
                               mcpr_result* report) {
  return runtime::tell(report,
                       runtime::sample_motion(cooked, request, joint, from, to, false, out));
}

mcpr_status mcpr_sample_ground_motion(const mcpr_cooked* cooked, const mcpr_sample_request* request,
                                      uint32_t joint, double from, double to, mcpr_transform* out,
                                      mcpr_result* report) {
  return runtime::tell(report, runtime::sample_motion(cooked, request, joint, from, to, true, out));
}
