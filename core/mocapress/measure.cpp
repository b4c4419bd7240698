// SPDX-License-Identifier: MIT
#include "core/mocapress/measure.h"

#include <utility>

#include "core/codec/encode/encoder.h"
#include "core/codec/methods/compared_file.h"
#include "core/motion/body_tracks.h"
#include "core/report/loaded_clip.h"

namespace mocapress {

Measurement measure(const Motion& original, std::span<const std::byte> file,
                    const SightLimits& limits) {
  OpenedMcpr opened = read_mcpr(file);
  const std::vector<ContactSpan> contacts = find_foot_contacts(original);
  Encoding compared;
  compared.compressed = std::move(opened.compressed);
  compared.file.assign(file.begin(), file.end());
  static_cast<Comparison&>(compared) = compare(
      original, body_tracks(original.skeleton, original.clip), opened.decoded, contacts, limits);
  Measurement measurement =
      LoadedClip(MotionFile{.motion = original}).measure(compared, contacts.size());
  if (compared.compressed.correction) measurement.ik_bytes = compared.compressed.correction_bytes();
  return measurement;
}

}  // namespace mocapress
