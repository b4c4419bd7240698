// SPDX-License-Identifier: MIT
#include "core/codec/encoder.h"

#include <algorithm>
#include <chrono>
#include <set>

#include "core/codec/clip_analysis.h"
#include "core/codec/decoder.h"
#include "core/codec/targeted_encode.h"
#include "core/ik/knee.h"
#include "core/motion/track_blocks.h"

namespace mocapress {
namespace {

/// Corrects `decoded` and says what came of it.
CorrectionResult apply(const CompressedClip& compressed, const Clip& original, double ratio,
                       Uncorrected& decoded) {
  CorrectionResult result{
      .ratio = ratio, .bytes = compressed.correction_bytes(), .uncorrected = decoded.clip};
  result.report = correct(compressed, decoded.differences, decoded.clip);
  const std::vector<Effector>& effectors = compressed.correction->effectors;
  result.fastest_knee = fastest_knee(compressed.skeleton, effectors, decoded.clip);
  result.fastest_knee_of_original = fastest_knee(compressed.skeleton, effectors, original);
  return result;
}

/// Distortion and footskate. Of a long clip's tracks only those of landmarks in contact are ever
/// all in memory: the other columns are not touched.
void compare(const ClipAnalysis& analysis, const std::vector<ContactSpan>& contacts,
             Encoding& encoding) {
  const Skeleton& skeleton = analysis.motion().skeleton;
  const Eigen::MatrixXd& original_tracks = analysis.original_tracks();
  std::set<Eigen::Index> in_contact;
  for (const ContactSpan& span : contacts) in_contact.insert(span.landmark);
  Eigen::MatrixXd contact_tracks(original_tracks.rows(), original_tracks.cols());
  DistortionMeter meter(skeleton, original_tracks);
  visit_tracks(skeleton, encoding.decoded, [&](int first, const Eigen::MatrixXd& tracks) {
    meter.add(first, tracks);
    for (const Eigen::Index landmark : in_contact)
      contact_tracks.block(first, 3 * landmark, tracks.rows(), 3) =
          tracks.middleCols<3>(3 * landmark);
  });
  encoding.distortion = meter.distortion();
  encoding.footskate =
      measure_footskate(contacts, original_tracks, contact_tracks, encoding.decoded.sample_rate_hz);
}

}  // namespace

std::string_view name(Effort effort) {
  switch (effort) {
    case Effort::Draft:
      return "draft";
    case Effort::Default:
      return "default";
    case Effort::Best:
      return "best";
  }
  return "unknown";
}

Coding effective_coding(const EncodeOptions& options) {
  return options.method == Method::ClosedLoop ? Coding::Adaptive : options.coding;
}

Encoder::Encoder(Motion motion) : analysis_(std::make_unique<ClipAnalysis>(std::move(motion))) {}
Encoder::~Encoder() = default;

const Motion& Encoder::motion() const {
  return analysis_->motion();
}
const Eigen::MatrixXd& Encoder::original_tracks() const {
  return analysis_->original_tracks();
}

const std::vector<ContactSpan>& Encoder::contacts() const {
  return analysis_->contacts();
}

Encoding Encoder::encode(const EncodeOptions& options,
                         const Observer<EncodeProgress>& observer) const {
  const auto start = std::chrono::steady_clock::now();
  EncodeOptions effective = options;
  effective.coding = effective_coding(options);
  TargetedEncoding found = encode_to_target(*analysis_, effective, observer);

  Encoding encoding;
  Uncorrected decoded = decode_uncorrected(found.compressed);
  if (found.compressed.correction)
    encoding.correction = apply(found.compressed, motion().clip, found.correction_ratio, decoded);
  encoding.decoded = std::move(decoded.clip);
  compare(*analysis_, contacts_for(*analysis_, options), encoding);
  encoding.compressed = std::move(found.compressed);
  encoding.compressed.provenance = {options.method, options.weighting, options.seed,
                                    static_cast<float>(encoding.distortion.eps(options.weighting)),
                                    static_cast<float>(encoding.distortion.max.cm)};
  encoding.coefficient_ratio =
      static_cast<double>(motion().clip.channels.size()) / std::max(found.count, 1);
  encoding.iterations = found.iterations;
  encoding.complete = found.complete;
  encoding.seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return encoding;
}

}  // namespace mocapress
