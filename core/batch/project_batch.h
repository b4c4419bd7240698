// SPDX-License-Identifier: MIT
// Makes a batch of a studio project: all its clips, each with its own settings.
#pragma once

#include <string>
#include <string_view>

#include "core/batch/batch.h"

namespace mocapress {

/// True if the extension is .mocapress.
bool is_project_file(const std::string& path);

/// Adds the clips of a project to a batch, with their skeletons, settings, import options and
/// verdicts. Outputs are made from a pattern as by add_items(). A clip that was never tuned gets
/// the batch's first preset. The batch's character is put on the clips, or the project's if the
/// batch has none. Throws InputError for a text that is not a project; throws Error as add_items()
/// does.
void add_project(Batch& batch, const std::string& file, const std::string& text,
                 std::string_view pattern);

}  // namespace mocapress
