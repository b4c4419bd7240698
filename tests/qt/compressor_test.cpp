// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/jobs/compressor.h"

#include <gtest/gtest.h>

#include <QTest>
#include <vector>

#include "tests/qt/patience.h"
#include "tests/support/test_motion.h"

namespace mocapress {
namespace {

struct Answer {
  DecodedPtr decoded;
  bool final;
  Method method() const { return decoded->compressed.provenance.method; }
};

std::shared_ptr<const Encoder> makeEncoder(int frames) {
  return std::make_shared<const Encoder>(test::smooth_motion(frames));
}

class CompressorTest : public testing::Test {
 protected:
  CompressorTest() {
    QObject::connect(&compressor_, &Compressor::answered,
                     [this](const DecodedPtr& decoded, bool final) {
                       answers_.push_back({decoded, final});
                     });
    QObject::connect(&compressor_, &Compressor::failed,
                     [this](const QString& message, bool out_of_reach) {
                       failures_ << message;
                       out_of_reach_ = out_of_reach;
                     });
  }

  static EncodeSettings ratio(double value, Method method = Method::Annealed) {
    EncodeSettings options;
    options.method = method;
    options.target = {Target::Kind::Ratio, value};
    return options;
  }

  bool waitForFinal() {
    return QTest::qWaitFor([this] { return !answers_.empty() && answers_.back().final; },
                           kPatience);
  }

  Compressor compressor_;
  std::vector<Answer> answers_;
  QStringList failures_;
  bool out_of_reach_ = false;
};

using Compressing = CompressorTest;

TEST_F(Compressing, AnswersWithTheStandardSelectionFirstAndTheAnnealedOneAfter) {
  std::vector<EncodeProgress> states;
  QObject::connect(&compressor_, &Compressor::progressed,
                   [&](const std::vector<EncodeProgress>& more) {
                     states.insert(states.end(), more.begin(), more.end());
                   });
  compressor_.setEncoder(makeEncoder(400));
  compressor_.request(ratio(15));
  ASSERT_TRUE(waitForFinal()) << failures_.join(u' ').toStdString();
  ASSERT_EQ(answers_.size(), 2U);
  EXPECT_EQ(answers_[0].method(), Method::Standard);
  EXPECT_FALSE(answers_[0].final);
  EXPECT_EQ(answers_[1].method(), Method::Annealed);
  EXPECT_LT(answers_[1].decoded->distortion->eps_bone_ends,
            answers_[0].decoded->distortion->eps_bone_ends);
  EXPECT_NEAR(answers_[1].decoded->ratio, 15, 0.3);
  EXPECT_FALSE(states.empty());
  EXPECT_FALSE(compressor_.busy());
}

TEST_F(Compressing, AnswersWithADraftFirstAndTheClosedLoopAfter) {
  for (const Target& target :
       {Target{Target::Kind::Ratio, 15}, Target{Target::Kind::Size, 4000},
        Target{Target::Kind::Error, 0.5}, Target{Target::Kind::MaxError, 1.5}}) {
    answers_.clear();
    compressor_.setEncoder(makeEncoder(300));
    compressor_.request({.method = Method::ClosedLoop, .target = target, .effort = Effort::Best});
    ASSERT_TRUE(waitForFinal()) << failures_.join(u' ').toStdString();
    ASSERT_EQ(answers_.size(), 3U);
    for (std::size_t i = 0; i < 2; ++i) {
      EXPECT_EQ(answers_[i].method(), Method::ClosedLoop);
      EXPECT_EQ(answers_[i].decoded->effort, Effort::Draft);
      EXPECT_FALSE(answers_[i].final);
    }
    EXPECT_TRUE(answers_[0].decoded->compressed.likely_bytes);
    EXPECT_TRUE(answers_[0].decoded->file.empty());
    EXPECT_FALSE(answers_[1].decoded->compressed.likely_bytes);
    EXPECT_FALSE(answers_[1].decoded->file.empty());
    EXPECT_NEAR(answers_[0].decoded->ratio / answers_[1].decoded->ratio, 1, 0.25);
    EXPECT_EQ(answers_[2].decoded->effort, Effort::Best);
  }
}

TEST_F(Compressing, ADraftCanBeSavedBeforeItIsCoded) {
  compressor_.setEncoder(makeEncoder(200));
  compressor_.request({.method = Method::ClosedLoop, .target = {Target::Kind::Error, 0.5}});
  ASSERT_TRUE(QTest::qWaitFor([&] { return !answers_.empty(); }, kPatience));
  compressor_.abandon();
  const DecodedClip& draft = *answers_[0].decoded;
  ASSERT_TRUE(draft.compressed.likely_bytes);
  EXPECT_EQ(savedFile(draft, nullptr, {}), coded(draft)->file);
}

TEST_F(Compressing, ADraftSearchesForNoIkRatio) {
  compressor_.setEncoder(makeEncoder(120));
  compressor_.request({.method = Method::ClosedLoop,
                       .target = {Target::Kind::Ratio, 12},
                       .correction = EncodeCorrection{.joints = {4}}});
  ASSERT_TRUE(QTest::qWaitFor([&] { return !answers_.empty(); }, kPatience));
  ASSERT_TRUE(answers_[0].decoded->correction) << failures_.join(u' ').toStdString();
  EXPECT_EQ(answers_[0].decoded->correction->ratio, 16);
  compressor_.abandon();
}

TEST_F(Compressing, AMovementGivesADraftAndAbandonsTheRunningRefinement) {
  compressor_.setEncoder(makeEncoder(3000));
  const auto asked = [](double cm) {
    return EncodeSettings{.method = Method::ClosedLoop,
                          .target = {Target::Kind::MaxError, cm},
                          .effort = Effort::Best};
  };
  compressor_.request(asked(1));
  ASSERT_TRUE(QTest::qWaitFor([&] { return compressor_.refining(); }, kPatience));
  answers_.clear();
  compressor_.request(asked(2));
  EXPECT_FALSE(compressor_.refining());
  ASSERT_TRUE(QTest::qWaitFor([&] { return !answers_.empty(); }, kPatience));
  EXPECT_FALSE(answers_[0].final);
  EXPECT_EQ(answers_[0].decoded->effort, Effort::Draft);
  compressor_.abandon();
}

TEST_F(Compressing, AnswersOnceWhereNothingIsAnnealed) {
  compressor_.setEncoder(makeEncoder(200));
  compressor_.request(ratio(10, Method::PerChannel));
  ASSERT_TRUE(waitForFinal());
  EXPECT_EQ(answers_[0].method(), Method::PerChannel);
  compressor_.request(ratio(5, Method::PerChannel));
  ASSERT_TRUE(QTest::qWaitFor([&] { return answers_.size() > 1; }, kPatience));
  EXPECT_LT(answers_[1].decoded->ratio, 7) << "a second answer to the first would come before";
}

TEST_F(Compressing, JudgesAnAnswerByOtherLimitsWithoutEncodingItAgain) {
  compressor_.setEncoder(makeEncoder(100));
  EncodeSettings options = ratio(20, Method::Standard);
  compressor_.request(options);
  ASSERT_TRUE(waitForFinal()) << failures_.join(u' ').toStdString();
  const DecodedPtr near = answers_.back().decoded;
  answers_.clear();
  options.limits.distance_m *= 4;
  compressor_.request(options);
  ASSERT_TRUE(waitForFinal());
  ASSERT_EQ(answers_.size(), 1U);  // without a draft
  const DecodedClip& far = *answers_[0].decoded;
  EXPECT_EQ(far.file, near->file);
  EXPECT_EQ(far.encode_seconds, near->encode_seconds);
  EXPECT_EQ(far.visibility->limits.distance_m, options.limits.distance_m);
  EXPECT_LT(far.visibility->worst().times_noticed(), near->visibility->worst().times_noticed());
}

TEST_F(Compressing, EndsWithTheAnswerToTheNewestRequest) {
  compressor_.setEncoder(makeEncoder(300));
  for (int i = 0; i < 40; ++i) {
    compressor_.request(ratio(8 + 0.5 * i));
    const std::size_t before = answers_.size();
    const auto answered = [&] { return answers_.size() > before || !compressor_.busy(); };
    if (i % 5 == 0)
      ASSERT_TRUE(QTest::qWaitFor(answered, kPatience));
    else
      runDueEvents();
  }
  ASSERT_TRUE(QTest::qWaitFor([&] { return !compressor_.busy(); }, kPatience));
  ASSERT_FALSE(answers_.empty());
  EXPECT_TRUE(answers_.back().final);
  EXPECT_NEAR(answers_.back().decoded->ratio, 27.5, 0.6);
  EXPECT_EQ(answers_.back().method(), Method::Annealed);
}

TEST_F(Compressing, KeepsAnsweringWhileRequestsKeepComing) {
  compressor_.setEncoder(makeEncoder(400));
  int requests = 0;
  const auto request_until_answered = [&] {
    compressor_.request(ratio(10 + 0.05 * requests++));
    return !answers_.empty();
  };
  EXPECT_TRUE(QTest::qWaitFor(request_until_answered, kPatience));
}

TEST_F(Compressing, CancelKeepsAnAnswerNoWorseThanTheStandardOne) {
  compressor_.setEncoder(makeEncoder(3000));
  compressor_.request(ratio(12));
  ASSERT_TRUE(QTest::qWaitFor([&] { return compressor_.refining(); }, kPatience));
  compressor_.stopEarly();
  ASSERT_TRUE(waitForFinal());
  EXPECT_LE(answers_.back().decoded->distortion->eps_bone_ends,
            answers_.front().decoded->distortion->eps_bone_ends);
  EXPECT_FALSE(compressor_.busy());
}

TEST_F(Compressing, CancelBeforeTheAnnealingBeginsLeavesTheStandardAnswer) {
  compressor_.setEncoder(makeEncoder(200));
  compressor_.request(ratio(12));
  ASSERT_TRUE(QTest::qWaitFor([&] { return !answers_.empty(); }, kPatience));
  compressor_.stopEarly();
  ASSERT_TRUE(waitForFinal());
  EXPECT_EQ(answers_.back().method(), Method::Standard);
}

TEST_F(Compressing, AMissedTargetIsAMessageAndTheNextRequestWorks) {
  compressor_.setEncoder(makeEncoder(100));
  compressor_.request(ratio(1e9));
  ASSERT_TRUE(QTest::qWaitFor([&] { return !failures_.empty(); }, kPatience));
  EXPECT_FALSE(compressor_.busy());
  EXPECT_TRUE(out_of_reach_);
  compressor_.request(ratio(8));
  ASSERT_TRUE(waitForFinal());
  failures_.clear();
  EncodeSettings impossible = ratio(8, Method::Standard);
  impossible.correction = EncodeCorrection{.joints = {0}};  // the root has no chain above it
  compressor_.request(impossible);
  ASSERT_TRUE(QTest::qWaitFor([&] { return !failures_.empty(); }, kPatience));
  EXPECT_FALSE(out_of_reach_);
}

TEST_F(Compressing, ReturningToAClipIsAnsweredAtOnce) {
  const EncodeSettings options = ratio(20, Method::Standard);
  const auto compress = [&](int frames, const char* content) {
    compressor_.setEncoder(makeEncoder(frames), content);
    answers_.clear();
    compressor_.request(options);
    const bool at_once = !answers_.empty();
    EXPECT_TRUE(waitForFinal());
    EXPECT_EQ(answers_.back().decoded->clip.frames(), frames);
    return at_once;
  };
  EXPECT_FALSE(compress(200, "walk"));
  EXPECT_FALSE(compress(120, "run"));
  EXPECT_TRUE(compress(200, "walk"));
  EXPECT_FALSE(compress(120, "")) << "nobody knows what it is";
  EXPECT_FALSE(compress(120, ""));
  compressor_.setEncoder(nullptr);
  EXPECT_FALSE(compress(200, "walk"));
}

TEST_F(Compressing, NothingOfTheOldClipArrivesAfterANewOne) {
  compressor_.setEncoder(makeEncoder(2000));
  compressor_.request(ratio(12));
  ASSERT_TRUE(QTest::qWaitFor([&] { return !answers_.empty(); }, kPatience));
  answers_.clear();
  compressor_.setEncoder(makeEncoder(64));
  compressor_.request(ratio(4));
  ASSERT_TRUE(waitForFinal());
  for (const Answer& answer : answers_) EXPECT_EQ(answer.decoded->compressed.frames, 64);
}

}  // namespace
}  // namespace mocapress
