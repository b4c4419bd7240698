// SPDX-License-Identifier: MIT
// Measures the size and speed of banks: mapping and opening, then the first pose from the name of a
// clip on. Each time is the median of many mappings, each for another clip. The file is in the
// system's cache, so the disk's own time is not measured. Prints one JSON object for each bank.
// With --against, times three instants of every clip of a cooked bank in random order instead, and
// compares one clip in a hundred with the packed bank of the same clips; fails if the differences
// exceed the interface's promises.
// Usage: mocapress-bank-study BANK.mcpk...
//        mocapress-bank-study COOKED.mcpk --against PACKED.mcpk
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <exception>
#include <iostream>
#include <nlohmann/json.hpp>
#include <numeric>
#include <string>
#include <string_view>
#include <vector>

#include "core/bank/bank_file.h"
#include "core/base/error.h"
#include "core/base/random.h"
#include "core/runtime/mocapress_runtime.hpp"
#include "core/runtime/own_memory.h"

namespace mocapress {
namespace {

using Json = nlohmann::ordered_json;
using Clock = std::chrono::steady_clock;

double microseconds_since(Clock::time_point start) {
  return std::chrono::duration<double, std::micro>(Clock::now() - start).count();
}

Json spread(std::vector<double> values) {
  std::ranges::sort(values);
  const auto at = [&](double share) {
    return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
  };
  return {{"median", at(0.5)}, {"p99", at(0.99)}, {"max", at(1)}};
}

void require(mcpr_status status) {
  if (status != MCPR_OK) throw Error(mcpr_status_message(status));
}

/// Times the first pose in a freshly mapped bank.
void time_first_pose(const std::string& path, bool beforehand, const std::string& name,
                     std::vector<double>& opens, std::vector<double>& poses) {
  std::vector<float> pose(8 * 4096);
  Clock::time_point start = Clock::now();
  const MappedFile file(path, beforehand);
  const mcpk_bank* bank = nullptr;
  require(mcpk_open(file.bytes().data(), file.bytes().size(), 0, &bank, nullptr));
  opens.push_back(microseconds_since(start));
  start = Clock::now();
  const mcpr_cooked* clip = nullptr;
  require(
      mcpk_cooked(bank, static_cast<std::uint32_t>(mcpk_find(bank, name.c_str())), &clip, nullptr));
  const mcpr_sample_request request{.unit = MCPR_SECONDS};
  require(mcpr_sample(clip, &request, 0.3, pose.data(), nullptr));
  poses.push_back(microseconds_since(start));
}

/// Times first poses of random clips, each in a mapping of its own.
Json first_poses(const BankFile& bank, const std::string& path, bool beforehand) {
  constexpr int kMappings = 1001;
  std::vector<double> opens;
  std::vector<double> poses;
  Random random(7);
  for (int i = 0; i < kMappings; ++i) {
    const auto clip = static_cast<std::uint32_t>(random.below(bank.clips()));
    time_first_pose(path, beforehand, bank.entry(clip).name, opens, poses);
  }
  return {{"open_us", spread(opens)}, {"first_pose_us", spread(poses)}};
}

Json study(const std::string& path) {
  Clock::time_point start = Clock::now();
  const BankFile bank(path);
  const double checked_us = microseconds_since(start);
  std::uint64_t motion_bytes = 0;
  std::uint64_t clip_bytes = 0;
  for (std::uint32_t clip = 0; clip < bank.clips(); ++clip) {
    const BankClip described = bank.describe(clip);
    motion_bytes += described.motion_bytes;
    clip_bytes += described.bytes;
  }
  Json row{{"bank", path},
           {"form", bank.is_cooked() ? "cooked" : "packed"},
           {"clips", bank.clips()},
           {"bytes", bank.bank().bytes},
           {"clip_bytes", clip_bytes},
           {"table_bytes", bank.bank().tables.bytes},
           {"item_bytes", bank.bank().items.bytes},
           {"index_bytes", bank.bank().index.bytes},
           {"full_check_us", checked_us}};
  if (!bank.is_cooked()) {
    row["motion_bytes"] = motion_bytes;
    row["bytes_to_motion"] =
        static_cast<double>(bank.bank().bytes) / static_cast<double>(motion_bytes);
    return row;
  }
  row["pages_as_touched"] = first_poses(bank, path, false);
  row["pages_beforehand"] = first_poses(bank, path, true);
  return row;
}

/// A clip of a packed bank, decoded as an engine would.
class DecodedClip {
 public:
  DecodedClip(const mcpk_bank& bank, std::uint32_t clip)
      : scratch_(read_bytes(bank, clip)), resident_(resident_bytes(bank, clip)) {
    require(mcpr_build(scratch_.data(), scratch_.size(), resident_.data(), resident_.size(), &clip_,
                       nullptr));
  }

  /// The pose, 7 floats for each joint.
  std::vector<float> pose(double frame) const {
    const mcpr_request request{.output = MCPR_LOCAL};
    const AlignedBytes working(mcpr_scratch_bytes(clip_, &request));
    std::vector<float> pose(mcpr_frame_values(clip_, &request));
    require(mcpr_decode_moment(clip_, &request, frame, pose.data(), working.data(), working.size(),
                               nullptr));
    return pose;
  }

 private:
  static std::size_t read_bytes(const mcpk_bank& bank, std::uint32_t clip) {
    mcpr_info info{};
    require(mcpk_inspect(&bank, clip, nullptr, &info, nullptr));
    return info.read_bytes;
  }
  std::size_t resident_bytes(const mcpk_bank& bank, std::uint32_t clip) const {
    std::size_t bytes = 0;
    require(mcpk_read(&bank, clip, nullptr, scratch_.data(), scratch_.size(), &bytes, nullptr));
    return bytes;
  }

  AlignedBytes scratch_;
  AlignedBytes resident_;
  const mcpr_clip* clip_ = nullptr;
};

/// The largest differences between joints of two poses.
struct Difference {
  double radians = 0;
  double cm = 0;

  void add(const std::vector<mcpr_transform>& sampled, const std::vector<float>& decoded) {
    if (decoded.size() != 7 * sampled.size()) throw Error("the banks have other clips");
    for (std::size_t j = 0; j < sampled.size(); ++j) {
      const float* const joint = &decoded[7 * j];
      double towards = 0;  // dot product of two quaternions: either sign is the same rotation
      double apart = 0;
      double against = 0;
      for (int i = 0; i < 4; ++i) {
        const double a = sampled[j].rotation[i];
        const double b = joint[i];
        towards += a * b;
        apart += (a - b) * (a - b);
        against += (a + b) * (a + b);
      }
      radians = std::max(radians, 2 * std::sqrt(towards > 0 ? apart : against));
      for (int i = 0; i < 3; ++i)
        cm = std::max(cm, double{std::abs(sampled[j].translation[i] - joint[4 + i])});
    }
  }
};

Json sample_all(const std::string& path, const std::string& packed_path) {
  constexpr double kInstants[] = {0, 0.37, 1};  // in clip lengths
  constexpr std::uint32_t kOneIn = 100;
  const BankFile packed(packed_path);
  Clock::time_point start = Clock::now();
  const MappedFile file(path);
  const mcpk_bank* bank = nullptr;
  require(mcpk_open(file.bytes().data(), file.bytes().size(), 0, &bank, nullptr));
  const double open_us = microseconds_since(start);
  const std::uint32_t clips = mcpr::describe(bank).clips;
  std::vector<std::uint32_t> order(clips);
  std::iota(order.begin(), order.end(), 0U);
  Random random(11);
  for (std::uint32_t i = clips; i > 1; --i) std::swap(order[i - 1], order[random.below(i)]);
  const mcpr_sample_request request{};
  std::vector<mcpr_transform> pose;
  const auto sample = [&](std::uint32_t number, double share) {
    const mcpr_cooked* clip = nullptr;
    require(mcpk_cooked(bank, number, &clip, nullptr));
    const mcpr_cooked_info info = mcpr::describe(clip);
    pose.resize(info.joints);
    const double frame = share * (info.frames - 1.0);
    require(mcpr_sample(clip, &request, frame, pose.front().rotation, nullptr));
    return frame;
  };
  std::uint64_t poses = 0;
  start = Clock::now();
  for (const std::uint32_t clip : order)
    for (const double share : kInstants) {
      sample(clip, share);
      ++poses;
    }
  const double sampled_us = microseconds_since(start);
  Difference most;
  std::uint64_t compared = 0;
  for (std::uint32_t i = 0; i < clips; i += kOneIn) {
    char name[MCPK_NAME_BYTES];
    if (mcpk_name(bank, order[i], name) == 0) throw Error("a clip without a name");
    const std::int32_t there = mcpk_find(&packed.bank(), name);
    if (there < 0) throw Error(std::string("the packed bank has no clip ") + name);
    const DecodedClip decoded(packed.bank(), static_cast<std::uint32_t>(there));
    for (const double share : kInstants) {
      const double frame = sample(order[i], share);
      most.add(pose, decoded.pose(frame));
      ++compared;
    }
  }
  const bool is_as_promised = most.radians <= 5e-4 && most.cm <= 2e-3;
  if (!is_as_promised) throw Error(path + ": poses are further off than 5e-4 radians or 2e-3 cm");
  return {{"bank", path},
          {"clips", clips},
          {"open_us", open_us},
          {"poses", poses},
          {"us_a_pose", sampled_us / static_cast<double>(poses)},
          {"compared", compared},
          {"most_radians", most.radians},
          {"most_cm", most.cm}};
}

}  // namespace
}  // namespace mocapress

int main(int argc, char** argv) {
  try {
    if (argc == 4 && std::string_view(argv[2]) == "--against") {
      std::cout << mocapress::sample_all(argv[1], argv[3]).dump() << std::endl;
      return 0;
    }
    for (int a = 1; a < argc; ++a) std::cout << mocapress::study(argv[a]).dump() << std::endl;
    return argc > 1 ? 0 : 2;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "mocapress-bank-study: %s\n", error.what());
    return 1;
  }
}
