// SPDX-License-Identifier: MIT
#include "core/mocapress/measure.h"

#include "core/baselines/compared_file.h"
#include "core/motion/body_tracks.h"
#include "core/report/loaded_clip.h"

namespace mocapress {
namespace {

std::string shape_text(const Clip& clip) {
  return std::to_string(clip.frames()) + " frames of " + std::to_string(clip.channels.cols()) +
         " channels";
}

}  // namespace

Measurement measure(const Motion& original, std::span<const std::byte> file) {
  OpenedMcpr opened = read_mcpr(file);
  if (opened.decoded.channels.rows() != original.clip.channels.rows() ||
      opened.decoded.channels.cols() != original.clip.channels.cols())
    throw Error("is not a compression of this motion: it has " + shape_text(opened.decoded) +
                ", the original " + shape_text(original.clip));
  const Eigen::MatrixXd tracks = body_tracks(original.skeleton, original.clip);
  const Eigen::MatrixXd found = body_tracks(original.skeleton, opened.decoded);
  const std::vector<ContactSpan> contacts = find_foot_contacts(original);
  const double rate = original.clip.sample_rate_hz;
  Compression compared;
  compared.file.assign(file.begin(), file.end());
  compared.motion_bytes = opened.compressed.motion_bytes();
  compared.distortion = measure(original.skeleton, tracks, found);
  compared.footskate = measure_footskate(contacts, tracks, found, rate);
  compared.visibility = measure_visibility(original.skeleton, tracks, found, rate, contacts);
  Measurement measurement =
      LoadedClip(MotionFile{.motion = original}).measure(compared, contacts.size());
  if (opened.compressed.correction) measurement.ik_bytes = opened.compressed.correction_bytes();
  return measurement;
}

}  // namespace mocapress
