// SPDX-License-Identifier: MIT
// Prints a hash of every output of the runtime for files and banks, one a line, to compare
// processors. Fails if the paths of one processor disagree.
// Usage: output_hashes FILE.mcpr|BANK.mcpk...
#include <mocapress_runtime.hpp>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

namespace {

[[noreturn]] void stop(const std::string& what, const char* why) {
  std::fprintf(stderr, "%s: %s\n", what.c_str(), why);
  std::exit(1);
}

void check(const std::string& what, mcpr_status status) {
  if (status != MCPR_OK) stop(what, mcpr_status_message(status));
}

/// Memory for the runtime: zeroed and aligned.
class Block {
 public:
  explicit Block(size_t size = 0) : bytes_(size + MCPR_ALIGNMENT), size_(size) {}
  void* data() {
    const auto at = reinterpret_cast<std::uintptr_t>(bytes_.data());
    return bytes_.data() + (MCPR_ALIGNMENT - at % MCPR_ALIGNMENT) % MCPR_ALIGNMENT;
  }
  size_t size() const { return size_; }

 private:
  std::vector<unsigned char> bytes_;
  size_t size_;
};

Block contents_of(const char* path) {
  std::FILE* const file = std::fopen(path, "rb");
  if (file == nullptr) stop(path, "cannot be opened");
  std::fseek(file, 0, SEEK_END);
  Block block(static_cast<size_t>(std::ftell(file)));
  std::rewind(file);
  if (std::fread(block.data(), 1, block.size(), file) != block.size()) stop(path, "cannot be read");
  std::fclose(file);
  return block;
}

/// FNV-1a hash.
unsigned long long hash_of(const void* bytes, size_t size) {
  unsigned long long hash = 14695981039346656037ULL;
  for (size_t i = 0; i < size; ++i)
    hash = (hash ^ static_cast<const unsigned char*>(bytes)[i]) * 1099511628211ULL;
  return hash;
}

std::vector<mcpr_path> paths() {
  std::vector<mcpr_path> found;
  for (const mcpr_path path : {MCPR_PATH_PLAIN, MCPR_PATH_SSE2, MCPR_PATH_AVX2, MCPR_PATH_NEON,
                               MCPR_PATH_WASM, MCPR_PATH_BEST})
    if (mcpr_path_exists(path) != 0) found.push_back(path);
  return found;
}

/// Prints the hash of the output of `make(path, floats)` for every path.
template <typename Make>
void print(const std::string& what, const Make& make) {
  unsigned long long first = 0;
  for (const mcpr_path path : paths()) {
    std::vector<float> floats;
    make(path, floats);
    const unsigned long long hash = hash_of(floats.data(), floats.size() * sizeof(float));
    if (path == MCPR_PATH_PLAIN)
      first = hash;
    else if (hash != first)
      stop(what, ("path " + std::to_string(path) + " gives other bits").c_str());
  }
  std::printf("%s %016llx\n", what.c_str(), first);
}

std::vector<double> instants(unsigned frames) {
  std::vector<double> all = {0, frames - 1.0};
  for (int i = 0; i < 60; ++i) all.push_back((frames - 1.0) * (i * 37 % 60 + 0.3) / 61);
  return all;
}

void print_decoded(const std::string& name, const mcpr_clip* clip) {
  const mcpr_clip_info info = mcpr::describe(clip);
  const char* const names[] = {"channels", "local", "positions"};
  for (int output = MCPR_CHANNELS; output <= MCPR_POSITIONS; ++output)
    for (int ik = 0; ik <= (info.effectors > 0 ? 1 : 0); ++ik)
      for (unsigned bands = 0; bands <= 1; ++bands) {
        const auto request_on = [&](mcpr_path path) {
          mcpr_request request{};
          request.output = static_cast<mcpr_output>(output);
          request.apply_ik = ik;
          request.bands_left_out = bands;
          request.path = path;
          return request;
        };
        const std::string what =
            name + " " + names[output] + (ik != 0 ? " ik" : "") + (bands != 0 ? " coarse" : "");
        print(what, [&](mcpr_path path, std::vector<float>& floats) {
          const mcpr_request request = request_on(path);
          Block scratch(mcpr_scratch_bytes(clip, &request));
          floats.resize(mcpr_frame_values(clip, &request) * info.frames);
          check(what, mcpr_decode_frames(clip, &request, 0, info.frames, floats.data(),
                                         scratch.data(), scratch.size(), nullptr));
        });
        print(what + " instants", [&](mcpr_path path, std::vector<float>& floats) {
          const mcpr_request request = request_on(path);
          Block scratch(mcpr_scratch_bytes(clip, &request));
          std::vector<float> pose(mcpr_frame_values(clip, &request));
          for (const double frame : instants(info.frames)) {
            check(what, mcpr_decode_moment(clip, &request, frame, pose.data(), scratch.data(),
                                           scratch.size(), nullptr));
            floats.insert(floats.end(), pose.begin(), pose.end());
            if (info.loop_frames == 0) continue;
            mcpr_request looping = request;
            looping.wrap = MCPR_LOOP;
            check(what, mcpr_decode_moment(clip, &looping, 3 * frame - 5, pose.data(),
                                           scratch.data(), scratch.size(), nullptr));
            floats.insert(floats.end(), pose.begin(), pose.end());
          }
        });
      }
  const mcpr_tracks* const tracks = mcpr_clip_tracks(clip);
  if (mcpr_track_count(tracks) == 0) return;
  print(name + " tracks", [&](mcpr_path, std::vector<float>& floats) {
    const mcpr_track_request request{};
    Block scratch(mcpr_track_scratch_bytes(tracks, &request));
    floats.resize(mcpr_track_values(tracks, &request) * info.frames);
    check(name, mcpr_track_frames(tracks, &request, 0, info.frames, floats.data(), scratch.data(),
                                  scratch.size(), nullptr));
  });
}

void print_sampled(const std::string& name, const mcpr_cooked* cooked) {
  const mcpr_cooked_info info = mcpr::describe(cooked);
  const char* const names[] = {"transforms", "arrays", "matrices"};
  for (int layout = MCPR_TRANSFORMS; layout <= MCPR_MATRICES; ++layout)
    for (int wrap = MCPR_CLAMP; wrap <= (info.loop_frames > 0 ? MCPR_LOOP : MCPR_CLAMP); ++wrap) {
      const auto request_on = [&](mcpr_path path, unsigned bands) {
        mcpr_sample_request request{};
        request.layout = static_cast<mcpr_layout>(layout);
        request.wrap = static_cast<mcpr_wrap>(wrap);
        request.path = path;
        request.bands_left_out = bands;
        return request;
      };
      const std::string what = name + " " + names[layout] + (wrap == MCPR_LOOP ? " loop" : "");
      print(what, [&](mcpr_path path, std::vector<float>& floats) {
        for (unsigned bands = 0; bands <= 2; ++bands) {
          const mcpr_sample_request request = request_on(path, bands);
          std::vector<float> pose(mcpr_sample_values(cooked, &request));
          for (const double frame : instants(info.frames)) {
            check(what, mcpr_sample(cooked, &request, wrap == MCPR_LOOP ? 3 * frame - 5 : frame,
                                    pose.data(), nullptr));
            floats.insert(floats.end(), pose.begin(), pose.end());
          }
        }
      });
      print(what + " played", [&](mcpr_path path, std::vector<float>& floats) {
        const mcpr_sample_request request = request_on(path, 0);
        std::vector<float> pose(mcpr_sample_values(cooked, &request));
        Block memory(mcpr_cursor_bytes(cooked));
        mcpr_cursor* cursor = nullptr;
        check(what, mcpr_make_cursor(cooked, memory.data(), memory.size(), &cursor, nullptr));
        for (double frame = 0; frame < info.frames; frame += 0.7) {
          check(what, mcpr_sample_next(cursor, &request, frame, pose.data(), nullptr));
          floats.insert(floats.end(), pose.begin(), pose.end());
        }
      });
    }
  print(name + " engines", [&](mcpr_path path, std::vector<float>& floats) {
    std::vector<std::int16_t> parents;
    for (unsigned j = 0; j < info.joints; ++j)
      parents.push_back(static_cast<std::int16_t>(static_cast<int>(j) / 2 - (j == 0 ? 1 : 0)));
    if (info.joints > 1) parents[1] = 0;
    for (int engine = MCPR_MOCAPRESS; engine <= MCPR_BLENDER; ++engine)
      for (int layout = MCPR_TRANSFORMS; layout <= MCPR_HALVES; ++layout) {
        mcpr_convention convention;
        check(name, mcpr_convention_of(static_cast<mcpr_engine>(engine), &convention, nullptr));
        mcpr_sample_request request{};
        request.layout = static_cast<mcpr_layout>(layout);
        request.path = path;
        request.convention = &convention;
        request.parents = parents.data();
        std::vector<float> pose(mcpr_sample_values(cooked, &request));
        check(name,
              mcpr_sample(cooked, &request, (info.frames - 1.0) * 0.37, pose.data(), nullptr));
        floats.insert(floats.end(), pose.begin(), pose.end());
      }
  });
  print(name + " wraps", [&](mcpr_path path, std::vector<float>& floats) {
    const std::uint16_t stepped[] = {0};
    for (int wrap = MCPR_PING_PONG; wrap <= MCPR_LOOP_HOLD; ++wrap) {
      mcpr_sample_request request{};
      request.wrap = static_cast<mcpr_wrap>(wrap);
      request.path = path;
      request.stepped = stepped;
      request.stepped_count = 1;
      std::vector<float> pose(mcpr_sample_values(cooked, &request));
      for (const double frame : instants(info.frames)) {
        check(name, mcpr_sample(cooked, &request, 3 * frame - 5, pose.data(), nullptr));
        floats.insert(floats.end(), pose.begin(), pose.end());
      }
      check(name, mcpr_sample(cooked, &request, info.frames - 0.6, pose.data(), nullptr));
      floats.insert(floats.end(), pose.begin(), pose.end());
    }
  });
  print(name + " motion", [&](mcpr_path path, std::vector<float>& floats) {
    mcpr_sample_request request{};
    request.path = path;
    if (info.loop_frames > 0) request.wrap = MCPR_LOOP;
    for (const double frame : instants(info.frames)) {
      mcpr_transform moved;
      check(name, mcpr_sample_motion(cooked, &request, 0, frame / 2, 2 * frame, &moved, nullptr));
      floats.insert(floats.end(), moved.rotation, moved.rotation + 4);
      floats.insert(floats.end(), moved.translation, moved.translation + 3);
    }
  });
  print(name + " blends", [&](mcpr_path path, std::vector<float>& floats) {
    mcpr_sample_request request{};
    request.path = path;
    std::vector<mcpr_transform> first(info.joints), second(info.joints), out(info.joints);
    check(name, mcpr_sample(cooked, &request, 0, first[0].rotation, nullptr));
    check(name,
          mcpr_sample(cooked, &request, (info.frames - 1.0) * 0.6, second[0].rotation, nullptr));
    const auto keep = [&floats](const std::vector<mcpr_transform>& pose) {
      for (const mcpr_transform& joint : pose)
        floats.insert(floats.end(), joint.rotation, joint.translation + 4);
    };
    std::vector<float> mask;
    std::vector<std::int16_t> parents;
    std::vector<std::uint16_t> partners;
    for (unsigned j = 0; j < info.joints; ++j) {
      mask.push_back(static_cast<float>(j % 5) / 4);
      parents.push_back(static_cast<std::int16_t>(static_cast<int>(j) - 1));
      partners.push_back(static_cast<std::uint16_t>(j));
    }
    mcpr_pose_form form{};
    form.joints = info.joints;
    const mcpr_weighted_pose both[] = {{first.data(), 0.7F, nullptr},
                                       {second.data(), 0.9F, mask.data()}};
    check(name, mcpr_blend(&form, both, 2, out.data(), nullptr));
    keep(out);
    check(name, mcpr_blend_layer(&form, &both[1], out.data(), nullptr));
    keep(out);
    check(name, mcpr_pose_difference(&form, second.data(), out.data(), out.data(), nullptr));
    keep(out);
    const mcpr_weighted_pose added = {out.data(), 0.8F, mask.data()};
    check(name, mcpr_blend_additive(&form, &added, first.data(), nullptr));
    keep(first);
    std::vector<mcpr_mirror_joint> mirror(info.joints);
    check(name, mcpr_make_mirror(&form, second.data(), parents.data(), partners.data(), 0,
                                 mirror.data(), nullptr));
    check(name, mcpr_mirror_pose(&form, mirror.data(), 0, first.data(), out.data(), nullptr));
    keep(out);
    check(name, mcpr_split_root(nullptr, &first[0], &second[0], nullptr));
    keep(first);
    keep(second);
    for (const double frame : instants(info.frames)) {
      check(name,
            mcpr_sample_ground_motion(cooked, &request, 0, frame / 2, frame, &out[0], nullptr));
      floats.insert(floats.end(), out[0].rotation, out[0].translation + 4);
    }
  });
  print(name + " crowd", [&](mcpr_path path, std::vector<float>& floats) {
    mcpr_crowd_request request{};
    request.path = path;
    floats.resize(size_t{8} * info.joints * 64);
    std::vector<mcpr_character> all(64);
    for (size_t i = 0; i < all.size(); ++i) {
      all[i].clip = cooked;
      all[i].time = (info.frames - 1.0) * static_cast<double>(i) / 80;
      all[i].out = floats.data() + size_t{8} * info.joints * i;
    }
    Block scratch(mcpr_crowd_scratch_bytes());
    check(name,
          mcpr_sample_crowd(&request, all.data(), 64, scratch.data(), scratch.size(), nullptr));
  });
}

void print_clip(const std::string& name, Block& scratch, size_t bytes) {
  Block resident(bytes);
  const mcpr_clip* clip = nullptr;
  check(name, mcpr_build(scratch.data(), scratch.size(), resident.data(), bytes, &clip, nullptr));
  print_decoded(name, clip);
  // Without the correction, exactly, and refitted.
  for (int ik = 0; ik <= (mcpr::describe(clip).effectors > 0 ? 2 : 0); ++ik) {
    mcpr_cook_options options{};
    options.apply_ik = ik != 0 ? 1 : 0;
    options.ik_error = ik == 2 ? 0.1F : 0.0F;
    Block space(mcpr_cook_scratch_bytes(clip, &options));
    size_t size = 0;
    check(name, mcpr_cook_size(clip, &options, space.data(), space.size(), &size, nullptr));
    Block memory(size);
    const mcpr_cooked* cooked = nullptr;
    check(name, mcpr_cook(clip, &options, space.data(), space.size(), memory.data(), size, &cooked,
                          nullptr));
    const std::string cooked_name = name + (ik == 0   ? " cooked"
                                            : ik == 1 ? " cooked-ik"
                                                      : " cooked-ik-refit");
    std::printf("%s %016llx\n", cooked_name.c_str(), hash_of(memory.data(), size));
    print_sampled(cooked_name, cooked);
  }
}

void print_file(const std::string& name, Block& file, size_t size, std::uint32_t tiers) {
  mcpr_limits limits = mcpr::default_limits();
  limits.tiers = tiers;
  mcpr_info info{};
  check(name, mcpr_inspect(file.data(), size, &limits, &info, nullptr));
  Block scratch(info.read_bytes);
  size_t bytes = 0;
  check(name,
        mcpr_read(file.data(), size, &limits, scratch.data(), scratch.size(), &bytes, nullptr));
  print_clip(name, scratch, bytes);
}

/// A file as a whole, and by each of its first tiers alone.
void print_file(const std::string& name, Block& file) {
  print_file(name, file, file.size(), 0);
  mcpr_tier tier{};
  for (std::uint32_t t = 0; mcpr_tier_of(file.data(), file.size(), t, &tier, nullptr) == MCPR_OK &&
                            tier.bands_left_out > 0;
       ++t)
    print_file(name + " tier " + std::to_string(t), file, tier.bytes, t + 1);
}

void print_bank(const std::string& name, Block& file) {
  const mcpk_bank* bank = nullptr;
  check(name, mcpk_open(file.data(), file.size(), 1, &bank, nullptr));
  const mcpk_info head = mcpr::describe(bank);
  for (std::uint32_t c = 0; c < head.clips; ++c) {
    const std::string clip = name + ":" + std::to_string(c);
    if (head.is_cooked != 0) {
      const mcpr_cooked* cooked = nullptr;
      check(clip, mcpk_cooked(bank, c, &cooked, nullptr));
      print_sampled(clip, cooked);
      continue;
    }
    mcpr_info info{};
    check(clip, mcpk_inspect(bank, c, nullptr, &info, nullptr));
    Block scratch(info.read_bytes);
    size_t bytes = 0;
    check(clip, mcpk_read(bank, c, nullptr, scratch.data(), scratch.size(), &bytes, nullptr));
    print_clip(clip, scratch, bytes);
  }
}

}  // namespace

int main(int count, char** arguments) {
  std::string names;
  for (const mcpr_path path : paths()) names += " " + std::to_string(path);
  std::fprintf(stderr, "paths:%s\n", names.c_str());
  for (int i = 1; i < count; ++i) {
    Block file = contents_of(arguments[i]);
    const char* const slash = std::strrchr(arguments[i], '/');
    const std::string name = slash != nullptr ? slash + 1 : arguments[i];
    if (name.size() > 5 && name.compare(name.size() - 5, 5, ".mcpk") == 0)
      print_bank(name, file);
    else
      print_file(name, file);
  }
  return 0;
}
