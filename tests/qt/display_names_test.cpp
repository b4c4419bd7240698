// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/models/display_names.h"

#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QTranslator>

#include "core/codec/methods/compression_method.h"
#include "tests/qt/untranslated.h"
#include "widgets/panels/study_panel.h"

#include <QListWidget>

namespace mocapress {
namespace {

TEST(MethodNames, AreTheOnesOfTheOneTable) {
  for (const CompressionMethod& compression_method : compression_methods())
    EXPECT_EQ(methodTitle(compression_method.name).toStdString(), compression_method.title);
  for (const Method method :
       {Method::ClosedLoop, Method::Annealed, Method::Standard, Method::PerChannel})
    EXPECT_EQ(displayName(method).toStdString(), find_compression_method(name(method))->title);
  EXPECT_EQ(seriesTitle("annealed", 16), QStringLiteral("Annealed wavelets + IK 16:1"));
  EXPECT_EQ(methodTitle("unheard-of"), QStringLiteral("unheard-of"));
}

TEST(MethodNames, AreTranslated) {
  QStringList untranslated;
  for (const char* language : {"es", "fr", "ja"}) {
    QTranslator texts;
    ASSERT_TRUE(texts.load(QStringLiteral(":/i18n/mocapress_%1.qm").arg(QLatin1String(language))));
    for (const CompressionMethod& compression_method : compression_methods())
      if (const std::string title(compression_method.title);
          texts.translate("mocapress::Methods", title.c_str()).isEmpty())
        untranslated << QString::fromStdString(language + (": " + title));
  }
  endWithUntranslated(untranslated);
}

TEST(MethodNames, TheClosedLoopIsTickedInAStudy) {
  StudyPanel panel;
  panel.setSettings(usualStudySettings());
  const auto items = panel.methods()->findItems(methodTitle("closed-loop"), Qt::MatchExactly);
  ASSERT_EQ(items.size(), 1);
  EXPECT_EQ(items.front()->checkState(), Qt::Checked);
}

}  // namespace
}  // namespace mocapress
