// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <vector>

#include "core/contact/footskate.h"

namespace mocapress {

class ContactStrip;
class ErrorStrip;

/// The strips below the 3D view, in line with each other.
class Timeline : public QWidget {
  Q_OBJECT

 public:
  explicit Timeline(QWidget* parent = nullptr);

  ErrorStrip* errors() const { return errors_; }
  ContactStrip* contacts() const { return contacts_; }

  /// ContactStrip::setContacts(), and leaves the same room for names in all strips.
  void setContacts(std::vector<ContactSpan> contacts, const std::vector<QString>& names,
                   int frames);
  void setFrame(int frame);

 signals:
  void seekRequested(int frame);

 private:
  ErrorStrip* errors_;
  ContactStrip* contacts_;
};

}  // namespace mocapress
