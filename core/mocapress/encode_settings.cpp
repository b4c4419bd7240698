// SPDX-License-Identifier: MIT
#include "core/mocapress/encode_settings.h"

#include <algorithm>

#include "core/base/error.h"
#include "core/codec/methods/compression_method.h"

namespace mocapress {
namespace {

std::vector<ContactSpan> contacts_for(const std::vector<ContactSetting>& contacts,
                                      const Skeleton& skeleton) {
  const std::vector<Landmark> points = landmarks(skeleton);
  std::vector<ContactSpan> spans;
  for (const ContactSetting& contact : contacts) {
    const auto point = std::ranges::find_if(
        points, [&](const Landmark& one) { return one.name == contact.point; });
    if (point == points.end()) throw Error("the skeleton has no joint named " + contact.point);
    spans.push_back(
        {static_cast<int>(point - points.begin()), contact.first_frame, contact.last_frame});
  }
  return spans;
}

}  // namespace

EncodeSettings encode_settings(const Settings& settings, const Skeleton& skeleton) {
  EncodeSettings of_clip{.coding = coding_of(settings).value_or(Coding::Deflate),
                         .weighting = settings.weighting,
                         .target = settings.target,
                         .seed = settings.seed,
                         .effort = settings.effort,
                         .importance = importance_for(settings.importance, skeleton),
                         .ranges = settings.ranges,
                         .promises = settings.promises,
                         .limits = settings.limits,
                         .ends = settings.ends,
                         .loop = settings.loop};
  std::erase_if(of_clip.ranges, [](const ImportantRange& range) { return range.factor == 1; });
  require_measurable(skeleton, settings.weighting);
  if (const CompressionMethod* compression_method = find_compression_method(settings.method))
    choose_wavelets(*compression_method, of_clip);
  if (settings.contacts) of_clip.contacts = contacts_for(*settings.contacts, skeleton);
  if (!settings.correction) return of_clip;
  const CorrectionSettings& wanted = *settings.correction;
  of_clip.correction =
      EncodeCorrection{.ratio = wanted.ratio, .solver = wanted.solver, .at = wanted.at};
  for (const std::string& effector : wanted.effectors) {
    const int joint = skeleton.find(effector);
    if (joint < 0) throw Error("the skeleton has no joint named " + effector);
    of_clip.correction->joints.push_back(joint);
  }
  return of_clip;
}

}  // namespace mocapress
