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
  Measurement measurement;      // the decoded file's, against its original
  bool complete = true;         // false: stopped early; the file is the best there was till then,
                                // and need not meet its target
};

/// Computes everything that does not depend on settings once, when first needed.
class ClipEncoder {
 public:
  /// Compresses `source.motion`. The source's format is kept in the .mcpr, so that a motion written
  /// from it can have the form of its source.
  explicit ClipEncoder(MotionFile source);
  ~ClipEncoder();

  const Motion& motion() const;

  /// `observer` is called now and then on the calling thread and answers whether to continue.
  /// `stop` stops the work too. Work is spread over all processors.
  ///
  /// Throws Error for settings that check() refuses or that name a joint the skeleton lacks. Throws
  /// TargetMissed if nothing meets the target; its what() tells the best result.
  Encoded encode(const Settings& settings, const Observer<EncodeProgress>& observer = {},
                 const std::stop_token& stop = {}) const;

 private:
  std::unique_ptr<const LoadedClip> clip_;
};

/// Compresses one motion once.
Encoded encode(MotionFile source, const Settings& settings,
               const Observer<EncodeProgress>& observer = {}, const std::stop_token& stop = {});

}  // namespace mocapress
