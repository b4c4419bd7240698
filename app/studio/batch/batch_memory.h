// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDir>
#include <QString>
#include <vector>

#include "core/base/json_text.h"
#include "widgets/models/batch_queue_model.h"

namespace mocapress {

/// The batch of a project, as its file keeps it. Of the clips, what they are and their own
/// settings; what became of them is in the journal of the batch's folder.
struct RememberedBatch {
  BatchSettings settings;
  Settings common = built_in_presets()[1];
  std::vector<QueuedClip> clips;
};

/// With paths relative to the folder of the project.
Json toJson(const RememberedBatch& batch, const QDir& folder);

/// The inverse. Throws Error, or like the JSON library does.
RememberedBatch batchFrom(const Json& json, const QDir& folder);

}  // namespace mocapress
