// SPDX-License-Identifier: GPL-3.0-or-later
// Checks the translated program: no text left in English, and none cut off.
#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QApplication>
#include <QComboBox>
#include <QFile>
#include <QGroupBox>
#include <QKeySequence>
#include <QLabel>
#include <QMap>
#include <QMenu>
#include <QMenuBar>
#include <QProcess>
#include <QPushButton>
#include <QRegularExpression>
#include <QSettings>
#include <QTabBar>
#include <QTemporaryDir>
#include <QTest>
#include <QTranslator>
#include <QXmlStreamReader>
#include <algorithm>

#include "app/studio/batch/batch_window.h"
#include "app/studio/study/study_window.h"
#include "app/studio/window/main_window.h"
#include "app/studio/window/tabs_below.h"
#include "tests/qt/patience.h"
#include "tests/qt/untranslated.h"
#include "translations/languages.h"
#include "widgets/viewport/viewport.h"

namespace mocapress {
namespace {

const QString kFolder = QStringLiteral(MOCAPRESS_SOURCE_DIR "/translations");

struct Text {
  QString source;
  QStringList translations;  // one for each plural form
  bool finished = true;
  bool plural = false;
};

std::vector<Text> textsOf(const QString& path) {
  QFile file(path);
  EXPECT_TRUE(file.open(QIODevice::ReadOnly)) << qPrintable(path);
  QXmlStreamReader xml(&file);
  std::vector<Text> texts;
  while (!xml.atEnd()) {
    xml.readNext();
    if (!xml.isStartElement()) continue;
    if (xml.name() == QLatin1String("message"))
      texts.push_back(
          {.plural = xml.attributes().value(QLatin1String("numerus")) == QLatin1String("yes")});
    if (xml.name() == QLatin1String("source")) texts.back().source = xml.readElementText();
    if (xml.name() == QLatin1String("translation")) {
      Text& text = texts.back();
      text.finished = !xml.attributes().hasAttribute(QLatin1String("type"));
      if (!text.plural) text.translations << xml.readElementText();
    }
    if (xml.name() == QLatin1String("numerusform"))
      texts.back().translations << xml.readElementText();
  }
  EXPECT_FALSE(xml.hasError()) << qPrintable(xml.errorString());
  return texts;
}

QStringList translated() {
  QStringList languages = shippedLanguages();
  languages.removeAll(QStringLiteral("en"));
  return languages;
}

QString fileOf(const QString& language) {
  return QStringLiteral("%1/mocapress_%2.ts").arg(kFolder, language);
}

/// Placeholders of a text such as "%1", "%L2", "%Ln", sorted.
QStringList placesIn(const QString& text) {
  QStringList places;
  static const QRegularExpression kPlace(QStringLiteral("%L?(\\d|n)"));
  auto match = kPlace.globalMatch(text);
  while (match.hasNext()) places << match.next().captured();
  places.sort();
  places.removeDuplicates();
  return places;
}

TEST(Translations, LeaveNoTextOfTheSourcesOut) {
  QStringList untranslated;
  for (const QString& language : translated()) {
    const QTemporaryDir directory;
    const QString copy = directory.filePath(QStringLiteral("texts.ts"));
    ASSERT_TRUE(QFile::copy(fileOf(language), copy));
    // Runs lupdate on the current sources, as the build's own target does.
    QProcess lupdate;
    lupdate.setWorkingDirectory(QStringLiteral(MOCAPRESS_SOURCE_DIR));
    lupdate.start(
        QStringLiteral(MOCAPRESS_LUPDATE),
        {QStringLiteral("-silent"), QStringLiteral("-no-obsolete"), QStringLiteral("-locations"),
         QStringLiteral("none"), QStringLiteral("-I"), QStringLiteral("."), QStringLiteral("app"),
         QStringLiteral("widgets"), QStringLiteral("-ts"), copy});
    if (!lupdate.waitForStarted()) GTEST_SKIP() << "needs Qt's lupdate";
    ASSERT_TRUE(lupdate.waitForFinished(120'000));
    const std::vector<Text> texts = textsOf(copy);
    EXPECT_GT(texts.size(), 400u);
    for (const Text& text : texts)
      if (!text.finished || text.translations.contains(QString()))
        untranslated << language + QStringLiteral(": ") + text.source;
  }
  endWithUntranslated(untranslated);
}

TEST(Translations, KeepThePlacesOfNumbersAndNames) {
  for (const QString& language : translated())
    for (const Text& text : textsOf(fileOf(language)))
      for (const QString& translation : text.finished ? text.translations : QStringList())
        EXPECT_EQ(placesIn(translation), placesIn(text.source))
            << qPrintable(language) << ": " << qPrintable(text.source);
}

TEST(Translations, HaveThePluralFormsOfTheirLanguage) {
  for (const auto& [language, forms] :
       {std::pair(QStringLiteral("es"), 2), std::pair(QStringLiteral("fr"), 2),
        std::pair(QStringLiteral("ja"), 1)}) {
    int plurals = 0;
    for (const Text& text : textsOf(fileOf(language)))
      if (text.plural) {
        EXPECT_EQ(text.translations.size(), forms) << qPrintable(text.source);
        ++plurals;
      }
    EXPECT_GT(plurals, 5);
  }
}

TEST(Translations, AreInTheProgram) {
  for (const QString& language : shippedLanguages()) {
    QTranslator texts;
    EXPECT_TRUE(texts.load(QStringLiteral(":/i18n/mocapress_%1.qm").arg(language)))
        << qPrintable(language);
  }
  QTranslator french;
  ASSERT_TRUE(french.load(QStringLiteral(":/i18n/mocapress_fr.qm")));
  EXPECT_EQ(french.translate("mocapress::ViewActions", "&Overlay"), QStringLiteral("&Superposer"));
  EXPECT_EQ(french.translate("mocapress::LibraryModel", "%Ln frame(s)", nullptr, 1),
            QStringLiteral("%Ln image"));
  EXPECT_EQ(french.translate("mocapress::LibraryModel", "%Ln frame(s)", nullptr, 2),
            QStringLiteral("%Ln images"));
}

QString contentsOf(const QString& path) {
  QFile file(QStringLiteral(MOCAPRESS_SOURCE_DIR "/") + path);
  EXPECT_TRUE(file.open(QIODevice::ReadOnly)) << qPrintable(path);
  return QString::fromUtf8(file.readAll());
}

TEST(Translations, EachLanguageIsInTheMenuAndOnTheDesktop) {
  QSettings().clear();
  MainWindow window;
  QStringList offered;
  for (const QAction* action : window.actions().languages->actions())
    offered << action->data().toString();
  offered.removeAll(QString());  // the system's
  EXPECT_EQ(offered.join(QLatin1Char(' ')), shippedLanguages().join(QLatin1Char(' ')));
  const QString desktop = QStringLiteral("resources/desktop/org.mocapress.Studio.");
  for (const QString& language : translated()) {
    const QString entry = contentsOf(desktop + QStringLiteral("desktop"));
    EXPECT_EQ(entry.count(QStringLiteral("[%1]=").arg(language)), 2) << qPrintable(language);
    const QString lang = QStringLiteral("xml:lang=\"%1\"").arg(language);
    EXPECT_EQ(contentsOf(desktop + QStringLiteral("metainfo.xml")).count(lang), 2);
    EXPECT_EQ(contentsOf(desktop + QStringLiteral("mime.xml")).count(lang), 4);
  }
  QSettings().clear();
}

/// Visible labels and buttons that are narrower than their text.
QStringList cutOff(const QWidget& window) {
  QStringList found;
  const auto judge = [&](const QWidget* widget, const QString& text) {
    if (!widget->isVisible() || text.isEmpty()) return;
    if (widget->width() + 1 < widget->minimumSizeHint().width())
      found << QStringLiteral("%1: %2 of %3")
                   .arg(text)
                   .arg(widget->width())
                   .arg(widget->minimumSizeHint().width());
  };
  for (const auto* label : window.findChildren<QLabel*>())
    if (!label->wordWrap()) judge(label, label->text());
  for (const auto* button : window.findChildren<QAbstractButton*>()) judge(button, button->text());
  for (const auto* box : window.findChildren<QComboBox*>()) judge(box, box->currentText());
  return found;
}

/// Shortcut keys used by more than one entry of a menu or submenu.
QStringList sharedKeys(const QList<QAction*>& entries) {
  QStringList shared;
  QMap<QString, QString> taken;
  for (const QAction* action : entries) {
    const QString key = QKeySequence::mnemonic(action->text()).toString();
    if (!key.isEmpty() && taken.contains(key))
      shared << QStringLiteral("%1 / %2").arg(taken[key], action->text());
    taken[key] = action->text();
    if (const QMenu* menu = action->menu()) shared << sharedKeys(menu->actions());
  }
  return shared;
}

/// Shortcut keys used more than once in a window, by menus, buttons or labels of fields. Such a key
/// opens neither.
QStringList sharedKeysIn(const QWidget& window) {
  QStringList shared;
  QMap<QString, QString> taken;
  const auto take = [&](const QString& text) {
    const QString key = QKeySequence::mnemonic(text).toString();
    if (key.isEmpty()) return;
    if (taken.contains(key)) shared << QStringLiteral("%1 / %2").arg(taken[key], text);
    taken[key] = text;
  };
  for (const auto* bar : window.findChildren<QMenuBar*>())
    for (const QAction* menu : bar->actions()) take(menu->text());
  const auto here = [&](const QWidget* widget) { return widget->window() == &window; };
  for (const auto* button : window.findChildren<QAbstractButton*>())
    if (here(button)) take(button->text());
  for (const auto* box : window.findChildren<QGroupBox*>())
    if (here(box)) take(box->title());
  for (const auto* label : window.findChildren<QLabel*>())
    if (here(label) && label->buddy()) take(label->text());
  for (const auto* menu : window.findChildren<QMenu*>()) shared << sharedKeys(menu->actions());
  return shared;
}

TEST(Translations, LayoutsHoldInEveryLanguage) {
  for (const QString& language : shippedLanguages()) {
    QSettings().clear();
    QTranslator texts;
    ASSERT_TRUE(texts.load(QStringLiteral(":/i18n/mocapress_%1.qm").arg(language)));
    QCoreApplication::installTranslator(&texts);
    {
      MainWindow window;
      window.resize(1440, 900);
      window.show();
      ASSERT_TRUE(QTest::qWaitForWindowExposed(&window));
      EXPECT_EQ(cutOff(window).join(QLatin1Char('\n')).toStdString(), "") << qPrintable(language);
      EXPECT_EQ(sharedKeys(window.menuBar()->actions()).join(QLatin1Char('\n')).toStdString(), "")
          << qPrintable(language);
      EXPECT_EQ(sharedKeysIn(window).join(QLatin1Char('\n')).toStdString(), "")
          << qPrintable(language);
      for (const auto* menu : window.findChildren<QMenu*>())
        EXPECT_LE(menu->sizeHint().height(), 720) << qPrintable(language + menu->title());
      EXPECT_LE(window.minimumSizeHint().width(), 1440) << qPrintable(language);
      EXPECT_LE(window.minimumSizeHint().height(), 900) << qPrintable(language);
      window.resize(1280, 720);
      const auto is_laid_out = [&window] {
        return tabsFit(window.findChildren<QTabBar*>(Qt::FindDirectChildrenOnly)) &&
               window.views().viewport->height() >= 0.45 * 720;
      };
      EXPECT_TRUE(QTest::qWaitFor(is_laid_out, kPatience)) << qPrintable(language);
      StudyWindow* study = window.showStudy();
      ASSERT_TRUE(QTest::qWaitForWindowExposed(study));
      EXPECT_EQ(cutOff(*study).join(QLatin1Char('\n')).toStdString(), "") << qPrintable(language);
      EXPECT_EQ(sharedKeysIn(*study).join(QLatin1Char('\n')).toStdString(), "")
          << qPrintable(language);
      study->close();
      window.actions().batch->trigger();
      auto* batch = window.findChild<BatchWindow*>();
      ASSERT_NE(batch, nullptr);
      for (const char* start : {"&Go On", "&Pause", "&Export"}) {  // the three texts of its button
        const QString key =
            QKeySequence::mnemonic(QCoreApplication::translate("mocapress::BatchStatus", start))
                .toString();
        for (const auto* button : batch->findChildren<QPushButton*>())
          if (button->window() == batch && button != batch->startButton()) {
            EXPECT_NE(QKeySequence::mnemonic(button->text()).toString(), key)
                << qPrintable(language) << ": " << qPrintable(button->text());
          }
      }
      EXPECT_EQ(sharedKeysIn(*batch).join(QLatin1Char('\n')).toStdString(), "")
          << qPrintable(language);
      batch->close();
    }
    QCoreApplication::removeTranslator(&texts);
  }
  QSettings().clear();
}

}  // namespace
}  // namespace mocapress
