// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/models/report_texts.h"

#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QLocale>
#include <QRegularExpression>
#include <QTranslator>
#include <cstdlib>
#include <filesystem>
#include <sstream>

#include "core/base/file.h"
#include "core/batch/report.h"
#include "core/batch/report_script.h"
#include "core/codec/methods/compression_method.h"
#include "core/metrics/sight_limits.h"
#include "core/report/review_clip.h"
#include "core/report/review_page.h"
#include "core/report/sight_chart.h"
#include "core/study/report.h"
#include "tests/qt/untranslated.h"
#include "translations/languages.h"
#include "widgets/models/display_names.h"

namespace mocapress::report_texts_test {
namespace {

/// The texts that a source passes to say().
QStringList saidIn(const QString& path) {
  QFile file(path);
  EXPECT_TRUE(file.open(QIODevice::ReadOnly)) << qPrintable(path);
  QString source = QString::fromUtf8(file.readAll());
  source.remove(QRegularExpression(QStringLiteral(R"("\s*\n\s*")")));
  const QRegularExpression saying(
      QStringLiteral(R"(\bsay_?\(\s*(?:[^()%1]*\?\s*)?%1([^%1]*)%1(?:\s*:\s*%1([^%1]*)%1)?)")
          .arg(QLatin1Char(path.endsWith(QLatin1String(".js")) ? '\'' : '"')));
  QStringList texts;
  auto said = saying.globalMatch(source);
  while (said.hasNext()) {
    const QRegularExpressionMatch match = said.next();
    for (const int part : {1, 2})
      if (!match.captured(part).isEmpty()) texts << match.captured(part);
  }
  return texts;
}

QStringList scriptTexts() {
  QStringList texts;
  for (const char* text : review_texts()) texts << QString::fromUtf8(text);
  for (const char* text : kReportTexts) texts << QString::fromUtf8(text);
  return texts;
}

QStringList allTexts() {
  QStringList texts = scriptTexts();
  for (const char* room : {"report", "batch", "study"}) {
    const QDir folder(QStringLiteral(MOCAPRESS_SOURCE_DIR "/core/%1").arg(QLatin1String(room)));
    for (const QString& name : folder.entryList({QStringLiteral("*.cpp")}))
      texts += saidIn(folder.filePath(name));
  }
  for (const CompressionMethod& method : compression_methods())
    texts << QString::fromStdString(std::string(method.note));
  texts << QString::fromUtf8(kSightLegend) << QStringLiteral("the clip's file changed")
        << QStringLiteral("the settings changed")
        << QStringLiteral("the clip's file and the settings changed")
        << QStringLiteral("it does not say which file and settings were reviewed");
  return texts;
}

TEST(ReportTexts, AreThereInEveryLanguage) {
  const QStringList texts = allTexts();
  EXPECT_GT(texts.size(), 200);
  QStringList untranslated;
  for (const QString& language : shippedLanguages()) {
    if (language == QLatin1String("en")) continue;
    QTranslator translator;
    ASSERT_TRUE(translator.load(QStringLiteral(":/i18n/mocapress_%1.qm").arg(language)));
    for (const QString& text : texts)
      if (translator.translate("mocapress::Report", text.toUtf8()).isEmpty())
        untranslated << language + QStringLiteral(": ") + text;
  }
  endWithUntranslated(untranslated);
}

/// Pages take texts of say() as markup, or between quotes.
TEST(ReportTexts, HoldNoMarkupInAnyLanguage) {
  const QRegularExpression markup(QStringLiteral("[<>&\"]"));
  for (const QString& language : shippedLanguages()) {
    QTranslator translator;
    ASSERT_TRUE(translator.load(QStringLiteral(":/i18n/mocapress_%1.qm").arg(language)));
    for (const QString& text : allTexts())
      for (const QString& said : {text, translator.translate("mocapress::Report", text.toUtf8())})
        EXPECT_FALSE(said.contains(markup)) << qPrintable(language) << ": " << qPrintable(said);
  }
}

/// say() of a page knows only the texts that core lists for it.
TEST(ReportTexts, ScriptsSayOnlyListedTexts) {
  const QStringList listed = scriptTexts();
  QStringList said;
  for (const char* path : {"core/report/viewer/viewer.js", "core/report/review_script.h",
                           "core/batch/report_script.h"})
    said += saidIn(QStringLiteral(MOCAPRESS_SOURCE_DIR "/%1").arg(QLatin1String(path)));
  EXPECT_GT(said.size(), 10);
  for (const QString& text : said) EXPECT_TRUE(listed.contains(text)) << qPrintable(text);
}

/// Speaks another language until it is destroyed.
class Speaking {
 public:
  explicit Speaking(const char* language) {
    EXPECT_TRUE(translator_.load(QStringLiteral(":/i18n/mocapress_%1.qm").arg(language)));
    QLocale::setDefault(QLocale(QLatin1String(language)));
    QCoreApplication::installTranslator(&translator_);
  }
  ~Speaking() {
    QCoreApplication::removeTranslator(&translator_);
    QLocale::setDefault(before_);
  }
  Speaking(const Speaking&) = delete;
  Speaking& operator=(const Speaking&) = delete;

 private:
  QLocale before_;
  QTranslator translator_;
};

/// For those who look at pages.
void keep(const std::string& page, const char* name) {
  if (const char* folder = std::getenv("MOCAPRESS_PICTURES"))
    write_text(std::filesystem::path(folder) / name, page);
}

void expectIn(const std::string& page, std::initializer_list<const char*> texts) {
  for (const char* text : texts) EXPECT_NE(page.find(text), page.npos) << text << '\n' << page;
}

std::string batchPage() {
  BatchRow row{.input = "/m/walk.bvh", .output = "walk"};
  row.stamp.source = "aa";
  row.measured = Measurement{};
  row.measured->seen = Seen{.times_noticed = 3,
                            .reason =
                                "jitter of rhand at frame 7: 1.5 degrees, noticed from 0.5 "
                                "degrees"};
  row.warnings = {"walk.bvh:9: the file ends within its last frame, which is dropped"};
  row.review = {.verdict = Verdict::Rejected, .reviewer = "ana"};
  std::ostringstream page;
  write_batch_html(page, [&](const auto& visit) { visit(row); }, 1, {}, reportLanguage(), {});
  return page.str();
}

TEST(ReportTexts, AreEnglishInALanguageThatTheProgramDoesNotHave) {
  const QLocale before;
  QLocale::setDefault(QLocale(QLocale::German));
  EXPECT_EQ(reportLanguage().code, "en");
  QLocale::setDefault(before);
}

TEST(ReportTexts, OwnLimitsNameTheirCuesInTheLanguage) {
  const Speaking french("fr");
  SightLimits limits;
  limits.of(Cue::Velocity) = {3, 0.08};
  limits.of(Cue::Hand).least = 6;
  EXPECT_EQ(QString::fromStdString(reportLanguage()(limits_text(limits))),
            QStringLiteral("limites propres : %1 3 cm/s ou 8 %, %2 6°")
                .arg(displayName(Cue::Velocity), displayName(Cue::Hand)));
}

TEST(ReportTexts, ReportsOfBatchesFollowTheProgram) {
  expectIn(batchPage(), {"<html lang=\"en\">", "<h2>Every clip</h2>", "const said = {};"});
  const Speaking french("fr");
  const std::string page = batchPage();
  keep(page, "batch-fr.html");
  expectIn(page, {"<html lang=\"fr\">", "<h2>Tous les clips</h2>", "rejeté par ana", "tremblement",
                  "image 7", "1.5°", "de sa dernière image", "data-sight=\"visible\"",
                  "data-verdict=\"rejected stale\"", "\"show all\":\"tout afficher\""});
}

TEST(ReportTexts, ReviewPagesFollowTheProgram) {
  const Speaking japanese("ja");
  const ReportLanguage say = reportLanguage();
  Distortion distortion;
  distortion.max.cm = 1.25;
  const std::string page = review_page(
      "walk", review_facts("closed-loop", 20, distortion, Weighting::BoneEnds, {}, say), "", say);
  keep(page, "review-ja.html");
  expectIn(page, {"<html lang=\"ja\">", "閉ループ", "最大誤差 1.25 cm", "\"Play\":\"再生\"",
                  "ビューアーには JavaScript が必要です。"});
}

TEST(ReportTexts, ReportsOfStudiesFollowTheProgram) {
  std::vector<StudyRow> rows;
  for (const double ratio : {10.0, 40.0}) {
    StudyRow row{.clip = "walk.bvh", .fingerprint = "a"};
    row.settings = {.method = "annealed", .target = {Target::Kind::Ratio, ratio}};
    row.measured = Measurement{.frames = 100, .sample_rate_hz = 30, .ratio = ratio};
    row.measured->eps_bone_ends_cm = row.measured->eps_joint_origins_cm = ratio / 50;
    rows.push_back(row);
  }
  const Speaking spanish("es");
  const std::string page = report_html(Results(rows), {}, reportLanguage(), {});
  keep(page, "study-es.html");
  expectIn(page, {"<html lang=\"es\">", "Estudio de compresión", "Ondículas recocidas",
                  "<h2>Todos los clips</h2>", "100 fotogramas", "ponderada por «superficie»",
                  "la ponderación «orígenes de articulaciones»"});
  EXPECT_EQ(page.find("joint-origins"), page.npos);
}

}  // namespace
}  // namespace mocapress::report_texts_test
