// SPDX-License-Identifier: MIT
// Makes poses of one clip, whose instructions neon_counts.py counts, and prints the sum of the last
// one. Compiled by itself with the joined runtime and ACL, for each processor.
// random: at instants far from each other. play: forwards at 60 Hz, ours by a cursor.
// Usage: pose_counts FILE.acl|FILE.cooked random|play POSES
#include <acl/core/compressed_tracks.h>
#include <acl/decompression/decompress.h>
#include <mocapress_runtime.hpp>

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <numeric>
#include <string_view>
#include <vector>

#include "tests/bench/acl_pose_writer.h"

namespace {

[[noreturn]] void stop(const char* why) {
  std::fprintf(stderr, "pose_counts: %s\n", why);
  std::exit(1);
}

struct Poses {
  bool random;
  std::uint32_t count;

  /// Calls sample(seconds) for each pose.
  template <typename Sample>
  void make(double duration, const Sample& sample) const {
    const auto steps = static_cast<std::uint32_t>(duration * 60);
    for (std::uint32_t i = 0; i < count; ++i)
      sample(random ? duration / 4294967296.0 * (i * 2654435769U)  // by the golden ratio
                    : i % steps / 60.0);
  }
};

double sum_of_theirs(const void* block, const Poses& poses) {
  const auto* const clip = static_cast<const acl::compressed_tracks*>(block);
  acl::decompression_context<acl::default_transform_decompression_settings> context;
  if (!context.initialize(*clip)) stop("no clip of ACL's");
  mocapress::PoseWriter writer;
  writer.joints.resize(clip->get_num_tracks(), rtm::qvv_identity());
  poses.make(clip->get_duration(), [&](double seconds) {
    context.seek(static_cast<float>(seconds), acl::sample_rounding_policy::none);
    context.decompress_tracks(writer);
  });
  double sum = 0;
  for (const rtm::qvvf& joint : writer.joints)
    sum += rtm::quat_get_w(joint.rotation) + rtm::vector_get_x(joint.translation);
  return sum;
}

double sum_of_ours(const void* block, std::size_t size, const Poses& poses) {
  const mcpr_cooked* clip = nullptr;
  if (mcpr_open_cooked(block, size, 0, &clip, nullptr) != MCPR_OK) stop("no cooked clip");
  const mcpr_cooked_info info = mcpr::describe(clip);
  const mcpr_sample_request request{.unit = MCPR_SECONDS};
  std::vector<float> out(mcpr_sample_values(clip, &request));
  void* const memory = std::aligned_alloc(MCPR_ALIGNMENT, 8192);  // the most a cursor takes
  mcpr_cursor* cursor = nullptr;
  if (mcpr_make_cursor(clip, memory, 8192, &cursor, nullptr) != MCPR_OK) stop("no cursor");
  poses.make((info.frames - 1) / info.sample_rate, [&](double seconds) {
    const mcpr_status status =
        poses.random ? mcpr_sample(clip, &request, seconds, out.data(), nullptr)
                     : mcpr_sample_next(cursor, &request, seconds, out.data(), nullptr);
    if (status != MCPR_OK) stop(mcpr_status_message(status));
  });
  std::free(memory);
  return std::accumulate(out.begin(), out.end(), 0.0);
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 4) stop("usage: pose_counts FILE.acl|FILE.cooked random|play POSES");
  const std::string_view name = arguments[1];
  std::ifstream file(arguments[1], std::ios::binary | std::ios::ate);
  if (!file) stop("the file cannot be opened");
  const auto size = static_cast<std::size_t>(file.tellg());
  // ACL may read 16 bytes more.
  void* const block =
      std::aligned_alloc(MCPR_ALIGNMENT, (size / MCPR_ALIGNMENT + 2) * MCPR_ALIGNMENT);
  file.seekg(0).read(static_cast<char*>(block), static_cast<std::streamsize>(size));
  const Poses poses{std::string_view(arguments[2]) == "random",
                    static_cast<std::uint32_t>(std::atoi(arguments[3]))};
  std::printf("%.4f\n", name.ends_with(".acl") ? sum_of_theirs(block, poses)
                                               : sum_of_ours(block, size, poses));
  std::free(block);
}
