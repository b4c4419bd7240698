// SPDX-License-Identifier: MIT
// Based on: "Adapting Wavelet Compression to Human Motion Capture Clips", sections 4 and 5.
#pragma once

#include <map>

#include "core/codec/encode/trial_coder.h"
#include "core/select/annealing.h"

namespace mocapress {

/// Encodes by the paper's methods: searches the number of coefficients that meets the target. The
/// method selects that many coefficients channel by channel, by size or by annealing.
class PaperEncode {
 public:
  /// Coder and passes must outlive this object.
  PaperEncode(TrialCoder& coder, Passes& passes) : coder_(coder), passes_(passes) {}

  Trial run(Method method);

 private:
  Trial search(Method method, int first_guess, int most_trials);
  Trial attempt(Method method, int count);
  Kept choose(Method method, Trial& trial);
  AnnealingReport best_annealing(const Kept& standard);
  int count_for(double coefficient_ratio) const;
  const BasisAnalysis& basis() const { return coder_.analysis().in(coder_.settings().basis); }

  TrialCoder& coder_;
  Passes& passes_;
  std::map<int, AnnealingReport> annealed_;  // by count; r_IK does not change them
};

}  // namespace mocapress
