// SPDX-License-Identifier: MIT
// ACL's bytes and errors at each of its precisions, and our bytes where each of these errors is
// met: of eps_x by bone ends, of the root mean square, the 99th percentile and the maximum of ACL's
// own points, three 3 cm from each joint. One line a clip and precision, then geometric means of
// our share of ACL's bytes. --json: one JSON object a line and nothing else. --no-max: without the
// maximum, which takes most of the time.
// --game: on rigs as games have them (tests/support/game_like.h).
// Usage: mocapress-peer-study CLIP|FOLDER... [--every N] [--game] [--json] [--no-max]
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <iostream>
#include <map>
#include <nlohmann/json.hpp>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/codec/encode/encoder.h"
#include "core/formats/motion_file.h"
#include "core/metrics/distortion.h"
#include "core/motion/body_tracks.h"
#include "tests/bench/acl_peer.h"
#include "tests/bench/study_clips.h"
#include "tests/support/game_like.h"

namespace mocapress {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr std::array kPrecisions = {0.01, 0.05, 0.1, 0.3, 1.0, 2.0};  // cm

Encoding encode(const Encoder& encoder, Weighting weighting, const Target& target) {
  return encoder.encode({.method = Method::ClosedLoop, .weighting = weighting, .target = target});
}

/// Null where it is out of reach.
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

/// A percentile is no target: it is searched by the mean error that brings it.
std::size_t bytes_at_shell_p99(const Encoder& encoder, double p99_cm) {
  double below = 0.1 * p99_cm;  // an RMS that keeps it
  double above = p99_cm;        // one that does not
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

Json row_of(const Motion& motion, const Encoder& encoder, double precision, bool with_max) {
  const AclResult acl = compress_by_acl(motion, precision);
  const Distortion theirs = measure(motion.skeleton, encoder.original_body(), acl.tracks);
  Json row = {{"precision", precision},
              {"acl_bytes", acl.bytes},
              {"acl_eps", theirs.eps_bone_ends},
              {"acl_shell_rms", theirs.shell.rms},
              {"acl_shell_p99", theirs.shell.p99},
              {"acl_shell_max", theirs.shell.max.cm}};
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

int run(int count, char** arguments) {
  std::vector<fs::path> clips;
  int every = 1;
  bool on_game_rig = false;
  bool json = false;
  bool with_max = true;
  for (int i = 1; i < count; ++i) {
    const std::string_view word = arguments[i];
    if (word == "--json")
      json = true;
    else if (word == "--game")
      on_game_rig = true;
    else if (word == "--no-max")
      with_max = false;
    else if (word == "--every" && i + 1 < count)
      every = std::max(1, std::atoi(arguments[++i]));
    else
      for (const fs::path& clip : clips_of(word)) clips.push_back(clip);
  }
  if (clips.empty()) {
    std::cerr
        << "usage: mocapress-peer-study CLIP|FOLDER... [--every N] [--game] [--json] [--no-max]\n";
    return 2;
  }
  constexpr std::array kMeasures = {"bytes_at_eps", "bytes_at_shell_rms", "bytes_at_shell_p99",
                                    "bytes_at_shell_max"};
  struct Mean {
    double log = 0;
    int clips = 0;
  };
  std::map<double, std::array<Mean, kMeasures.size()>> means;
  for (const fs::path& path : clips) {
    Motion motion = thinned(read_motion(path).motion, every);
    if (on_game_rig) motion = test::game_like(motion);
    const Encoder encoder(motion);
    for (const double precision : kPrecisions) {
      const Json row = row_of(motion, encoder, precision, with_max);
      Json line = {{"clip", path.stem().string()}};
      line.update(row);
      if (json) std::cout << line.dump() << std::endl;
      for (std::size_t m = 0; m < kMeasures.size(); ++m) {
        if (row[kMeasures[m]].is_null()) continue;
        Mean& mean = means[precision][m];
        mean.log += std::log(row[kMeasures[m]].get<double>() / row["acl_bytes"].get<double>());
        ++mean.clips;
      }
      if (!json)
        std::printf("%-16s %5.2f cm  ACL %8zu bytes, eps %.4f, shell %.4f %.4f %.4f  ours %s\n",
                    path.stem().c_str(), precision, row["acl_bytes"].get<std::size_t>(),
                    row["acl_eps"].get<double>(), row["acl_shell_rms"].get<double>(),
                    row["acl_shell_p99"].get<double>(), row["acl_shell_max"].get<double>(),
                    Json{row[kMeasures[0]], row[kMeasures[1]], row[kMeasures[2]], row[kMeasures[3]]}
                        .dump()
                        .c_str());
    }
  }
  if (json) return 0;
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
  try {
    return mocapress::run(count, arguments);
  } catch (const std::exception& error) {
    std::cerr << "mocapress-peer-study: " << error.what() << '\n';
    return 1;
  }
}
