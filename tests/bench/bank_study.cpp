// SPDX-License-Identifier: MIT
// What a bank takes, and how fast it is there: mapping and opening it, then its first pose, from
// the name of a clip on; each from the middle of many mappings, each of another clip. The file is
// in the system's cache then: a disk's own time is not in these figures. One JSON object a bank.
// Usage: mocapress-bank-study BANK.mcpk...
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <exception>
#include <iostream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/bank/bank_file.h"
#include "core/base/error.h"
#include "core/base/random.h"

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

void require(const mcpr_result& result) {
  if (result.status != MCPR_OK) throw Error(result.message);
}

/// Of a bank that nobody looked into yet.
void time_first_pose(const std::string& path, bool beforehand, const std::string& name,
                     std::vector<double>& opens, std::vector<double>& poses) {
  std::vector<float> pose(8 * 4096);
  Clock::time_point start = Clock::now();
  const MappedFile file(path, beforehand);
  const mcpk_bank* bank = nullptr;
  require(mcpk_open(file.bytes().data(), file.bytes().size(), 0, &bank));
  opens.push_back(microseconds_since(start));
  start = Clock::now();
  const mcpr_cooked* clip = nullptr;
  require(mcpk_cooked(bank, static_cast<std::uint32_t>(mcpk_find(bank, name.c_str())), &clip));
  const mcpr_sample_request request{.unit = MCPR_SECONDS};
  require(mcpr_sample(clip, &request, 0.3, pose.data()));
  poses.push_back(microseconds_since(start));
}

/// Of clips at random, each in a mapping of its own.
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

}  // namespace
}  // namespace mocapress

int main(int argc, char** argv) {
  try {
    for (int a = 1; a < argc; ++a) std::cout << mocapress::study(argv[a]).dump() << std::endl;
    return argc > 1 ? 0 : 2;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "mocapress-bank-study: %s\n", error.what());
    return 1;
  }
}
