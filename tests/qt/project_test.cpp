// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/library/project.h"

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "tests/qt/elaborate_settings.h"

namespace mocapress {
namespace {

using test::elaborateByName;

TEST(ProjectFile, BringsClipsBackRelativeToItsFolder) {
  Project project;
  project.current = QStringLiteral("/motions/walk.bvh");
  project.clips = {{.path = QStringLiteral("/motions/walk.bvh"),
                    .settings = elaborateByName(),
                    .outcome = Outcome{25, 0.5, 2, 1000, false, Sight::Visible, 1.5},
                    .review = {Verdict::Rejected, "knee pops — frame 12", "ann",
                               "2026-11-27T01:39:46Z", "0123456789abcdef", "fedcba9876543210"},
                    .pins = {{QStringLiteral("hero"), QColor(1, 2, 3), elaborateByName()}}},
                   {.path = QStringLiteral("/motions/cmu/09_01.amc"),
                    .skeleton = QStringLiteral("/motions/cmu/09.asf")}};
  const QByteArray text = projectText(project, QDir(QStringLiteral("/motions")));
  EXPECT_FALSE(text.contains("/motions"));
  const Project moved = parseProject(text, QDir(QStringLiteral("/elsewhere")));
  ASSERT_EQ(moved.clips.size(), 2u);
  EXPECT_EQ(moved.current, QStringLiteral("/elsewhere/walk.bvh"));
  EXPECT_EQ(moved.clips[0].review.verdict, Verdict::Rejected);
  EXPECT_EQ(moved.clips[0].review, project.clips[0].review);
  EXPECT_EQ(moved.clips[0].outcome, project.clips[0].outcome);
  EXPECT_EQ(moved.clips[0].settings->preset, elaborateByName().preset);
  EXPECT_EQ(moved.clips[0].settings->contacts, elaborateByName().contacts);
  ASSERT_EQ(moved.clips[0].pins.size(), 1u);
  const Pin& pin = moved.clips[0].pins[0];
  EXPECT_EQ(pin.name, QStringLiteral("hero"));
  EXPECT_EQ(pin.colour, QColor(1, 2, 3));
  EXPECT_EQ(pin.settings.preset, elaborateByName().preset);
  EXPECT_TRUE(moved.clips[1].pins.empty());
  EXPECT_EQ(moved.clips[1].skeleton, QStringLiteral("/elsewhere/cmu/09.asf"));
  EXPECT_FALSE(moved.clips[1].settings);
}

TEST(ProjectFile, RemembersHowEachClipIsToBeRead) {
  const ReadOptions told{.sample_rate_hz = 59.94,
                         .cm_per_unit = 2.54,
                         .up = UpAxis::Z,
                         .bvh_root = TranslationConvention::Replaces};
  Project project;
  project.clips = {{.path = QStringLiteral("/motions/told.bvh"), .reading = told},
                   {.path = QStringLiteral("/motions/plain.bvh")}};
  const QDir folder(QStringLiteral("/motions"));
  const Project back = parseProject(projectText(project, folder), folder);
  ASSERT_EQ(back.clips.size(), 2u);
  EXPECT_EQ(back.clips[0].reading, told);
  EXPECT_EQ(back.clips[1].reading, ReadOptions());
}

TEST(ProjectFile, RemembersTheCharacterOfEachRigAndWhetherItIsShown) {
  const QDir folder(QStringLiteral("/motions"));
  Project project;
  EXPECT_TRUE(parseProject(projectText(project, folder), folder).shows_skin);
  project.characters = {{"aa", QStringLiteral("/motions/knight.fbx")}, {"bb", QString()}};
  project.clips = {{.path = QStringLiteral("/motions/walk.bvh"), .rig = "aa"}};
  project.shows_skin = false;
  const Project moved =
      parseProject(projectText(project, folder), QDir(QStringLiteral("/elsewhere")));
  const CharacterFiles characters{{"aa", QStringLiteral("/elsewhere/knight.fbx")},
                                  {"bb", QString()}};
  EXPECT_EQ(moved.characters, characters);
  EXPECT_EQ(moved.clips.at(0).rig, "aa");
  EXPECT_FALSE(moved.shows_skin);
}

TEST(ProjectFile, AProjectWithoutPinsStillOpens) {
  const Project project = parseProject(
      R"({"format": "mocapress-project", "version": 1, "clips": [{"path": "walk.bvh"}]})",
      QDir(QStringLiteral("/motions")));
  ASSERT_EQ(project.clips.size(), 1u);
  EXPECT_TRUE(project.clips[0].pins.empty());
}

TEST(ProjectFile, LeavesOutSettingsThatItWouldNotReadAgain) {
  NamedSettings impossible;
  impossible.preset.correction = CorrectionSettings{.ratio = 0};
  Project project;
  project.clips = {{.path = QStringLiteral("/motions/walk.bvh"),
                    .settings = impossible,
                    .review = {.note = "knee"},
                    .pins = {{QStringLiteral("hero"), QColor(1, 2, 3), impossible}}}};
  const QDir folder(QStringLiteral("/motions"));
  const Project back = parseProject(projectText(project, folder), folder);
  ASSERT_EQ(back.clips.size(), 1u);
  EXPECT_FALSE(back.clips[0].settings);
  EXPECT_EQ(back.clips[0].review.note, "knee");
  EXPECT_TRUE(back.clips[0].pins.empty());
}

TEST(ProjectFile, RefusesWhatIsNoneAndWhatIsNewer) {
  for (const char* text : {"", "{", "{}", "[1, 2]",
                           "{\"format\": \"mocapress-project\", "
                           "\"version\": 99}",
                           "{\"format\": \"mocapress-project\", \"clips\": [{}]}"})
    EXPECT_THROW(parseProject(text, {}), Error) << text;
}

}  // namespace
}  // namespace mocapress
