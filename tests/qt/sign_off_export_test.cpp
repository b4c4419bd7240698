// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/library/sign_off_export.h"

#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QDir>
#include <QLocale>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTranslator>

#include "app/studio/document/session.h"
#include "app/studio/library/library.h"
#include "core/base/file.h"
#include "core/formats/motion_file.h"
#include "tests/qt/patience.h"
#include "tests/support/test_motion.h"
#include "widgets/models/library_model.h"
#include "widgets/models/report_texts.h"

namespace mocapress {
namespace {

TEST(SignOffExport, TellsClipsOfOneNameApartByTheirFolders) {
  Session session;
  LibraryModel model;
  Library library(&session, &model);
  library.add({QStringLiteral("/x/old/walk.bvh"), QStringLiteral("/x/new/walk.bvh"),
               QStringLiteral("/x/new/run.bvh")});
  const SignOff report = signOffOf(library, model);
  ASSERT_EQ(report.clips.size(), 3u);
  EXPECT_EQ(report.clips[0].name, "old/walk.bvh");
  EXPECT_EQ(report.clips[1].name, "new/walk.bvh");
  EXPECT_EQ(report.clips[2].name, "run.bvh");
}

TEST(SignOffExport, WritesTheLibraryInEachFormat) {
  const QTemporaryDir directory;
  const auto path = [&](const char* name) {
    return QDir(directory.path()).filePath(QLatin1String(name));
  };
  Session session;
  LibraryModel model;
  Library library(&session, &model);
  for (const char* name : {"a.bvh", "b.bvh"})
    write_motion(path(name).toStdU16String(), test::smooth_motion(60, 1));
  library.add({path("a.bvh"), path("b.bvh")});
  QSignalSpy settled(&session, &Session::settled);
  library.openClip(0);
  ASSERT_TRUE(settled.count() > 0 || settled.wait(kPatience));
  library.setFrameNote(0, -1, {.frame = 7, .joint = "lhand", .text = "slides"});
  library.setVerdict({0}, Verdict::Approved);

  const SignOff report = signOffOf(library, model);
  ASSERT_EQ(report.clips.size(), 2u);
  EXPECT_EQ(count(report), (SignOffCounts{.approved = 1, .waiting = 1}));
  ASSERT_TRUE(report.clips[0].figures);
  const WorstPoint worst =
      session.document().decoded()->distortion->worst(session.document().options().weighting);
  EXPECT_EQ(report.clips[0].figures->worst_frame, worst.frame);
  EXPECT_EQ(report.clips[0].figures->max_cm, worst.cm);
  EXPECT_FALSE(report.clips[0].figures->stale);
  EXPECT_FALSE(report.clips[1].figures);

  writeSignOff(path("s.html"), report);
  writeSignOff(path("s.csv"), report);
  writeSignOff(path("s.pdf"), report);
  const auto written = [&](const char* name) { return read_text(path(name).toStdU16String()); };
  EXPECT_EQ(written("s.html"), sign_off_html(report));
  EXPECT_EQ(written("s.csv"), sign_off_csv(report));
  const std::string pdf = written("s.pdf");
  EXPECT_EQ(pdf.rfind("%PDF-", 0), 0u);
  EXPECT_NE(pdf.find("%%EOF"), pdf.npos);
  EXPECT_GT(pdf.size(), 5000u) << "its text is drawn";
}

TEST(SignOffExport, FollowsTheProgramsLanguage) {
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
}  // namespace mocapress
