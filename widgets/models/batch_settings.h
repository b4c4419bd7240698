// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <vector>

#include "core/batch/batch.h"

namespace mocapress {

/// Where the files of a batch go, and which.
struct BatchSettings {
  QString folder;  // empty: not chosen yet
  QString names = QString::fromUtf8(kUsualNames);
  std::vector<OutputFormat> formats = {OutputFormat::Mcpr};
  bool overwrite = false;

  bool operator==(const BatchSettings&) const = default;
};

}  // namespace mocapress
