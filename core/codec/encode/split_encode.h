// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "core/codec/encode/loop_encode.h"
#include "core/codec/encode/paper_encode.h"
#include "core/codec/encode/search/split_search.h"

namespace mocapress {

/// One encode by the requested method. Where r_IK is left open, it first finds the split between
/// motion and correction.
class SplitEncode {
 public:
  /// Throws Error for an impossible correction.
  SplitEncode(const ClipAnalysis& analysis, const EncodeSettings& settings,
              const Observer<EncodeProgress>& observer);
  SplitEncode(const SplitEncode&) = delete;  // its parts refer to one another

  /// Encodes to the target. Throws TargetMissed if that is out of reach; a draft promises nothing.
  Trial run();

  /// The r_IK that suits the target best.
  double split();

  LoopEncode& loop() { return loop_; }
  TrialCoder& coder() { return coder_; }

 private:
  void check(const Trial& trial) const;
  Trial run_with_split();
  Trial run_with(Method method, Effort effort);
  Trial find_split();
  Method split_method() const;
  Effort split_effort() const;
  Split split_of(const Trial& trial) const;

  const ClipAnalysis& analysis_;
  const EncodeSettings& settings_;
  TrialCoder coder_;
  Passes passes_;
  PaperEncode paper_;
  LoopEncode loop_;
  std::optional<double> slide_without_cm_;
};

}  // namespace mocapress
