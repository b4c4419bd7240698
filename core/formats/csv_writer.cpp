// SPDX-License-Identifier: MIT
#include "core/formats/csv.h"
#include "core/formats/text_writer.h"

namespace mocapress {

std::string csv_text(const Motion& motion, const ScalarTracks& tracks) {
  const Skeleton& skeleton = motion.skeleton;
  std::string text = "time_s";
  for (int c = 0; c < skeleton.channel_count(); ++c) {
    text += ',' + as_word(skeleton.channel_name(c), ",\"");
    text += is_rotation(skeleton.channel_kind(c)) ? "_rad" : "_cm";
  }
  for (const ScalarTrack& track : tracks) text += ',' + as_word(label(track), ",\"");
  text += '\n';
  for (int t = 0; t < motion.clip.frames(); ++t) {
    append_number(text, t / motion.clip.sample_rate_hz);
    for (int c = 0; c < skeleton.channel_count(); ++c) {
      text += ',';
      append_number(text, motion.clip.channels(t, c), 9);
    }
    for (const ScalarTrack& track : tracks) {
      text += ',';
      append_number(text, static_cast<double>(track.values[t]), 9);
    }
    text += '\n';
  }
  return text;
}

}  // namespace mocapress
