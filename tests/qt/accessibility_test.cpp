// SPDX-License-Identifier: GPL-3.0-or-later
// Texts for screen readers, and the help's texts.
#include <gtest/gtest.h>

#include <QAbstractSpinBox>
#include <QAccessible>
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QImage>
#include <QKeySequenceEdit>
#include <QLineEdit>
#include <QMenuBar>
#include <QRadioButton>
#include <QSet>
#include <QSettings>
#include <QSignalSpy>
#include <QStackedWidget>
#include <QTest>
#include <QTimer>
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
         qobject_cast<const QAbstractSpinBox*>(whole) || qobject_cast<const QComboBox*>(whole) ||
         qobject_cast<const QKeySequenceEdit*>(whole);
}

/// Controls that Tab does not reach from where the focus is, and that no command does.
QStringList beyondTab(QWidget* window, const std::vector<Command>& commands) {
  QSet<const QWidget*> reached;
  constexpr int kTabs = 300;  // more than a window has controls
  for (int i = 0; i < kTabs; ++i) {
    QWidget* const at = window->focusWidget();
    QTest::keyClick(at ? at : window, Qt::Key_Tab);
    reached.insert(window->focusWidget());
  }
  QStringList found;
  for (QAccessibleInterface* item : itemsOf(window)) {
    const auto* const widget = qobject_cast<const QWidget*>(item->object());
    if (!widget || !isOperable(item) || !widget->isVisible() || !widget->isEnabled()) continue;
    if (!reached.contains(widget) && !isOfCommand(widget, commands) && !isPart(widget))
      found << placeOf(item) + QLatin1String(": ") + item->text(QAccessible::Name);
  }
  return found;
}

/// Every page of a window is named and reached by Tab.
void expectForKeyboard(QWidget* window, const std::vector<Command>& commands) {
  auto* const pages = window->findChild<QStackedWidget*>();
  for (int page = 0; page < (pages ? pages->count() : 1); ++page) {
    if (pages) pages->setCurrentIndex(page);
    EXPECT_EQ(nameless(window).join(QLatin1Char('\n')).toStdString(), "")
        << qPrintable(window->windowTitle());
    EXPECT_EQ(beyondTab(window, commands).join(QLatin1Char('\n')).toStdString(), "")
        << qPrintable(window->windowTitle());
  }
}

TEST(Accessibility, EveryControlHasANameAndIsReachedByTabOrACommand) {
  QSettings().clear();
  MainWindow window;
  window.resize(1440, 900);
  window.show();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&window));
  QSignalSpy settled(&window.session(), &Session::settled);
  window.files().open(sampleClip());
  ASSERT_TRUE(settled.count() > 0 || settled.wait(kPatience));
  window.libraryPanel().view()->setFocus();
  EXPECT_EQ(nameless(&window).join(QLatin1Char('\n')).toStdString(), "");
  EXPECT_EQ(beyondTab(&window, window.commands()).join(QLatin1Char('\n')).toStdString(), "");

  const Actions& actions = window.actions();
  for (QAction* shows :
       {actions.study, actions.batch, actions.blind_test, actions.find_command,
        actions.keyboard_map, actions.shortcuts, actions.guide, actions.about,
        actions.import_options, actions.note_here, actions.open, actions.export_sign_off}) {
    int windows = 0;
    // Some of them return only after they are closed.
    QTimer::singleShot(0, &window, [&] {
      for (QWidget* top : QApplication::topLevelWidgets()) {
        if (!top->isVisible() || top == &window) continue;
        ++windows;
        expectForKeyboard(top, window.commands());
        top->close();
      }
    });
    shows->trigger();
    QApplication::processEvents();
    EXPECT_EQ(windows, 1) << qPrintable(shows->text());
  }
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
