// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QActionGroup>
#include <QObject>

#include "app/jobs/clips.h"
#include "widgets/models/error_colour.h"

class QAction;

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

/// How errors are shown: by which scale of distances and which of angles, whether heat map and
/// graph tell distances or angles, and whether the heat map tells what is seen instead. Remembered
/// from run to run.
class ErrorDisplay : public QObject {
  Q_OBJECT

 public:
  explicit ErrorDisplay(QObject* parent = nullptr);

  /// Of heat map and graph. Strip and figure always tell distances.
  ErrorQuantity quantity() const;

  ErrorScaleChoice* scales(ErrorQuantity quantity) const {
    return quantity == ErrorQuantity::Angle ? angles_ : distances_;
  }

  /// Of the heat map.
  bool tellsSight() const;

  /// The switches to angles and to what is seen: one at most is on.
  QAction* inDegrees() const { return in_degrees_; }
  QAction* asSeen() const { return as_seen_; }

 signals:
  void changed();

 private:
  ErrorScaleChoice* distances_;
  ErrorScaleChoice* angles_;
  QAction* in_degrees_;
  QAction* as_seen_;
};

}  // namespace mocapress
