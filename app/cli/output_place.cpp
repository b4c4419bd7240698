// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/output_place.h"

#include "core/base/file_identity.h"
#include "core/base/staged_file.h"
#include "core/base/utf8_path.h"

namespace mocapress::cli {

void require_place(const std::filesystem::path& output,
                   const std::vector<std::filesystem::path>& sources) {
  refuse_source(output, sources);
  const std::filesystem::path folder = output.parent_path();
  std::error_code error;
  if (!folder.empty() && !std::filesystem::exists(folder, error) && !error)
    throw WriteError(utf8(output) +
                     ": cannot be written: No such file or directory: " + utf8(folder));
  StagedFile{output};  // refuses what cannot be written, and leaves nothing there
}

}  // namespace mocapress::cli
