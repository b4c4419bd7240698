// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDir>
#include <QString>
#include <vector>

#include "core/base/json_text.h"
#include "widgets/models/batch_queue_model.h"

namespace mocapress {

/// The batch of a project as the project file stores it: clips and their own settings. Results are
/// in the journal in the batch's folder.
struct RememberedBatch {
  BatchSettings settings;
  Settings common = built_in_presets()[1];
  std::vector<QueuedClip> clips;
};

/// Writes paths relative to the project's folder.
Json toJson(const RememberedBatch& batch, const QDir& folder);

/// The inverse of toJson(). Throws Error, or the JSON library's exceptions.
RememberedBatch batchFrom(const Json& json, const QDir& folder);

}  // namespace mocapress
