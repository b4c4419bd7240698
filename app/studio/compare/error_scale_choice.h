// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QActionGroup>

#include "app/jobs/clips.h"
#include "widgets/models/error_colour.h"

namespace mocapress {

/// The one scale by which all views colour errors of a quantity: a fixed one, by which clips and
/// settings compare, or one that fits what is shown. Remembered from run to run.
class ErrorScaleChoice : public QActionGroup {
  Q_OBJECT

 public:
  explicit ErrorScaleChoice(ErrorQuantity quantity, QObject* parent = nullptr);

  /// For what is shown; null: nothing is.
  ErrorScale scaleFor(const DecodedPtr& decoded) const;

 signals:
  void changed();

 private:
  ErrorQuantity quantity_;
};

}  // namespace mocapress
