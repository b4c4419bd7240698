// SPDX-License-Identifier: MIT
#include "core/formats/csv.h"
#include "core/formats/text_writer.h"

namespace mocapress {

std::string csv_text(const Motion& motion) {
  const Skeleton& skeleton = motion.skeleton;
  std::string text = "time_s";
  for (int c = 0; c < skeleton.channel_count(); ++c) {
    text += ',' + as_word(skeleton.channel_name(c), ",\"");
    text += is_rotation(skeleton.channel_kind(c)) ? "_rad" : "_cm";
  }
  text += '\n';
  for (int t = 0; t < motion.clip.frames(); ++t) {
    append_number(text, t / motion.clip.sample_rate_hz);
    for (int c = 0; c < skeleton.channel_count(); ++c) {
      text += ',';
      append_number(text, motion.clip.channels(t, c), 9);
    }
    text += '\n';
  }
  return text;
}

}  // namespace mocapress
