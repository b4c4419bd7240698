// SPDX-License-Identifier: MIT
// Runs every method of `compress --method` from the command line to the file and back.
#include <gmock/gmock.h>

#include "core/base/file.h"
#include "core/codec/methods/comparison_method.h"
#include "core/codec/methods/compression_method.h"
#include "core/formats/motion_file.h"
#include "core/metrics/distortion.h"
#include "tests/system/command.h"

namespace mocapress::test {
namespace {

using nlohmann::json;

class CliMethods : public CommandLine, public testing::WithParamInterface<CompressionMethod> {
 protected:
  // The shortest of the bundled clips.
  const std::string clip_ =
      (std::filesystem::path(MOCAPRESS_SOURCE_DIR) / "resources/samples/human_run.amc").string();
  const std::string packed_ = file("run.mcpr");
  const std::string method_{GetParam().name};
  const bool of_wavelets_ = find_comparison_method(method_) == nullptr;

  json compress(std::vector<std::string> options) const {
    options.insert(options.begin(),
                   {"compress", clip_, "-o", packed_, "--method", method_, "--json"});
    return json_of(options);
  }
};

/// Ignores the last digits of numbers: sums of frames depend on their grouping.
void expect_alike(const json& a, const json& b, const std::string& key) {
  if (b.is_object()) {
    ASSERT_EQ(a.size(), b.size()) << key;
    for (const auto& [name, value] : b.items()) {
      ASSERT_TRUE(a.contains(name)) << key << ' ' << name;
      expect_alike(a[name], value, key + ' ' + name);
    }
  } else if (b.is_number_float()) {
    EXPECT_NEAR(a.get<double>(), b.get<double>(), 1e-4) << key;
  } else {
    EXPECT_EQ(a, b) << key;
  }
}

TEST_P(CliMethods, MeasureSaysWhatCompressSaid) {
  const json made = compress({"--target-error", "1", "--weighting", "joint-origins"});
  const json measured = json_of({"measure", clip_, packed_, "--json"});
  EXPECT_EQ(made["method"], method_);
  EXPECT_EQ(made["coding"].is_null(), !of_wavelets_);
  EXPECT_EQ(made["coefficient_ratio"].is_null(), !of_wavelets_);
  EXPECT_EQ(made["iterations"].is_null(), method_ != "annealed");
  EXPECT_LE(made["eps_x_cm"], 1);
  EXPECT_EQ(made["eps_x_cm"], made["eps_x_joint_origins_cm"]);
  for (const auto& [key, value] : made.items()) {
    ASSERT_TRUE(measured.contains(key)) << key;
    if (key == "coefficient_ratio" || key == "iterations" || key == "encode_seconds") continue;
    if (key == "verified_by") continue;  // depends on the reader, not on the file
    expect_alike(measured[key], value, key);
  }
  EXPECT_EQ(measured.size(), made.size());
}

TEST_P(CliMethods, DecompressesToTheMotionThatWasMeasured) {
  const json made = compress({"--ratio", "8"});
  EXPECT_NEAR(made["ratio"].get<double>() / 8, 1, 0.25);
  const std::string back = file("back.amc");
  const std::string bones = file("back.asf");
  const Outcome outcome = mocapress({"decompress", packed_, "-o", back, "--skeleton-out", bones});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const Motion original = read_motion(clip_, {}).motion;
  const Motion again = read_motion(back, bones).motion;
  ASSERT_EQ(again.clip.channels.cols(), original.clip.channels.cols());
  EXPECT_NEAR(measure(original.skeleton, original.clip, again.clip).surface.rms,
              made["eps_x_cm"].get<double>(), 1e-3);
}

TEST_P(CliMethods, InfoNamesTheMethod) {
  compress({"--ratio", "5"});
  const json info = json_of({"info", packed_, "--json"})[0];
  EXPECT_EQ(info["method"], method_);
  for (const char* key : {"basis", "coding", "seed"})
    EXPECT_EQ(info[key].is_null(), !of_wavelets_) << key;
}

TEST_P(CliMethods, TheCoefficientRatioIsForWaveletsAlone) {
  const Outcome outcome =
      mocapress({"compress", clip_, "--method", method_, "--coefficient-ratio", "10"});
  EXPECT_EQ(outcome.exit_code, of_wavelets_ ? 0 : 2) << outcome.err;
}

TEST_P(CliMethods, ATargetOutOfReachIsFourAndWritesNothing) {
  for (const auto& target : {std::pair{"--ratio", "1e6"}, {"--target-error", "1e-9"}}) {
    const Outcome outcome = mocapress(
        {"compress", clip_, "-o", packed_, "--method", method_, target.first, target.second});
    EXPECT_EQ(outcome.exit_code, 4) << outcome.err;
    EXPECT_THAT(outcome.err, testing::HasSubstr("out of reach"));
    EXPECT_FALSE(std::filesystem::exists(packed_));
  }
}

INSTANTIATE_TEST_SUITE_P(, CliMethods,
                         testing::ValuesIn(compression_methods().begin(),
                                           compression_methods().end()),
                         [](const auto& of) {
                           std::string name(of.param.name);
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

}  // namespace
}  // namespace mocapress::test
