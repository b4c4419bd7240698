// SPDX-License-Identifier: MIT
#include <numbers>
#include <vector>

#include "core/formats/amc.h"
#include "core/formats/text_writer.h"

namespace mocapress {
namespace {

/// One value on a joint's line: its channel, and the factor to the file's units.
struct Value {
  int channel;
  double units_per_value;  // per cm or radian
};

/// The values on a joint's line in the order of its dof: translations, then rotations. The rotation
/// applied first comes first.
std::vector<Value> values_of(const Skeleton& skeleton, int joint, double cm_per_unit) {
  std::vector<Value> translations;
  std::vector<Value> rotations;
  const auto& channels = skeleton.joint(joint).channels;
  for (std::size_t i = 0; i < channels.size(); ++i) {
    const int channel = skeleton.first_channel(joint) + static_cast<int>(i);
    if (is_rotation(channels[i]))
      rotations.push_back({channel, 180 / std::numbers::pi});
    else
      translations.push_back({channel, 1 / cm_per_unit});
  }
  translations.insert(translations.end(), rotations.rbegin(), rotations.rend());
  return translations;
}

}  // namespace

std::string amc_text(const Motion& motion, double cm_per_unit) {
  const Skeleton& skeleton = motion.skeleton;
  const std::vector<std::string> names = asf_names(skeleton);
  std::vector<std::vector<Value>> lines;
  for (int j = 0; j < skeleton.joint_count(); ++j)
    lines.push_back(values_of(skeleton, j, cm_per_unit));

  const int decimals = length_decimals(cm_per_unit);

  std::string text = ":FULLY-SPECIFIED\n:DEGREES\n:SAMPLES-PER-SECOND ";
  append_number(text, motion.clip.sample_rate_hz);
  text += '\n';
  for (int t = 0; t < motion.clip.frames(); ++t) {
    text += std::to_string(t + 1) + '\n';
    for (std::size_t j = 0; j < names.size(); ++j) {
      if (j > 0 && lines[j].empty()) continue;
      text += names[j];
      for (const Value& value : lines[j]) {
        text += ' ';
        append_number(text, motion.clip.channels(t, value.channel) * value.units_per_value,
                      decimals);
      }
      text += '\n';
    }
  }
  return text;
}

}  // namespace mocapress
