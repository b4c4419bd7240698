// SPDX-License-Identifier: GPL-3.0-or-later
// A character of one file on the clip of another.
#include <gtest/gtest.h>

#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <filesystem>

#include "app/studio/document/session.h"
#include "app/studio/library/library.h"
#include "core/formats/motion_file.h"
#include "tests/qt/patience.h"
#include "tests/support/test_motion.h"

namespace mocapress {
namespace {

class CharacterSession : public testing::Test {
 protected:
  void SetUp() override {
    if (!QFile::exists(sample("character.glb"))) GTEST_SKIP() << "no sample character";
  }

  static QString sample(const char* name) {
    return QStringLiteral(MOCAPRESS_SOURCE_DIR "/resources/samples/") + QString::fromLatin1(name);
  }

  void open(const QString& path) {
    QSignalSpy opened(&session_, &Session::opened);
    session_.open(path);
    ASSERT_TRUE(opened.wait(kPatience));
  }

  QTemporaryDir folder_;
  Session session_;
  Document& document_ = session_.document();
};

TEST_F(CharacterSession, ShowsTheSkinOfTheFileItself) {
  open(sample("character.glb"));
  ASSERT_TRUE(document_.skin());
  EXPECT_EQ(document_.skin(), document_.original()->skin);
}

TEST_F(CharacterSession, PutsACharacterOnAClipWithoutOne) {
  open(sample("human_walk.amc"));
  EXPECT_FALSE(document_.skin());
  QSignalSpy put(&session_, &Session::characterPut);
  session_.putCharacter(sample("character.glb"));
  ASSERT_TRUE(put.wait(kPatience));
  ASSERT_TRUE(document_.skin());
  // The bones are this clip's joints.
  const SkinBone& bone = document_.skin()->bones.front();
  EXPECT_LT(bone.joint, document_.skeleton()->joint_count());

  // It stays for the next clip with such joints, and not for others.
  open(sample("human_run.amc"));
  EXPECT_TRUE(document_.skin());
  const QString other = folder_.filePath(QStringLiteral("other.bvh"));
  write_motion(other.toStdU16String(), test::smooth_motion(40));
  open(other);
  EXPECT_FALSE(document_.skin());
}

TEST_F(CharacterSession, PuttingOneOnIsUndone) {
  open(sample("human_walk.amc"));
  QSignalSpy put(&session_, &Session::characterPut);
  session_.putCharacter(sample("character.glb"));
  ASSERT_TRUE(put.wait(kPatience));
  session_.history()->undo();
  EXPECT_FALSE(document_.skin());
  EXPECT_TRUE(document_.character().path.isEmpty());
  session_.history()->redo();
  EXPECT_TRUE(document_.skin());
}

TEST_F(CharacterSession, SaysWhereItsMeshReachesFarFromTheBones) {
  open(sample("human_walk.amc"));
  const PutCharacter human{read_character(sample("character.glb").toStdU16String()),
                           sample("character.glb")};
  Skin far = *human.character.skin;
  for (Skin::Vertex& vertex : far.vertices) vertex.in_bind *= 10;
  PutCharacter giant = human;
  giant.character.skin = std::make_shared<const Skin>(far);
  const OriginalPtr original = dressed(*document_.original(), giant);
  ASSERT_EQ(original->of_character.size(), 1u);
  EXPECT_NE(original->of_character[0].message.find("the mesh reaches much further"),
            std::string::npos);
  EXPECT_TRUE(dressed(*original, human)->of_character.empty());
}

TEST_F(CharacterSession, IsMeasuredOnWhereItWasPutOn) {
  const auto settle = [&](const auto& act) {
    QSignalSpy settled(&session_, &Session::settled);
    act();
    ASSERT_TRUE(settled.wait(kPatience));
  };
  settle([&] { session_.open(sample("human_walk.amc")); });
  EXPECT_FALSE(document_.decoded()->distortion->skin);
  const std::vector<std::byte> file = document_.decoded()->file;

  // The clip is not compressed again for it.
  settle([&] { session_.putCharacter(sample("character.glb")); });
  ASSERT_TRUE(document_.skeleton()->skin());
  EXPECT_TRUE(document_.decoded()->distortion->skin);
  EXPECT_EQ(document_.decoded()->file, file);

  // It can be: by the mesh.
  EncodeOptions by_skin = document_.options();
  by_skin.weighting = Weighting::Skin;
  by_skin.target = {Target::Kind::Error, 0.4};
  settle([&] { session_.setOptions(by_skin); });
  EXPECT_LE(document_.decoded()->distortion->eps(Weighting::Skin), 0.4);
  const QString saved = folder_.filePath(QStringLiteral("walk.mcpr"));
  QSignalSpy written(&session_, &Session::saved);
  session_.save(saved);
  ASSERT_TRUE(written.wait(kPatience));

  // The next clip has it from the beginning.
  settle([&] { session_.open(sample("human_run.amc")); });
  EXPECT_TRUE(document_.skeleton()->skin());
  settle([&] { session_.open(sample("human_walk.amc")); });
  EXPECT_EQ(document_.options().weighting, Weighting::Skin);

  // Without it there is nothing to measure on.
  settle([&] {
    session_.history()->undo();
    session_.history()->undo();
  });
  EXPECT_FALSE(document_.skeleton()->skin());
  EXPECT_EQ(document_.options().weighting, Weighting::Surface);
  EXPECT_FALSE(document_.decoded()->distortion->skin);
  settle([&] {
    session_.history()->redo();
    session_.history()->redo();
  });
  EXPECT_EQ(document_.options().weighting, Weighting::Skin);
  EXPECT_TRUE(document_.decoded()->distortion->skin);
}

TEST_F(CharacterSession, ComesBackWithItsProject) {
  const QString project = folder_.filePath(QStringLiteral("walkers.mocapress"));
  {
    Session session;
    LibraryModel model;
    Library library(&session, &model);
    QSignalSpy settled(&session, &Session::settled);
    session.open(sample("human_walk.amc"));
    ASSERT_TRUE(settled.wait(kPatience));
    session.putCharacter(sample("character.glb"));
    ASSERT_TRUE(settled.wait(kPatience));
    EncodeOptions by_skin = session.document().options();
    by_skin.weighting = Weighting::Skin;
    session.setOptions(by_skin);
    library.setShowsSkin(false);
    ASSERT_TRUE(library.saveAs(project));
  }
  Session session;
  LibraryModel model;
  Library library(&session, &model);
  ASSERT_TRUE(library.open(project));
  EXPECT_FALSE(library.showsSkin());
  ASSERT_TRUE(QTest::qWaitFor(
      [&] { return session.document().skin() && session.document().original(); }, kPatience));
  EXPECT_EQ(session.document().character().path,
            QFileInfo(sample("character.glb")).absoluteFilePath());

  EXPECT_EQ(session.document().options().weighting, Weighting::Skin);
  EXPECT_TRUE(session.document().skeleton()->skin());

  // Another project has none.
  ASSERT_TRUE(library.startNew());
  EXPECT_TRUE(session.document().character().path.isEmpty());
  EXPECT_TRUE(library.showsSkin());
}

TEST_F(CharacterSession, WhoseFileIsGoneIsSaidOnceAndStaysTheProjects) {
  const QString project = folder_.filePath(QStringLiteral("walkers.mocapress"));
  Project kept;
  kept.character = folder_.filePath(QStringLiteral("gone.glb"));
  kept.clips = {{.path = sample("human_walk.amc")}};
  kept.current = kept.clips[0].path;
  writeProject(project, kept);
  LibraryModel model;
  Library library(&session_, &model);
  QSignalSpy failed(&session_, &Session::characterFailed);
  QSignalSpy settled(&session_, &Session::settled);
  ASSERT_TRUE(library.open(project));
  ASSERT_TRUE(settled.wait(kPatience));
  ASSERT_EQ(failed.count(), 1);
  EXPECT_TRUE(failed.front().front().toString().contains(QStringLiteral("gone.glb")));
  EXPECT_FALSE(document_.skin());
  EXPECT_EQ(library.project().character, kept.character);
}

TEST_F(CharacterSession, SaysInOneSentenceWhichJointsAClipLacks) {
  const QString other = folder_.filePath(QStringLiteral("other.bvh"));
  write_motion(other.toStdU16String(), test::smooth_motion(40));
  open(other);
  QSignalSpy failed(&session_, &Session::characterFailed);
  session_.putCharacter(sample("character.glb"));
  ASSERT_TRUE(failed.wait(kPatience));
  const QString message = failed.front().front().toString();
  EXPECT_TRUE(message.contains(QStringLiteral("the clip has no joint"))) << message.toStdString();
  EXPECT_FALSE(document_.skin());
}

}  // namespace
}  // namespace mocapress
