// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/output_place.h"

#include "core/base/file_identity.h"
#include "core/base/staged_file.h"

namespace mocapress::cli {

void require_place(const std::filesystem::path& output,
                   const std::vector<std::filesystem::path>& sources) {
  refuse_source(output, sources);
  StagedFile{output};  // throws if `output` cannot be written; leaves no file there
}

}  // namespace mocapress::cli
