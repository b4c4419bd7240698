// SPDX-License-Identifier: GPL-3.0-or-later
// Texts for screen readers, and the help's texts.
#include <gtest/gtest.h>

#include <QAbstractSpinBox>
#include <QAccessible>
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QImage>
#include <QLineEdit>
#include <QMenuBar>
#include <QRadioButton>
#include <QSet>
#include <QSettings>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>
#include <QTreeView>
#include <algorithm>

#include "app/studio/study/study_window.h"
#include "app/studio/window/help.h"
#include "app/studio/window/main_window.h"
#include "app/studio/window/theme.h"
#include "tests/qt/patience.h"
#include "widgets/panels/library_panel.h"

namespace mocapress {
namespace {

/// All items below a window that a screen reader sees, but for the cells of lists: their texts are
/// those of the models.
std::vector<QAccessibleInterface*> itemsOf(QAccessibleInterface* item) {
  if (!item || !item->isValid()) return {};
  std::vector<QAccessibleInterface*> items{item};
  if (item->tableInterface()) return items;
  for (int i = 0; i < item->childCount(); ++i) {
    const std::vector<QAccessibleInterface*> below = itemsOf(item->child(i));
    items.insert(items.end(), below.begin(), below.end());
  }
  return items;
}

std::vector<QAccessibleInterface*> itemsOf(QWidget* window) {
  return itemsOf(QAccessible::queryAccessibleInterface(window));
}

/// True for what the keyboard or a click may act on.
bool isOperable(QAccessibleInterface* item) {
  // A label whose text can be selected is named by it, a bar of tabs by the chosen one.
  if (item->role() == QAccessible::ScrollBar || item->role() == QAccessible::Separator ||
      item->role() == QAccessible::StaticText || item->role() == QAccessible::PageTabList)
    return false;
  QAccessibleActionInterface* const actions = item->actionInterface();
  return item->state().focusable || (actions && !actions->actionNames().isEmpty());
}

QString placeOf(QAccessibleInterface* item) {
  QStringList names;
  for (; item; item = item->parent()) {
    const QObject* const object = item->object();
    names.prepend(object ? QString::fromLatin1(object->metaObject()->className()) +
                               QLatin1Char(' ') + object->objectName()
                         : QStringLiteral("role %1").arg(item->role()));
  }
  return names.join(QStringLiteral(" > "));
}

QStringList nameless(QWidget* window) {
  QStringList found;
  for (QAccessibleInterface* item : itemsOf(window))
    if (isOperable(item) && item->text(QAccessible::Name).trimmed().isEmpty())
      found << placeOf(item);
  return found;
}

TEST(Accessibility, EveryControlHasAName) {
  QSettings().clear();
  MainWindow window;
  window.show();
  EXPECT_EQ(nameless(&window).join(QLatin1Char('\n')).toStdString(), "");
  EXPECT_EQ(nameless(window.showStudy()).join(QLatin1Char('\n')).toStdString(), "");
  window.actions().batch->trigger();
  window.actions().blind_test->trigger();
  window.actions().find_command->trigger();
  window.actions().keyboard_map->trigger();
  window.actions().shortcuts->trigger();
  int windows = 0;
  for (QWidget* top : QApplication::topLevelWidgets()) {
    if (!top->isVisible() || top == &window) continue;
    ++windows;
    EXPECT_EQ(nameless(top).join(QLatin1Char('\n')).toStdString(), "")
        << qPrintable(top->windowTitle());
  }
  EXPECT_GE(windows, 6);
}

/// True for a button of a command that the palette finds and the keyboard map gives a key.
bool isOfCommand(const QWidget* widget, const std::vector<Command>& commands) {
  const auto* button = qobject_cast<const QToolButton*>(widget);
  return button && std::any_of(commands.begin(), commands.end(), [&](const Command& command) {
           return command.action == button->defaultAction();
         });
}

/// True for parts whose whole has the focus, and does by keys what they do.
bool isPart(const QWidget* widget) {
  const QWidget* const whole = widget->parentWidget();
  if (const auto* radio = qobject_cast<const QRadioButton*>(widget))
    return !radio->isChecked();  // the arrows go there from the one that is
  return qobject_cast<const QMenuBar*>(widget) || qobject_cast<const QLineEdit*>(whole) ||
         qobject_cast<const QAbstractSpinBox*>(whole) || qobject_cast<const QComboBox*>(whole);
}

TEST(Accessibility, EveryControlIsReachedByTabOrHasACommand) {
  QSettings().clear();
  MainWindow window;
  window.resize(1440, 900);
  window.show();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&window));
  QSignalSpy settled(&window.session(), &Session::settled);
  window.files().open(sampleClip());
  ASSERT_TRUE(settled.count() > 0 || settled.wait(kPatience));

  QSet<const QWidget*> reached;
  window.libraryPanel().view()->setFocus();
  constexpr int kTabs = 300;  // more than the window has controls
  for (int i = 0; i < kTabs; ++i) {
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
    ASSERT_NE(QApplication::focusWidget(), nullptr);
    reached.insert(QApplication::focusWidget());
  }
  EXPECT_GT(reached.size(), 20);
  EXPECT_LT(reached.size(), kTabs) << "the first is reached again";
  QStringList beyond;
  for (QAccessibleInterface* item : itemsOf(&window)) {
    const auto* const widget = qobject_cast<const QWidget*>(item->object());
    if (!widget || !isOperable(item) || !widget->isVisible() || !widget->isEnabled()) continue;
    if (!reached.contains(widget) && !isOfCommand(widget, window.commands()) && !isPart(widget))
      beyond << placeOf(item) + QLatin1String(": ") + item->text(QAccessible::Name);
  }
  EXPECT_EQ(beyond.join(QLatin1Char('\n')).toStdString(), "");
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
