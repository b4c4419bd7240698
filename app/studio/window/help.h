// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <QString>

class QMenuBar;

namespace mocapress {

/// All keys of a window's menus, by menu, as a table in HTML.
QString shortcutSheet(const QMenuBar& menus);

/// A page to read, in a window of its own beside the studio's.
class HelpWindow : public QDialog {
  Q_OBJECT

 public:
  HelpWindow(const QString& title, const QString& html, QWidget* parent);
};

/// The guide in the language of the program, else in English.
QString guideHtml();

void showGuide(QWidget* window);
void showShortcuts(const QMenuBar& menus, QWidget* window);
void showAbout(QWidget* window);

}  // namespace mocapress
