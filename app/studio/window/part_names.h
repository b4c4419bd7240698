// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

namespace mocapress {

/// Names parts of controls that Qt makes without a name, for screen readers: the list in a combo
/// box, the field in a number box, the button that clears a field. Says what choosers
/// are for. Tab goes past scroll areas to what is in them. Filters events of the application.
class PartNames : public QObject {
  Q_OBJECT

 public:
  using QObject::QObject;

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
};

}  // namespace mocapress
