// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "core/codec/encode/analysis/clip_analysis.h"
#include "core/codec/encode/closed_loop/closed_loop.h"
#include "core/codec/encode/mend/correction_encoder.h"
#include "core/codec/encode/options/encode_settings.h"
#include "core/codec/encode/search/goal.h"
#include "core/feet/footskate.h"

namespace mocapress {

/// The form in which a trial keeps its values: coded bytes, the values themselves, or values with
/// an estimate of their bytes.
enum class TrialBytes { Coded, Values, Estimated };

/// Makes the trials of one encode: turns a method's choice into a coded clip with its correction
/// and ends, measured against the target. Owns the error model and the closed loop of that encode.
class TrialCoder {
 public:
  /// Analysis and settings must outlive this object. Throws Error for an impossible correction.
  TrialCoder(const ClipAnalysis& analysis, const EncodeSettings& settings);

  const ClipAnalysis& analysis() const { return analysis_; }
  const EncodeSettings& settings() const { return settings_; }
  const Coefficients& coefficients() const { return coefficients_; }
  const Goal& goal() const { return goal_; }
  bool has_correction() const { return correction_.has_value(); }

  /// The r_IK of the next trials: coefficients of the correction / kept coefficients.
  double correction_ratio() const { return correction_ratio_; }
  void set_correction_ratio(double ratio) { correction_ratio_ = ratio; }

  /// Changes the weights of joints for the next trials.
  void weigh_joints(const Importance& importance);

  /// The error model of the encode: errors weigh more at important joints, and less where a
  /// correction mends them.
  const ErrorModel& model() const;
  const ClosedLoop& loop();

  /// Codes and measures a trial of the paper's methods.
  Trial code(const Kept& kept);

  /// Codes a trial of the closed loop, without coding its ends or measuring it.
  Trial code(ClosedLoop::Result result, TrialBytes bytes) const;

  /// Makes a trial without bytes, for searches that only look at its error.
  Trial without_bytes(const ClosedLoop::Result& result) const;

  /// Codes the values of a trial that was made with TrialBytes::Values.
  void pack(Trial& trial) const;

  void mend_ends(Trial& trial) const;
  void measure(Trial& trial) const;

  /// Removes a correction's signals; they are made anew when the motion changes.
  void drop_correction(QuantisedSignals& coded) const;

  /// Footskate of a decoded clip.
  Footskate footskate_of(const Clip& decoded) const;

 private:
  const BasisAnalysis& basis() const { return analysis_.in(settings_.basis); }
  CompressedClip empty_clip() const;
  void finish(QuantisedSignals coded, TrialBytes bytes, CompressedClip& compressed) const;
  void append_correction(std::vector<std::byte>& words, CompressedClip& compressed) const;

  const ClipAnalysis& analysis_;
  const EncodeSettings& settings_;
  const Coefficients& coefficients_;
  const std::vector<ContactSpan> contacts_;
  const Eigen::VectorXd frame_factors_;  // empty: all frames count alike
  const Goal goal_;
  std::optional<CorrectionEncoder> correction_;
  double correction_ratio_ = 0;
  std::optional<ErrorModel> own_model_;  // set if importance or a correction change the model
  std::optional<ClosedLoop> own_loop_;   // set if own_model_ is, or if frames have factors
};

/// Counts the passes of an encode, for its progress.
class Passes {
 public:
  explicit Passes(const Observer<EncodeProgress>& observer) : observer_(observer) {}

  int begin() { return count_++; }
  const Observer<EncodeProgress>& observer() const { return observer_; }

  /// Begins the next pass, a closed loop's, and returns its observer.
  Observer<ClosedLoopProgress> next();

 private:
  const Observer<EncodeProgress>& observer_;
  int count_ = 0;
};

/// The contacts to use: edited ones, or those found on the original.
const std::vector<ContactSpan>& contacts_for(const ClipAnalysis& analysis,
                                             const EncodeSettings& settings);

/// The original, with tracks that the analysis keeps.
Original original_of(const ClipAnalysis& analysis);

}  // namespace mocapress
