// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/models/report_texts.h"

#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QFile>
#include <QLocale>
#include <QRegularExpression>
#include <QTranslator>

#include "core/report/sign_off.h"
#include "translations/languages.h"

namespace mocapress::report_texts_test {
namespace {

/// The texts that a source passes to its ReportLanguage.
QStringList saidIn(const QString& path) {
  QFile file(QStringLiteral(MOCAPRESS_SOURCE_DIR "/%1").arg(path));
  EXPECT_TRUE(file.open(QIODevice::ReadOnly)) << qPrintable(path);
  QString source = QString::fromUtf8(file.readAll());
  source.remove(QRegularExpression(QStringLiteral(R"("\s*\n\s*")")));
  static const QRegularExpression kSaid(QStringLiteral(R"re(\bsay\(\s*"((?:[^"\\]|\\.)*)")re"));
  QStringList texts;
  auto said = kSaid.globalMatch(source);
  while (said.hasNext()) texts << said.next().captured(1);
  return texts;
}

TEST(ReportTexts, AreInEveryLanguage) {
  QStringList texts = saidIn(QStringLiteral("core/report/sign_off.cpp"));
  EXPECT_GT(texts.size(), 20);
  texts << QStringLiteral("the clip's file changed") << QStringLiteral("the settings changed")
        << QStringLiteral("the clip's file and the settings changed")
        << QStringLiteral("it does not say which file and settings were reviewed")
        << QStringLiteral("approved") << QStringLiteral("rejected");
  for (const QString& language : shippedLanguages()) {
    if (language == QLatin1String("en")) continue;
    QTranslator translator;
    ASSERT_TRUE(translator.load(QStringLiteral(":/i18n/mocapress_%1.qm").arg(language)));
    for (const QString& text : texts)
      EXPECT_FALSE(translator.translate("mocapress::Report", text.toUtf8()).isEmpty())
          << qPrintable(language) << ": " << qPrintable(text);
  }
}

TEST(ReportTexts, ASignOffFollowsTheProgramsLanguage) {
  const QLocale before;
  SignOff report{.title = "Knights"};
  report.clips.push_back({.name = "walk.bvh",
                          .path = "/m/walk.bvh",
                          .review = {.verdict = Verdict::Approved,
                                     .reviewer = "ana",
                                     .source_hash = "a",
                                     .settings_hash = "b"},
                          .source_hash = "a",
                          .settings_hash = "c",
                          .problem = "walk.bvh:3: no complete frame follows"});
  report.language = reportLanguage();
  EXPECT_NE(sign_off_html(report).find("the settings changed"), std::string::npos);
  QLocale::setDefault(QLocale(QStringLiteral("es")));
  QTranslator spanish;
  ASSERT_TRUE(spanish.load(QStringLiteral(":/i18n/mocapress_es.qm")));
  QCoreApplication::installTranslator(&spanish);
  report.language = reportLanguage();
  const std::string page = sign_off_html(report);
  QCoreApplication::removeTranslator(&spanish);
  QLocale::setDefault(before);
  for (const char* text :
       {"<html lang=\"es\">", "Visto bueno: Knights", "0 de 1 revisados", ">aprobado<",
        "los ajustes cambiaron", "walk.bvh:3: no sigue ningún fotograma completo"})
    EXPECT_NE(page.find(text), page.npos) << text << '\n' << page;
}

}  // namespace
}  // namespace mocapress::report_texts_test
