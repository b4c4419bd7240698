// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/library/sign_off_export.h"

#include <gtest/gtest.h>

#include <QDir>
#include <QSignalSpy>
#include <QTemporaryDir>

#include "app/studio/document/session.h"
#include "app/studio/library/library.h"
#include "core/base/file.h"
#include "core/formats/motion_file.h"
#include "tests/qt/patience.h"
#include "tests/support/test_motion.h"
#include "widgets/models/library_model.h"

namespace mocapress {
namespace {

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
  const int worst = session.document().decoded()->distortion->max.frame;
  EXPECT_EQ(report.clips[0].figures->worst_frame, worst);
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

}  // namespace
}  // namespace mocapress
