// SPDX-License-Identifier: GPL-3.0-or-later
// Texts for screen readers, and the help's texts.
#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QAccessible>
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QLineEdit>
#include <QScrollBar>
#include <QSettings>

#include "app/studio/study/study_window.h"
#include "app/studio/window/help.h"
#include "app/studio/window/main_window.h"
#include "app/studio/window/theme.h"

namespace mocapress {
namespace {

bool isInteractive(const QWidget* widget) {
  if (qobject_cast<const QScrollBar*>(widget)) return false;
  // Skips parts of a control that has a name itself.
  for (const QWidget* above = widget->parentWidget(); above; above = above->parentWidget())
    if (qobject_cast<const QComboBox*>(above) || qobject_cast<const QAbstractSpinBox*>(above) ||
        qobject_cast<const QLineEdit*>(above) || qobject_cast<const QAbstractItemView*>(above))
      return false;
  if (widget->objectName().startsWith(QStringLiteral("qt_"))) return false;
  // Own widgets that the keyboard reaches: the 3D view, plots, maps, strips.
  if (QLatin1String(widget->metaObject()->className()).startsWith(QLatin1String("mocapress::")) &&
      (widget->focusPolicy() & Qt::TabFocus))
    return true;
  return qobject_cast<const QAbstractButton*>(widget) || qobject_cast<const QComboBox*>(widget) ||
         qobject_cast<const QAbstractSpinBox*>(widget) ||
         qobject_cast<const QAbstractSlider*>(widget) || qobject_cast<const QLineEdit*>(widget) ||
         qobject_cast<const QAbstractItemView*>(widget);
}

QStringList nameless(const QWidget* window) {
  QStringList found;
  for (QWidget* widget : window->findChildren<QWidget*>()) {
    if (!isInteractive(widget)) continue;
    QAccessibleInterface* read = QAccessible::queryAccessibleInterface(widget);
    if (!read || read->text(QAccessible::Name).trimmed().isEmpty())
      found << QString::fromLatin1(widget->metaObject()->className()) + QLatin1Char(' ') +
                   widget->objectName() + QStringLiteral(" in ") +
                   QString::fromLatin1(widget->parentWidget()->metaObject()->className());
  }
  return found;
}

TEST(Accessibility, EveryControlHasAName) {
  QSettings().clear();
  MainWindow window;
  EXPECT_EQ(nameless(&window).join(QLatin1Char('\n')).toStdString(), "");
  EXPECT_EQ(nameless(window.showStudy()).join(QLatin1Char('\n')).toStdString(), "");
  window.actions().batch->trigger();
  window.actions().blind_test->trigger();
  window.actions().find_command->trigger();
  window.actions().keyboard_map->trigger();
  window.actions().shortcuts->trigger();
  int windows = 0;
  for (const QWidget* top : QApplication::topLevelWidgets()) {
    if (!top->isVisible() || top == &window) continue;
    ++windows;
    EXPECT_EQ(nameless(top).join(QLatin1Char('\n')).toStdString(), "")
        << qPrintable(top->windowTitle());
  }
  EXPECT_GE(windows, 6);
}

/// Contrast as WCAG 2 defines it.
double contrast(const QColor& a, const QColor& b) {
  const auto luminance = [](const QColor& colour) {
    const auto linear = [](double x) {
      return x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(static_cast<double>(colour.redF())) +
           0.7152 * linear(static_cast<double>(colour.greenF())) +
           0.0722 * linear(static_cast<double>(colour.blueF()));
  };
  const double high = std::max(luminance(a), luminance(b));
  const double low = std::min(luminance(a), luminance(b));
  return (high + 0.05) / (low + 0.05);
}

TEST(Theme, TextIsReadableInBoth) {
  for (const QPalette& palette : {lightPalette(), darkPalette()}) {
    using enum QPalette::ColorRole;
    for (const auto& [text, ground] :
         {std::pair(WindowText, Window), std::pair(Text, Base), std::pair(Text, AlternateBase),
          std::pair(ButtonText, Button), std::pair(ToolTipText, ToolTipBase),
          std::pair(PlaceholderText, Window)})
      EXPECT_GE(contrast(palette.color(text), palette.color(ground)), 4.5) << text;
    EXPECT_GE(contrast(palette.color(HighlightedText), palette.color(Highlight)), 3.8);
  }
}

TEST(Theme, FollowsTheSystemUnlessTheUserChose) {
  QSettings().clear();
  const auto isDark = [] {
    return QApplication::palette().color(QPalette::Window).lightnessF() < 0.5F;
  };
  Theme theme;
  theme.setSystemDark(true);
  EXPECT_TRUE(isDark());
  theme.setSystemDark(false);
  EXPECT_FALSE(isDark());
  theme.choose(ThemeChoice::Dark);
  EXPECT_TRUE(isDark());
  EXPECT_EQ(Theme().choice(), ThemeChoice::Dark);  // remembered
  theme.choose(ThemeChoice::Light);
  theme.setSystemDark(true);
  EXPECT_FALSE(isDark());
  theme.choose(ThemeChoice::System);
  EXPECT_TRUE(isDark());
  theme.setSystemDark(false);
  QSettings().clear();
}

TEST(Guide, IsThereInEveryLanguage) {
  const QLocale before;
  QStringList guides;
  for (const char* language : {"en", "es", "fr", "ja"}) {
    QLocale::setDefault(QLocale(QLatin1String(language)));
    guides << guideHtml();
    EXPECT_EQ(guides.last().count(QStringLiteral("<h3>")), 6) << language;
    EXPECT_EQ(guides.last().count(QStringLiteral("<img")), 4) << language;
    for (const char* picture : {"compare", "inspect", "curve", "pinned"}) {
      const QString file =
          QStringLiteral(":/guide/%1_%2.png").arg(QLatin1String(picture), QLatin1String(language));
      EXPECT_TRUE(guides.last().contains(QStringLiteral("\"%1\"").arg(file))) << qPrintable(file);
      EXPECT_FALSE(QImage(file).isNull()) << qPrintable(file);
    }
  }
  EXPECT_EQ(QSet<QString>(guides.begin(), guides.end()).size(), 4);
  QLocale::setDefault(QLocale(QStringLiteral("de")));
  EXPECT_EQ(guideHtml(), guides[0]);
  QLocale::setDefault(before);
}

}  // namespace
}  // namespace mocapress
