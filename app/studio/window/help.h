// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <QString>

class QMenuBar;

namespace mocapress {

/// All shortcuts of a window's menus as an HTML table.
QString shortcutSheet(const QMenuBar& menus);

/// A page of text in a window of its own.
class HelpWindow : public QDialog {
  Q_OBJECT

 public:
  HelpWindow(const QString& title, const QString& html, QWidget* parent);
};

/// The guide in the program's language, else in English.
QString guideHtml();

void showGuide(QWidget* window);
void showShortcuts(const QMenuBar& menus, QWidget* window);
void showAbout(QWidget* window);

}  // namespace mocapress
