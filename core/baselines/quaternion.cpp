// SPDX-License-Identifier: MIT
// Based on: "Adapting Wavelet Compression to Human Motion Capture Clips", section 6.3. The bytes:
// METHODS.md.
#include "core/baselines/quaternion.h"

#include "core/baselines/quaternion_signals.h"
#include "core/codec/decode/signal_decoder.h"
#include "core/codec/encode/clip_analysis.h"
#include "core/codec/format/rle16.h"
#include "core/codec/format/signal_coder.h"
#include "core/select/annealing.h"

namespace mocapress {
namespace {

class QuaternionCoder : public DetailCoder {
 public:
  QuaternionCoder(const Motion& motion, Weighting weighting)
      : QuaternionCoder(motion, weighting, QuaternionSignals(motion.skeleton)) {}

  int most_detail() const override { return basis_.ranked.total(); }

  std::vector<std::byte> encode(int detail) const override {
    const Kept start = basis_.standard.keep(detail);
    const Kept kept = anneal(basis_.ranked, model_, start).kept;
    return pack(code_signals(basis_.ranked, basis_.scales, kept), Coding::Deflate);
  }

 private:
  QuaternionCoder(const Motion& motion, Weighting weighting, const QuaternionSignals& quaternions)
      : QuaternionCoder(motion, weighting, quaternions, quaternions.of(motion.clip)) {}
  QuaternionCoder(const Motion& motion, Weighting weighting, const QuaternionSignals& quaternions,
                  const Eigen::MatrixXd& signals)
      : basis_({motion.clip.sample_rate_hz, signals}, quaternions.scales(), Basis::Cubic),
        model_(motion.skeleton, motion.clip, measured_points(motion.skeleton, weighting),
               quaternions.moves(motion.clip, signals)) {}

  BasisAnalysis basis_;
  ErrorModel model_;
};

class Quaternion : public ComparisonMethod {
 public:
  std::string_view name() const override { return "quaternion"; }
  std::string_view title() const override { return "Quaternion wavelets"; }
  std::string_view note() const override {
    return "Cubic wavelets on unit quaternions, coefficients moved between components by annealing "
           "on the linearised rotation: the paper's section 6.3.";
  }

  std::unique_ptr<DetailCoder> analyse(const Motion& motion, Weighting weighting) const override {
    return std::make_unique<QuaternionCoder>(motion, weighting);
  }

  Clip decode(const Skeleton& skeleton, double sample_rate_hz, int frames,
              std::span<const std::byte> motion) const override {
    const QuaternionSignals quaternions(skeleton);
    const int count = quaternions.count();
    const std::vector<std::byte> words =
        unpack(motion, Coding::Deflate, rle16_bound(frames, count));
    ByteReader reader(words);
    const Eigen::MatrixXd signals = read_signals(reader, Basis::Cubic, frames, count);
    reader.expect_end();
    return quaternions.clip_of(signals, sample_rate_hz);
  }
};

}  // namespace

const ComparisonMethod& quaternion_method() {
  static const Quaternion kMethod;
  return kMethod;
}

}  // namespace mocapress
