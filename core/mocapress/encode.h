// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <memory>
#include <stop_token>
#include <vector>

#include "core/base/progress.h"
#include "core/codec/encode/options/effort.h"
#include "core/mocapress/motion.h"
#include "core/mocapress/settings.h"
#include "core/report/measurement.h"

namespace mocapress {

class LoadedClip;

/// A compressed motion.
struct Encoded {
  std::vector<std::byte> file;  // all of a .mcpr
  Measurement measurement;      // of the decoded file against its original
  bool complete = true;         // false: stopped early; the file is the best one so far and
                                // may miss the target
};

/// Compresses one motion any number of times. Computes what does not depend on settings once, when
/// it is first needed.
class ClipEncoder {
 public:
  /// Takes the motion to compress. The .mcpr keeps the source's format, so that a motion written
  /// from it can have the same form.
  explicit ClipEncoder(MotionFile source);
  ~ClipEncoder();

  const Motion& motion() const;

  /// Compresses the motion on all processors. `observer` is called now and then on the calling
  /// thread and returns whether to continue; `stop` ends the work, too.
  ///
  /// Throws Error for settings that check() refuses or that name a joint the skeleton does not
  /// have. Throws TargetMissed if nothing meets the target; its what() tells the best result.
  Encoded encode(const Settings& settings, const Observer<EncodeProgress>& observer = {},
                 const std::stop_token& stop = {}) const;

 private:
  std::unique_ptr<const LoadedClip> clip_;
};

/// Compresses a motion once.
Encoded encode(MotionFile source, const Settings& settings,
               const Observer<EncodeProgress>& observer = {}, const std::stop_token& stop = {});

}  // namespace mocapress
