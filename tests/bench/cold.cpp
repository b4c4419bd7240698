// SPDX-License-Identifier: MIT
// Times poses at random instants of clips that are not in the caches, as in a game, beside ACL.
// Cuts pieces of half a second to two seconds out of the clips, or with --seconds of a quarter to
// all of so many, compresses each by ACL at precision 0.1 cm and by ours at equal shell RMS, and
// copies them until there are 10,000 in memory: ours in one cooked bank, ACL's blocks one after the
// other. Each pass samples every clip once, in an order at random; all ways take turns in one run,
// in an order at random. Medians of 25 poses at a time are printed.
// warm: the first 20 clips only, again and again. between: what the other clips take of the caches
// lies between two poses of one clip. flushed: all clips were flushed from all caches before.
// asked before: all bytes of a clip were prefetched while the pose before it was made. A crowd, of
// 25 characters, does so itself.
// ACL has one context that goes over to each clip, or one for each clip; ours needs none. By SSE2,
// ours has the instructions that ACL is compiled for.
// Usage: mocapress-cold CLIP|FOLDER... [--pieces N] [--seconds N] [--clips N] [--rounds N]
//   [--detail-bands N]
#include <immintrin.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
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
#include "core/runtime/own_memory.h"
#include "tests/bench/acl_peer.h"
#include "tests/bench/study_clips.h"

namespace mocapress {
namespace {

namespace fs = std::filesystem;

constexpr double kPrecision = 0.1;  // cm, for ACL
constexpr std::size_t kLine = 64;   // bytes of a line of the caches
constexpr std::size_t kWarmClips = 20;
constexpr std::size_t kTogether = 25;  // poses timed together, so that few are interrupted

struct Instant {
  std::size_t clip;
  float seconds;
};

struct Cold {
  std::vector<fs::path> clips;
  std::size_t pieces = 250;
  std::size_t copies = 10000;  // clips in memory
  int rounds = 15;
  int seconds = 2;                 // the longest piece; the shortest is a quarter of it
  std::uint32_t detail_bands = 0;  // in ours, as in mcpr_cook_options

  void run() const;
};

/// Frames out of a motion that is loaded, about as long as a game's clips.
Motion piece_of(const Motion& whole, int seconds, Random& random) {
  Motion piece = whole;
  const auto frames = static_cast<std::uint64_t>(whole.clip.frames());
  const auto most = static_cast<std::uint64_t>(seconds * whole.clip.sample_rate_hz);
  const std::uint64_t count = std::min(frames, most / 4 + random.below(most - most / 4));
  const auto first = static_cast<Eigen::Index>(random.below(frames - count + 1));
  piece.clip.channels =
      whole.clip.channels.middleRows(first, static_cast<Eigen::Index>(count)).eval();
  return piece;
}

void flush(const std::byte* bytes, std::size_t size) {
  for (std::size_t i = 0; i < size; i += kLine) _mm_clflush(bytes + i);
  _mm_mfence();
}

void Cold::run() const {
  const fs::path folder =
      fs::temp_directory_path() / ("mocapress-cold-" + std::to_string(getpid()));
  fs::create_directories(folder);
  Random random(47);
  std::vector<Motion> wholes;
  for (const fs::path& path : clips) wholes.push_back(read_motion(path).motion);
  std::vector<std::unique_ptr<AclClip>> theirs;
  std::vector<float> durations;
  std::size_t joints = 0;
  std::size_t coded = 0;
  for (std::size_t i = 0; i < pieces; ++i) {
    const Motion motion = piece_of(wholes[i % wholes.size()], seconds, random);
    const Encoder encoder(motion);
    theirs.push_back(std::make_unique<AclClip>(motion, kPrecision));
    const Eigen::MatrixXd tracks = theirs.back()->tracks(motion.skeleton);
    const double shell_rms = measure(motion.skeleton, encoder.original_body(), tracks).shell.rms;
    const Encoding encoding = encoder.encode({.method = Method::ClosedLoop,
                                              .weighting = Weighting::Shell,
                                              .target = {Target::Kind::Error, shell_rms}});
    coded += encoding.compressed.motion_bytes();
    write_bytes(folder / (std::to_string(i) + ".mcpr"), write_container(encoding.compressed));
    durations.push_back(
        static_cast<float>((motion.clip.frames() - 1) / motion.clip.sample_rate_hz));
    joints = std::max(joints, static_cast<std::size_t>(motion.skeleton.joint_count()));
  }
  std::vector<BankSource> sources;
  for (std::size_t c = 0; c < copies; ++c) {
    char name[24];
    std::snprintf(name, sizeof name, "%06zu", c);
    sources.push_back({name, folder / (std::to_string(c % pieces) + ".mcpr"), {}});
  }
  make_bank(folder / "cooked.mcpk", sources,
            {.form = runtime::BankForm::Cooked,
             .tags = {},
             .texts = {},
             .cooking = {.detail_bands = detail_bands}});
  const MappedFile file(folder / "cooked.mcpk");
  fs::remove_all(folder);
  const AlignedBytes memory(file.bytes().size());
  std::memcpy(memory.data(), file.bytes().data(), file.bytes().size());
  const mcpk_bank* bank = nullptr;
  if (mcpk_open(memory.data(), memory.size(), 1, &bank, nullptr) != MCPR_OK)
    throw Error("the bank cannot be opened");
  std::vector<const mcpr_cooked*> ours(copies);
  std::vector<std::size_t> sizes(copies);
  for (std::uint32_t c = 0; c < copies; ++c) {
    mcpk_cooked(bank, c, &ours[c], nullptr);
    mcpr_cooked_info info;
    mcpr_cooked_describe(ours[c], &info);
    sizes[c] = info.bytes;
  }

  constexpr std::size_t kAclAlignment = 16;
  std::vector<std::size_t> places;
  std::size_t acl_bytes = 0;
  for (std::size_t c = 0; c < copies; ++c) {
    places.push_back(acl_bytes);
    acl_bytes += (theirs[c % pieces]->bytes() + kAclAlignment - 1) / kAclAlignment * kAclAlignment;
  }
  const AlignedBytes acl(acl_bytes);
  auto* const blocks = static_cast<std::byte*>(acl.data());
  for (std::size_t c = 0; c < copies; ++c)
    std::ranges::copy(theirs[c % pieces]->block(), blocks + places[c]);
  std::vector<AclPlayer> players;
  for (std::size_t c = 0; c < copies; ++c) players.emplace_back(blocks + places[c], joints);
  AclPlayer player(blocks, joints);

  std::vector<float> out(8 * joints);
  // ACL's bytes are asked for by the same function, which looks at none of them.
  const auto acl_ask = [&](std::size_t clip) {
    const std::size_t end = clip + 1 < copies ? places[clip + 1] : acl_bytes;
    mcpr_prefetch_hint(reinterpret_cast<const mcpr_cooked*>(blocks + places[clip]),
                       end - places[clip]);
  };
  const auto acl_sample = [&](const Instant& at) {
    player.open(blocks + places[at.clip]);
    player.sample(at.seconds);
  };
  const auto ask = [&](std::size_t clip) { mcpr_prefetch_hint(ours[clip], sizes[clip]); };
  const auto sample_by = [&](mcpr_path path) {
    return [&, path](const Instant& at) {
      const mcpr_sample_request request{.unit = MCPR_SECONDS, .path = path};
      mcpr_sample(ours[at.clip], &request, static_cast<double>(at.seconds), out.data(), nullptr);
    };
  };
  const AlignedBytes crowd_scratch(mcpr_crowd_scratch_bytes());
  const auto sample_crowd = [&](const Instant* first) {
    const mcpr_crowd_request request{.unit = MCPR_SECONDS};
    mcpr_character characters[kTogether] = {};
    for (std::size_t k = 0; k < kTogether; ++k)
      characters[k] = {.clip = ours[first[k].clip],
                       .time = static_cast<double>(first[k].seconds),
                       .out = out.data()};
    mcpr_sample_crowd(&request, characters, kTogether, crowd_scratch.data(), crowd_scratch.size(),
                      nullptr);
  };
  /// Samples kTogether instants, one by one.
  const auto each = [](auto sample) {
    return [=](const Instant* first) { std::for_each_n(first, kTogether, sample); };
  };
  /// The same, and asks for each one's clip a pose earlier.
  const auto each_asked = [](auto sample, auto ask_for) {
    return [=](const Instant* first) {
      for (const Instant* at = first; at != first + kTogether; ++at) {
        ask_for(at[1].clip);
        sample(*at);
      }
    };
  };
  struct Way {
    const char* name;
    std::function<void(const Instant* first)> sample;  // kTogether of them; one more follows
    std::vector<double> us = {};                       // a pose
  };
  Way ways[] = {
      {"ACL, one context", each(acl_sample)},
      {"ACL, one a clip", each([&](const Instant& at) { players[at.clip].sample(at.seconds); })},
      {"ACL, asked before", each_asked(acl_sample, acl_ask)},
      {"ours", each(sample_by(MCPR_PATH_BEST))},
      {"ours, asked before", each_asked(sample_by(MCPR_PATH_BEST), ask)},
      {"ours, a crowd", sample_crowd},
      {"ours, SSE2", each(sample_by(MCPR_PATH_SSE2))},
      {"ours, SSE2, asked before", each_asked(sample_by(MCPR_PATH_SSE2), ask)},
  };
  constexpr std::size_t kAclWays = 3;  // the first of them
  std::printf(
      "%zu clips of %zu pieces of %zu clips; bytes a clip: coded %zu, cooked %zu, ACL %zu\n"
      "us a pose; shares of the least of ACL's times without asking, and of all of ACL's\n",
      copies, pieces, wholes.size(), coded / pieces, memory.size() / copies, acl_bytes / copies);
  std::vector<Instant> instants;
  enum State { kWarm, kBetween, kFlushed };
  const char* const names[] = {"warm", "between", "flushed"};
  for (const State state : {kWarm, kBetween, kFlushed}) {
    const auto time = [&](Way& way) {
      if (state == kFlushed) {
        flush(static_cast<const std::byte*>(memory.data()), memory.size());
        flush(blocks, acl_bytes);
      }
      for (std::size_t i = 0; i + kTogether < instants.size(); i += kTogether) {
        const auto start = std::chrono::steady_clock::now();
        way.sample(&instants[i]);
        const std::chrono::duration<double, std::micro> took =
            std::chrono::steady_clock::now() - start;
        way.us.push_back(took.count() / static_cast<double>(kTogether));
      }
    };
    for (Way& way : ways) way.us.clear();
    for (int round = 0; round < rounds; ++round) {
      instants.clear();
      for (std::size_t c = 0; c < copies; ++c) {
        const std::size_t clip = state == kWarm ? c % kWarmClips : c;
        instants.push_back({clip, durations[clip % pieces] * static_cast<float>(random.unit())});
      }
      const auto shuffle = [&random](auto& some) {
        for (std::size_t i = std::size(some); i-- > 1;)
          std::swap(some[i], some[random.below(i + 1)]);
      };
      shuffle(instants);
      std::array<Way*, std::size(ways)> order;
      std::ranges::transform(ways, order.begin(), [](Way& way) { return &way; });
      shuffle(order);  // what a way leaves in the caches helps or hinders the next
      for (Way* way : order) time(*way);
    }
    double median[std::size(ways)];
    for (std::size_t i = 0; i < std::size(ways); ++i) {
      const auto middle = ways[i].us.begin() + std::ssize(ways[i].us) / 2;
      std::ranges::nth_element(ways[i].us, middle);
      median[i] = *middle;
    }
    const double least = std::min(median[0], median[1]);
    const double least_asked = *std::ranges::min_element(median, median + kAclWays);
    for (std::size_t i = 0; i < std::size(ways); ++i)
      std::printf("%-8s %-25s %.3f  %.3f  %.3f\n", names[state], ways[i].name, median[i],
                  median[i] / least, median[i] / least_asked);
  }
}

}  // namespace
}  // namespace mocapress

int main(int count, char** arguments) {
  mocapress::Cold cold;
  for (int a = 1; a < count; ++a) {
    const std::string word = arguments[a];
    const auto number = [&] { return a + 1 < count ? std::atoi(arguments[++a]) : 0; };
    if (word == "--pieces")
      cold.pieces = static_cast<std::size_t>(number());
    else if (word == "--clips")
      cold.copies = static_cast<std::size_t>(number());
    else if (word == "--detail-bands")
      cold.detail_bands = static_cast<std::uint32_t>(number());
    else if (word == "--seconds")
      cold.seconds = number();
    else if (word == "--rounds")
      cold.rounds = number();
    else
      for (const auto& clip : mocapress::clips_of(word)) cold.clips.push_back(clip);
  }
  if (cold.clips.empty() || cold.rounds < 1 || cold.seconds < 1 || cold.pieces < 1 ||
      cold.copies < std::max(cold.pieces, mocapress::kWarmClips)) {
    std::fprintf(stderr,
                 "mocapress-cold CLIP|FOLDER... [--pieces N] [--seconds N] [--clips N] [--rounds "
                 "N] [--detail-bands N]\n");
    return 2;
  }
  try {
    cold.run();
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "mocapress-cold: %s\n", error.what());
    return 1;
  }
}
