// SPDX-License-Identifier: MIT
// Prints the most stack that any call of the runtime takes, in bytes, for each call. Every call
// runs on a stack that was painted before. Usage: stack_use FILE.mcpr|BANK.mcpk...
#include <ucontext.h>
#include <mocapress_runtime.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <iterator>
#include <map>
#include <string>
#include <vector>

namespace {

// Four times what a call may take. All of it is painted and looked through for each of many
// thousand calls.
constexpr std::size_t kStackBytes = std::size_t{64} << 10;
constexpr std::uint64_t kPaint = 0xA5A5A5A5A5A5A5A5;
std::map<std::string, std::size_t> most_of_call;

/// Memory for the runtime, with room for an alignment.
class Block {
 public:
  explicit Block(std::size_t size = 0, std::size_t alignment = MCPR_ALIGNMENT)
      : bytes_(size + alignment), alignment_(alignment), size_(size) {}
  unsigned char* data() {
    const auto at = reinterpret_cast<std::uintptr_t>(bytes_.data());
    return bytes_.data() + (alignment_ - at % alignment_) % alignment_;
  }
  std::size_t size() const { return size_; }

 private:
  std::vector<unsigned char> bytes_;
  std::size_t alignment_;
  std::size_t size_;
};

/// Bytes of the painted stack that a call overwrote. A context has that stack, not a thread, which
/// would wait its turn on a busy machine.
std::size_t overwritten_by(const std::function<void()>& call) {
  alignas(64) static std::array<std::uint64_t, kStackBytes / sizeof kPaint> stack;
  static const std::function<void()>* under_way = nullptr;
  stack.fill(kPaint);
  under_way = &call;
  ucontext_t here;
  ucontext_t there;
  if (getcontext(&there) != 0) std::abort();
  there.uc_stack.ss_sp = stack.data();
  there.uc_stack.ss_size = kStackBytes;
  there.uc_link = &here;
  makecontext(
      &there, [] { (*under_way)(); }, 0);
  if (swapcontext(&here, &there) != 0) std::abort();
  const auto first =
      std::find_if(stack.begin(), stack.end(), [](std::uint64_t word) { return word != kPaint; });
  return static_cast<std::size_t>(stack.end() - first) * sizeof kPaint;
}

void measure(const char* name, const std::function<mcpr_status()>& call) {
  static const std::size_t of_nothing = overwritten_by([] {});
  mcpr_status status = MCPR_OK;
  const std::size_t all = overwritten_by([&] { status = call(); });
  if (status != MCPR_OK) {
    std::fprintf(stderr, "%s: %s\n", name, mcpr_status_message(status));
    std::exit(1);
  }
  std::size_t& most = most_of_call[name];
  most = std::max(most, all - of_nothing);
}

std::size_t size_by(const char* name, const std::function<std::size_t()>& call) {
  std::size_t size = 0;
  measure(name, [&] {
    size = call();
    return MCPR_OK;
  });
  return size;
}

std::vector<mcpr_path> paths() {
  std::vector<mcpr_path> found;
  for (const mcpr_path path :
       {MCPR_PATH_PLAIN, MCPR_PATH_SSE2, MCPR_PATH_AVX2, MCPR_PATH_NEON, MCPR_PATH_WASM})
    if (mcpr_path_exists(path) != 0) found.push_back(path);
  return found;
}

/// For calls that return a plain number or a string.
template <typename Call>
void use(const char* name, const Call& call) {
  size_by(name, [&] {
    static_cast<void>(call());
    return std::size_t{0};
  });
}

/// An engine's skeleton with the names and parents of a clip.
struct Rig {
  std::vector<std::string> names;
  std::vector<const char*> texts;
  std::vector<std::int16_t> parents;
  std::vector<std::int16_t> map;
  mcpr_map_gaps gaps{};

  void add(const mcpr_joint& joint) {
    names.emplace_back(joint.name);
    parents.push_back(static_cast<std::int16_t>(joint.parent));
  }
  mcpr_skeleton skeleton() {
    texts.clear();
    for (const std::string& name : names) texts.push_back(name.c_str());
    map.resize(names.size());
    return {static_cast<std::uint32_t>(names.size()), texts.data(), parents.data()};
  }
};

void describe(const mcpr_clip* clip) {
  mcpr_clip_info info{};
  use("mcpr_clip_describe", [&] { return mcpr_clip_describe(clip, &info), 0; });
  Rig rig;
  for (std::uint32_t j = 0; j < info.joints; ++j) {
    mcpr_joint joint;
    measure("mcpr_clip_joint", [&] { return mcpr_clip_joint(clip, j, &joint, nullptr); });
    rig.add(joint);
  }
  use("mcpr_find_joint", [&] { return mcpr_find_joint(clip, rig.names.back().c_str()); });
  use("mcpr_skeleton_hash", [&] { return mcpr_skeleton_hash(clip); });
  const mcpr_skeleton skeleton = rig.skeleton();
  measure("mcpr_map_joints",
          [&] { return mcpr_map_joints(clip, &skeleton, rig.map.data(), &rig.gaps, nullptr); });
}

/// Poses that are blended, mirrored and put onto another skeleton.
void blend(const mcpr_cooked* cooked) {
  mcpr_convention convention{};
  measure("mcpr_convention_of",
          [&] { return mcpr_convention_of(MCPR_UNREAL, &convention, nullptr); });
  const std::uint32_t joints = mcpr::describe(cooked).joints;
  mcpr_sample_request request{};
  request.convention = &convention;
  std::vector<mcpr_transform> pose(joints), other(joints), out(joints);
  measure("mcpr_sample", [&] { return mcpr_sample(cooked, &request, 0, pose.data(), nullptr); });
  measure("mcpr_sample", [&] { return mcpr_sample(cooked, &request, 1e9, other.data(), nullptr); });
  const mcpr_pose_form form{joints, &convention};
  const mcpr_weighted_pose both[] = {{pose.data(), 0.4F, nullptr}, {other.data(), 0.6F, nullptr}};
  measure("mcpr_blend", [&] { return mcpr_blend(&form, both, 2, out.data(), nullptr); });
  measure("mcpr_blend_layer",
          [&] { return mcpr_blend_layer(&form, &both[1], out.data(), nullptr); });
  measure("mcpr_pose_difference", [&] {
    return mcpr_pose_difference(&form, pose.data(), other.data(), out.data(), nullptr);
  });
  measure("mcpr_blend_additive",
          [&] { return mcpr_blend_additive(&form, both, out.data(), nullptr); });
  mcpr_transform ground;
  measure("mcpr_split_root",
          [&] { return mcpr_split_root(&convention, &out[0], &ground, nullptr); });
  std::vector<std::int16_t> parents, map;
  std::vector<std::uint16_t> partners;
  for (std::uint32_t j = 0; j < joints; ++j) {
    parents.push_back(static_cast<std::int16_t>(static_cast<int>(j) - 1));
    partners.push_back(static_cast<std::uint16_t>(j));
    map.push_back(static_cast<std::int16_t>(j));
  }
  std::vector<mcpr_mirror_joint> mirror(joints);
  measure("mcpr_make_mirror", [&] {
    return mcpr_make_mirror(&form, pose.data(), parents.data(), partners.data(), 0, mirror.data(),
                            nullptr);
  });
  measure("mcpr_mirror_pose", [&] {
    return mcpr_mirror_pose(&form, mirror.data(), 0, pose.data(), out.data(), nullptr);
  });
  measure("mcpr_remap_pose", [&] {
    return mcpr_remap_pose(map.data(), joints, other.data(), pose.data(), joints, out.data(),
                           nullptr);
  });
}

void decode(const mcpr_clip* clip) {
  describe(clip);
  const mcpr_clip_info info = mcpr::describe(clip);
  for (const mcpr_path path : paths())
    for (int output = MCPR_CHANNELS; output <= MCPR_POSITIONS; ++output) {
      const std::uint16_t first_channel = 0;
      mcpr_request request{};
      request.output = static_cast<mcpr_output>(output);
      request.apply_ik = 1;
      request.path = path;
      if (output == MCPR_CHANNELS) {
        request.channels = &first_channel;
        request.channel_count = 1;
      }
      Block scratch(
          size_by("mcpr_scratch_bytes", [&] { return mcpr_scratch_bytes(clip, &request); }));
      std::vector<float> out(info.frames * size_by("mcpr_frame_values", [&] {
                               return mcpr_frame_values(clip, &request);
                             }));
      measure("mcpr_decode_frames", [&] {
        return mcpr_decode_frames(clip, &request, 0, info.frames, out.data(), scratch.data(),
                                  scratch.size(), nullptr);
      });
      request.wrap = MCPR_LOOP_BLEND;
      for (double frame = 0.3; frame < info.frames; frame += 7)
        measure("mcpr_decode_moment", [&] {
          return mcpr_decode_moment(clip, &request, frame, out.data(), scratch.data(),
                                    scratch.size(), nullptr);
        });
    }
}

void play(const mcpr_tracks* tracks) {
  use("mcpr_track_count", [&] { return mcpr_track_count(tracks); });
  if (mcpr_track_count(tracks) == 0) return;
  mcpr_track track;
  measure("mcpr_track_describe", [&] { return mcpr_track_describe(tracks, 0, &track, nullptr); });
  use("mcpr_find_track",
      [&] { return mcpr_find_track(tracks, track.kind, track.node, track.name); });
  use("mcpr_track_values", [&] {
    const mcpr_track_request all{};
    return mcpr_track_values(tracks, &all);
  });
  mcpr_track_request request{};
  request.wrap = MCPR_PING_PONG;
  Block scratch(size_by("mcpr_track_scratch_bytes",
                        [&] { return mcpr_track_scratch_bytes(tracks, &request); }));
  std::vector<float> out(mcpr_track_values(tracks, &request));
  measure("mcpr_track_frames", [&] {
    return mcpr_track_frames(tracks, &request, 0, 1, out.data(), scratch.data(), scratch.size(),
                             nullptr);
  });
  measure("mcpr_track_moment", [&] {
    return mcpr_track_moment(tracks, &request, 0.5, out.data(), scratch.data(), scratch.size(),
                             nullptr);
  });
  std::uint32_t count = 0;
  measure("mcpr_track_changes", [&] {
    return mcpr_track_changes(tracks, &request, -30, 30, nullptr, 0, &count, nullptr);
  });
}

void sample(const mcpr_cooked* cooked) {
  mcpr_cooked_info info{};
  use("mcpr_cooked_describe", [&] { return mcpr_cooked_describe(cooked, &info), 0; });
  const std::uint16_t first_joint = 0;
  const double last = info.frames - 1.0;
  use("mcpr_cooked_tracks", [&] { return mcpr_cooked_tracks(cooked); });
  play(mcpr_cooked_tracks(cooked));
  blend(cooked);
  Block memory(size_by("mcpr_cursor_bytes", [&] { return mcpr_cursor_bytes(cooked); }));
  mcpr_cursor* cursor = nullptr;
  measure("mcpr_make_cursor",
          [&] { return mcpr_make_cursor(cooked, memory.data(), memory.size(), &cursor, nullptr); });
  Block selection_memory(
      size_by("mcpr_selection_bytes", [&] { return mcpr_selection_bytes(cooked, 1); }));
  const mcpr_selection* selection = nullptr;
  measure("mcpr_make_selection", [&] {
    return mcpr_make_selection(cooked, &first_joint, 1, selection_memory.data(),
                               selection_memory.size(), &selection, nullptr);
  });
  std::vector<float> out(std::size_t{12} * info.joints + 40);
  for (const mcpr_path path : paths()) {
    for (int layout = MCPR_TRANSFORMS; layout <= MCPR_WRITER; ++layout)
      for (int listed = 0; listed <= 1; ++listed) {
        mcpr_convention convention{};
        mcpr_convention_of(MCPR_UNITY, &convention, nullptr);
        mcpr_sample_request request{};
        request.layout = static_cast<mcpr_layout>(layout);
        request.path = path;
        request.wrap = MCPR_LOOP_BLEND;
        request.stepped = &first_joint;
        request.stepped_count = 1;
        request.convention = &convention;
        if (listed != 0) {
          request.joints = &first_joint;
          request.joint_count = 1;
        }
        size_by("mcpr_sample_values", [&] { return mcpr_sample_values(cooked, &request); });
        size_by("mcpr_sample_scratch_bytes",
                [&] { return mcpr_sample_scratch_bytes(cooked, &request); });
        for (double frame = 0.3; frame < info.frames; frame += last / 40) {
          mcpr_writer writer{[](void*, std::uint32_t, const mcpr_transform*) {}, nullptr};
          void* const to = layout == MCPR_WRITER ? static_cast<void*>(&writer) : out.data();
          use("mcpr_prefetch_hint", [&] { return mcpr_prefetch_hint(cooked, info.bytes), 0; });
          measure("mcpr_sample", [&] { return mcpr_sample(cooked, &request, frame, to, nullptr); });
          measure("mcpr_sample_next",
                  [&] { return mcpr_sample_next(cursor, &request, frame, to, nullptr); });
        }
        mcpr_transform moved;
        for (double frame = 0.3; frame < info.frames; frame += last / 10) {
          measure("mcpr_sample_motion", [&] {
            return mcpr_sample_motion(cooked, &request, 0, frame, 3 * last, &moved, nullptr);
          });
          measure("mcpr_sample_ground_motion", [&] {
            return mcpr_sample_ground_motion(cooked, &request, 0, frame, 3 * last, &moved, nullptr);
          });
        }
      }
    std::vector<std::vector<float>> poses(64, out);
    std::vector<mcpr_character> all(64);
    for (std::size_t i = 0; i < all.size(); ++i) {
      all[i].clip = cooked;
      all[i].selection = i % 3 == 0 ? selection : nullptr;
      all[i].time = last * static_cast<double>(63 - i) / 640;
      all[i].out = poses[i].data();
      all[i].stepped = &first_joint;
      all[i].stepped_count = 1;
    }
    mcpr_crowd_request request{};
    request.path = path;
    Block sorting(size_by("mcpr_sort_crowd_scratch_bytes",
                          [&] { return mcpr_sort_crowd_scratch_bytes(64); }));
    Block scratch(size_by("mcpr_crowd_scratch_bytes", [] { return mcpr_crowd_scratch_bytes(); }));
    measure("mcpr_sort_crowd", [&] {
      return mcpr_sort_crowd(&request, all.data(), 64, sorting.data(), sorting.size(), nullptr);
    });
    measure("mcpr_sample_crowd", [&] {
      return mcpr_sample_crowd(&request, all.data(), 64, scratch.data(), scratch.size(), nullptr);
    });
  }
}

void use(Block& scratch, std::size_t bytes) {
  Block resident(bytes);
  const mcpr_clip* clip = nullptr;
  measure("mcpr_build", [&] {
    return mcpr_build(scratch.data(), scratch.size(), resident.data(), bytes, &clip, nullptr);
  });
  decode(clip);
  use("mcpr_clip_tracks", [&] { return mcpr_clip_tracks(clip); });
  play(mcpr_clip_tracks(clip));
  for (const float ik_error : {0.0F, 0.5F}) {
    mcpr_cook_options options{};
    options.apply_ik = 1;
    options.ik_error = ik_error;
    options.skeleton = 1;
    Block space(size_by("mcpr_cook_scratch_bytes",
                        [&] { return mcpr_cook_scratch_bytes(clip, &options); }));
    std::size_t size = 0;
    measure("mcpr_cook_size", [&] {
      return mcpr_cook_size(clip, &options, space.data(), space.size(), &size, nullptr);
    });
    Block memory(size);
    const mcpr_cooked* cooked = nullptr;
    measure("mcpr_cook", [&] {
      return mcpr_cook(clip, &options, space.data(), space.size(), memory.data(), size, &cooked,
                       nullptr);
    });
    measure("mcpr_open_cooked",
            [&] { return mcpr_open_cooked(memory.data(), size, 1, &cooked, nullptr); });
    Rig rig;
    for (std::uint32_t j = 0; j < mcpr::describe(cooked).joints; ++j) {
      mcpr_joint joint;
      measure("mcpr_cooked_joint", [&] { return mcpr_cooked_joint(cooked, j, &joint, nullptr); });
      rig.add(joint);
    }
    use("mcpr_cooked_skeleton_hash", [&] { return mcpr_cooked_skeleton_hash(cooked); });
    const mcpr_skeleton skeleton = rig.skeleton();
    measure("mcpr_map_cooked_joints", [&] {
      return mcpr_map_cooked_joints(cooked, &skeleton, rig.map.data(), &rig.gaps, nullptr);
    });
    sample(cooked);
  }
}

constexpr mcpr_allocator kAllocator{
    [](void*, std::size_t size, std::size_t alignment) {
      return std::aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment);
    },
    [](void*, void* memory) { std::free(memory); }, nullptr};

/// The calls that allocate by themselves.
void load(Block& file) {
  const mcpr_clip* clip = nullptr;
  measure("mcpr_load", [&] {
    return mcpr_load(file.data(), file.size(), nullptr, &kAllocator, &clip, nullptr);
  });
  std::free(const_cast<mcpr_clip*>(clip));
  const mcpr_cooked* cooked = nullptr;
  mcpr_cook_options options{};
  options.apply_ik = 1;
  measure("mcpr_load_cooked", [&] {
    return mcpr_load_cooked(file.data(), file.size(), nullptr, &options, &kAllocator, &cooked,
                            nullptr);
  });
  std::free(const_cast<mcpr_cooked*>(cooked));
  mcpr_tier tier;
  use("mcpr_tier_of", [&] { return mcpr_tier_of(file.data(), file.size(), 0, &tier, nullptr); });
}

void use_file(Block& file) {
  load(file);
  mcpr_info info{};
  measure("mcpr_inspect",
          [&] { return mcpr_inspect(file.data(), file.size(), nullptr, &info, nullptr); });
  Block scratch(info.read_bytes);
  std::size_t bytes = 0;
  measure("mcpr_read", [&] {
    return mcpr_read(file.data(), file.size(), nullptr, scratch.data(), scratch.size(), &bytes,
                     nullptr);
  });
  use(scratch, bytes);
}

void use_bank(Block& file) {
  const mcpk_bank* bank = nullptr;
  measure("mcpk_open", [&] { return mcpk_open(file.data(), file.size(), 1, &bank, nullptr); });
  char name[MCPK_NAME_BYTES];
  mcpk_info head{};
  use("mcpk_describe", [&] { return mcpk_describe(bank, &head), 0; });
  use("mcpk_key", [&] { return mcpk_key(bank, 0); });
  use("mcpk_value", [&] { return mcpk_value(bank, 0); });
  use("mcpk_tiers", [&] { return mcpk_tiers(bank, nullptr); });
  for (std::uint32_t clip = 0; clip < head.clips; ++clip) {
    std::uint64_t offset = 0;
    std::uint64_t size = 0;
    measure("mcpk_place", [&] { return mcpk_place(bank, clip, &offset, &size, nullptr); });
    use("mcpk_tier_place", [&] { return mcpk_tier_place(bank, clip, 1, &offset, &size, nullptr); });
    use("mcpk_tag", [&] { return mcpk_tag(bank, clip, 0); });
    use("mcpk_skeleton", [&] { return mcpk_skeleton(bank, clip); });
    size_by("mcpk_name", [&] { return mcpk_name(bank, clip, name); });
    size_by("mcpk_find", [&] { return static_cast<std::size_t>(mcpk_find(bank, name)); });
    measure("mcpk_check", [&] { return mcpk_check(bank, clip, nullptr); });
    if (head.is_cooked != 0) {
      const mcpr_cooked* cooked = nullptr;
      measure("mcpk_cooked", [&] { return mcpk_cooked(bank, clip, &cooked, nullptr); });
      Rig rig;
      for (std::uint32_t j = 0; j < mcpr::describe(cooked).joints; ++j) {
        mcpr_joint joint;
        measure("mcpk_joint", [&] { return mcpk_joint(bank, clip, j, &joint, nullptr); });
        rig.add(joint);
      }
      use("mcpk_find_joint", [&] { return mcpk_find_joint(bank, clip, rig.names[0].c_str()); });
      use("mcpk_skeleton_hash", [&] { return mcpk_skeleton_hash(bank, clip); });
      const mcpr_skeleton skeleton = rig.skeleton();
      measure("mcpk_map_joints", [&] {
        return mcpk_map_joints(bank, clip, &skeleton, rig.map.data(), &rig.gaps, nullptr);
      });
      sample(cooked);
      continue;
    }
    mcpr_info info{};
    measure("mcpk_inspect", [&] { return mcpk_inspect(bank, clip, nullptr, &info, nullptr); });
    Block scratch(info.read_bytes);
    std::size_t bytes = 0;
    measure("mcpk_read", [&] {
      return mcpk_read(bank, clip, nullptr, scratch.data(), scratch.size(), &bytes, nullptr);
    });
    use(scratch, bytes);
    const mcpr_clip* loaded = nullptr;
    measure("mcpk_load",
            [&] { return mcpk_load(bank, clip, nullptr, &kAllocator, &loaded, nullptr); });
    std::free(const_cast<mcpr_clip*>(loaded));
    const mcpr_cooked* cooked = nullptr;
    measure("mcpk_load_cooked", [&] {
      return mcpk_load_cooked(bank, clip, nullptr, nullptr, &kAllocator, &cooked, nullptr);
    });
    std::free(const_cast<mcpr_cooked*>(cooked));
  }
}

}  // namespace

int main(int count, char** arguments) {
  mcpr_limits limits;
  use("mcpr_default_limits", [&] { return mcpr_default_limits(&limits), 0; });
  use("mcpr_status_message", [] { return mcpr_status_message(MCPR_DAMAGED); });
  use("mcpr_path_exists", [] { return mcpr_path_exists(MCPR_PATH_AVX2); });
  for (int i = 1; i < count; ++i) {
    std::ifstream stream(arguments[i], std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(stream), {}};
    Block file(bytes.size());
    std::copy(bytes.begin(), bytes.end(), file.data());
    if (std::string(arguments[i]).ends_with(".mcpk"))
      use_bank(file);
    else
      use_file(file);
  }
  for (const auto& [name, bytes] : most_of_call) std::printf("%s %zu\n", name.c_str(), bytes);
  return 0;
}
