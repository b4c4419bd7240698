// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/jobs/level_encoder.h"

#include "core/base/error.h"

namespace mocapress {

void LevelEncoder::start(std::shared_ptr<const Encoder> encoder, const EncodeSettings& options,
                         const std::vector<double>& levels) {
  const auto work = [this, encoder = std::move(encoder), options, levels](const Job& job) {
    for (const double level : levels) {
      if (job.stopRequested()) break;
      EncodeSettings wanted = options;
      wanted.target = {Target::Kind::Visibility, level};
      wanted.effort = Effort::Draft;  // near the level is enough: each result is measured
      wanted.promises = {};
      wanted.ranges.clear();
      try {
        Encoding encoding =
            encoder->encode(wanted, [&job](const EncodeProgress&) { return !job.stopRequested(); });
        if (!encoding.complete) break;
        const DecodedPtr decoded = decodedClip(std::move(encoding), *encoder, wanted);
        job.post([this, decoded] { emit made(decoded); });
      } catch (const TargetMissed&) {
        // The clip cannot reach so small an error: the level is left out.
      }
    }
    return true;
  };
  runner_.start(
      work, [this](bool) { emit ended(); }, [this](const QString&) { emit ended(); });
}

}  // namespace mocapress
