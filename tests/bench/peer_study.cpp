// SPDX-License-Identifier: MIT
// Compares with ACL: its bytes and errors at each of its precisions, and our bytes at the same
// errors, which are eps_x by bone ends, and the root mean square, the 99th percentile and the
// maximum of ACL's own points, three for each joint at 3 cm. Prints one line for each clip and
// precision, then geometric means of our bytes relative to ACL's.
// --json: prints JSON objects only, one a line. --no-max: leaves out the maximum, which takes most
// of the time.
// At precision 0.1 it also times both in turns: local transforms at a random instant and forwards
// at 60 Hz, opening, the whole clip for each frame, and encoding in frames a second, as medians of
// a few turns. It prints the bytes of our cooked form without the skeleton's part.
// sse2_...: ours by SSE2, for which ACL is compiled too, except in mocapress-peer-study-avx.
// --times: prints times only. --game: uses game-like rigs (tests/support/game_like.h).
// --detail-bands: how many our cooked form keeps, as in mcpr_cook_options.
// --write: only writes the clips that --times times into a folder, for neon_counts.py.
// Usage: mocapress-peer-study CLIP|FOLDER... [--every N] [--game] [--json] [--no-max] [--times]
//          [--detail-bands N] [--write FOLDER]
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <iostream>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/kept_memory.h"
#include "core/base/number_text.h"
#include "core/base/one_thread.h"
#include "core/base/random.h"
#include "core/codec/encode/encoder.h"
#include "core/codec/format/container.h"
#include "core/formats/motion_file.h"
#include "core/metrics/distortion.h"
#include "core/motion/body_tracks.h"
#include "tests/bench/acl_peer.h"
#include "tests/bench/study_clips.h"
#include "tests/support/cooked_clip.h"
#include "tests/support/game_like.h"
#include "tests/support/opened_clip.h"

namespace mocapress {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr std::array kPrecisions = {0.01, 0.05, 0.1, 0.3, 1.0, 2.0};  // cm
constexpr double kTimedPrecision = 0.1;

Encoding encode(const Encoder& encoder, Weighting weighting, const Target& target) {
  return encoder.encode({.method = Method::ClosedLoop, .weighting = weighting, .target = target});
}

/// Null if the target is out of reach.
template <typename Search>
Json if_reached(const Search& search) {
  try {
    return search();
  } catch (const TargetMissed&) {
    return nullptr;
  }
}

std::size_t bytes_at(const Encoder& encoder, Weighting weighting, const Target& target) {
  return encode(encoder, weighting, target).compressed.motion_bytes();
}

/// A percentile is no target, so the search varies the mean error.
std::size_t bytes_at_shell_p99(const Encoder& encoder, double p99_cm) {
  double below = 0.1 * p99_cm;  // an RMS that meets the percentile
  double above = p99_cm;        // an RMS that misses it
  std::size_t bytes = bytes_at(encoder, Weighting::Shell, {Target::Kind::Error, below});
  for (int i = 0; i < 8; ++i) {
    const double rms = std::sqrt(below * above);
    const Encoding encoding = encode(encoder, Weighting::Shell, {Target::Kind::Error, rms});
    if (encoding.distortion.shell.p99 <= p99_cm) {
      below = rms;
      bytes = encoding.compressed.motion_bytes();
    } else {
      above = rms;
    }
  }
  return bytes;
}

/// Medians of the times of two calls in microseconds. The calls take turns, so that other work on
/// the machine slows both.
template <int kTurns = 101, typename Theirs, typename Ours>
std::pair<double, double> median_us(int calls, const Theirs& theirs, const Ours& ours) {
  std::vector<double> of_theirs;
  std::vector<double> of_ours;
  const auto time = [&](const auto& call) {
    const auto start = std::chrono::steady_clock::now();
    for (int i = 0; i < calls; ++i) call(i);
    const std::chrono::duration<double, std::micro> took = std::chrono::steady_clock::now() - start;
    return took.count() / calls;
  };
  const auto middle = [](std::vector<double>& values) {
    std::nth_element(values.begin(), values.begin() + kTurns / 2, values.end());
    return values[kTurns / 2];
  };
  for (int turn = 0; turn < kTurns; ++turn) {
    of_theirs.push_back(time(theirs));
    of_ours.push_back(time(ours));
  }
  return {middle(of_theirs), middle(of_ours)};
}

/// Frames a second on one thread: from transforms for ACL, from angles for ours, including the
/// search for the target.
Json encoding_speeds(const Motion& motion, double precision, double shell_rms) {
  constexpr std::size_t kTurns = 5;
  std::vector<double> of_theirs;
  std::vector<double> of_ours;
  for (std::size_t turn = 0; turn < kTurns; ++turn) {
    of_theirs.push_back(AclClip(motion, precision).encode_seconds());
    on_one_thread([&] {
      const auto start = std::chrono::steady_clock::now();
      encode(Encoder(motion), Weighting::Shell, {Target::Kind::Error, shell_rms});
      of_ours.push_back(
          std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    });
  }
  const auto speed = [&](std::vector<double>& seconds) {
    std::ranges::sort(seconds);
    return static_cast<double>(motion.clip.frames()) / seconds[kTurns / 2];
  };
  return {{"acl_encode_frames_per_second", speed(of_theirs)},
          {"encode_frames_per_second", speed(of_ours)}};
}

/// Writes the clip as ACL's block (.acl), and ours at equal shell RMS, cooked by default (.cooked)
/// and with two detail bands (.two_bands), beside `path` without its extension.
void write_clips(const Motion& motion, fs::path path) {
  const Encoder encoder(motion);
  const AclClip acl(motion, kTimedPrecision);
  const double shell_rms =
      measure(motion.skeleton, encoder.original_body(), acl.tracks(motion.skeleton)).shell.rms;
  const test::OpenedClip opened(write_container(
      encode(encoder, Weighting::Shell, {Target::Kind::Error, shell_rms}).compressed));
  if (opened.clip == nullptr) throw Error(opened.result.message);
  write_bytes(path.replace_extension("acl"), acl.block());
  for (const std::uint32_t bands : {0U, 2U}) {
    const test::CookedClip cooked(opened.clip, {.detail_bands = bands});
    if (cooked.clip == nullptr) throw Error(cooked.result.message);
    write_bytes(path.replace_extension(bands == 0 ? "cooked" : "two_bands"),
                {cooked.bytes->data(), cooked.bytes->size()});
  }
}

/// Times of local transforms of all joints on one thread: at a random instant, forwards at 60 Hz
/// (ours with a cursor), and for every frame of the clip (ours with a cursor, and by
/// mcpr_decode_frames from the resident form); and of opening a clip in memory. ACL at one
/// precision, ours at equal shell RMS.
Json times_of(const Encoder& encoder, AclClip& acl, double shell_rms, std::uint32_t detail_bands) {
  constexpr int kInstants = 500;
  const Encoding encoding = encode(encoder, Weighting::Shell, {Target::Kind::Error, shell_rms});
  const test::OpenedClip opened(write_container(encoding.compressed));
  if (opened.clip == nullptr) throw Error(opened.result.message);
  const mcpr_clip_info info = mcpr::describe(opened.clip);
  const test::CookedClip cooked(opened.clip, {.detail_bands = detail_bands});
  if (cooked.clip == nullptr) throw Error(cooked.result.message);
  const mcpr_sample_request request{.unit = MCPR_SECONDS};
  std::vector<float> out(mcpr_sample_values(cooked.clip, &request));
  const double duration = (info.frames - 1) / info.sample_rate;
  Random random(1);
  std::vector<double> at_random(kInstants);
  for (double& instant : at_random) instant = duration * random.unit();
  std::vector<double> forwards(kInstants);
  for (int i = 0; i < kInstants; ++i)
    forwards[static_cast<std::size_t>(i)] = std::fmod(i / 60.0, duration);
  const AlignedBytes cursor_memory(mcpr_cursor_bytes(cooked.clip));
  mcpr_cursor* cursor = nullptr;
  mcpr_make_cursor(cooked.clip, cursor_memory.data(), cursor_memory.size(), &cursor, nullptr);
  const auto of_both = [&](const std::vector<double>& instants, const auto& ours) {
    const auto at = [&](int i) { return instants[static_cast<std::size_t>(i)]; };
    return median_us(
        kInstants, [&](int i) { acl.sample(static_cast<float>(at(i))); },
        [&](int i) { ours(at(i)); });
  };
  acl.open();
  const auto [acl_pose, pose] = of_both(
      at_random, [&](double at) { mcpr_sample(cooked.clip, &request, at, out.data(), nullptr); });
  const auto [acl_play, play] = of_both(
      forwards, [&](double at) { mcpr_sample_next(cursor, &request, at, out.data(), nullptr); });
  const mcpr_cooked* clip = nullptr;
  const auto [acl_open, open] = median_us(
      kInstants, [&](int) { acl.open(); },
      [&](int) {
        mcpr_open_cooked(cooked.bytes->data(), cooked.bytes->size(), 0, &clip, nullptr);
      });
  const double frame_seconds = 1 / info.sample_rate;
  const auto [acl_clip, clip_frames] = median_us<15>(
      1, [&](int) { acl.decode_frames(); },
      [&](int) {
        for (std::uint32_t frame = 0; frame < info.frames; ++frame)
          mcpr_sample_next(cursor, &request, frame_seconds * frame, out.data(), nullptr);
      });
  const mcpr_request local{.output = MCPR_LOCAL};
  std::vector<float> frames(info.frames * mcpr_frame_values(opened.clip, &local));
  const AlignedBytes scratch(mcpr_scratch_bytes(opened.clip, &local));
  const auto resident_frames =
      median_us<15>(
          1, [&](int) { acl.decode_frames(); },
          [&](int) {
            mcpr_decode_frames(opened.clip, &local, 0, info.frames, frames.data(), scratch.data(),
                               scratch.size(), nullptr);
          })
          .second;
  const mcpr_cooked_info cooked_info = mcpr::describe(cooked.clip);
  Json row = {{"motion_bytes", encoding.compressed.motion_bytes()},
              {"resident_bytes", cooked_info.bytes - cooked_info.skeleton_bytes},
              {"acl_pose_us", acl_pose},
              {"pose_us", pose},
              {"acl_play_us", acl_play},
              {"play_us", play},
              {"acl_open_us", acl_open},
              {"open_us", open},
              {"acl_clip_us_per_frame", acl_clip / info.frames},
              {"clip_us_per_frame", clip_frames / info.frames},
              {"resident_clip_us_per_frame", resident_frames / info.frames}};
  const mcpr_sample_request sse2{.unit = MCPR_SECONDS, .path = MCPR_PATH_SSE2};
  if (mcpr_path_exists(sse2.path) != 0) {
    const auto [acl_pose_again, sse2_pose] = of_both(
        at_random, [&](double at) { mcpr_sample(cooked.clip, &sse2, at, out.data(), nullptr); });
    const auto [acl_play_again, sse2_play] = of_both(
        forwards, [&](double at) { mcpr_sample_next(cursor, &sse2, at, out.data(), nullptr); });
    row.update({{"acl_pose_us_beside_sse2", acl_pose_again},
                {"sse2_pose_us", sse2_pose},
                {"acl_play_us_beside_sse2", acl_play_again},
                {"sse2_play_us", sse2_play}});
  }
  return row;
}

Json row_of(const Motion& motion, const Encoder& encoder, double precision, bool with_max,
            bool only_times, std::uint32_t detail_bands) {
  AclClip acl(motion, precision);
  const Distortion theirs =
      measure(motion.skeleton, encoder.original_body(), acl.tracks(motion.skeleton));
  Json row = {{"precision", precision},
              {"acl_bytes", acl.bytes()},
              {"acl_eps", theirs.eps_bone_ends},
              {"acl_shell_rms", theirs.shell.rms},
              {"acl_shell_p99", theirs.shell.p99},
              {"acl_shell_max", theirs.shell.max.cm}};
  if (precision == kTimedPrecision) {
    row.update(times_of(encoder, acl, theirs.shell.rms, detail_bands));
    row.update(encoding_speeds(motion, precision, theirs.shell.rms));
  }
  if (only_times) return row;
  const auto reach = [&](Weighting weighting, Target::Kind kind, double cm) {
    return if_reached([&] { return bytes_at(encoder, weighting, {kind, cm}); });
  };
  row["bytes_at_eps"] = reach(Weighting::BoneEnds, Target::Kind::Error, theirs.eps_bone_ends);
  row["bytes_at_shell_rms"] = reach(Weighting::Shell, Target::Kind::Error, theirs.shell.rms);
  row["bytes_at_shell_p99"] =
      if_reached([&] { return bytes_at_shell_p99(encoder, theirs.shell.p99); });
  row["bytes_at_shell_max"] =
      with_max ? reach(Weighting::Shell, Target::Kind::MaxError, theirs.shell.max.cm) : Json();
  return row;
}

/// Our times and bytes relative to ACL's: geometric means and worst clips.
class TimeShares {
 public:
  static std::string line(const fs::path& clip, const Json& row) {
    const auto value = [&](const char* key, int digits) {
      return significant_text(row.at(key).get<double>(), digits);
    };
    const auto both = [&](const std::string& key) {
      return value(("acl_" + key).c_str(), 3) + " " + value(key.c_str(), 3);
    };
    return clip.stem().string() + ": us, ACL's and ours: pose " + both("pose_us") + ", play " +
           both("play_us") + ", open " + both("open_us") + ", a frame of the whole clip " +
           both("clip_us_per_frame") + " (resident form " + value("resident_clip_us_per_frame", 3) +
           "); frames encoded a second " + both("encode_frames_per_second") + "; bytes: motion " +
           value("motion_bytes", 9) + ", resident " + value("resident_bytes", 9) + "\n";
  }

  void add(const Json& row) {
    for (Share& share : shares_)
      if (row.contains(share.ours)) {
        const double value = row[share.ours].get<double>() / row[share.theirs].get<double>();
        share.log += std::log(value);
        share.worst = std::max(share.worst, value);
        ++share.clips;
      }
  }

  void print() const {
    std::printf("\n| of precision 0.1 | geometric mean | worst clip |\n| --- | --- | --- |\n");
    for (const Share& share : shares_)
      if (share.clips > 0)
        std::printf("| %s / %s | %.3f | %.3f |\n", share.ours, share.theirs,
                    std::exp(share.log / share.clips), share.worst);
  }

 private:
  struct Share {
    const char* ours;
    const char* theirs;
    double log = 0;
    double worst = 0;
    int clips = 0;
  };
  std::array<Share, 9> shares_{{{"pose_us", "acl_pose_us"},
                                {"play_us", "acl_play_us"},
                                {"sse2_pose_us", "acl_pose_us_beside_sse2"},
                                {"sse2_play_us", "acl_play_us_beside_sse2"},
                                {"open_us", "acl_open_us"},
                                {"clip_us_per_frame", "acl_clip_us_per_frame"},
                                {"resident_clip_us_per_frame", "acl_clip_us_per_frame"},
                                {"acl_encode_frames_per_second", "encode_frames_per_second"},
                                {"resident_bytes", "motion_bytes"}}};
};

int run(int count, char** arguments) {
  std::vector<fs::path> clips;
  int every = 1;
  bool on_game_rig = false;
  bool json = false;
  bool with_max = true;
  bool only_times = false;
  std::uint32_t detail_bands = 0;
  fs::path written;  // the folder to write clips into, or empty
  for (int i = 1; i < count; ++i) {
    const std::string_view word = arguments[i];
    if (word == "--json")
      json = true;
    else if (word == "--game")
      on_game_rig = true;
    else if (word == "--no-max")
      with_max = false;
    else if (word == "--times")
      only_times = true;
    else if (word == "--detail-bands" && i + 1 < count)
      detail_bands = static_cast<std::uint32_t>(std::atoi(arguments[++i]));
    else if (word == "--write" && i + 1 < count)
      written = arguments[++i];
    else if (word == "--every" && i + 1 < count)
      every = std::max(1, std::atoi(arguments[++i]));
    else
      for (const fs::path& clip : clips_of(word)) clips.push_back(clip);
  }
  if (clips.empty()) {
    std::cerr
        << "usage: mocapress-peer-study CLIP|FOLDER... [--every N] [--game] [--json] [--no-max] "
           "[--times] [--detail-bands N] [--write FOLDER]\n";
    return 2;
  }
  constexpr std::array kMeasures = {"bytes_at_eps", "bytes_at_shell_rms", "bytes_at_shell_p99",
                                    "bytes_at_shell_max"};
  struct Mean {
    double log = 0;
    int clips = 0;
  };
  std::map<double, std::array<Mean, kMeasures.size()>> means;
  TimeShares times;
  for (const fs::path& path : clips) {
    Motion motion = thinned(read_motion(path).motion, every);
    if (on_game_rig) motion = test::game_like(motion);
    if (!written.empty()) {
      write_clips(motion, written / path.filename());
      continue;
    }
    const Encoder encoder(motion);
    for (const double precision : kPrecisions) {
      if (only_times && precision != kTimedPrecision) continue;
      const Json row = row_of(motion, encoder, precision, with_max, only_times, detail_bands);
      times.add(row);
      Json line = {{"clip", path.stem().string()}};
      line.update(row);
      if (json) std::cout << line.dump() << std::endl;
      if (!json && row.contains("pose_us")) std::printf("%s", TimeShares::line(path, row).c_str());
      if (only_times) continue;
      for (std::size_t m = 0; m < kMeasures.size(); ++m) {
        if (row[kMeasures[m]].is_null()) continue;
        Mean& mean = means[precision][m];
        mean.log += std::log(row[kMeasures[m]].get<double>() / row["acl_bytes"].get<double>());
        ++mean.clips;
      }
      if (!json && !only_times)
        std::printf("%-16s %5.2f cm  ACL %8zu bytes, eps %.4f, shell %.4f %.4f %.4f  ours %s\n",
                    path.stem().c_str(), precision, row["acl_bytes"].get<std::size_t>(),
                    row["acl_eps"].get<double>(), row["acl_shell_rms"].get<double>(),
                    row["acl_shell_p99"].get<double>(), row["acl_shell_max"].get<double>(),
                    Json{row[kMeasures[0]], row[kMeasures[1]], row[kMeasures[2]], row[kMeasures[3]]}
                        .dump()
                        .c_str());
    }
  }
  if (json || !written.empty()) return 0;
  times.print();
  if (only_times) return 0;
  std::printf(
      "\nShare of ACL's bytes (geometric means over %zu clips), at its\n"
      "| precision | eps_x | shell RMS | shell p99 | shell maximum |\n"
      "| --- | --- | --- | --- | --- |\n",
      clips.size());
  for (const auto& [precision, all] : means) {
    std::printf("| %.2f cm |", precision);
    for (const Mean& mean : all) {
      if (mean.clips > 0)
        std::printf(" %.3f", std::exp(mean.log / mean.clips));
      else
        std::printf(" -");
      if (mean.clips > 0 && mean.clips < static_cast<int>(clips.size()))
        std::printf(" (%d)", mean.clips);
      std::printf(" |");
    }
    std::printf("\n");
  }
  return 0;
}

}  // namespace
}  // namespace mocapress

int main(int count, char** arguments) {
  mocapress::keep_freed_memory();  // as the programs do
  try {
    return mocapress::run(count, arguments);
  } catch (const std::exception& error) {
    std::cerr << "mocapress-peer-study: " << error.what() << '\n';
    return 1;
  }
}
