// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/document/session.h"

#include <gtest/gtest.h>

#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <cmath>
#include <memory>
#include <vector>

#include "app/studio/compare/figures.h"
#include "core/base/file.h"
#include "core/codec/decode/track_decoding.h"
#include "core/codec/format/source_section.h"
#include "core/codec/format/tracks_section.h"
#include "core/codec/methods/compression_method.h"
#include "core/formats/motion_file.h"
#include "tests/qt/patience.h"
#include "tests/support/small_gltf.h"
#include "tests/support/test_motion.h"

namespace mocapress {
namespace {

class SessionTest : public testing::Test {
 protected:
  SessionTest() { session_.setOptions(ratio(10)); }

  static EncodeSettings ratio(double value) {
    return {.method = Method::Annealed,
            .weighting = Weighting::BoneEnds,
            .target = {Target::Kind::Ratio, value}};
  }

  QString path(const char* name) const { return directory_.filePath(QString::fromLatin1(name)); }

  QString writeClip(const char* name, int frames) const {
    write_motion(path(name).toStdU16String(), test::smooth_motion(frames));
    return path(name);
  }

  bool waitFor(QSignalSpy& spy) { return spy.count() > 0 || spy.wait(kPatience); }

  void openAndSettle(const QString& file) {
    QSignalSpy settled(&session_, &Session::settled);
    session_.open(file);
    ASSERT_TRUE(waitFor(settled));
  }

  void saveAndWait(const QString& file) {
    QSignalSpy saved(&session_, &Session::saved);
    session_.save(file);
    ASSERT_TRUE(waitFor(saved));
  }

  QTemporaryDir directory_;
  Session session_;
  Document& document_ = session_.document();
};

using Studio = SessionTest;

TEST_F(Studio, OpensAMotionAndCompressesItAtOnce) {
  openAndSettle(writeClip("motion.bvh", 300));
  ASSERT_TRUE(document_.original());
  ASSERT_TRUE(document_.decoded());
  EXPECT_TRUE(document_.final());
  EXPECT_EQ(document_.frames(), 300);
  EXPECT_EQ(document_.title(), QStringLiteral("motion.bvh"));
  EXPECT_FALSE(document_.modified());
  const ResultFigures figures = *figuresOf(document_);
  EXPECT_NEAR(figures.ratio, 10, 0.2);
  EXPECT_GT(*figures.p99_cm, 0);
  EXPECT_GE(figures.max_cm, *figures.p99_cm);
  EXPECT_FALSE(document_.curves().names().isEmpty());
}

TEST_F(Studio, MentionsACancelOnlyIfTheUserCancelled) {
  openAndSettle(writeClip("motion.bvh", 800));
  const auto says_cancelled = [&] {
    return stateOf(document_).contains(QStringLiteral("cancel"), Qt::CaseInsensitive);
  };
  EXPECT_FALSE(says_cancelled());

  QSignalSpy failed(&session_, &Session::compressFailed);
  session_.setOptions(ratio(1e7));
  ASSERT_TRUE(waitFor(failed));
  EXPECT_TRUE(failed[0][1].toBool());
  EXPECT_FALSE(says_cancelled()) << stateOf(document_).toStdString();
  EXPECT_TRUE(document_.unanswered());

  // Each request replaces the one before it.
  QSignalSpy settled(&session_, &Session::settled);
  for (int i = 0; i < 5; ++i) {
    session_.setOptions(ratio(12 + i));
    runDueEvents();
    EXPECT_FALSE(says_cancelled()) << stateOf(document_).toStdString();
  }
  ASSERT_TRUE(QTest::qWaitFor([&] { return !session_.busy(); }, kPatience));
  EXPECT_FALSE(says_cancelled());
  EXPECT_FALSE(document_.unanswered());

  settled.clear();
  session_.setOptions(ratio(30));
  ASSERT_TRUE(QTest::qWaitFor([&] { return session_.refining() || settled.count(); }, kPatience));
  session_.cancelAnnealing();
  ASSERT_TRUE(waitFor(settled));
  const bool ended_early = document_.decoded()->compressed.provenance.method != Method::Annealed ||
                           !document_.decoded()->complete;
  EXPECT_EQ(says_cancelled(), ended_early) << stateOf(document_).toStdString();
}

TEST_F(Studio, ReportsAFileThatCannotBeReadAndKeepsWhatIsOpen) {
  openAndSettle(writeClip("motion.bvh", 100));
  QFile broken(path("broken.bvh"));
  ASSERT_TRUE(broken.open(QIODevice::WriteOnly));
  broken.write("HIERARCHY\nROOT hip\n{\n  OFFSET 0 0\n");
  broken.close();
  for (const char* name : {"broken.bvh", "missing.bvh", "broken.mcpr", "walk.amc", "odd.txt"}) {
    QSignalSpy failed(&session_, &Session::openFailed);
    session_.open(path(name));
    ASSERT_TRUE(waitFor(failed)) << name;
    EXPECT_FALSE(failed[0][1].toString().isEmpty()) << name;
  }
  EXPECT_EQ(document_.title(), QStringLiteral("motion.bvh"));
  EXPECT_EQ(document_.frames(), 100);
}

TEST_F(Studio, SavesWhatItShowsAndOpensItAgain) {
  openAndSettle(writeClip("motion.bvh", 300));
  const DecodedPtr saved = document_.decoded();
  saveAndWait(path("motion.mcpr"));
  EXPECT_FALSE(document_.modified());
  EXPECT_EQ(document_.title(), QStringLiteral("motion.mcpr"));

  Session other;
  QSignalSpy settled(&other, &Session::settled);
  other.open(path("motion.mcpr"));
  ASSERT_TRUE(waitFor(settled));
  EXPECT_FALSE(other.document().original());
  EXPECT_LT((*other.document().decoded()->tracks - *saved->tracks).cwiseAbs().maxCoeff(), 1e-3);
  const ResultFigures recorded = *figuresOf(other.document());
  EXPECT_NEAR(recorded.eps_cm, saved->distortion->eps_bone_ends, 1e-4);
  EXPECT_FALSE(recorded.p99_cm);

  QSignalSpy together(&other, &Session::settled);
  other.open(path("motion.bvh"));
  ASSERT_TRUE(waitFor(together));
  EXPECT_TRUE(other.document().original());
  EXPECT_TRUE(figuresOf(other.document())->p99_cm);
  EXPECT_EQ(other.document().title(), QStringLiteral("motion.mcpr"));
}

TEST_F(Studio, ReadsAClipAgainByOtherOptionsAndExportsItAsItsSourceWas) {
  openAndSettle(writeClip("motion.bvh", 100));
  const Eigen::MatrixXd before = *document_.original()->tracks();
  QSignalSpy settled(&session_, &Session::settled);
  session_.readAgain({.cm_per_unit = 2.54, .up = UpAxis::Z});
  ASSERT_TRUE(waitFor(settled));
  EXPECT_EQ(document_.frames(), 100);
  EXPECT_NEAR(document_.options().target.value, 10, 1e-12);
  const Eigen::MatrixXd after = *document_.original()->tracks();
  EXPECT_LT((after.col(0) - 2.54 * before.col(0)).cwiseAbs().maxCoeff(), 1e-6);
  EXPECT_LT((after.col(1) - 2.54 * before.col(2)).cwiseAbs().maxCoeff(), 1e-6);

  saveAndWait(path("motion.mcpr"));
  EXPECT_EQ(load_source(path("motion.mcpr").toStdU16String()), document_.source());
  QSignalSpy exported(&session_, &Session::exported);
  session_.exportMotion(path("back.bvh"));
  ASSERT_TRUE(waitFor(exported));
  const MotionFile back = read_motion(path("back.bvh").toStdU16String(), {}, {.cm_per_unit = 1.0});
  EXPECT_LT(
      (landmark_tracks(back.motion.skeleton, back.motion.clip).leftCols(3) - before.leftCols(3))
          .cwiseAbs()
          .maxCoeff(),
      20);
}

TEST_F(Studio, ExportsAPageOfTheClipWithWhatWasSaidAboutIt) {
  openAndSettle(writeClip("motion.bvh", 60));
  QSignalSpy exported(&session_, &Session::exported);
  session_.exportReview(path("page.html"), {{"rejected by ana"}, {{30, "slides"}}});
  ASSERT_TRUE(waitFor(exported));
  const std::string page = read_text(path("page.html").toStdU16String());
  EXPECT_NE(page.find("mocapressReview(\"motion.bvh\", \""), page.npos);
  EXPECT_NE(page.find("<li>rejected by ana</li><li>slides</li>"), page.npos);
  EXPECT_NE(page.find("[{\"frame\":30,\"text\":\"slides\"}]);"), page.npos);
}

TEST_F(Studio, ReadingAClipByOtherOptionsIsUndoneAmongItsOtherSteps) {
  openAndSettle(writeClip("motion.bvh", 60));
  const auto settleAfter = [this](auto act) {
    QSignalSpy settled(&session_, &Session::settled);
    act();
    ASSERT_TRUE(waitFor(settled));
  };
  settleAfter([&] { session_.setOptions(ratio(12)); });
  settleAfter([&] { session_.readAgain({.sample_rate_hz = 48.0}); });
  EXPECT_EQ(document_.sampleRate(), 48);
  settleAfter([&] { session_.setOptions(ratio(14)); });

  settleAfter([&] { session_.history()->undo(); });
  EXPECT_EQ(document_.options().target.value, 12);
  EXPECT_EQ(session_.history()->undoText(), QStringLiteral("Import Options"));
  settleAfter([&] { session_.history()->undo(); });
  EXPECT_EQ(document_.sampleRate(), 120);
  EXPECT_EQ(document_.options().target.value, 12);
  settleAfter([&] { session_.history()->redo(); });
  EXPECT_EQ(document_.sampleRate(), 48);
  settleAfter([&] {
    session_.history()->undo();
    session_.history()->redo();  // before the file is read
  });
  EXPECT_EQ(document_.sampleRate(), 48);
  settleAfter([&] { session_.history()->redo(); });
  EXPECT_EQ(document_.options().target.value, 14);
}

/// Writes a knee that turns for the given seconds in each animation.
QString writeTakes(const QString& path, const std::vector<int>& seconds) {
  test::SmallGltf gltf;
  for (const int length : seconds) {
    gltf.begin_animation("take " + std::to_string(length));
    std::vector<float> times;
    std::vector<float> turns;
    for (int key = 0; key <= 30 * length; ++key) {
      const double half = 0.3 * std::sin(0.2 * key);
      times.push_back(static_cast<float>(key) / 30);
      turns.insert(turns.end(),
                   {static_cast<float>(std::sin(half)), 0, 0, static_cast<float>(std::cos(half))});
    }
    const std::size_t input = gltf.add("SCALAR", times);
    gltf.move(1, "rotation", input, gltf.add("VEC4", turns));
  }
  write_text(path.toStdU16String(), gltf.glb());
  return path;
}

TEST_F(Studio, OpensAnotherTakeOfTheFileAsAClipOfItsOwn) {
  openAndSettle(writeTakes(path("takes.glb"), {3, 5}));
  const Takes takes = document_.original()->takes;
  EXPECT_EQ(takes.keys, (std::vector<std::string>{"take 3", "take 5"}));
  EXPECT_EQ(takes.read, 0u);
  EXPECT_EQ(document_.original()->reading.take, "take 3");
  EXPECT_EQ(document_.frames(), 91);
  const auto settleAfter = [this](auto act) {
    QSignalSpy settled(&session_, &Session::settled);
    act();
    ASSERT_TRUE(waitFor(settled));
  };
  settleAfter([&] { session_.setOptions(ratio(5)); });
  settleAfter([&] { session_.setRanges({{.first_frame = 80, .last_frame = 90, .factor = 2}}); });
  settleAfter([&] { session_.chooseTake(1); });
  EXPECT_EQ(document_.frames(), 151);
  EXPECT_EQ(document_.original()->takes.read, 1u);
  EXPECT_EQ(document_.original()->reading.take, "take 5");
  EXPECT_EQ(document_.decoded()->compressed.frames, 151);
  EXPECT_TRUE(document_.options().ranges.empty());
  EXPECT_FALSE(session_.history()->canUndo());
  settleAfter([&] { session_.setOptions(ratio(4)); });

  settleAfter([&] { session_.chooseTake(0); });
  EXPECT_EQ(document_.frames(), 91);
  EXPECT_EQ(document_.options().target.value, 5);
  EXPECT_EQ(document_.options().ranges.size(), 1u);
  settleAfter([&] { session_.history()->undo(); });
  EXPECT_TRUE(document_.options().ranges.empty());
}

TEST_F(Studio, AFailedReadIsNoUndoStep) {
  const QString clip = writeClip("motion.bvh", 60);
  openAndSettle(clip);
  const int steps = session_.history()->count();
  ASSERT_TRUE(QFile::remove(clip));
  QSignalSpy failed(&session_, &Session::openFailed);
  session_.readAgain({.sample_rate_hz = 48.0});
  ASSERT_TRUE(waitFor(failed));
  EXPECT_EQ(session_.history()->count(), steps);
}

TEST_F(Studio, OpensEachClipAsItWasReadBefore) {
  const QString told = writeClip("told.bvh", 60);
  session_.setReadingMemory([&](const QString& path) {
    return path == told ? ReadOptions{.sample_rate_hz = 48.0} : ReadOptions();
  });
  openAndSettle(told);
  EXPECT_EQ(document_.sampleRate(), 48);
  openAndSettle(writeClip("other.bvh", 60));
  EXPECT_EQ(document_.sampleRate(), 120);
}

TEST_F(Studio, ShowsACompressedClipWithItsOriginalAlreadyOpen) {
  openAndSettle(writeClip("motion.bvh", 200));
  saveAndWait(path("motion.mcpr"));
  openAndSettle(path("motion.mcpr"));
  EXPECT_TRUE(document_.original());
  EXPECT_TRUE(document_.decoded()->distortion);
}

TEST_F(Studio, ShowsAndSavesAClipOfAComparisonMethod) {
  const QString original = writeClip("motion.bvh", 300);
  const Motion motion = read_motion(original.toStdU16String(), {}).motion;
  const Encoding made = MethodEncoder(motion).compress(*find_compression_method("pca"),
                                                       {.target = {Target::Kind::Ratio, 5}});
  write_bytes(path("pca.mcpr").toStdU16String(), made.file);
  openAndSettle(path("pca.mcpr"));
  ASSERT_TRUE(document_.decoded());
  EXPECT_EQ(document_.decoded()->method, "pca");
  EXPECT_EQ(document_.decoded()->clip.frames(), 300);
  QSignalSpy settled(&session_, &Session::settled);
  session_.compareWith(original);
  ASSERT_TRUE(waitFor(settled));
  ASSERT_TRUE(document_.decoded()->distortion);
  EXPECT_TRUE(stateOf(document_).startsWith(QStringLiteral("PCA")));
  saveAndWait(path("again.mcpr"));
  EXPECT_EQ(read_bytes(path("again.mcpr").toStdU16String()), made.file);
}

TEST_F(Studio, DoesNotMixClipsThatDoNotBelongTogether) {
  openAndSettle(writeClip("motion.bvh", 200));
  saveAndWait(path("motion.mcpr"));
  Session other;
  QSignalSpy settled(&other, &Session::settled);
  other.open(path("motion.mcpr"));
  ASSERT_TRUE(waitFor(settled));

  QSignalSpy failed(&other, &Session::openFailed);
  other.compareWith(writeClip("longer.bvh", 201));
  ASSERT_TRUE(waitFor(failed));
  EXPECT_FALSE(other.document().original());

  QSignalSpy opened(&other, &Session::settled);
  other.open(path("longer.bvh"));
  ASSERT_TRUE(waitFor(opened));
  EXPECT_EQ(other.document().frames(), 201);
  EXPECT_EQ(other.document().title(), QStringLiteral("longer.bvh"));
}

TEST_F(Studio, IsModifiedOnceTheUserChangesSomethingAndUntilItIsSaved) {
  openAndSettle(writeClip("motion.bvh", 200));
  QSignalSpy settled(&session_, &Session::settled);
  session_.setOptions(ratio(20));
  EXPECT_TRUE(document_.modified());
  ASSERT_TRUE(waitFor(settled));
  EXPECT_NEAR(document_.decoded()->ratio, 20, 0.4);
  saveAndWait(path("motion.mcpr"));
  EXPECT_FALSE(document_.modified());
}

TEST_F(Studio, IsNotModifiedByADistanceWhichJudgesTheSameFile) {
  openAndSettle(writeClip("motion.bvh", 200));
  const auto look_from = [&](double metres) {
    EncodeSettings options = document_.options();
    options.limits.distance_m = metres;
    QSignalSpy judged(&document_, &Document::decodedChanged);
    session_.setOptions(options);
    ASSERT_TRUE(waitFor(judged));
    ASSERT_EQ(document_.decoded()->visibility->limits.distance_m, metres);
  };
  look_from(2);
  EXPECT_FALSE(document_.modified());
  QSignalSpy settled(&session_, &Session::settled);
  session_.setOptions(ratio(20));
  ASSERT_TRUE(waitFor(settled));
  EXPECT_TRUE(document_.modified());
  saveAndWait(path("motion.mcpr"));
  look_from(3);
  EXPECT_FALSE(document_.modified());
}

TEST_F(Studio, ASaveThatFailsIsAMessage) {
  openAndSettle(writeClip("motion.bvh", 100));
  QSignalSpy failed(&session_, &Session::saveFailed);
  session_.save(path("no/such/directory/motion.mcpr"));
  ASSERT_TRUE(waitFor(failed));
  EXPECT_TRUE(document_.savedPath().isEmpty());
}

TEST_F(Studio, CurvesAndCurrentJointOutliveTheClip) {
  openAndSettle(writeClip("motion.bvh", 100));
  CurveSelection curves;
  curves.add(QStringLiteral("lhand end"));
  document_.setCurves(curves);
  document_.setCurrentJoint(document_.skeleton()->find("rlower"));
  openAndSettle(writeClip("other.bvh", 150));
  EXPECT_EQ(document_.curves(), curves);
  EXPECT_EQ(document_.currentJoint(), document_.skeleton()->find("rlower"));
}

class StudioFeet : public SessionTest {
 protected:
  static EncodeSettings heldFeet() {
    EncodeSettings options = ratio(40);
    options.method = Method::Standard;
    options.correction = EncodeCorrection{.ratio = 16.0};
    return options;
  }

  const QString walk_ = QStringLiteral(MOCAPRESS_SOURCE_DIR "/resources/samples/human_walk.amc");
};

TEST_F(StudioFeet, AreHeldAndTheMotionWithoutIkIsAKeyAway) {
  session_.setOptions(heldFeet());
  openAndSettle(walk_);
  const double held = document_.shownFootskate()->total_cm;
  EXPECT_EQ(document_.shownTracks(), document_.decoded()->tracks);
  document_.setUncorrected(true);
  EXPECT_EQ(document_.shownTracks(), document_.decoded()->uncorrected_tracks);
  EXPECT_LT(held, 0.3 * document_.shownFootskate()->total_cm);
  const ResultFigures figures = *figuresOf(document_);
  EXPECT_EQ(figures.correction_ratio, 16.0);
  EXPECT_GT(*figures.correction_bytes, 50u);
  EXPECT_DOUBLE_EQ(*figures.footskate_cm, held);
}

TEST_F(StudioFeet, StayHeldInAFileThatIsOpenedAgain) {
  session_.setOptions(heldFeet());
  openAndSettle(walk_);
  const double held = document_.decoded()->footskate->total_cm;
  saveAndWait(path("held.mcpr"));
  openAndSettle(path("held.mcpr"));
  ASSERT_TRUE(document_.decoded()->compressed.correction);
  EXPECT_NEAR(document_.decoded()->footskate->total_cm, held, 0.05);
  EXPECT_TRUE(document_.decoded()->uncorrected_tracks);
  EXPECT_EQ(document_.options().correction->joints.size(), 2u);
}

TEST_F(StudioFeet, HeldJointsDoNotOutliveTheirSkeleton) {
  openAndSettle(writeClip("motion.bvh", 100));
  EncodeSettings options = heldFeet();
  options.correction->joints = {document_.skeleton()->find("lhand")};
  QSignalSpy settled(&session_, &Session::settled);
  session_.setOptions(options);
  ASSERT_TRUE(waitFor(settled));
  openAndSettle(walk_);
  EXPECT_TRUE(document_.options().correction->joints.empty());
  EXPECT_EQ(document_.decoded()->compressed.correction->effectors.size(), 2u);
}

TEST_F(StudioFeet, StandWhereTheThresholdsSay) {
  openAndSettle(walk_);
  const std::size_t usual = document_.contacts().size();
  ASSERT_GT(usual, 2u);
  QSignalSpy settled(&session_, &Session::settled);
  session_.setContactSettings({.begin_speed = 0.1, .end_speed = 0.1});
  ASSERT_TRUE(waitFor(settled));
  EXPECT_LT(document_.contacts().size(), usual);
  session_.setContactSettings({});
  EXPECT_EQ(document_.contacts().size(), usual);
}

TEST_F(Studio, TheNewestOfManyOpensWins) {
  QSignalSpy settled(&session_, &Session::settled);
  for (int i = 0; i < 20; ++i) session_.open(writeClip("one.bvh", 100));
  session_.open(writeClip("two.bvh", 120));
  ASSERT_TRUE(waitFor(settled));
  EXPECT_EQ(document_.frames(), 120);
  EXPECT_EQ(settled.count(), 1);
}

TEST_F(Studio, CanBeClosedInTheMiddleOfAnything) {
  const QString clip = writeClip("motion.bvh", 2000);
  EncodeSettings annealed = ratio(10);
  annealed.method = Method::Annealed;
  // Moments of an action: while the clip is read, while it is encoded, and while it is refined.
  enum class Moment { Reading, Encoding, Refining };
  for (const Moment moment : {Moment::Reading, Moment::Encoding, Moment::Refining}) {
    auto brief = std::make_unique<Session>();
    QSignalSpy opened(brief.get(), &Session::opened);
    QSignalSpy progress(brief.get(), &Session::annealed);
    brief->setOptions(annealed);
    brief->open(clip);
    if (moment != Moment::Reading) {
      ASSERT_TRUE(waitFor(opened));
    }
    if (moment == Moment::Refining) {
      ASSERT_TRUE(waitFor(progress));
    }
    brief.reset();
    EXPECT_EQ(opened.count(), moment == Moment::Reading ? 0 : 1);
  }
  openAndSettle(clip);
  EXPECT_EQ(document_.frames(), 2000) << "whoever comes next finds all as usual";
}

TEST_F(Studio, NothingIsOpenAfterAClose) {
  openAndSettle(writeClip("motion.bvh", 100));
  session_.setOptions(ratio(20));
  session_.open(writeClip("other.bvh", 150));
  QSignalSpy opened(&session_, &Session::opened);
  const QUndoStack* before = session_.history();
  session_.close();
  EXPECT_FALSE(document_.original());
  EXPECT_FALSE(document_.decoded());
  EXPECT_FALSE(session_.busy());
  EXPECT_NE(session_.history(), before);
  EXPECT_TRUE(document_.title().isEmpty());
  openAndSettle(path("motion.bvh"));
  EXPECT_EQ(opened.count(), 1) << "what was on its way does not arrive";
  EXPECT_EQ(document_.frames(), 100);
}

TEST_F(Studio, KeepsTracksByABoundOfTheirOwn) {
  test::SmallGltf gltf = test::bending_knee();
  gltf.json["nodes"].push_back({{"name", "Face"}, {"mesh", 0}});
  gltf.json["scenes"][0]["nodes"].push_back(3);
  gltf.json["meshes"] = Json::array(
      {{{"primitives", {{{"attributes", Json::object()}, {"targets", {Json::object()}}}}}}});
  std::vector<float> weights;
  for (int key = 0; key < 11; ++key) weights.push_back(std::sin(0.4F * static_cast<float>(key)));
  gltf.move(3, "weights", 0, gltf.add("SCALAR", weights));
  write_text(path("face.glb").toStdU16String(), gltf.glb());
  session_.setOptions({.method = Method::ClosedLoop, .target = {Target::Kind::Error, 0.5}});
  openAndSettle(path("face.glb"));
  ASSERT_EQ(document_.original()->scalars.size(), 1U);

  const auto track_bytes = [&] { return track_bytes_of(document_.file()); };
  const std::size_t before = track_bytes();
  QSignalSpy decoded(&document_, &Document::decodedChanged);
  session_.setTrackError(0.1);
  ASSERT_TRUE(waitFor(decoded));  // the result's size has changed
  EXPECT_LT(track_bytes(), before);
  EXPECT_TRUE(document_.modified());
  saveAndWait(path("face.mcpr"));
  EXPECT_FALSE(document_.modified());
  const ScalarTracks kept =
      decode_tracks(coded_tracks_of(read_bytes(path("face.mcpr").toStdU16String())));
  const double error = track_error(document_.original()->scalars, kept);
  EXPECT_LE(error, 0.1);
  EXPECT_GT(error, kUsualTrackError);

  while (session_.history()->canUndo()) session_.history()->undo();
  EXPECT_EQ(document_.settings().track_error, kUsualTrackError);
  EXPECT_EQ(track_bytes(), before);
}

}  // namespace
}  // namespace mocapress
