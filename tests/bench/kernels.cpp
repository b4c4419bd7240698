// SPDX-License-Identifier: MIT
// Times the kernels of every path of this machine, all in turns in one run.
// Usage: mocapress-kernels FILE.mcpr
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <map>
#include <string>
#include <vector>

#include "core/base/random.h"
#include "core/runtime/format/value_prediction.h"
#include "core/runtime/mocapress_runtime.hpp"

namespace {

using namespace mocapress;

constexpr int kRounds = 15;

/// Memory for the runtime.
class Block {
 public:
  explicit Block(std::size_t size) : bytes_(size + MCPR_ALIGNMENT), size_(size) {}
  void* data() {
    const auto at = reinterpret_cast<std::uintptr_t>(bytes_.data());
    return bytes_.data() + (MCPR_ALIGNMENT - at % MCPR_ALIGNMENT) % MCPR_ALIGNMENT;
  }
  std::size_t size() const { return size_; }

 private:
  std::vector<unsigned char> bytes_;
  std::size_t size_;
};

struct Clip {
  explicit Clip(const std::vector<char>& file) {
    mcpr_info head{};
    mcpr_inspect(file.data(), file.size(), nullptr, &head, nullptr);
    Block scratch(head.read_bytes);
    std::size_t bytes = 0;
    mcpr_read(file.data(), file.size(), nullptr, scratch.data(), scratch.size(), &bytes, nullptr);
    resident = Block(bytes);
    mcpr_build(scratch.data(), scratch.size(), resident.data(), bytes, &clip, nullptr);
    Block space(mcpr_cook_scratch_bytes(clip, nullptr));
    mcpr_cook_size(clip, nullptr, space.data(), space.size(), &bytes, nullptr);
    block = Block(bytes);
    mcpr_cook(clip, nullptr, space.data(), space.size(), block.data(), bytes, &cooked, nullptr);
  }

  Block resident{0};
  Block block{0};
  const mcpr_clip* clip = nullptr;
  const mcpr_cooked* cooked = nullptr;
};

void sample(const Clip& clip, mcpr_path path, std::vector<float>& out) {
  mcpr_sample_request request{};
  request.path = path;
  Random random(1);
  const double last = mcpr::describe(clip.cooked).frames - 1.0;
  for (int i = 0; i < 2000; ++i)
    mcpr_sample(clip.cooked, &request, last * random.unit(), out.data(), nullptr);
}

void play(const Clip& clip, mcpr_path path, std::vector<float>& out) {
  mcpr_sample_request request{};
  request.path = path;
  Block memory(mcpr_cursor_bytes(clip.cooked));
  mcpr_cursor* cursor = nullptr;
  mcpr_make_cursor(clip.cooked, memory.data(), memory.size(), &cursor, nullptr);
  const double last = mcpr::describe(clip.cooked).frames - 1.0;
  double frame = 0;
  for (int i = 0; i<2000; ++i, frame = frame + 2> last ? 0 : frame + 2)
    mcpr_sample_next(cursor, &request, frame, out.data(), nullptr);
}

void decode(const Clip& clip, mcpr_path path, std::vector<float>& out) {
  mcpr_request request{};
  request.path = path;
  Block scratch(mcpr_scratch_bytes(clip.clip, &request));
  const std::uint32_t frames = mcpr::describe(clip.clip).frames;
  out.resize(std::max(out.size(), mcpr_frame_values(clip.clip, &request) * frames));
  mcpr_decode_frames(clip.clip, &request, 0, frames, out.data(), scratch.data(), scratch.size(),
                     nullptr);
}

/// Predicts and learns as when reading a file, with realistic numbers.
void predict(const Clip&, mcpr_path path, std::vector<float>& out) {
  const runtime::PredictionKernels& kernels = *runtime::prediction_of(path);
  runtime::SignalPrediction signal;
  runtime::RestPrediction rest;
  signal.begin();
  rest.begin();
  Random random(1);
  std::array<std::int32_t, runtime::RestPrediction::kTaps> values;
  for (std::int32_t& value : values) value = static_cast<std::int32_t>(random.below(41)) - 20;
  runtime::RestPrediction::Taps taps;
  int sum = 0;
  for (int i = 0; i < 5000; ++i) {
    values[static_cast<std::size_t>(i) % values.size()] = i % 37 - 18;
    kernels.normalise(values, runtime::kInverseScales[8], taps);
    const int first = kernels.of_signal(signal, taps.data());
    const int second = kernels.of_rest(rest, taps);
    kernels.signal_follows(signal, taps.data(), i % 23 - first);
    kernels.rest_follows(rest, taps, i % 23 - first - second);
    sum += first + second;
  }
  out[0] = static_cast<float>(sum);
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 2) {
    std::fprintf(stderr, "usage: %s FILE.mcpr\n", arguments[0]);
    return 2;
  }
  std::ifstream stream(arguments[1], std::ios::binary);
  const Clip clip({std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()});
  if (clip.cooked == nullptr) {
    std::fprintf(stderr, "%s: not a clip that can be cooked\n", arguments[1]);
    return 3;
  }
  struct Work {
    const char* name;
    void (*run)(const Clip&, mcpr_path, std::vector<float>&);
  };
  constexpr Work kWorks[] = {{"a random instant", sample},
                             {"play by a cursor", play},
                             {"all frames decoded", decode},
                             {"values predicted", predict}};
  const std::map<mcpr_path, const char*> names = {{MCPR_PATH_PLAIN, "plain"},
                                                  {MCPR_PATH_SSE2, "SSE2"},
                                                  {MCPR_PATH_AVX2, "AVX2"},
                                                  {MCPR_PATH_NEON, "NEON"},
                                                  {MCPR_PATH_WASM, "WASM"}};
  std::vector<float> out(std::size_t{8} * mcpr::describe(clip.cooked).joints);
  for (const Work& work : kWorks) {
    std::map<mcpr_path, double> least;
    for (int round = 0; round < kRounds; ++round)
      for (const auto& [path, name] : names) {
        if (mcpr_path_exists(path) == 0) continue;
        const auto begin = std::chrono::steady_clock::now();
        work.run(clip, path, out);
        const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
        const auto [at, is_new] = least.emplace(path, took.count());
        if (!is_new) at->second = std::min(at->second, took.count());
      }
    std::printf("%-20s", work.name);
    for (const auto& [path, seconds] : least)
      std::printf("  %s %.2f", names.at(path), seconds / least.at(MCPR_PATH_PLAIN));
    std::printf("  of plain\n");
  }
  return 0;
}
