// SPDX-License-Identifier: MIT
// Poses a crowd on all cores: each character plays a clip of a bank at an instant of its own.
// Compares the local transforms of all joints with ACL's for the same clips at precision 0.1 cm;
// ours have equal shell RMS and lie in one cooked bank mapped from disk. Both take turns in this
// run, so that other work on the machine slows both; medians are printed. ACL has a context for
// each clip and thread, which is made beforehand and not counted; ours needs none.
// The second comparison sorts characters by clip and instant with mcpr_sort_crowd on one thread;
// that time counts for both. Ours are then posed by mcpr_sample_crowd, ACL's one by one, since it
// has no such call.
// The third measures ours by level of detail: all joints within 10 m; without the outermost joints
// and the finest band within 30 m; beyond that, joints with four joints below them, without two
// bands. Characters stand anywhere in a square of 100 m. The last one measures all joints at each
// level alone: poses a second without these bands, and the joints' distances from their places with
// all bands.
// Usage: mocapress-crowd CLIP|FOLDER... [--every N] [--characters N] [--rounds N]
#include <unistd.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "core/bank/bank.h"
#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/random.h"
#include "core/codec/encode/encoder.h"
#include "core/codec/format/container.h"
#include "core/formats/motion_file.h"
#include "core/metrics/distortion.h"
#include "core/motion/body_tracks.h"
#include "core/runtime/mocapress_runtime.hpp"
#include "core/runtime/own_memory.h"
#include "tests/bench/acl_peer.h"
#include "tests/bench/study_clips.h"

namespace mocapress {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr double kPrecision = 0.1;  // cm, for ACL

struct Character {
  std::uint32_t clip = 0;
  float seconds = 0;
  int detail = 0;  // 0: all joints
};

/// The joints of a clip that are sampled at each level of detail.
struct Detail {
  std::vector<int> parents;
  std::vector<std::uint16_t> joints[3];
  std::unique_ptr<AlignedBytes> memory[3];
  const mcpr_selection* selection[3] = {};

  mcpr_sample_request request(int level) const {
    return {.unit = MCPR_SECONDS,
            .selection = level > 0 ? selection[level] : nullptr,
            .bands_left_out = static_cast<std::uint32_t>(level)};
  }
};

/// Chooses joints by the number of joints below them, themselves included.
Detail detail_of(const mcpk_bank* bank, std::uint32_t clip, const mcpr_cooked* cooked) {
  const std::uint32_t joints = mcpr::describe(cooked).joints;
  std::vector<int> below(joints, 1);
  std::vector<int> parents(joints);
  for (std::uint32_t j = 0; j < joints; ++j) {
    mcpr_joint joint{};
    mcpk_joint(bank, clip, j, &joint, nullptr);
    parents[j] = joint.parent;
  }
  for (std::uint32_t j = joints; j-- > 0;)
    if (parents[j] >= 0) below[static_cast<std::size_t>(parents[j])] += below[j];
  Detail detail;
  constexpr int kFewest[] = {1, 2, 5};
  for (int level = 0; level < 3; ++level) {
    std::vector<std::uint16_t>& list = detail.joints[level];
    for (std::uint32_t j = 0; j < joints; ++j)
      if (below[j] >= kFewest[level]) list.push_back(static_cast<std::uint16_t>(j));
    const auto count = static_cast<std::uint32_t>(list.size());
    AlignedBytes& memory = *(
        detail.memory[level] = std::make_unique<AlignedBytes>(mcpr_selection_bytes(cooked, count)));
    mcpr_make_selection(cooked, list.data(), count, memory.data(), memory.size(),
                        &detail.selection[level], nullptr);
  }
  detail.parents = std::move(parents);
  return detail;
}

/// World positions of the joints in a pose.
std::vector<Eigen::Vector3f> places_of(const std::vector<int>& parents,
                                       const std::vector<float>& pose) {
  std::vector<Eigen::Isometry3f> joints(parents.size());
  std::vector<Eigen::Vector3f> places;
  for (std::size_t j = 0; j < parents.size(); ++j) {
    const float* const q = &pose[8 * j];
    joints[j] = Eigen::Translation3f(q[4], q[5], q[6]) * Eigen::Quaternionf(q[0], q[1], q[2], q[3]);
    if (parents[j] >= 0) joints[j] = joints[static_cast<std::size_t>(parents[j])] * joints[j];
    places.emplace_back(joints[j].translation());
  }
  return places;
}

/// Distances of joints from their positions with all bands, cm.
struct Missed {
  double squares = 0;
  double most = 0;
  std::size_t joints = 0;

  void add(const mcpr_cooked* clip, const std::vector<int>& parents, double seconds,
           std::uint32_t bands) {
    std::vector<float> pose(8 * parents.size());
    const mcpr_sample_request all{.unit = MCPR_SECONDS};
    const mcpr_sample_request some{.unit = MCPR_SECONDS, .bands_left_out = bands};
    mcpr_sample(clip, &all, seconds, pose.data(), nullptr);
    const std::vector<Eigen::Vector3f> right = places_of(parents, pose);
    mcpr_sample(clip, &some, seconds, pose.data(), nullptr);
    const std::vector<Eigen::Vector3f> coarse = places_of(parents, pose);
    for (std::size_t j = 0; j < right.size(); ++j) {
      const auto apart = static_cast<double>((coarse[j] - right[j]).norm());
      squares += apart * apart;
      most = std::max(most, apart);
    }
    joints += right.size();
  }
  double rms() const { return std::sqrt(squares / static_cast<double>(joints)); }
};

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Seconds to pose slices of `count` characters on all cores.
template <typename PoseSlice>
double pose_slices(std::size_t characters, std::size_t at_a_time, unsigned threads,
                   const PoseSlice& pose) {
  std::atomic<std::size_t> next{0};
  const auto work = [&](unsigned thread) {
    for (std::size_t first; (first = next.fetch_add(at_a_time)) < characters;)
      pose(thread, first, std::min(at_a_time, characters - first));
  };
  const auto start = std::chrono::steady_clock::now();
  std::vector<std::thread> workers;
  for (unsigned t = 1; t < threads; ++t) workers.emplace_back(work, t);
  work(0);
  for (std::thread& worker : workers) worker.join();
  return seconds_since(start);
}

/// Seconds to pose all characters one by one on all cores.
template <typename Pose>
double pose_all(const std::vector<Character>& crowd, unsigned threads, const Pose& pose) {
  return pose_slices(crowd.size(), 64, threads,
                     [&](unsigned thread, std::size_t first, std::size_t count) {
                       for (std::size_t c = first; c < first + count; ++c) pose(thread, crowd[c]);
                     });
}

void require(mcpr_status status) {
  if (status != MCPR_OK) throw Error(mcpr_status_message(status));
}

/// Characters for mcpr_sample_crowd, put into order.
class SortedCrowd {
 public:
  SortedCrowd(const std::vector<Character>& crowd, const std::vector<const mcpr_cooked*>& clips,
              unsigned threads, std::size_t most_joints)
      : threads_(threads), poses_(crowd.size() / kSlice + 1, std::vector<float>(8 * most_joints)) {
    for (const Character& character : crowd)
      all_.push_back({.clip = clips[character.clip],
                      .selection = nullptr,
                      .time = static_cast<double>(character.seconds),
                      .out = poses_[0].data(),
                      .wrap = MCPR_CLAMP,
                      .bands_left_out = 0});
    const auto count = static_cast<std::uint32_t>(all_.size());
    // An engine would keep this memory from frame to frame.
    static const AlignedBytes scratch(mcpr_sort_crowd_scratch_bytes(count));
    const mcpr_crowd_request request{.unit = MCPR_SECONDS};
    const auto start = std::chrono::steady_clock::now();
    require(mcpr_sort_crowd(&request, all_.data(), count, scratch.data(), scratch.size(), nullptr));
    sort_seconds = seconds_since(start);
    // All poses of a slice go to the same memory, as in the other timings.
    for (std::size_t c = 0; c < all_.size(); ++c) all_[c].out = poses_[c / kSlice].data();
  }

  /// Seconds to pose, without sorting.
  double pose(bool exact) {
    const mcpr_crowd_request request{.unit = MCPR_SECONDS, .exact = exact ? 1 : 0};
    std::vector<std::unique_ptr<AlignedBytes>> scratch;
    for (unsigned t = 0; t < threads_; ++t)
      scratch.push_back(std::make_unique<AlignedBytes>(mcpr_crowd_scratch_bytes()));
    return pose_slices(
        all_.size(), kSlice, threads_, [&](unsigned thread, std::size_t first, std::size_t count) {
          require(mcpr_sample_crowd(&request, &all_[first], static_cast<std::uint32_t>(count),
                                    scratch[thread]->data(), scratch[thread]->size(), nullptr));
        });
  }

  double sort_seconds = 0;

 private:
  static constexpr std::size_t kSlice = 512;
  unsigned threads_;
  std::vector<std::vector<float>> poses_;
  std::vector<mcpr_character> all_;
};

double middle(std::vector<double> values) {
  std::ranges::nth_element(values, values.begin() + std::ssize(values) / 2);
  return values[values.size() / 2];
}

struct Crowd {
  std::vector<fs::path> clips;
  int every = 1;
  std::size_t characters = 10000;
  int rounds = 25;

  Json run() const;
};

Json Crowd::run() const {
  const fs::path folder =
      fs::temp_directory_path() / ("mocapress-crowd-" + std::to_string(getpid()));
  fs::create_directories(folder);
  std::vector<std::unique_ptr<AclClip>> theirs;
  std::vector<BankSource> sources;
  std::vector<double> durations;
  std::size_t acl_bytes = 0;
  for (const fs::path& path : clips) {
    const Motion motion = thinned(read_motion(path).motion, every);
    if (motion.clip.frames() < 2) continue;
    const Encoder encoder(motion);
    auto acl = std::make_unique<AclClip>(motion, kPrecision);
    const double shell_rms =
        measure(motion.skeleton, encoder.original_body(), acl->tracks(motion.skeleton)).shell.rms;
    const Encoding encoding = encoder.encode({.method = Method::ClosedLoop,
                                              .weighting = Weighting::Shell,
                                              .target = {Target::Kind::Error, shell_rms}});
    acl_bytes += acl->bytes();
    theirs.push_back(std::move(acl));
    char name[16];
    std::snprintf(name, sizeof name, "%06zu", sources.size());
    sources.push_back({name, folder / (std::string(name) + ".mcpr"), {}});
    write_bytes(sources.back().file, write_container(encoding.compressed));
    durations.push_back((motion.clip.frames() - 1) / motion.clip.sample_rate_hz);
  }
  make_bank(folder / "packed.mcpk", sources, {});
  make_bank(folder / "cooked.mcpk", sources,
            {.form = runtime::BankForm::Cooked, .tags = {}, .texts = {}});
  const BankFile packed(folder / "packed.mcpk");
  const MappedFile file(folder / "cooked.mcpk");
  fs::remove_all(folder);
  const mcpk_bank* bank = nullptr;
  require(mcpk_open(file.bytes().data(), file.bytes().size(), 0, &bank, nullptr));

  std::vector<const mcpr_cooked*> ours(sources.size());
  std::vector<Detail> details;
  std::size_t most_joints = 0;
  for (std::uint32_t c = 0; c < ours.size(); ++c) {
    mcpk_cooked(bank, c, &ours[c], nullptr);
    const std::uint32_t joints = mcpr::describe(ours[c]).joints;
    details.push_back(detail_of(bank, c, ours[c]));
    most_joints = std::max<std::size_t>(most_joints, joints);
  }
  const unsigned threads = std::max(std::thread::hardware_concurrency(), 1U);
  std::vector<std::vector<AclPlayer>> players(threads);
  for (auto& of_thread : players)
    for (const auto& clip : theirs) of_thread.emplace_back(*clip);
  std::vector<std::vector<float>> poses(threads, std::vector<float>(8 * most_joints));

  std::vector<double> acl_seconds;
  std::vector<double> acl_sorted_seconds;
  std::vector<double> our_seconds;
  std::vector<double> crowd_seconds;
  std::vector<double> exact_seconds;
  std::vector<double> sort_seconds;
  std::vector<double> detail_seconds;
  constexpr std::uint32_t kBands = MCPR_MOST_BANDS_LEFT_OUT + 1;
  std::vector<double> band_seconds[kBands];
  std::vector<double> selected_seconds[3];
  Missed missed[kBands];
  double sampled_joints[2] = {};
  Random random(16);
  for (int round = 0; round < rounds; ++round) {
    std::vector<Character> crowd(characters);
    for (Character& character : crowd) {
      character.clip = static_cast<std::uint32_t>(random.below(ours.size()));
      character.seconds = static_cast<float>(durations[character.clip] * random.unit());
      const double away = 100 * std::hypot(random.unit() - 0.5, random.unit() - 0.5);  // in m
      character.detail = away < 10 ? 0 : away < 30 ? 1 : 2;
      sampled_joints[0] += static_cast<double>(details[character.clip].joints[0].size());
      sampled_joints[1] +=
          static_cast<double>(details[character.clip].joints[character.detail].size());
    }
    acl_seconds.push_back(pose_all(crowd, threads, [&](unsigned t, const Character& c) {
      players[t][c.clip].sample(c.seconds);
    }));
    our_seconds.push_back(pose_all(crowd, threads, [&](unsigned t, const Character& c) {
      const mcpr_sample_request request{.unit = MCPR_SECONDS};
      mcpr_sample(ours[c.clip], &request, static_cast<double>(c.seconds), poses[t].data(), nullptr);
    }));
    SortedCrowd sorted(crowd, ours, threads, most_joints);
    sort_seconds.push_back(sorted.sort_seconds);
    crowd_seconds.push_back(sorted.sort_seconds + sorted.pose(false));
    exact_seconds.push_back(sorted.sort_seconds + sorted.pose(true));
    std::vector<Character> in_order = crowd;
    std::ranges::sort(in_order, {},
                      [](const Character& c) { return std::pair(c.clip, c.seconds); });
    acl_sorted_seconds.push_back(sorted.sort_seconds +
                                 pose_all(in_order, threads, [&](unsigned t, const Character& c) {
                                   players[t][c.clip].sample(c.seconds);
                                 }));
    detail_seconds.push_back(pose_all(crowd, threads, [&](unsigned t, const Character& c) {
      const mcpr_sample_request request = details[c.clip].request(c.detail);
      mcpr_sample(ours[c.clip], &request, static_cast<double>(c.seconds), poses[t].data(), nullptr);
    }));
    for (std::uint32_t bands = 0; bands < kBands; ++bands) {
      band_seconds[bands].push_back(pose_all(crowd, threads, [&](unsigned t, const Character& c) {
        const mcpr_sample_request request{.unit = MCPR_SECONDS, .bands_left_out = bands};
        mcpr_sample(ours[c.clip], &request, static_cast<double>(c.seconds), poses[t].data(),
                    nullptr);
      }));
      for (std::size_t c = 0; c < crowd.size(); c += 20)
        missed[bands].add(ours[crowd[c].clip], details[crowd[c].clip].parents,
                          static_cast<double>(crowd[c].seconds), bands);
    }
    for (int level = 0; level < 3; ++level)
      selected_seconds[level].push_back(
          pose_all(crowd, threads, [&](unsigned t, const Character& c) {
            const mcpr_sample_request request{.unit = MCPR_SECONDS,
                                              .selection = details[c.clip].selection[level]};
            mcpr_sample(ours[c.clip], &request, static_cast<double>(c.seconds), poses[t].data(),
                        nullptr);
          }));
  }
  const auto per_second = [&](const std::vector<double>& seconds) {
    return static_cast<double>(characters) / middle(seconds);
  };
  const auto count = static_cast<double>(characters);
  Json without_bands;
  for (std::uint32_t bands = 0; bands < kBands; ++bands)
    without_bands.push_back({{"bands_left_out", bands},
                             {"poses_per_second", per_second(band_seconds[bands])},
                             {"rms_cm", missed[bands].rms()},
                             {"max_cm", missed[bands].most}});
  Json selected;
  for (const std::vector<double>& seconds : selected_seconds)
    selected.push_back(per_second(seconds));
  return {
      {"clips", ours.size()},
      {"characters", characters},
      {"threads", threads},
      {"rounds", rounds},
      {"acl_poses_per_second", per_second(acl_seconds)},
      {"acl_sorted_poses_per_second", per_second(acl_sorted_seconds)},
      {"poses_per_second", per_second(our_seconds)},
      {"poses_to_acl", per_second(our_seconds) / per_second(acl_seconds)},
      {"crowd_poses_per_second", per_second(crowd_seconds)},
      {"exact_crowd_poses_per_second", per_second(exact_seconds)},
      {"crowd_to_best_acl", per_second(crowd_seconds) /
                                std::max(per_second(acl_seconds), per_second(acl_sorted_seconds))},
      {"exact_crowd_to_best_acl",
       per_second(exact_seconds) /
           std::max(per_second(acl_seconds), per_second(acl_sorted_seconds))},
      {"sort_us", 1e6 * middle(sort_seconds)},
      {"detail_poses_per_second", per_second(detail_seconds)},
      {"detail_joints_share", sampled_joints[1] / sampled_joints[0]},
      {"selected_poses_per_second", selected},
      {"without_bands", without_bands},
      {"acl_bytes", acl_bytes},
      {"cooked_bytes", bank->bytes},
      {"packed_bytes", packed.bank().bytes},
      {"acl_bytes_a_character", static_cast<double>(acl_bytes) / count},
      {"cooked_bytes_a_character", static_cast<double>(bank->bytes) / count},
      {"cooked_to_acl_bytes", static_cast<double>(bank->bytes) / static_cast<double>(acl_bytes)}};
}

}  // namespace
}  // namespace mocapress

int main(int argc, char** argv) {
  mocapress::Crowd crowd;
  for (int a = 1; a < argc; ++a) {
    const std::string word = argv[a];
    if (word == "--every" && a + 1 < argc)
      crowd.every = std::atoi(argv[++a]);
    else if (word == "--characters" && a + 1 < argc)
      crowd.characters = static_cast<std::size_t>(std::atoi(argv[++a]));
    else if (word == "--rounds" && a + 1 < argc)
      crowd.rounds = std::atoi(argv[++a]);
    else
      for (const auto& clip : mocapress::clips_of(word)) crowd.clips.push_back(clip);
  }
  if (crowd.clips.empty() || crowd.every < 1 || crowd.characters < 1 || crowd.rounds < 1) {
    std::fprintf(stderr,
                 "mocapress-crowd CLIP|FOLDER... [--every N] [--characters N] [--rounds N]\n");
    return 2;
  }
  try {
    std::cout << crowd.run().dump(1) << std::endl;
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "mocapress-crowd: %s\n", error.what());
    return 1;
  }
}
