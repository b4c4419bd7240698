// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include "core/codec/format/compressed_clip.h"
#include "core/motion/body_tracks.h"

namespace mocapress {

/// The motion that decoded clips are compared with, landmark by landmark, some frames at a time.
class Original {
 public:
  using Tracks = std::function<const Eigen::MatrixXd&()>;

  /// `tracks` gives its body_tracks() once they are needed. Without, those of a few frames are
  /// computed whenever these are compared, and never kept. The motion must outlive this.
  explicit Original(const Motion& motion, Tracks tracks = {})
      : motion_(motion), tracks_(std::move(tracks)) {}

  const Motion& motion() const { return motion_; }

  /// Rows of body_tracks() of both clips, from first_frame on: in time, each frame once.
  using Visit =
      std::function<void(int first_frame, const TrackRows& original, const TrackRows& decoded)>;

  /// With frames that were decoded: those from first_frame on. Their channels may be others than
  /// the original's, the bones are the same.
  void compare(int first_frame, const Skeleton& skeleton, const Clip& decoded,
               const Visit& visit) const;

  /// With all that a clip decodes to, in memory that does not grow with its segments.
  void compare(const CompressedClip& compressed, const Visit& visit) const;

 private:
  const Motion& motion_;
  Tracks tracks_;
};

}  // namespace mocapress
