// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "core/codec/encode/encoder.h"
#include "core/wavelet/lifting.h"
#include "tests/support/test_motion.h"
#include "widgets/models/care_edit.h"
#include "widgets/models/contact_edit.h"
#include "widgets/models/error_profile.h"
#include "widgets/models/kept_coefficients.h"

namespace mocapress {
namespace {

TEST(ErrorProfile, HasGreatestAndMeanOfEveryFrame) {
  Eigen::MatrixXf distances(2, 3);
  distances << 1, 2, 3, 0, 6, 0;
  const ErrorProfile profile = errorProfile(distances);
  EXPECT_EQ(profile.max, Eigen::Vector2f(3, 6));
  EXPECT_EQ(profile.mean, Eigen::Vector2f(2, 2));
  EXPECT_EQ(errorProfile({}).frames(), 0);
}

TEST(WorstFrames, ComeWorstFirstAndApart) {
  Eigen::VectorXf max = Eigen::VectorXf::Zero(100);
  max[20] = 5;
  max[22] = 4;  // belongs to the same peak
  max[60] = 9;
  max[90] = 1;
  const std::vector<int> worst = worstFrames(max, 10, 3);
  EXPECT_EQ(worst, (std::vector<int>{60, 20, 90}));
  EXPECT_EQ(worstFrames(Eigen::VectorXf(), 10, 3).size(), 0u);
}

TEST(RangeErrors, AreThoseOfTheFramesInTheRange) {
  Eigen::MatrixXf distances = Eigen::MatrixXf::Constant(40, 2, 9);
  distances.middleRows(10, 20).setConstant(0.5F);
  distances(12, 1) = 2;
  const RangeErrors errors = rangeErrors(distances, 10, 29);
  EXPECT_DOUBLE_EQ(errors.max, 2);
  EXPECT_EQ(errors.frame, 12);
  EXPECT_EQ(errors.landmark, 1);
  EXPECT_DOUBLE_EQ(errors.p95, 0.5);
  EXPECT_NEAR(errors.rms, std::sqrt((39 * 0.25 + 4) / 40), 1e-6);
  EXPECT_DOUBLE_EQ(rangeErrors(distances, 0, 0).rms, 9);
}

TEST(WorstFrames, AreSteppedThroughRoundAndRound) {
  const std::vector<int> worst = {60, 20, 90};
  EXPECT_EQ(nextWorst(worst, 7, 1), 60);
  EXPECT_EQ(nextWorst(worst, 7, -1), 60);
  EXPECT_EQ(nextWorst(worst, 60, 1), 20);
  EXPECT_EQ(nextWorst(worst, 90, 1), 60);
  EXPECT_EQ(nextWorst(worst, 60, -1), 90);
  EXPECT_EQ(nextWorst({}, 7, 1), 7);
}

TEST(KeptCoefficients, CountsWhatIsNotZeroInEachScale) {
  constexpr int kLength = 200;
  const Lifting lifting(Basis::Cubic, kLength);
  Eigen::VectorXd coefficients = Eigen::VectorXd::Zero(kLength);
  const Band& coarse = lifting.bands().front();
  const Band& fine = lifting.bands().back();
  coefficients[coarse.first] = 3;
  coefficients[fine.first + 2] = 0.01;
  coefficients[fine.first + 5] = -0.2;
  Eigen::VectorXd samples(kLength);
  lifting.inverse({coefficients.data(), kLength}, {samples.data(), kLength});
  const std::vector<KeptBand> kept = keptByScale(samples, Basis::Cubic);
  ASSERT_EQ(kept.size(), lifting.bands().size());
  EXPECT_EQ(kept.front(), (KeptBand{1, coarse.size}));
  EXPECT_EQ(kept.back(), (KeptBand{2, fine.size}));
  for (std::size_t band = 1; band + 1 < kept.size(); ++band) EXPECT_EQ(kept[band].kept, 0);
}

TEST(KeptCoefficients, AddUpToTheClipsCoefficientRatio) {
  const Encoder encoder(test::smooth_motion(300));
  const Encoding encoding =
      encoder.encode({.method = Method::Standard, .target = {Target::Kind::CoefficientRatio, 20}});
  int kept = 0;
  for (Eigen::Index c = 0; c < encoding.decoded.channels.cols(); ++c)
    for (const KeptBand& band : keptByScale(encoding.decoded.channels.col(c), Basis::Cubic))
      kept += band.kept;
  const auto all = static_cast<double>(encoding.decoded.channels.size());
  EXPECT_NEAR(all / kept, *encoding.coefficient_ratio, 0.02 * *encoding.coefficient_ratio);
}

const std::vector<ContactSpan> kStands = {{2, 10, 19}, {2, 40, 59}, {5, 12, 30}};

TEST(ContactEdit, MovesAnEndAsFarAsTheNextContactAndItsOwnOtherEnd) {
  const auto firstAt = [](int frame) {
    return withEndAt(kStands, 1, SpanEnd::First, frame, 100)[1].first_frame;
  };
  EXPECT_EQ(firstAt(30), 30);
  EXPECT_EQ(firstAt(0), 20);  // another contact of the same foot ends at 19
  EXPECT_EQ(firstAt(99), 59);
  const auto lastAt = [](int index, int frame) {
    return withEndAt(kStands, index, SpanEnd::Last, frame, 100)[static_cast<std::size_t>(index)]
        .last_frame;
  };
  EXPECT_EQ(lastAt(0, 70), 39);
  EXPECT_EQ(lastAt(0, 0), 10);
  EXPECT_EQ(lastAt(1, 500), 99);
  EXPECT_EQ(lastAt(2, 50), 50);  // another foot's contacts do not limit it
}

TEST(ContactEdit, NeverMakesContactsOfOneFootOverlap) {
  for (int frame = -10; frame < 110; frame += 3)
    for (int index = 0; index < 3; ++index)
      for (const SpanEnd end : {SpanEnd::First, SpanEnd::Last}) {
        const auto edited = withEndAt(kStands, index, end, frame, 100);
        EXPECT_LT(edited[0].last_frame, edited[1].first_frame);
        for (const ContactSpan& span : edited) {
          EXPECT_GE(span.frames(), 1);
          EXPECT_GE(span.first_frame, 0);
          EXPECT_LT(span.last_frame, 100);
        }
      }
}

TEST(ContactEdit, StandsOverARangeAndJoinsWhatItTouches) {
  const std::vector<ContactSpan> stands = {{2, 10, 19}, {2, 40, 60}, {5, 30, 69}};
  EXPECT_EQ(withContactOver(stands, 2, 20, 45),
            (std::vector<ContactSpan>{{2, 10, 60}, {5, 30, 69}}));
  EXPECT_EQ(withContactOver(stands, 2, 25, 30),
            (std::vector<ContactSpan>{{2, 10, 19}, {2, 25, 30}, {2, 40, 60}, {5, 30, 69}}));
  EXPECT_EQ(withContactOver({}, 5, 3, 4), (std::vector<ContactSpan>{{5, 3, 4}}));
}

TEST(ContactEdit, LiftsAFootInARangeAlone) {
  const std::vector<ContactSpan> stands = {{2, 10, 19}, {2, 40, 60}, {5, 30, 69}};
  EXPECT_EQ(withoutContactOver(stands, 2, 15, 50),
            (std::vector<ContactSpan>{{2, 10, 14}, {2, 51, 60}, {5, 30, 69}}));
  EXPECT_EQ(withoutContactOver(stands, 5, 40, 49),
            (std::vector<ContactSpan>{{2, 10, 19}, {2, 40, 60}, {5, 30, 39}, {5, 50, 69}}));
}

TEST(CareEdit, TheLastFactorOfAFrameIsItsFactor) {
  const auto once = withCareOver({}, 10, 30, 3);
  EXPECT_EQ(once, (std::vector<ImportantRange>{{10, 30, 3}}));
  EXPECT_EQ(withCareOver(once, 20, 40, 2), (std::vector<ImportantRange>{{10, 19, 3}, {20, 40, 2}}));
  EXPECT_EQ(withCareOver(once, 15, 20, 1), (std::vector<ImportantRange>{{10, 14, 3}, {21, 30, 3}}));
  EXPECT_EQ(withCareOver(once, 31, 40, 3), (std::vector<ImportantRange>{{10, 40, 3}}));
  EXPECT_TRUE(withCareOver(once, 0, 99, 1).empty());
  EXPECT_EQ(careOver(once, 12, 30), 3);
  EXPECT_EQ(careOver(once, 12, 31), 1);
}

TEST(ContactEdit, AddsWhereThereIsRoomAndRemoves) {
  const auto added = withContactAt(kStands, 2, 30, 40, 100);
  ASSERT_EQ(added.size(), 4u);
  EXPECT_EQ(added[1], (ContactSpan{2, 20, 39}));
  EXPECT_EQ(withContactAt(kStands, 2, 15, 10, 100), kStands);  // the frame has one already
  EXPECT_EQ(withContactAt(kStands, 5, 90, 40, 100).back(), (ContactSpan{5, 70, 99}));
  EXPECT_EQ(withContactAt({}, 7, 50, 10, 100).front(), (ContactSpan{7, 45, 54}));
  EXPECT_EQ(withoutContact(added, 1), kStands);
}

}  // namespace
}  // namespace mocapress
