// SPDX-License-Identifier: MIT
// Prints what the native runtime makes of a .mcpr file, as JSON: native_poses CLIP.mcpr INSTANTS.
// The tests of the browser compare WebAssembly with it. World positions are those that
// mcpr_decode_moment gives; poses are sampled by a cursor.
#include "mocapress_runtime.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace {

void check(mcpr_status status) {
  if (status == MCPR_OK) return;
  std::fprintf(stderr, "native_poses: %s\n", mcpr_status_message(status));
  std::exit(1);
}

void* memory_of(std::size_t bytes) {
  void* const memory =
      std::aligned_alloc(MCPR_ALIGNMENT, (bytes / MCPR_ALIGNMENT + 1) * MCPR_ALIGNMENT);
  if (memory == nullptr) std::exit(1);
  return memory;
}

std::vector<char> bytes_of(const char* path) {
  std::FILE* const file = std::fopen(path, "rb");
  if (file == nullptr) std::exit(1);
  std::vector<char> bytes;
  for (int c; (c = std::fgetc(file)) != EOF;) bytes.push_back(static_cast<char>(c));
  std::fclose(file);
  return bytes;
}

const mcpr_clip* clip_of(const std::vector<char>& file, mcpr_info& info) {
  std::size_t bytes = 0;
  const mcpr_clip* clip = nullptr;
  check(mcpr_inspect(file.data(), file.size(), nullptr, &info, nullptr));
  void* const scratch = memory_of(info.read_bytes);
  check(mcpr_read(file.data(), file.size(), nullptr, scratch, info.read_bytes, &bytes, nullptr));
  check(mcpr_build(scratch, info.read_bytes, memory_of(bytes), bytes, &clip, nullptr));
  return clip;
}

/// Cooked as the package does.
const mcpr_cooked* cooked_of(const mcpr_clip* clip, float ik_error) {
  mcpr_cook_options options = {};
  options.apply_ik = 1;
  options.ik_error = ik_error;
  const std::size_t scratch_bytes = mcpr_cook_scratch_bytes(clip, &options);
  void* const scratch = memory_of(scratch_bytes);
  std::size_t bytes = 0;
  const mcpr_cooked* cooked = nullptr;
  check(mcpr_cook_size(clip, &options, scratch, scratch_bytes, &bytes, nullptr));
  check(
      mcpr_cook(clip, &options, scratch, scratch_bytes, memory_of(bytes), bytes, &cooked, nullptr));
  return cooked;
}

void print(const char* name, const std::vector<float>& values) {
  std::printf(",\n\"%s\": [", name);
  for (std::size_t i = 0; i < values.size(); ++i)
    std::printf("%s%.9g", i > 0 ? "," : "", static_cast<double>(values[i]));
  std::printf("]");
}

/// The least of many rounds, for other programs may run.
template <typename Instant>
double microseconds_a_pose(mcpr_cursor* cursor, const Instant& instant, std::vector<float>& pose) {
  mcpr_sample_request request = {};
  request.unit = MCPR_SECONDS;
  constexpr int kRounds = 100;
  constexpr int kPoses = 1200;
  double least = std::numeric_limits<double>::infinity();
  for (int round = 0; round < kRounds; ++round) {
    const auto start = std::chrono::steady_clock::now();
    for (int i = 0; i < kPoses; ++i)
      check(mcpr_sample_next(cursor, &request, instant(i), pose.data(), nullptr));
    const std::chrono::duration<double, std::micro> taken =
        std::chrono::steady_clock::now() - start;
    least = std::min(least, taken.count() / kPoses);
  }
  return least;
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 3) return 2;
  mcpr_info file;
  const mcpr_clip* const clip = clip_of(bytes_of(arguments[1]), file);
  const mcpr_cooked* const cooked = cooked_of(clip, file.error);
  const mcpr_clip_info info = mcpr::describe(clip);
  const int instants = std::atoi(arguments[2]);
  mcpr_cursor* cursor = nullptr;
  check(mcpr_make_cursor(cooked, memory_of(mcpr_cursor_bytes(cooked)), mcpr_cursor_bytes(cooked),
                         &cursor, nullptr));
  mcpr_request decoding = {};
  decoding.output = MCPR_POSITIONS;
  decoding.apply_ik = 1;
  const std::size_t scratch_bytes = mcpr_scratch_bytes(clip, &decoding);
  void* const scratch = memory_of(scratch_bytes);
  mcpr_sample_request sampling = {};
  sampling.unit = MCPR_SECONDS;
  std::vector<float> pose(8 * info.joints), place(3 * info.joints), poses, places, seconds;
  for (int i = 0; i < instants; ++i) {
    // Halves and quarters of frames are exact in any unit of time.
    const double frame = static_cast<int>(4.0 * i * (info.frames - 1) / (instants - 1)) / 4.0;
    const double second = static_cast<float>(frame / info.sample_rate);
    seconds.push_back(static_cast<float>(second));
    check(mcpr_sample_next(cursor, &sampling, second, pose.data(), nullptr));
    poses.insert(poses.end(), pose.begin(), pose.end());
    check(
        mcpr_decode_moment(clip, &decoding, frame, place.data(), scratch, scratch_bytes, nullptr));
    places.insert(places.end(), place.begin(), place.end());
  }
  std::printf("{\"joints\": [");
  for (std::uint32_t j = 0; j < info.joints; ++j) {
    mcpr_joint joint;
    check(mcpr_clip_joint(clip, j, &joint, nullptr));
    std::printf("%s{\"name\": \"%s\", \"parent\": %d}", j > 0 ? ", " : "", joint.name,
                joint.parent);
  }
  std::printf("],\n\"sample_rate\": %.9g", info.sample_rate);
  print("seconds", seconds);
  print("poses", poses);
  print("positions", places);
  std::mt19937 random(1);
  const double duration = (info.frames - 1) / info.sample_rate;
  std::uniform_real_distribution<double> anywhere(0, duration);
  const double playing = microseconds_a_pose(
      cursor, [&](int i) { return i % 600 / 599.0 * duration; }, pose);
  const double jumping = microseconds_a_pose(
      cursor, [&](int) { return anywhere(random); }, pose);
  std::printf(",\n\"us_playing\": %.4g, \"us_random\": %.4g}\n", playing, jumping);
}
