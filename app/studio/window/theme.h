// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDBusVariant>
#include <QObject>
#include <QPalette>
#include <QProxyStyle>

namespace mocapress {

/// Fusion, with check boxes whose outline is seen on dark ground too, tool buttons that stand out
/// while they are on, and sliders that come to where they are pressed, follow a drag from there,
/// and look disabled where they are.
class StudioStyle : public QProxyStyle {
 public:
  StudioStyle();

  void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                     const QWidget* widget) const override;
  void drawComplexControl(ComplexControl control, const QStyleOptionComplex* option,
                          QPainter* painter, const QWidget* widget) const override;
  int styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                QStyleHintReturn* returned) const override;
};

/// What the user wants the windows to look like.
enum class ThemeChoice { System, Light, Dark };

QPalette lightPalette();
QPalette darkPalette();

/// Gives the application its palette: the chosen one, or the desktop's as it says so (through the
/// settings portal, which tells of changes too). Remembered from run to run.
class Theme : public QObject {
  Q_OBJECT

 public:
  explicit Theme(QObject* parent = nullptr);

  ThemeChoice choice() const { return choice_; }
  void choose(ThemeChoice choice);

  /// What the desktop prefers, when it is known.
  void setSystemDark(bool dark);

 private:
  void askDesktop();
  void apply();

  ThemeChoice choice_;
  bool system_dark_;

 private slots:
  void desktopChanged(const QString& group, const QString& key, const QDBusVariant& value);
};

}  // namespace mocapress
