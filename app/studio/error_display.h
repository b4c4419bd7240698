// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include "app/studio/error_scale_choice.h"

class QAction;

namespace mocapress {

/// How errors are shown: by which scale of distances and which of angles, and whether heat map and
/// graph tell distances or angles. Remembered from run to run.
class ErrorDisplay : public QObject {
  Q_OBJECT

 public:
  explicit ErrorDisplay(QObject* parent = nullptr);

  /// Of heat map and graph. Strip and figure always tell distances.
  ErrorQuantity quantity() const;

  ErrorScaleChoice* scales(ErrorQuantity quantity) const {
    return quantity == ErrorQuantity::Angle ? angles_ : distances_;
  }

  /// The switch between both quantities.
  QAction* inDegrees() const { return in_degrees_; }

 signals:
  void changed();

 private:
  ErrorScaleChoice* distances_;
  ErrorScaleChoice* angles_;
  QAction* in_degrees_;
};

}  // namespace mocapress
