// SPDX-License-Identifier: GPL-3.0-or-later
// Puts the character of one file on the clip of another.
#include <gtest/gtest.h>

#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <filesystem>

#include "app/studio/document/session.h"
#include "app/studio/library/library.h"
#include "core/formats/motion_file.h"
#include "core/motion/rig.h"
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

  void put(const char* name) {
    QSignalSpy put(&session_, &Session::characterPut);
    session_.putCharacter(sample(name));
    ASSERT_TRUE(put.wait(kPatience));
  }

  /// A clip of another rig with all joints that the sample character uses, and a tail.
  QString clipOfAnotherRig() const {
    MotionFile walk = read_motion(sample("human_walk.amc").toStdU16String());
    Joint tail;
    tail.name = "tail";
    tail.parent = 0;
    tail.offset = {0, 0, -20};
    walk.motion.skeleton.add(tail);
    const QString path = folder_.filePath(QStringLiteral("tail.amc"));
    write_motion(path.toStdU16String(), walk.motion);
    return path;
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
  // The bones refer to this clip's joints.
  const SkinBone& bone = document_.skin()->bones.front();
  EXPECT_LT(bone.joint, document_.skeleton()->joint_count());

  // The character stays for the next clip of the rig, and not for others.
  open(sample("human_run.amc"));
  EXPECT_TRUE(document_.skin());
  const QString other = folder_.filePath(QStringLiteral("other.bvh"));
  write_motion(other.toStdU16String(), test::smooth_motion(40));
  open(other);
  EXPECT_FALSE(document_.skin());
}

TEST_F(CharacterSession, FiguresOfTheOtherSettingsStayWhenOneIsPutOn) {
  open(sample("human_walk.amc"));
  QSignalSpy settled(&session_, &Session::settled);
  ASSERT_TRUE(document_.final() || settled.wait(kPatience));
  session_.switchSlot();
  ASSERT_TRUE(session_.slotFigures(0));
  const double ratio = session_.slotFigures(0)->ratio;
  put("character.glb");
  ASSERT_TRUE(session_.slotFigures(0));
  EXPECT_EQ(session_.slotFigures(0)->ratio, ratio);
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

TEST_F(CharacterSession, BelongsToTheClipsOfARig) {
  open(clipOfAnotherRig());
  ASSERT_FALSE(document_.skin());
  open(sample("human_walk.amc"));
  put("character.glb");
  // The character would fit, but was not put on this clip.
  open(clipOfAnotherRig());
  EXPECT_FALSE(document_.skin());
  EXPECT_TRUE(document_.character().path.isEmpty());
  put("character.fbx");
  ASSERT_TRUE(document_.skin());
  // The other rig keeps its own character.
  open(sample("human_run.amc"));
  EXPECT_EQ(QFileInfo(document_.character().path).fileName(), QStringLiteral("character.glb"));
  open(clipOfAnotherRig());
  EXPECT_EQ(QFileInfo(document_.character().path).fileName(), QStringLiteral("character.fbx"));
}

TEST_F(CharacterSession, PuttingOneOnIsUndoneAfterAnotherClipWasOpen) {
  open(sample("human_walk.amc"));
  put("character.glb");
  open(sample("human_run.amc"));
  EXPECT_TRUE(document_.skin());
  open(sample("human_walk.amc"));
  ASSERT_TRUE(session_.history()->canUndo());
  session_.history()->undo();
  EXPECT_FALSE(document_.skin());
  session_.history()->redo();
  EXPECT_TRUE(document_.skin());
}

TEST_F(CharacterSession, IsTakenOffAndThatIsUndone) {
  open(sample("human_walk.amc"));
  put("character.glb");
  session_.takeCharacterOff();
  EXPECT_FALSE(document_.skin());
  open(sample("human_run.amc"));
  EXPECT_FALSE(document_.skin());
  open(sample("human_walk.amc"));
  session_.history()->undo();
  EXPECT_TRUE(document_.skin());
}

TEST_F(CharacterSession, UndoKeepsWhatAnotherClipOfTheRigPutOnSince) {
  const auto worn = [&] { return QFileInfo(document_.character().path).fileName(); };
  open(sample("human_walk.amc"));
  put("character.glb");
  open(sample("human_run.amc"));
  put("character.fbx");
  open(sample("human_walk.amc"));
  session_.history()->undo();
  EXPECT_EQ(worn(), QStringLiteral("character.fbx"));
  session_.history()->redo();
  EXPECT_EQ(worn(), QStringLiteral("character.fbx"));
  open(sample("human_run.amc"));
  session_.history()->undo();
  EXPECT_EQ(worn(), QStringLiteral("character.glb"));
}

TEST(OriginalClip, WearsACharacterThatWasReadAndPutOnIt) {
  const auto skin = std::make_shared<const Skin>();
  OriginalClip clip;
  EXPECT_TRUE(clip.wears({}));
  clip.character = QStringLiteral("a.glb");
  EXPECT_TRUE(clip.wears({{}, QStringLiteral("a.glb")})) << "nobody could read it yet";
  EXPECT_FALSE(clip.wears({{{}, skin}, QStringLiteral("a.glb")}));
  EXPECT_FALSE(clip.wears({}));
  clip.has_character = true;
  EXPECT_TRUE(clip.wears({{{}, skin}, QStringLiteral("a.glb")}));
  EXPECT_FALSE(clip.wears({{{}, skin}, QStringLiteral("b.glb")}));
}

TEST_F(CharacterSession, SaysWhatTheClipLacksAndKeepsItsOwnBones) {
  MotionFile walk = read_motion(sample("human_walk.amc").toStdU16String());
  Skeleton shorter;
  for (Joint joint : walk.motion.skeleton.joints()) {
    joint.offset *= 0.8;
    if (joint.name == "lhand") joint.name = "mitten";
    shorter.add(joint);
  }
  walk.motion.skeleton = shorter;
  const QString path = folder_.filePath(QStringLiteral("shorter.amc"));
  write_motion(path.toStdU16String(), walk.motion);
  open(path);
  put("character.glb");
  ASSERT_TRUE(document_.skin());
  EXPECT_NEAR(document_.skin()->lengths.scale, 1.25, 0.01);
  // The character starts where the clip starts.
  Pose pose;
  document_.original()->poses()(0, pose);
  EXPECT_NEAR(document_.skin()->lengths.centre.x(), pose.origin[0].x(), 1e-6);
  ASSERT_TRUE(
      QTest::qWaitFor([&] { return document_.original()->of_character.size() >= 2; }, kPatience));
  EXPECT_NE(document_.original()->of_character[0].message.find("no joint lhand"),
            std::string::npos);
  EXPECT_NE(document_.original()->of_character[1].message.find("other proportions"),
            std::string::npos);
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

  // Putting it on does not compress the clip again.
  settle([&] { session_.putCharacter(sample("character.glb")); });
  ASSERT_TRUE(document_.skeleton()->skin());
  EXPECT_TRUE(document_.decoded()->distortion->skin);
  EXPECT_EQ(document_.decoded()->file, file);

  // The clip can be compressed by the mesh.
  EncodeSettings by_skin = document_.options();
  by_skin.weighting = Weighting::Skin;
  by_skin.target = {Target::Kind::Error, 0.4};
  settle([&] { session_.setOptions(by_skin); });
  EXPECT_LE(document_.decoded()->distortion->eps(Weighting::Skin), 0.4);
  const QString saved = folder_.filePath(QStringLiteral("walk.mcpr"));
  QSignalSpy written(&session_, &Session::saved);
  session_.save(saved);
  ASSERT_TRUE(written.wait(kPatience));

  // The next clip has it from the start.
  settle([&] { session_.open(sample("human_run.amc")); });
  EXPECT_TRUE(document_.skeleton()->skin());
  settle([&] { session_.open(sample("human_walk.amc")); });
  EXPECT_EQ(document_.options().weighting, Weighting::Skin);

  // Without it there is no mesh to measure on.
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

TEST_F(CharacterSession, TakingOneOffIsUndoneWithTheWeightingByItsMesh) {
  const auto settle = [&](const auto& act) {
    QSignalSpy settled(&session_, &Session::settled);
    act();
    ASSERT_TRUE(settled.wait(kPatience));
  };
  settle([&] { session_.open(sample("human_walk.amc")); });
  settle([&] { session_.putCharacter(sample("character.glb")); });
  EncodeSettings by_skin = document_.options();
  by_skin.weighting = Weighting::Skin;
  settle([&] { session_.setOptions(by_skin); });
  settle([&] { session_.takeCharacterOff(); });
  EXPECT_EQ(document_.options().weighting, Weighting::Surface);
  settle([&] { session_.history()->undo(); });
  EXPECT_EQ(document_.options().weighting, Weighting::Skin);
  ASSERT_TRUE(document_.decoded()->distortion->skin);
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
    EncodeSettings by_skin = session.document().options();
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

  // The batch's clips have the character.
  const std::vector<TunedClip> tuned = library.tuned({});
  ASSERT_EQ(tuned.size(), 1u);
  EXPECT_EQ(tuned[0].reading.character,
            QFileInfo(sample("character.glb")).absoluteFilePath().toStdString());

  // Another project has none.
  ASSERT_TRUE(library.startNew());
  EXPECT_TRUE(session.document().character().path.isEmpty());
  EXPECT_TRUE(library.showsSkin());
}

TEST_F(CharacterSession, IsPutOnTheRigsOfSelectedClipsInOneStepOfTheLibrary) {
  LibraryModel model;
  Library library(&session_, &model);
  open(sample("human_walk.amc"));
  const QString other = folder_.filePath(QStringLiteral("other.bvh"));
  write_motion(other.toStdU16String(), test::smooth_motion(40));
  open(other);
  open(sample("human_walk.amc"));
  QSignalSpy settled(&session_, &Session::settled);
  library.putCharacter({0, 1}, sample("character.glb"));
  ASSERT_TRUE(settled.wait(kPatience));
  EXPECT_TRUE(document_.skin());
  EXPECT_EQ(document_.characters().size(), 2u);
  EXPECT_EQ(library.history()->undoText(), QStringLiteral("Character"));
  library.history()->undo();
  ASSERT_TRUE(settled.wait(kPatience));
  EXPECT_FALSE(document_.skin());
  EXPECT_TRUE(document_.characters().empty());
}

/// As of a project that was saved when all its clips had one character.
TEST_F(CharacterSession, AMissingFileIsReportedOnceAndStaysInTheProject) {
  const QString project = folder_.filePath(QStringLiteral("walkers.mocapress"));
  Project kept;
  kept.clips = {{.path = sample("human_walk.amc")}};
  kept.current = kept.clips[0].path;
  const MotionFile walk = read_motion(kept.current.toStdU16String());
  kept.characters = {{rig_of(walk.motion.skeleton), folder_.filePath(QStringLiteral("gone.glb"))}};
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
  EXPECT_EQ(library.project().characters, kept.characters);
  open(sample("human_run.amc"));
  EXPECT_EQ(failed.count(), 1);
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
