// SPDX-License-Identifier: MIT
// Tests the things that scripts depend on: keys and types of the JSON, targets that are met, files
// that can be read again.
#include <gmock/gmock.h>

#include <set>
#include <sstream>

#include "core/base/file.h"
#include "core/base/number_text.h"
#include "core/codec/decode/decoder.h"
#include "core/codec/format/container.h"
#include "core/formats/motion_file.h"
#include "core/metrics/distortion.h"
#include "tests/support/small_gltf.h"
#include "tests/system/command.h"

namespace mocapress::test {
namespace {

using nlohmann::json;

class Cli : public CommandLine {
 protected:
  const std::string clip_ = write("walk.bvh", test_bvh());
  const std::string packed_ = file("walk.mcpr");

  json compress(std::vector<std::string> options) const {
    options.insert(options.begin(), {"compress", clip_, "-o", packed_, "--json"});
    return json_of(options);
  }
};

std::set<std::string> keys_of(const json& object) {
  std::set<std::string> keys;
  for (const auto& [key, value] : object.items()) keys.insert(key);
  return keys;
}

const std::set<std::string> kStringKeys = {
    "input",       "method",     "weighting",         "coding",
    "verified_by", "visibility", "visibility_reason", "loop"};
const std::set<std::string> kIntegerKeys = {"frames",    "channels",     "joints",
                                            "raw_bytes", "motion_bytes", "file_bytes",
                                            "contacts",  "tracks",       "track_bytes"};
const std::set<std::string> kNumberKeys = {"sample_rate_hz",
                                           "ratio",
                                           "eps_x_cm",
                                           "eps_x_bone_ends_cm",
                                           "eps_x_joint_origins_cm",
                                           "max_error_cm",
                                           "bone_ends_max_cm",
                                           "bone_ends_p95_cm",
                                           "bone_ends_p99_cm",
                                           "p95_error_cm",
                                           "p99_error_cm",
                                           "bits_per_joint_sample",
                                           "surface_rms_cm",
                                           "surface_p95_cm",
                                           "surface_p99_cm",
                                           "surface_max_cm",
                                           "shell_rms_cm",
                                           "shell_p95_cm",
                                           "shell_p99_cm",
                                           "shell_max_cm",
                                           "angle_rms_degrees",
                                           "head_degrees",
                                           "head_worst_degrees",
                                           "root_cm",
                                           "root_degrees",
                                           "first_frame_cm",
                                           "last_frame_cm",
                                           "seam_cm",
                                           "seam_cm_per_frame",
                                           "neighbours_cm",
                                           "neighbours_cm_per_frame",
                                           "worst_neighbours_cm",
                                           "worst_neighbours_cm_per_frame",
                                           "times_noticed",
                                           "unnoticed_from_m",
                                           "distance_m",
                                           "visible_frames_share",
                                           "velocity_error_cm_per_s",
                                           "velocity_error_worst_cm_per_s",
                                           "jitter_ratio",
                                           "floor_depth_cm",
                                           "head_window_degrees",
                                           "root_flight_cm_per_s"};
const std::set<std::string> kEncodingKeys = {"coefficient_ratio", "iterations", "encode_seconds"};
// Null for a clip without feet, hands and tracks.
const std::set<std::string> kNullKeys = {"hand_degrees",
                                         "finger_degrees",
                                         "finger_worst_degrees",
                                         "foot_degrees",
                                         "foot_worst_degrees",
                                         "hand_window_degrees",
                                         "skin_rms_cm",
                                         "skin_p95_cm",
                                         "skin_p99_cm",
                                         "skin_max_cm",
                                         "track_max_error",
                                         "own_limits",
                                         "ik_ratio",
                                         "ik_bytes",
                                         "footskate_cm",
                                         "footskate_mean_cm",
                                         "footskate_worst_cm",
                                         "footskate_drift_mean_cm",
                                         "footskate_drift_worst_cm",
                                         "footskate_without_ik_cm",
                                         "slide_worst_contact_cm",
                                         "lift_worst_contact_cm",

                                         "hand_worst_degrees"};

/// Expects exactly the keys of a report with their types; keys of the encoding are numbers or null.
void expect_report(const json& report, bool encoded) {
  std::set<std::string> all;
  const auto expect_all = [&](const std::set<std::string>& keys, auto has_type) {
    for (const std::string& key : keys)
      EXPECT_TRUE(report.contains(key) && has_type(report[key])) << key << " in " << report;
    all.insert(keys.begin(), keys.end());
  };
  expect_all(kStringKeys, [](const json& value) { return value.is_string(); });
  expect_all(kIntegerKeys, [](const json& value) { return value.is_number_integer(); });
  expect_all(kNumberKeys, [](const json& value) { return value.is_number(); });
  expect_all(kEncodingKeys,
             [&](const json& value) { return encoded ? value.is_number() : value.is_null(); });
  expect_all(kNullKeys, [](const json& value) { return value.is_null(); });
  EXPECT_TRUE(report["noticed_by_cue"].is_object());
  all.insert("noticed_by_cue");
  EXPECT_EQ(keys_of(report), all);
}

TEST_F(Cli, CompressReportsExactlyTheDocumentedKeys) {
  const json report = compress({"--method", "annealed"});
  expect_report(report, true);
  EXPECT_EQ(report["input"], clip_);
  EXPECT_EQ(report["method"], "annealed");
  EXPECT_EQ(report["weighting"], "surface");
  EXPECT_EQ(report["coding"], "deflate");
  EXPECT_EQ(report["frames"], 600);
  EXPECT_EQ(report["channels"], 14);
  EXPECT_EQ(report["joints"], 5);
  EXPECT_EQ(report["raw_bytes"], 600 * 14 * 4);
  EXPECT_EQ(report["file_bytes"], std::filesystem::file_size(packed_));
  EXPECT_NEAR(report["ratio"].get<double>(),
              report["raw_bytes"].get<double>() / report["motion_bytes"].get<double>(), 1e-9);
  EXPECT_EQ(report["eps_x_cm"], report["surface_rms_cm"]);
  EXPECT_EQ(report["verified_by"], "library") << "no engine plays annealed wavelets in DEFLATE";
}

TEST_F(Cli, CompressReadsBackWhatItWroteAsAnEngineWould) {
  const json report = compress({"--method", "closed-loop"});
  EXPECT_EQ(report["verified_by"], "runtime");
  const json measured = json_of({"measure", clip_, packed_, "--json"});
  EXPECT_NEAR(measured["max_error_cm"].get<double>(), report["max_error_cm"].get<double>(), 1e-4);
  EXPECT_EQ(report["weighting"], "surface");
  EXPECT_EQ(report["max_error_cm"], report["surface_max_cm"]);
  EXPECT_NE(report["max_error_cm"], report["bone_ends_max_cm"]);
}

TEST_F(Cli, CompressesToWhatIsNotVisible) {
  const json report = compress({"--weighting", "surface", "--target", "not-visible"});
  EXPECT_EQ(report["visibility"], "not-visible");
  EXPECT_LE(report["times_noticed"], 1);
  EXPECT_GT(report["times_noticed"], 0.6);
  const json measured = json_of({"measure", clip_, packed_, "--json"});
  EXPECT_EQ(measured["visibility"], "not-visible");
  EXPECT_EQ(compress({"--ratio", "500", "--method", "closed-loop"})["visibility"], "visible");
}

TEST_F(Cli, HoldsTheFeetOfASampleAndReportsIt) {
  const std::string walk = std::string(MOCAPRESS_SOURCE_DIR) + "/resources/samples/human_walk.amc";
  const json with = json_of({"compress", walk, "-o", packed_, "--method", "standard",
                             "--coefficient-ratio", "30", "--ik", "16", "--json"});
  EXPECT_EQ(with["ik_ratio"], 16);
  EXPECT_GT(with["ik_bytes"], 50);
  const json without = json_of({"compress", walk, "--method", "standard", "--target-size",
                                std::to_string(with["motion_bytes"].get<int>()), "--json"});
  EXPECT_TRUE(without["ik_ratio"].is_null());
  EXPECT_LT(with["footskate_cm"], 0.2 * without["footskate_cm"].get<double>());
  const json measured = json_of({"measure", walk, packed_, "--json"});
  EXPECT_EQ(measured["ik_bytes"], with["ik_bytes"]);
  EXPECT_EQ(measured["motion_bytes"], with["motion_bytes"]);
  EXPECT_NEAR(measured["footskate_cm"], with["footskate_cm"], 0.01);
  EXPECT_GT(measured["contacts"], 1);
  EXPECT_NEAR(measured["footskate_mean_cm"].get<double>() * measured["contacts"].get<double>(),
              measured["footskate_cm"].get<double>(), 1e-9);
  EXPECT_GE(measured["footskate_worst_cm"], measured["footskate_mean_cm"]);
  EXPECT_LE(measured["footskate_worst_cm"], measured["footskate_cm"]);
  EXPECT_GE(measured["footskate_drift_worst_cm"], measured["footskate_drift_mean_cm"]);
  // The distance between two errors is at most twice the larger one.
  EXPECT_LE(measured["footskate_drift_worst_cm"].get<double>(),
            2 * measured["bone_ends_max_cm"].get<double>() + 1e-9);
}

TEST_F(Cli, ShowsTheSplitThatAutoFound) {
  const std::string walk = std::string(MOCAPRESS_SOURCE_DIR) + "/resources/samples/human_walk.amc";
  const std::vector<std::string> command = {"compress", walk,   "--target-error",
                                            "0.5",      "--ik", "auto"};
  std::vector<std::string> as_json = command;
  as_json.push_back("--json");
  const json found = json_of(as_json);
  EXPECT_GE(found["ik_ratio"], 1);
  const double without = found["footskate_without_ik_cm"];
  EXPECT_GT(without, 0.1);
  EXPECT_LE(found["footskate_cm"], 0.1 * without);
  EXPECT_THAT(mocapress(command).err, testing::HasSubstr("r_IK found: "));
}

TEST_F(Cli, NamesTheEffectorThatIsNoJoint) {
  const Outcome result = mocapress({"compress", clip_, "--ik", "16", "--effectors", "nose"});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.err, testing::HasSubstr("nose"));
}

TEST_F(Cli, WithoutJsonEverythingForPeopleIsOnStandardError) {
  for (const auto& arguments :
       {std::vector<std::string>{"compress", clip_, "-o", packed_}, {"measure", clip_, packed_}}) {
    const Outcome outcome = mocapress(arguments);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    EXPECT_THAT(outcome.err, testing::HasSubstr("walk.bvh"));
  }
}

TEST_F(Cli, ListingsAreOnStandardOutputAndMessagesAreNot) {
  const Outcome info = mocapress({"info", clip_});
  EXPECT_THAT(info.out, testing::HasSubstr("walk.bvh\n  joints"));
  EXPECT_EQ(info.err, "");
}

TEST_F(Cli, MeasureSaysWhatCompressSaid) {
  for (const char* weighting : {"bone-ends", "joint-origins", "surface", "shell"}) {
    const json made = compress({"--weighting", weighting});
    const json measured = json_of({"measure", clip_, packed_, "--json"});
    expect_report(measured, false);
    for (const std::string& key : kNumberKeys)
      EXPECT_NEAR(measured[key].get<double>(), made[key].get<double>(), 1e-6) << key;
    for (const std::string& key : kIntegerKeys) EXPECT_EQ(measured[key], made[key]) << key;
    EXPECT_EQ(measured["weighting"], weighting);
    EXPECT_EQ(measured["method"], made["method"]);
  }
}

TEST_F(Cli, TellsTheErrorOfEachTier) {
  compress({"--tiers", "3", "--target-error", "0.5"});
  const json tiers = json_of({"info", "--json", packed_})[0]["tiers"];
  ASSERT_EQ(tiers.size(), 3U);
  const Motion original = read_motion(clip_).motion;
  for (std::size_t t = 0; t < tiers.size(); ++t) {
    const Clip coarse = decode(read_container(read_bytes(packed_), static_cast<int>(t) + 1));
    const Distortion found = measure(original.skeleton, original.clip, coarse);
    EXPECT_NEAR(found.surface.rms, tiers[t]["eps_x_cm"].get<double>(), 0.005 * found.surface.rms);
  }
}

TEST_F(Cli, MeetsTheErrorOfBasePlusDifference) {
  const json report = compress({"--additive", clip_, "--base-frame", "1", "--target-error", "0.5"});
  EXPECT_LE(report["surface_rms_cm"].get<double>(), 0.5);
  EXPECT_GT(report["surface_rms_cm"].get<double>(), 0.4);
  EXPECT_EQ(report["verified_by"], "runtime");
  EXPECT_EQ(mocapress({"compress", clip_, "--additive", clip_, "--tiers", "2"}).exit_code, 2);
  EXPECT_EQ(mocapress({"compress", clip_, "--additive", clip_, "--base-frame", "600"}).exit_code,
            0);
  const Outcome beyond = mocapress({"compress", clip_, "--additive", clip_, "--base-frame", "601"});
  EXPECT_EQ(beyond.exit_code, 3);
  EXPECT_THAT(beyond.err, testing::HasSubstr("has no frame 601"));
}

TEST_F(Cli, SolvesTheRatioWithinTwoPercent) {
  for (const char* method : {"per-channel", "standard", "annealed"})
    for (const char* coding : {"rle16", "deflate"})
      for (const double ratio : {8.0, 25.0}) {
        const json report =
            compress({"--method", method, "--coding", coding, "--ratio", fixed_text(ratio, 6)});
        EXPECT_NEAR(report["ratio"].get<double>() / ratio, 1, 0.02) << report;
      }
}

TEST_F(Cli, ClosesTheLoopToEveryTarget) {
  const auto closed = [this](std::vector<std::string> target) {
    target.insert(target.begin(), {"--method", "closed-loop"});
    return compress(target);
  };
  const json report = closed({"--ratio", "40", "--coding", "adaptive"});
  EXPECT_NEAR(report["ratio"].get<double>() / 40, 1, 0.02);
  EXPECT_EQ(report["coding"], "adaptive");
  EXPECT_LE(closed({"--target-error", "0.5"})["eps_x_cm"], 0.5);
  EXPECT_LE(closed({"--max-error", "1.5"})["surface_max_cm"], 1.5);
  EXPECT_LE(closed({"--target-size", "800"})["motion_bytes"], 800);
  EXPECT_GT(compress({"--method", "annealed", "--target-error", "0.5"})["motion_bytes"],
            2 * closed({"--target-error", "0.5"})["motion_bytes"].get<int>());
}

TEST_F(Cli, KeepsEveryOtherTarget) {
  EXPECT_LE(compress({"--target-error", "0.5"})["eps_x_cm"], 0.5);
  EXPECT_LE(compress({"--max-error", "1.5"})["surface_max_cm"], 1.5);
  EXPECT_LE(compress({"--target-size", "1500"})["motion_bytes"], 1500);
  EXPECT_NEAR(compress({"--coefficient-ratio", "12"})["coefficient_ratio"], 12, 0.24);
}

TEST_F(Cli, TargetsAreNotMetByWaste) {
  EXPECT_GE(compress({"--target-error", "0.5"})["eps_x_cm"], 0.4);
  EXPECT_GE(compress({"--target-size", "1500"})["motion_bytes"], 1400);
}

TEST_F(Cli, SameSeedSameBytes) {
  compress({"--seed", "7"});
  const auto first = read_bytes(packed_);
  compress({"--seed", "7"});
  EXPECT_EQ(read_bytes(packed_), first);
  compress({"--seed", "8"});
  EXPECT_NE(read_bytes(packed_), first);
}

TEST_F(Cli, OneThreadMakesTheSameBytes) {
  if (run_program({"taskset", "-c", "0", "true"}).exit_code != 0)
    GTEST_SKIP() << "taskset is not there to hold the program on one processor";
  compress({"--seed", "7"});
  const auto on_all = read_bytes(packed_);
  const Outcome outcome = run_program({"taskset", "-c", "0", MOCAPRESS_EXECUTABLE, "compress",
                                       clip_, "-o", packed_, "--seed", "7"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(read_bytes(packed_), on_all);
}

TEST_F(Cli, DecompressedFilesReadAgainAsTheDecodedMotion) {
  compress({});
  const CompressedClip packed = read_container(read_bytes(packed_));
  const Clip decoded = decode(packed);
  const Eigen::MatrixXd tracks = landmark_tracks(packed.skeleton, decoded);
  const std::string skeleton = file("bones.asf");
  for (const std::string& output : {file("back.bvh").string(), file("back.amc").string(),
                                    file("back.glb").string(), file("back.gltf").string()}) {
    const Outcome outcome =
        mocapress({"decompress", packed_, "-o", output, "--skeleton-out", skeleton});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const Motion again = read_motion(output, skeleton).motion;
    ASSERT_EQ(again.clip.frames(), decoded.frames()) << output;
    EXPECT_NEAR(again.clip.sample_rate_hz, packed.sample_rate_hz, 1e-3) << output;
    // Formats may add joints, so every point of the file must be one of the points read.
    const Eigen::MatrixXd tracks_again = landmark_tracks(again.skeleton, again.clip);
    for (Eigen::Index p = 0; p + 2 < tracks.cols(); p += 3) {
      double nearest = std::numeric_limits<double>::infinity();
      for (Eigen::Index q = 0; q + 2 < tracks_again.cols(); q += 3)
        nearest = std::min(
            nearest,
            (tracks.middleCols<3>(p) - tracks_again.middleCols<3>(q)).rowwise().norm().maxCoeff());
      EXPECT_LT(nearest, 1e-4) << output << ", landmark " << p / 3;  // cm
    }
  }
}

/// The lines of a file that begin with `word`, without their indents.
std::vector<std::string> lines_of(const std::string& path, const std::string& word) {
  std::vector<std::string> found;
  std::istringstream lines(read_text(path));
  for (std::string line; std::getline(lines, line);) {
    line.erase(0, line.find_first_not_of(" \t"));
    if (line.starts_with(word)) found.push_back(line);
  }
  return found;
}

TEST_F(Cli, ExportsComeBackInTheUnitAxesRateAndRootConventionOfTheirSource) {
  // A figure of 67 inches, Z up, whose root replaces its OFFSET.
  std::string text =
      "HIERARCHY\nROOT hips\n{\n  OFFSET 1 2 38\n  CHANNELS 6 Xposition Yposition "
      "Zposition Zrotation Xrotation Yrotation\n  JOINT chest\n  {\n    OFFSET 0 0 20\n"
      "    CHANNELS 3 Zrotation Xrotation Yrotation\n    End Site\n    {\n"
      "      OFFSET 0 0 47\n    }\n  }\n}\nMOTION\nFrames: 60\nFrame Time: 0.04\n";
  for (int t = 0; t < 60; ++t)
    text += fixed_text(1 + 0.2 * t, 6) + " 2 38.5 0 " + std::to_string(t) + " 0 0 0 0\n";
  const std::string source = write("inches.bvh", text);
  const json packed =
      json_of({"compress", source, "-o", packed_, "--up", "z", "--max-error", "0.05", "--json"});
  EXPECT_EQ(packed["file_bytes"], std::filesystem::file_size(packed_));
  const json described = json_of({"info", packed_, "--json"})[0]["source"];
  EXPECT_EQ(described, json::parse(R"({"format": "bvh", "cm_per_unit": 2.54, "up": "z",
                                       "bvh_root": "replace"})"));
  const auto decompress = [&](std::vector<std::string> options) {
    const std::string back = file("back.bvh");
    options.insert(options.begin(), {"decompress", packed_, "-o", back});
    const Outcome outcome = mocapress(options);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return back;
  };
  const std::vector<std::string> offsets = lines_of(source, "OFFSET");
  EXPECT_EQ(lines_of(decompress({}), "OFFSET"), offsets);
  EXPECT_EQ(lines_of(file("back.bvh"), "CHANNELS"), lines_of(source, "CHANNELS"));
  EXPECT_EQ(lines_of(file("back.bvh"), "Frame Time"), lines_of(source, "Frame Time"));
  const Motion original = read_motion(source).motion;
  const Motion again = read_motion(file("back.bvh")).motion;
  EXPECT_LT((landmark_tracks(original.skeleton, original.clip) -
             landmark_tracks(again.skeleton, again.clip))
                .cwiseAbs()
                .maxCoeff(),
            0.051);

  EXPECT_EQ(lines_of(decompress({"--out-cm-per-unit", "1", "--out-up", "y", "--out-bvh-root", "add",
                                 "--out-rate", "50"}),
                     "OFFSET"),
            (std::vector<std::string>{"OFFSET 2.54 96.52 -5.08", "OFFSET 0 50.8 0",
                                      "OFFSET 0 119.38 0"}));
  EXPECT_EQ(lines_of(file("back.bvh"), "Frame Time").front(), "Frame Time: 0.02");
}

TEST_F(Cli, ReadsAndWritesAsItIsTold) {
  for (const std::vector<std::string>& wrong : {std::vector<std::string>{"--up", "x"},
                                                {"--bvh-root", "both"},
                                                {"--cm-per-unit", "0"},
                                                {"--cm-per-unit", "nan"},
                                                {"--rate", "-1"}}) {
    std::vector<std::string> words = {"info", clip_};
    words.insert(words.end(), wrong.begin(), wrong.end());
    EXPECT_EQ(mocapress(words).exit_code, 2) << wrong[0] << ' ' << wrong[1];
  }
  const json told =
      json_of({"info", clip_, "--json", "--up", "z", "--cm-per-unit", "2.54", "--rate", "25"})[0];
  EXPECT_EQ(told["sample_rate_hz"], 25);
  EXPECT_EQ(told["source"]["up"], "z");
  EXPECT_EQ(told["source"]["cm_per_unit"], 2.54);
}

TEST_F(Cli, DecompressPutsAMotionOntoTheGltfItCameFrom) {
  SmallGltf knee = bending_knee();
  const Json walk = knee.json["animations"][0];
  knee.begin_animation("jump");
  knee.move(0, "translation", 0, knee.add("VEC3", std::vector<float>(33, 1.5F)));
  knee.json["materials"].push_back({{"name", "skin"}});
  const std::string source = write("knee.glb", knee.glb());
  ASSERT_EQ(
      mocapress({"compress", source, "-o", packed_, "--take", "walk", "--target-error", "0.01"})
          .exit_code,
      0);
  const std::string output = file("back.glb");
  const auto onto = [&](const std::string& path, const std::string& take) {
    return mocapress({"decompress", packed_, "-o", path, "--onto", source, "--take", take});
  };
  ASSERT_EQ(onto(output, "walk").exit_code, 0);
  const GltfFile written(output, read_text(output));
  EXPECT_EQ(written.json()["materials"], knee.json["materials"]);
  EXPECT_NE(written.json()["animations"][0], walk);
  EXPECT_EQ(written.json()["animations"][1], knee.json["animations"][1]);
  EXPECT_EQ(read_motion(output, {}, {.take = "walk"}).motion.clip.frames(), 11);
  EXPECT_EQ(onto(output, "3").exit_code, 3);
  const Outcome wrong = onto(file("back.bvh"), "walk");
  EXPECT_EQ(wrong.exit_code, 2);
  EXPECT_THAT(wrong.err, testing::HasSubstr("only an .fbx can be written onto an .fbx"));
}

TEST_F(Cli, MeasuresOnTheSkinOfAClipWithAMesh) {
  const std::string character =
      std::string(MOCAPRESS_SOURCE_DIR) + "/resources/samples/character.glb";
  if (!std::filesystem::exists(character)) GTEST_SKIP() << "no sample character";
  const json report = json_of({"compress", character, "-o", packed_, "--weighting", "skin",
                               "--target-error", "0.3", "--json"});
  EXPECT_EQ(report["weighting"], "skin");
  EXPECT_EQ(report["eps_x_cm"], report["skin_rms_cm"]);
  EXPECT_LE(report["skin_rms_cm"], 0.3);
  EXPECT_GT(report["skin_max_cm"], report["skin_rms_cm"]);
  const json measured = json_of({"measure", character, packed_, "--json"});
  EXPECT_NEAR(measured["skin_max_cm"].get<double>(), report["skin_max_cm"].get<double>(), 1e-6);

  const json bounded = json_of(
      {"compress", character, "-o", packed_, "--weighting", "skin", "--max-error", "1", "--json"});
  EXPECT_LE(bounded["skin_max_cm"], 1);

  const auto refused = mocapress({"compress", clip_, "-o", packed_, "--weighting", "skin"});
  EXPECT_NE(refused.exit_code, 0);
  EXPECT_THAT(refused.err, testing::HasSubstr("the weighting skin needs a clip with a mesh"));
}

TEST_F(Cli, MeasuresOnTheSkinOfACharacterThatIsPutOn) {
  const std::string samples = std::string(MOCAPRESS_SOURCE_DIR) + "/resources/samples/";
  const std::string character = samples + "character.glb";
  if (!std::filesystem::exists(character)) GTEST_SKIP() << "no sample character";
  const std::string walk = samples + "human_walk.amc";
  const json report = json_of({"compress", walk, "-o", packed_, "--character", character,
                               "--weighting", "skin", "--target-error", "0.3", "--json"});
  EXPECT_EQ(report["eps_x_cm"], report["skin_rms_cm"]);
  EXPECT_LE(report["skin_rms_cm"], 0.3);
  const json measured = json_of({"measure", walk, packed_, "--character", character, "--json"});
  EXPECT_NEAR(measured["skin_max_cm"].get<double>(), report["skin_max_cm"].get<double>(), 1e-6);

  const auto refused = mocapress({"compress", clip_, "--character", character});
  EXPECT_NE(refused.exit_code, 0);
  EXPECT_THAT(refused.err, testing::HasSubstr("cannot be put on: the clip has no joint"));
}

TEST_F(Cli, KeepsMorphWeightsWithinTheirOwnBound) {
  SmallGltf gltf = bending_knee();
  gltf.json["nodes"].push_back({{"name", "Face"}, {"mesh", 0}});
  gltf.json["scenes"][0]["nodes"].push_back(3);
  gltf.json["meshes"] = json::array(
      {{{"primitives",
         {{{"attributes", json::object()}, {"targets", {json::object(), json::object()}}}}},
        {"extras", {{"targetNames", {"smile", "blink"}}}}}});
  std::vector<float> weights;
  for (int key = 0; key < 11; ++key)
    weights.insert(weights.end(),
                   {std::sin(0.4F * static_cast<float>(key)), key > 5 ? 1.0F : 0.0F});
  gltf.move(3, "weights", 0, gltf.add("SCALAR", weights));
  const std::string source = write("face.glb", gltf.glb());
  const json made = json_of({"compress", source, "-o", packed_, "--target-error", "0.1",
                             "--track-error", "0.01", "--json"});
  EXPECT_EQ(made["tracks"], 2);
  EXPECT_GT(made["track_bytes"], 30);
  EXPECT_LE(made["track_max_error"], 0.01);
  const json measured = json_of({"measure", source, packed_, "--json"});
  for (const char* key : {"tracks", "track_bytes", "track_max_error"})
    EXPECT_EQ(measured[key], made[key]) << key;
  const json info = json_of({"info", source, packed_, "--json"});
  EXPECT_EQ(info[0]["tracks"], info[1]["tracks"]);
  EXPECT_EQ(
      info[1]["tracks"][1],
      (json{{"kind", "morph-weight"}, {"node", "Face"}, {"name", "blink"}, {"steps", false}}));
  EXPECT_EQ(info[1]["track_bytes"], made["track_bytes"]);

  const std::string back = file("back.glb");
  ASSERT_EQ(mocapress({"decompress", packed_, "-o", back, "--onto", source}).exit_code, 0);
  const MotionFile again = read_motion(back);
  ASSERT_EQ(again.tracks.size(), 2u);
  for (std::size_t key = 0; key < 11; ++key) {
    EXPECT_NEAR(again.tracks[0].values[key], weights[2 * key], 0.0101);
    EXPECT_EQ(again.tracks[1].values[key], weights[2 * key + 1]) << "a switch is exact";
  }
  EXPECT_THAT(mocapress({"decompress", packed_, "-o", file("back.bvh")}).err,
              testing::HasSubstr("back.bvh: has no place for 2 tracks of the clip"));
  ASSERT_EQ(mocapress({"decompress", packed_, "-o", file("back.csv")}).exit_code, 0);
  EXPECT_THAT(read_text(file("back.csv")), testing::HasSubstr(",Face.smile,Face.blink\n"));
  EXPECT_EQ(mocapress({"compress", source, "--track-error", "0"}).exit_code, 2);
}

TEST_F(Cli, KeepsCurvesOfATableWithTheClip) {
  std::string table = "time_s,ik_left,step\n";
  for (int t = 0; t < 600; ++t)
    table += "0," + std::to_string(t % 60) + ".5," + (t % 90 < 45 ? "0\n" : "1\n");
  const std::string curves = write("curves.csv", table);
  const json made = json_of(
      {"compress", clip_, "--tracks", curves, "-o", packed_, "--track-error", "0.01", "--json"});
  EXPECT_EQ(made["tracks"], 2);
  EXPECT_LE(made["track_max_error"], 0.01);
  const json measured = json_of({"measure", clip_, packed_, "--tracks", curves, "--json"});
  EXPECT_EQ(measured["track_max_error"], made["track_max_error"]);
  const json info = json_of({"info", packed_, "--json"});
  EXPECT_EQ(info[0]["tracks"][1],
            (json{{"kind", "property"}, {"node", ""}, {"name", "step"}, {"steps", true}}));
  ASSERT_EQ(mocapress({"decompress", packed_, "-o", file("back.csv")}).exit_code, 0);
  EXPECT_THAT(read_text(file("back.csv")), testing::HasSubstr(",ik_left,step\n"));

  const auto missing = mocapress({"compress", clip_, "--tracks", write("a.csv", "a\n1\n")});
  EXPECT_EQ(missing.exit_code, 3);
  EXPECT_THAT(missing.err,
              testing::HasSubstr("a.csv:2:1: ends after values of 1 frame, the clip has 600"));
}

TEST_F(Cli, DecompressedCsvHasALineForEachFrame) {
  compress({});
  const std::string output = file("back.csv");
  ASSERT_EQ(mocapress({"decompress", packed_, "-o", output}).exit_code, 0);
  const std::string text = read_text(output);
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1 + 600);
  EXPECT_EQ(std::count(text.begin(), text.end(), ','), (1 + 600) * 14);
}

TEST_F(Cli, UsesTheClosedLoopByDefault) {
  const json report = compress({});
  EXPECT_EQ(report["method"], "closed-loop");
  EXPECT_EQ(report["coding"], "adaptive");
  EXPECT_TRUE(report["iterations"].is_null());
}

TEST_F(Cli, TakesMoreCareOfWhatIsImportant) {
  const std::string walk = std::string(MOCAPRESS_SOURCE_DIR) + "/resources/samples/human_walk.amc";
  const auto footskate = [&](std::vector<std::string> importance) {
    std::vector<std::string> words = {"compress", walk, "--ratio", "150", "--json"};
    words.insert(words.end(), importance.begin(), importance.end());
    return json_of(words)["footskate_cm"].get<double>();
  };
  EXPECT_LT(footskate({"--importance", "contacts=20"}), 0.5 * footskate({}));
  for (const char* wrong : {"feat=2", "feet", "feet=much", "feet=-1"}) {
    const auto refused = mocapress({"compress", walk, "--importance", wrong});
    EXPECT_EQ(refused.exit_code, 2) << wrong;
    EXPECT_NE(refused.err.find("--importance"), std::string::npos) << refused.err;
  }
}

TEST_F(Cli, TakesMoreCareOfARange) {
  const std::string walk = std::string(MOCAPRESS_SOURCE_DIR) + "/resources/samples/human_walk.amc";
  const auto bytes = [&](std::vector<std::string> words) {
    words.insert(words.begin(), {"compress", walk, "--target-error", "0.5", "--json"});
    return json_of(words)["motion_bytes"].get<int>();
  };
  const int plain = bytes({});
  EXPECT_GT(bytes({"--importance-range", "40-80=4"}), plain);
  EXPECT_GT(bytes({"--importance-range", "1-10=2,40-80=4"}),
            bytes({"--importance-range", "40-80=4"}));
  EXPECT_EQ(bytes({"--importance-range", "40-80=1"}), plain);
  for (const char* wrong :
       {"40", "40-80", "80-40=2", "-1-5=2", "0-5=2", "1-100000=2", "1-5=0.5", "1-5=x"}) {
    const auto refused = mocapress({"compress", walk, std::string("--importance-range=") + wrong});
    EXPECT_EQ(refused.exit_code, 2) << wrong;
    EXPECT_FALSE(refused.err.empty()) << wrong;
  }
}

TEST_F(Cli, InfoDescribesEveryKindOfFile) {
  compress({});
  ASSERT_EQ(mocapress({"decompress", packed_, "-o", file("back.amc")}).exit_code, 0);
  const json all = json_of({"info", clip_, packed_, file("back.amc"), "--json"});
  ASSERT_EQ(all.size(), 3u);
  for (const json& one : all) {
    EXPECT_EQ(one["frames"], 600) << one;
    EXPECT_NEAR(one["sample_rate_hz"].get<double>(), 120, 1e-3) << one;
  }
  EXPECT_EQ(all[1]["method"], "closed-loop");
  EXPECT_EQ(all[1]["basis"], "cubic");
  EXPECT_EQ(all[1]["segments"], 1);
  EXPECT_EQ(all[1]["file_bytes"], std::filesystem::file_size(packed_));
  EXPECT_TRUE(all[0]["warnings"].is_array());
}

TEST_F(Cli, InfoSaysWhichJointsABvhNamesOtherwise) {
  const std::string odd = write("odd.bvh",
                                "HIERARCHY\nROOT L Thigh\n{\nOFFSET 0 0 0\nCHANNELS 1 Xrotation\n"
                                "JOINT not \xff UTF-8\n{\nOFFSET 0 90 0\nCHANNELS 1 Xrotation\n}\n"
                                "JOINT plain\n{\nOFFSET 0 90 0\nCHANNELS 1 Xrotation\n}\n}\n"
                                "MOTION\nFrames: 2\nFrame Time: 0.01\n0 1 2\n3 4 5\n");
  ASSERT_EQ(mocapress({"compress", odd, "-o", file("odd.mcpr"), "--max-error", "1"}).exit_code, 0);
  const json names = json_of({"info", file("odd.mcpr"), "--json"})[0]["bvh_names"];
  EXPECT_EQ(names, json({{"L_Thigh", "L Thigh"}, {"not___UTF-8", "not \uFFFD UTF-8"}}));
}

TEST_F(Cli, BenchReportsExactlyTheDocumentedKeys) {
  const json figures = json_of({"bench", clip_, "--json"});
  const std::set<std::string> measured = {"decode_us_per_frame",
                                          "copy_us_per_frame",
                                          "window_us_per_frame",
                                          "pose_us",
                                          "positions_us_per_frame",
                                          "open_us",
                                          "motion_bytes",
                                          "resident_bytes",
                                          "annealed_seconds",
                                          "annealed_iterations",
                                          "annealed_us_per_iteration",
                                          "reference_us_per_iteration",
                                          "closed_loop_seconds",
                                          "closed_loop_frames_per_second",
                                          "draft_ms",
                                          "coded_draft_ms"};
  std::set<std::string> keys = {"ik_us_per_frame", "ik_cyclic_descent_us_per_frame"};
  for (const std::string& key : measured)
    EXPECT_TRUE(figures.contains(key) && figures[key].is_number() && figures[key] > 0) << key;
  keys.insert(measured.begin(), measured.end());
  EXPECT_EQ(keys_of(figures), keys);
}

TEST_F(Cli, SamplesCompress) {
  const std::filesystem::path samples =
      std::filesystem::path(MOCAPRESS_SOURCE_DIR) / "resources/samples";
  int clips = 0;
  for (const auto& entry : std::filesystem::directory_iterator(samples)) {
    const std::string extension = entry.path().extension();
    if (extension != ".amc" && extension != ".bvh") continue;
    ++clips;
    const json report = json_of({"compress", entry.path(), "--method", "standard", "--json"});
    EXPECT_NEAR(report["ratio"].get<double>() / 25, 1, 0.02) << entry.path();
  }
  EXPECT_GE(clips, 3);
}

TEST_F(Cli, InfoDividesTheBytesOfAFile) {
  const json report = compress({});
  const json info = json::parse(mocapress({"info", packed_, "--bytes", "--json"}).out)[0];
  const json& bytes = info["bytes"];
  EXPECT_EQ(bytes["joints"].size(), report["joints"].get<std::size_t>());
  double sum = 0;
  for (const json& one : bytes["joints"]) sum += one["bytes"].get<double>();
  double by_second = 0;
  for (const json& one : bytes["seconds"]) by_second += one.get<double>();
  EXPECT_NEAR(sum, by_second, 1e-6);
  for (const json& one : bytes["rest"]) sum += one["bytes"].get<double>();
  EXPECT_NEAR(sum, info["file_bytes"].get<double>(), 1e-6);
  EXPECT_THAT(mocapress({"info", packed_, "--bytes"}).out, testing::HasSubstr("bytes by second"));
  EXPECT_FALSE(json::parse(mocapress({"info", packed_, "--json"}).out)[0].contains("bytes"));
}

TEST_F(Cli, ViewersWhoAreNearerNoticeMore) {
  compress({"--target-error", "2"});
  const auto seen = [&](const std::vector<std::string>& options) {
    std::vector<std::string> all = {"measure", clip_, packed_, "--json"};
    all.insert(all.end(), options.begin(), options.end());
    return json_of(all)["times_noticed"].get<double>();
  };
  EXPECT_GT(seen({"--distance", "1"}), seen({}));
  EXPECT_EQ(seen({"--distance", "5"}), seen({}));
  EXPECT_THAT(mocapress({"measure", clip_, packed_, "--distance", "8"}).err,
              testing::HasSubstr(" from 8 m"));
  const std::string blind = write("limits.json", R"({"distance_m": 100})");
  EXPECT_LT(seen({"--limits", blind}), seen({}));
  const Outcome bad = mocapress(
      {"measure", clip_, packed_, "--limits", write("bad.json", R"({"hands": {"least": 1}})")});
  EXPECT_EQ(bad.exit_code, 3);
  EXPECT_THAT(bad.err, testing::HasSubstr("bad.json: \"hands\" is unknown"));
}

TEST_F(Cli, PresetsAreThoseOfABatchAndOptionsReplaceTheirParts) {
  const std::string mine = write(
      "mine.json",
      R"({"name": "Mine", "target": {"kind": "error", "value": 0.4}, "importance": {"feet": 4},
          "promises": {"hand_degrees": 3}, "importance_ranges": [
          {"first_frame": 40, "last_frame": 80, "factor": 3}]})");
  for (const std::vector<std::string>& options : std::initializer_list<std::vector<std::string>>{
           {"--preset", "planted-feet"},
           {"--preset", "gameplay", "--target-error", "0.4"},
           {"--preset", mine},
           {"--preset", mine, "--target-error", "0.6", "--importance", "spine=2"}}) {
    std::vector<std::string> words = {"batch", clip_, "-o", file("out"), "--name", "made"};
    words.insert(words.end(), options.begin(), options.end());
    words.emplace_back("--overwrite");
    ASSERT_EQ(mocapress(words).exit_code, 0);
    compress(options);
    EXPECT_EQ(read_bytes(packed_), read_bytes(file("out") / "made.mcpr")) << options.back();
  }
  compress({});
  const auto plain = read_bytes(packed_);
  compress({"--ratio", "25"});
  EXPECT_EQ(read_bytes(packed_), plain);
  EXPECT_EQ(mocapress({"compress", clip_, "--preset", "nothing"}).exit_code, 3);
}

TEST_F(Cli, HelpAndVersionSucceed) {
  EXPECT_EQ(mocapress({"--help"}).exit_code, 0);
  EXPECT_EQ(mocapress({"--version"}).exit_code, 0);
  for (const char* command :
       {"info", "compress", "decompress", "measure", "contacts", "bench", "study"})
    EXPECT_EQ(mocapress({command, "--help"}).exit_code, 0) << command;
}

}  // namespace
}  // namespace mocapress::test
