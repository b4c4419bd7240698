// SPDX-License-Identifier: MIT
// Tests promised figures on real clips, which need the study corpus, and on the bundled clips.
#include <cmath>
#include <fstream>
#include <sstream>

#include "core/base/number_text.h"
#include "tests/support/corpus.h"
#include "tests/system/command.h"

namespace mocapress::test {
namespace {

struct Promise {
  const char* clip;
  const char* coefficient_ratio;
  double eps_cm;  // at most
  double ratio;   // at least
};

class Acceptance : public CommandLine, public testing::WithParamInterface<Promise> {};

TEST_P(Acceptance, AnnealingMeetsThePapersTable) {
  const auto folder = corpus();
  if (!folder) GTEST_SKIP() << "the corpus of real motions is not there";
  const nlohmann::json report =
      json_of({"compress", *folder / "study" / GetParam().clip, "--method", "annealed",
               "--weighting", "joint-origins", "--coding", "deflate", "--coefficient-ratio",
               GetParam().coefficient_ratio, "--json"});
  EXPECT_LE(report["eps_x_cm"], GetParam().eps_cm);
  EXPECT_GE(report["ratio"], GetParam().ratio);
}

INSTANTIATE_TEST_SUITE_P(StudyClips, Acceptance,
                         testing::Values(Promise{"49_02.amc", "20", 0.33, 33},
                                         Promise{"09_01.amc", "15", 0.42, 20}),
                         [](const auto& promise) { return std::string(promise.param.clip, 5); });

/// The expected ratios were measured once: a better codec gets new ones.
class ClosedLoopRatios : public CommandLine {};

TEST_F(ClosedLoopRatios, BundledClipsKeepTheirRatios) {
  constexpr double kTolerance = 0.02;
  std::ifstream golden(MOCAPRESS_SOURCE_DIR "/tests/golden/closed_loop_ratios.csv");
  std::string line;
  std::getline(golden, line);
  ASSERT_EQ(line, "clip,eps_cm,ratio");
  int rows = 0;
  while (std::getline(golden, line)) {
    std::istringstream cells(line);
    std::string clip, eps, ratio;
    std::getline(cells, clip, ',');
    std::getline(cells, eps, ',');
    std::getline(cells, ratio);
    const nlohmann::json report =
        json_of({"compress", MOCAPRESS_SOURCE_DIR "/resources/samples/" + clip + ".amc",
                 "--target-error", eps, "--json"});
    EXPECT_LE(report["eps_x_cm"], number_in(eps).value()) << line;
    EXPECT_NEAR(report["ratio"].get<double>() / number_in(ratio).value(), 1, kTolerance) << line;
    ++rows;
  }
  EXPECT_GE(rows, 6);
}

}  // namespace
}  // namespace mocapress::test
