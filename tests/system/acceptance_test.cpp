// SPDX-License-Identifier: MIT
// The figures promised for real clips. They need the study corpus.
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

}  // namespace
}  // namespace mocapress::test
