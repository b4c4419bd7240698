// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QActionGroup>
#include <QObject>

#include "app/jobs/clips.h"
#include "widgets/models/error_colour.h"

class QAction;

namespace mocapress {

/// The scale by which all views colour the errors of a quantity: either fixed, so that clips and
/// settings can be compared, or fitted to the shown clip. The choice is kept from run to run.
class ErrorScaleChoice : public QActionGroup {
  Q_OBJECT

 public:
  explicit ErrorScaleChoice(ErrorQuantity quantity, QObject* parent = nullptr);

  /// The scale for a result. Null: no result is shown.
  ErrorScale scaleFor(const DecodedPtr& decoded) const;

 signals:
  void changed();

 private:
  ErrorQuantity quantity_;
};

/// The display of errors: the scales of distances and angles, the quantity in heat map and graph,
/// and the heat map's switch to visibility. The choices are kept from run to run.
class ErrorDisplay : public QObject {
  Q_OBJECT

 public:
  explicit ErrorDisplay(QObject* parent = nullptr);

  /// The quantity in heat map and graph. Strip and figure always show distances.
  ErrorQuantity quantity() const;

  ErrorScaleChoice* scales(ErrorQuantity quantity) const {
    return quantity == ErrorQuantity::Angle ? angles_ : distances_;
  }

  /// True when the heat map shows visibility.
  bool tellsSight() const;

  /// The switches to angles and to visibility: at most one is on.
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
