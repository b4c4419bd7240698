// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/jobs/clip_saving.h"

#include <filesystem>

#include "app/jobs/clips.h"
#include "core/base/staged_file.h"
#include "core/batch/verification.h"
#include "core/codec/format/source_section.h"

namespace mocapress {

void saveClip(const QString& path, const DecodedClip& decoded, const OriginalClip* original) {
  const bool was_encoded_here = decoded.coefficient_ratio.has_value();
  StagedFile file(std::filesystem::path(path.toStdU16String()));
  file.write(
      with_source(decoded.file, original && was_encoded_here ? original->source : decoded.source));
  if (original && was_encoded_here)
    verify(file.read_back(), *original->encoder);
  else
    read_mcpr(file.read_back());
  file.commit();
}

}  // namespace mocapress
