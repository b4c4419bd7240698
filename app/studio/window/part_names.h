// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

namespace mocapress {

/// For screen readers, names parts of controls that Qt makes without a name: the list in a combo
/// box, the field in a number box, the button that clears a field. Also describes the purpose of
/// choosers, and lets Tab go past scroll areas to their contents. Filters events of the
/// application.
class PartNames : public QObject {
  Q_OBJECT

 public:
  using QObject::QObject;

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
};

}  // namespace mocapress
