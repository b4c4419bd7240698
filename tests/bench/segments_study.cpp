// SPDX-License-Identifier: MIT
// Measures long clips in segments: memory, cost in bytes, and the visibility of seams.
// Usage: mocapress-segments-study memory CLIP FRAMES[,FRAMES...] [LONGEST]
//        mocapress-segments-study seams CLIP LONGEST [EPS_CM]
// If FRAMES exceeds the clip's length, the clip is played forwards and backwards. LONGEST is the
// number of frames in a segment. Output is Markdown.
// Each number of frames has a process of its own. Its memory is the peak of resident memory while
// it encodes, measures and writes the file, less the memory used before, which includes the clip in
// the form that the encoder takes.
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <ctime>
#include <exception>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/codec/encode/encoder.h"
#include "core/codec/format/container.h"
#include "core/formats/motion_file.h"
#include "core/metrics/rate.h"
#include "core/runtime/mocapress_runtime.hpp"

namespace mocapress {
namespace {

double mebibytes(double bytes) {
  return bytes / (1 << 20);
}

double peak_memory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return mebibytes(1024.0 * static_cast<double>(usage.ru_maxrss));
}

double present_memory() {
  std::ifstream statm("/proc/self/statm");
  double all = 0;
  double resident = 0;
  statm >> all >> resident;
  return mebibytes(4096 * resident);
}

/// Plays the motion forwards and backwards up to `frames` frames.
Motion repeated(const Motion& motion, int frames) {
  Motion longer{motion.skeleton, {motion.clip.sample_rate_hz, {}}};
  longer.clip.channels.resize(frames, motion.clip.channels.cols());
  const int once = motion.clip.frames();
  for (int t = 0; t < frames; ++t) {
    const int in_two = t % (2 * once);
    longer.clip.channels.row(t) =
        motion.clip.channels.row(in_two < once ? in_two : 2 * once - 1 - in_two);
  }
  return longer;
}

EncodeSettings options_at(double eps_cm, int longest) {
  EncodeSettings options{.method = Method::ClosedLoop,
                         .coding = Coding::Adaptive,
                         .weighting = Weighting::BoneEnds,
                         .target = {Target::Kind::Error, eps_cm}};
  options.segments.longest = longest;
  return options;
}

/// The memory with which the runtime decoder opens a file.
double scratch_memory(const std::vector<std::byte>& file) {
  mcpr_limits limits = mcpr::default_limits();
  limits.values = UINT64_MAX;
  limits.scratch_bytes = SIZE_MAX;
  mcpr_info info{};
  mcpr_result result;
  if (mcpr_inspect(file.data(), file.size(), &limits, &info, &result) != MCPR_OK)
    throw std::runtime_error(result.message);
  return mebibytes(static_cast<double>(info.read_bytes));
}

void memory(const Motion& motion, int frames, int longest) {
  Motion longer = repeated(motion, frames);
  const double values = static_cast<double>(longer.clip.channels.size());
  EncodeSettings options = options_at(0.5, longest);
  options.figures_only = true;
  const double before = present_memory();
  const std::clock_t start = std::clock();
  const Encoder encoder(std::move(longer));
  const Encoding encoding = encoder.encode(options);
  const std::vector<std::byte> file = write_container(encoding.compressed);
  const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  const double beyond = peak_memory() - before;
  std::printf("| %d | %d | %.0f MiB | %.0f MiB | %.0f KiB | %.1f MiB | %.1f | %.4f cm | %.0f |\n",
              frames, encoding.compressed.segment_layout().count(), mebibytes(8 * values), beyond,
              static_cast<double>(file.size()) / 1024, scratch_memory(file),
              compression_ratio(encoder.motion().clip, encoding.compressed.motion_bytes()),
              encoding.distortion.eps_bone_ends, frames / seconds);
}

/// Starts a process for each number of frames, since a process's peak never falls.
void memory_of_each(const std::string& path, const std::string& lengths, int longest) {
  std::printf(
      "| frames | segments | clip | beyond | file | to open it | ratio | eps_x | frames/s |\n");
  std::printf("| --- | --- | --- | --- | --- | --- | --- | --- | --- |\n");
  std::istringstream list(lengths);
  for (std::string frames; std::getline(list, frames, ',');) {
    std::fflush(stdout);
    const pid_t child = fork();
    if (child == 0) {
      memory(read_motion(path).motion, std::stoi(frames), longest);
      return;
    }
    int status = 0;
    if (child < 0 || waitpid(child, &status, 0) < 0 || status != 0)
      throw std::runtime_error("no figures of " + frames + " frames");
  }
}

/// Errors of landmarks and of their velocities over some frames.
struct Errors {
  double squares = 0;
  double largest = 0;
  double velocity_squares = 0;
  double largest_velocity = 0;
  double count = 0;

  void add(double cm, double cm_a_frame) {
    squares += cm * cm;
    largest = std::max(largest, cm);
    velocity_squares += cm_a_frame * cm_a_frame;
    largest_velocity = std::max(largest_velocity, cm_a_frame);
    ++count;
  }
  void print(const char* where) const {
    std::printf("| %s | %.0f | %.4f | %.3f | %.4f | %.3f |\n", where, count,
                std::sqrt(squares / count), largest, std::sqrt(velocity_squares / count),
                largest_velocity);
  }
};

void seams(const Motion& motion, int longest, double eps_cm) {
  const Encoder encoder(motion);
  const Encoding whole = encoder.encode(options_at(eps_cm, motion.clip.frames()));
  const Encoding cut = encoder.encode(options_at(eps_cm, longest));
  const SegmentLayout layout = cut.compressed.segment_layout();
  std::printf("%d segments of %d frames, %d shared: %zu bytes at %.4f cm, %zu whole at %.4f cm\n\n",
              layout.count(), layout.length, layout.overlap, cut.compressed.motion_bytes(),
              cut.distortion.eps_bone_ends, whole.compressed.motion_bytes(),
              whole.distortion.eps_bone_ends);
  const auto error_of = [&](const Encoding& encoding) {
    return (landmark_tracks(motion.skeleton, encoding.decoded) - encoder.original_tracks()).eval();
  };
  Errors in_overlaps;
  Errors elsewhere;
  Errors there_in_whole;
  for (const bool of_whole : {false, true}) {
    const Eigen::MatrixXd error = error_of(of_whole ? whole : cut);
    for (Eigen::Index t = 1; t < error.rows(); ++t) {
      // The frames just after a seam count as part of it: a jump would be there.
      const bool at_seam = layout.stretch_at(static_cast<int>(t)).shared >= 0 ||
                           layout.stretch_at(static_cast<int>(t) - 1).shared >= 0;
      if (of_whole && !at_seam) continue;
      Errors& errors = of_whole ? there_in_whole : at_seam ? in_overlaps : elsewhere;
      for (Eigen::Index p = 0; p + 2 < error.cols(); p += 3)
        errors.add(error.row(t).segment<3>(p).norm(),
                   (error.row(t) - error.row(t - 1)).segment<3>(p).norm());
    }
  }
  std::printf(
      "| where | samples | error, RMS cm | largest | of velocity, cm a frame | largest |\n");
  std::printf("| --- | --- | --- | --- | --- | --- |\n");
  in_overlaps.print("in overlaps");
  elsewhere.print("elsewhere");
  there_in_whole.print("in overlaps, coded whole");
}

int run(int count, char** arguments) {
  if (count < 4) {
    std::fprintf(
        stderr,
        "usage: %s memory CLIP FRAMES[,FRAMES...] [LONGEST] | seams CLIP LONGEST [EPS_CM]\n",
        arguments[0]);
    return 2;
  }
  const std::string what = arguments[1];
  if (what == "memory")
    memory_of_each(arguments[2], arguments[3],
                   count > 4 ? std::stoi(arguments[4]) : SegmentPlan().longest);
  else
    seams(read_motion(arguments[2]).motion, std::stoi(arguments[3]),
          count > 4 ? std::stod(arguments[4]) : 0.5);
  return 0;
}

}  // namespace
}  // namespace mocapress

int main(int count, char** arguments) {
  try {
    return mocapress::run(count, arguments);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
