// SPDX-License-Identifier: MIT
// A project of the studio as a batch: its clips, each by its own settings.
#pragma once

#include <string>
#include <string_view>

#include "core/batch/batch.h"

namespace mocapress {

/// True if the extension is .mocapress.
bool is_project_file(const std::string& path);

/// Adds the clips of a project to a batch, with their skeletons, settings, import options and
/// verdicts, named by a pattern as in add_items(). A clip that was never tuned gets the batch's
/// first preset. The batch's character is put on the clips; without one, the project's. Throws
/// InputError for a text that is no project; throws Error as add_items() does.
void add_project(Batch& batch, const std::string& file, const std::string& text,
                 std::string_view pattern);

}  // namespace mocapress
