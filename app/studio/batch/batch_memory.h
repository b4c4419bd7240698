// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <vector>

#include "widgets/models/batch_queue_model.h"

namespace mocapress {

/// What of a batch outlives the program. Of the clips, what they are and their own settings; what
/// became of them is in the journal of the batch's folder.
struct RememberedBatch {
  BatchSettings settings;
  Settings common = built_in_presets()[1];
  std::vector<QueuedClip> clips;
};

/// The usual one where there is none, or none that can be read.
RememberedBatch rememberedBatch(const QString& file);

/// Throws WriteError.
void rememberBatch(const QString& file, const RememberedBatch& batch);

/// Where the queue is remembered unless told otherwise: with the user's data.
QString batchMemory();

}  // namespace mocapress
