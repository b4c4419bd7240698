// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDBusVariant>
#include <QObject>
#include <QPalette>
#include <QProxyStyle>

namespace mocapress {

/// Fusion with four changes: check boxes have an outline visible on dark ground, checked tool
/// buttons stand out, sliders jump to a press and follow its drag, and disabled sliders look
/// disabled.
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

/// The user's choice of colours.
enum class ThemeChoice { System, Light, Dark };

QPalette lightPalette();
QPalette darkPalette();

/// Sets the application's palette: the one that the user chose, or the desktop's. The desktop's
/// settings portal reports its preference and each change of it. The user's choice is kept from run
/// to run.
class Theme : public QObject {
  Q_OBJECT

 public:
  explicit Theme(QObject* parent = nullptr);

  ThemeChoice choice() const { return choice_; }
  void choose(ThemeChoice choice);

  /// The desktop's preference, if known.
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
