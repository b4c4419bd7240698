// SPDX-License-Identifier: MIT
// Files of every released version stay readable: see README.md beside this file.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstring>
#include <filesystem>
#include <sstream>

#include "core/bank/bank.h"
#include "core/base/file.h"
#include "core/codec/decode/decoder.h"
#include "core/codec/format/container.h"
#include "core/codec/format/packed_clip_writer.h"
#include "core/codec/format/source_section.h"
#include "core/codec/format/tiers.h"
#include "core/formats/csv.h"
#include "tests/golden/golden_motion.h"
#include "tests/support/opened_clip.h"
#include "tests/support/some_tracks.h"

namespace mocapress::test {
namespace {

constexpr double kValueTolerance = 2e-5;     // cm or radians; the decoder returns 32-bit floats
constexpr double kSolvedTolerance = 1e-4;    // for angles found by a solver
constexpr double kSkeletonTolerance = 1e-5;  // cm; files hold 32-bit floats

std::filesystem::path golden(const std::string& name) {
  return std::filesystem::path(MOCAPRESS_SOURCE_DIR) / "tests/golden" / name;
}

CompressedClip golden_file(const std::string& name) {
  return read_container(read_bytes(golden(name)));
}

std::string file_name(Coding coding) {
  return "v1_" + std::string(name(coding)) + ".mcpr";
}

/// The values of a .csv written by csv_text(): frames x channels.
Eigen::MatrixXd values_of_csv(const std::string& text, Eigen::Index frames, Eigen::Index channels) {
  std::istringstream lines(text);
  std::string line;
  std::getline(lines, line);
  Eigen::MatrixXd values(frames, channels);
  for (Eigen::Index t = 0; t < frames; ++t) {
    std::getline(lines, line);
    std::istringstream cells(line);
    std::string cell;
    std::getline(cells, cell, ',');  // skips the time
    for (Eigen::Index c = 0; c < channels; ++c) {
      std::getline(cells, cell, ',');
      values(t, c) = std::stod(cell);
    }
  }
  return values;
}

void expect_golden_skeleton(const Skeleton& skeleton) {
  const Skeleton expected = golden_motion().skeleton;
  ASSERT_EQ(skeleton.joint_count(), expected.joint_count());
  for (int j = 0; j < expected.joint_count(); ++j) {
    const Joint& joint = skeleton.joint(j);
    const Joint& wanted = expected.joint(j);
    EXPECT_EQ(joint.name, wanted.name);
    EXPECT_EQ(joint.parent, wanted.parent);
    EXPECT_EQ(joint.channels, wanted.channels);
    EXPECT_LT((joint.offset - wanted.offset).norm(), kSkeletonTolerance);
    EXPECT_LT((joint.joint_from_axes - wanted.joint_from_axes).norm(), kSkeletonTolerance);
    ASSERT_EQ(joint.end_site.has_value(), wanted.end_site.has_value());
    if (!wanted.end_site) continue;
    EXPECT_LT((*joint.end_site - *wanted.end_site).norm(), kSkeletonTolerance);
  }
}

class Golden : public testing::TestWithParam<Coding> {};

TEST_P(Golden, Version1ReadsAsItAlwaysDid) {
  const CompressedClip clip = golden_file(file_name(GetParam()));
  expect_golden_skeleton(clip.skeleton);
  EXPECT_EQ(clip.sample_rate_hz, 60);
  EXPECT_EQ(clip.basis, Basis::Cubic);
  EXPECT_EQ(clip.coding, GetParam());
  EXPECT_EQ(clip.provenance.method, Method::PerChannel);
  EXPECT_EQ(clip.provenance.weighting, Weighting::JointOrigins);
  EXPECT_EQ(clip.provenance.seed, 42u);
  EXPECT_EQ(clip.provenance.eps_cm, 0.5F);
  EXPECT_EQ(clip.provenance.max_error_cm, 1.5F);
  const Clip decoded = decode(clip);
  ASSERT_EQ(decoded.frames(), 50);
  const Eigen::MatrixXd expected =
      values_of_csv(read_text(golden("v1_expected.csv")), 50, clip.skeleton.channel_count());
  EXPECT_LT((decoded.channels - expected).cwiseAbs().maxCoeff(), kValueTolerance);
}

TEST_P(Golden, TheWriterStillMakesTheSameMotion) {
  const Clip now = decode(golden_clip(GetParam()));
  const Clip then = decode(golden_file(file_name(GetParam())));
  EXPECT_LT((now.channels - then.channels).cwiseAbs().maxCoeff(), kValueTolerance);
}

INSTANTIATE_TEST_SUITE_P(Version1, Golden, testing::Values(Coding::Rle16, Coding::Deflate),
                         [](const auto& coding) { return std::string(name(coding.param)); });

TEST(GoldenCorrection, Version1ReadsAsItAlwaysDid) {
  const CompressedClip clip = golden_file("v1_correction.mcpr");
  ASSERT_TRUE(clip.correction);
  EXPECT_EQ(clip.correction->solver, IkSolver::NearestPose);
  const Eigen::MatrixXd expected = values_of_csv(read_text(golden("v1_correction_expected.csv")),
                                                 50, clip.skeleton.channel_count());
  EXPECT_LT((decode(clip).channels - expected).cwiseAbs().maxCoeff(), kSolvedTolerance);
}

TEST(GoldenAdaptive, Version1ReadsAsItAlwaysDid) {
  const CompressedClip clip = golden_file("v1_joints.mcpr");
  EXPECT_EQ(clip.coding, Coding::Adaptive);
  const Eigen::MatrixXd expected =
      values_of_csv(read_text(golden("v1_joints_expected.csv")), 50, clip.skeleton.channel_count());
  EXPECT_LT((decode(clip).channels - expected).cwiseAbs().maxCoeff(), kValueTolerance);
}

/// The runtime decoder's output, frames x channels, as bytes.
std::vector<std::byte> played(const std::vector<std::byte>& file) {
  const OpenedClip clip(file);
  EXPECT_NE(clip.clip, nullptr) << clip.result.message;
  if (clip.clip == nullptr) return {};
  const std::vector<float> frames = clip.frames({}, 0, clip.info.frames);
  const auto bytes = std::as_bytes(std::span(frames));
  return {bytes.begin(), bytes.end()};
}

TEST(GoldenJoints, Version1PlaysToTheSameBits) {
  const std::vector<std::byte> file = read_bytes(golden("v1_joints.mcpr"));
  EXPECT_TRUE(played(file) == read_bytes(golden("v1_joints_expected.f32")));
  expect_golden_skeleton(read_container(file).skeleton);
}

TEST(GoldenJoints, TheWriterStillMakesTheSameFile) {
  EXPECT_TRUE(write_container(golden_adaptive_clip()) == read_bytes(golden("v1_joints.mcpr")));
}

TEST(GoldenEnds, Version1PlaysToTheSameBits) {
  const std::vector<std::byte> file = read_bytes(golden("v1_ends.mcpr"));
  EXPECT_TRUE(played(file) == read_bytes(golden("v1_ends_expected.f32")));
  EXPECT_EQ(read_container(file).loop, Loop::Follows);
}

TEST(GoldenEnds, TheWriterStillMakesTheSameFile) {
  EXPECT_TRUE(write_container(golden_ends_clip()) == read_bytes(golden("v1_ends.mcpr")));
}

TEST(GoldenVelocity, Version1PlaysToTheSameBits) {
  const std::vector<std::byte> file = read_bytes(golden("v1_velocity.mcpr"));
  EXPECT_TRUE(played(file) == read_bytes(golden("v1_velocity_expected.f32")));
  EXPECT_GT(read_container(file).ends->count(), runtime::kVelocity);
}

TEST(GoldenVelocity, TheWriterStillMakesTheSameFile) {
  EXPECT_TRUE(write_container(golden_velocity_clip()) == read_bytes(golden("v1_velocity.mcpr")));
}

/// Joint positions in cm by the runtime decoder.
std::vector<float> positions(const std::vector<std::byte>& file) {
  const OpenedClip clip(file);
  EXPECT_NE(clip.clip, nullptr) << clip.result.message;
  if (clip.clip == nullptr) return {};
  return clip.frames({.output = MCPR_POSITIONS}, 0, clip.info.frames);
}

TEST(GoldenAxes, Version1PutsJointsWhereItAlwaysDid) {
  const std::vector<float> found = positions(read_bytes(golden("v1_axes.mcpr")));
  const std::vector<std::byte> bytes = read_bytes(golden("v1_axes_expected.f32"));
  std::vector<float> expected(bytes.size() / sizeof(float));
  std::memcpy(expected.data(), bytes.data(), bytes.size());
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) ASSERT_NEAR(found[i], expected[i], 1e-3) << i;
}

TEST(GoldenAxes, TheWriterStillMakesTheSameFile) {
  EXPECT_TRUE(write_container(golden_turned_clip()) == read_bytes(golden("v1_axes.mcpr")));
}

TEST(GoldenSegments, Version1PlaysToTheSameBits) {
  const std::vector<std::byte> file = read_bytes(golden("v1_segments.mcpr"));
  EXPECT_TRUE(played(file) == read_bytes(golden("v1_segments_expected.f32")));
  EXPECT_EQ(read_container(file).segment_layout().count(), 3);
}

TEST(GoldenSegments, TheWriterStillMakesTheSameFile) {
  EXPECT_TRUE(write_container(golden_segmented_clip()) == read_bytes(golden("v1_segments.mcpr")));
}

/// The same motion in three tiers.
std::vector<std::byte> golden_tiers() {
  const auto error = [](std::span<const std::byte> file, int tiers) {
    return TierError{0.5F * static_cast<float>(sections_of(file, tiers).bands_left_out()), 2};
  };
  return with_tiers(read_bytes(golden("v1_segments.mcpr")), 3, error);
}

TEST(GoldenTiers, StayTheSame) {
  const std::vector<std::byte> file = read_bytes(golden("v1_tiers.mcpr"));
  EXPECT_TRUE(played(file) == read_bytes(golden("v1_segments_expected.f32")));
  EXPECT_TRUE(golden_tiers() == file);
}

/// A packed bank of clips without tiers and with them.
void write_tiers_bank(const std::filesystem::path& path, bool has_segments) {
  BankWriter bank(path, runtime::BankForm::Packed);
  const InternItem intern = [&](runtime::BankItem kind, std::span<const std::byte> bytes) {
    return bank.intern(kind, bytes);
  };
  const auto add = [&](const char* name, const std::vector<std::byte>& file) {
    const PackedClip clip = pack_clip(file);
    bank.add(name, intern_outline(clip, intern), clip.bytes, {}, clip.pieces);
  };
  const auto unmeasured = [](std::span<const std::byte>, int) { return TierError{1, 2}; };
  add("v1_ends", with_tiers(read_bytes(golden("v1_ends.mcpr")), 2, unmeasured));
  add("v1_joints", read_bytes(golden("v1_joints.mcpr")));
  if (has_segments) add("v1_tiers", read_bytes(golden("v1_tiers.mcpr")));
  bank.finish({});
}

/// A bank whose finest tier was cut off.
void write_stripped_bank(const std::filesystem::path& path) {
  const auto whole = std::filesystem::path(testing::TempDir()) /
                     ("golden_whole_bank" + std::to_string(getpid()) + ".mcpk");
  write_tiers_bank(whole, false);
  strip_bank(whole, path, 1);
  std::filesystem::remove(whole);
}

TEST(GoldenTiersBank, StaysTheSameAndSoDoesACutOne) {
  const auto now = std::filesystem::path(testing::TempDir()) /
                   ("golden_tiers_bank" + std::to_string(getpid()) + ".mcpk");
  write_tiers_bank(now, true);
  EXPECT_TRUE(read_bytes(now) == read_bytes(golden("v1_tiers.mcpk")));
  write_stripped_bank(now);
  EXPECT_TRUE(read_bytes(now) == read_bytes(golden("v1_stripped.mcpk")));
  std::filesystem::remove(now);
}

TEST(GoldenTiersBank, Version1PlaysToTheSameBits) {
  const BankFile whole(golden("v1_tiers.mcpk"));
  ASSERT_EQ(whole.clips(), 3U);
  EXPECT_TRUE(whole.extract(whole.entry(2)) == read_bytes(golden("v1_tiers.mcpr")));
  const BankFile stripped(golden("v1_stripped.mcpk"));
  ASSERT_EQ(stripped.clips(), 2U);
  EXPECT_TRUE(played(stripped.extract(stripped.entry(0))) ==
              read_bytes(golden("v1_coarse_expected.f32")));
  EXPECT_TRUE(played(stripped.extract(stripped.entry(1))) ==
              read_bytes(golden("v1_joints_expected.f32")));
}

const SourceFormat kGoldenSource{.kind = SourceFormat::Kind::Bvh,
                                 .cm_per_unit = 2.54,
                                 .up = UpAxis::Z,
                                 .root = TranslationConvention::Replaces};

TEST(GoldenSource, Version1SaysWhatItAlwaysDid) {
  const std::vector<std::byte> file = read_bytes(golden("v1_source.mcpr"));
  EXPECT_EQ(source_of(file), kGoldenSource);
  EXPECT_TRUE(played(file) == read_bytes(golden("v1_joints_expected.f32")));
}

TEST(GoldenSource, TheWriterStillMakesTheSameFile) {
  EXPECT_TRUE(with_source(write_container(golden_adaptive_clip()), kGoldenSource) ==
              read_bytes(golden("v1_source.mcpr")));
}

std::vector<std::byte> golden_tracks_file() {
  const CompressedClip clip = golden_adaptive_clip();
  return with_coded_tracks(write_container(clip), some_coded_tracks(clip.frames));
}

/// All tracks at all frames by the runtime decoder.
std::vector<std::byte> played_tracks(const std::vector<std::byte>& file) {
  const OpenedClip clip(file);
  EXPECT_NE(clip.clip, nullptr) << clip.result.message;
  if (clip.clip == nullptr) return {};
  const std::vector<float> frames = clip.tracks(0, clip.info.frames);
  const auto bytes = std::as_bytes(std::span(frames));
  return {bytes.begin(), bytes.end()};
}

TEST(GoldenTracks, Version1PlaysToTheSameBits) {
  const std::vector<std::byte> file = read_bytes(golden("v1_tracks.mcpr"));
  EXPECT_TRUE(played_tracks(file) == read_bytes(golden("v1_tracks_expected.f32")));
  EXPECT_TRUE(played(file) == read_bytes(golden("v1_joints_expected.f32")));
}

TEST(GoldenTracks, TheWriterStillMakesTheSameFile) {
  EXPECT_TRUE(golden_tracks_file() == read_bytes(golden("v1_tracks.mcpr")));
}

/// The golden files of the bank's clips.
std::vector<std::filesystem::path> files_of_bank() {
  std::vector<std::filesystem::path> files;
  for (const char* name : {"joints", "ends", "segments", "source", "tracks"})
    files.push_back(golden("v1_" + std::string(name) + ".mcpr"));
  return files;
}

TEST(GoldenBank, Version1GivesItsFilesBack) {
  const BankFile bank(golden("v1_bank.mcpk"));
  ASSERT_EQ(bank.clips(), files_of_bank().size());
  for (const std::filesystem::path& file : files_of_bank()) {
    const std::string name = file.stem().string();
    const std::int64_t clip = runtime::find_clip(bank.bank(), name.data(), name.size());
    ASSERT_GE(clip, 0) << name;
    EXPECT_TRUE(bank.extract(bank.entry(static_cast<std::uint32_t>(clip))) == read_bytes(file))
        << name;
  }
}

TEST(GoldenBank, TheWriterStillMakesTheSameFile) {
  const auto now = std::filesystem::path(testing::TempDir()) /
                   ("golden_bank" + std::to_string(getpid()) + ".mcpk");
  make_bank(now, find_bank_sources(files_of_bank()), {});
  EXPECT_TRUE(read_bytes(now) == read_bytes(golden("v1_bank.mcpk")));
  std::filesystem::remove(now);
}

/// Its clips learn from each other; the segmented clip is coded as in its file.
void write_learned_bank(const std::filesystem::path& path) {
  BankWriter bank(path, runtime::BankForm::Packed);
  const InternItem intern = [&](runtime::BankItem kind, std::span<const std::byte> bytes) {
    return bank.intern(kind, bytes);
  };
  const std::vector<std::byte> lesson = golden_lesson();
  for (const char* const name : {"v1_ends", "v1_joints", "v1_segments"}) {
    const PackedClip clip = pack_clip(read_bytes(golden(std::string(name) + ".mcpr")), lesson);
    bank.add(name, intern_outline(clip, intern), clip.bytes, {});
  }
  bank.finish({});
}

TEST(GoldenLearnedBank, Version1GivesItsFilesBackAndPlays) {
  const BankFile bank(golden("v1_learned.mcpk"));
  ASSERT_EQ(bank.clips(), 3U);
  for (std::uint32_t clip = 0; clip < bank.clips(); ++clip) {
    const runtime::BankEntry entry = bank.entry(clip);
    const std::vector<std::byte> file = read_bytes(golden(std::string(entry.name) + ".mcpr"));
    EXPECT_TRUE(bank.extract(entry) == file) << entry.name;
    EXPECT_TRUE(bank.play(clip)) << entry.name;
    const bool is_shorter = bank.describe(clip).motion_bytes < sections_of(file).motion_bytes();
    EXPECT_EQ(is_shorter, std::string(entry.name) != "v1_segments") << entry.name;
  }
}

TEST(GoldenLearnedBank, TheWriterStillMakesTheSameFile) {
  const auto now = std::filesystem::path(testing::TempDir()) /
                   ("golden_learned_bank" + std::to_string(getpid()) + ".mcpk");
  write_learned_bank(now);
  EXPECT_TRUE(read_bytes(now) == read_bytes(golden("v1_learned.mcpk")));
  std::filesystem::remove(now);
}

TEST(GoldenBytes, TheWriterStillMakesTheSameRle16Files) {
  EXPECT_TRUE(write_container(golden_clip(Coding::Rle16)) == read_bytes(golden("v1_rle16.mcpr")));
  EXPECT_TRUE(write_container(golden_corrected_clip()) == read_bytes(golden("v1_correction.mcpr")));
}

TEST(GoldenBytes, DISABLED_AreWrittenAnew) {
  for (const Coding coding : {Coding::Rle16, Coding::Deflate})
    write_bytes(golden(file_name(coding)), write_container(golden_clip(coding)));
  const auto write_expected = [](const char* file, const CompressedClip& clip) {
    write_text(golden(file), csv_text({clip.skeleton, decode(clip)}));
  };
  write_expected("v1_expected.csv", golden_clip(Coding::Rle16));
  write_bytes(golden("v1_joints.mcpr"), write_container(golden_adaptive_clip()));
  write_expected("v1_joints_expected.csv", golden_adaptive_clip());
  write_bytes(golden("v1_joints_expected.f32"), played(write_container(golden_adaptive_clip())));
  write_bytes(golden("v1_source.mcpr"),
              with_source(write_container(golden_adaptive_clip()), kGoldenSource));
  write_bytes(golden("v1_tracks.mcpr"), golden_tracks_file());
  write_bytes(golden("v1_tracks_expected.f32"), played_tracks(golden_tracks_file()));
  write_bytes(golden("v1_ends.mcpr"), write_container(golden_ends_clip()));
  write_bytes(golden("v1_ends_expected.f32"), played(write_container(golden_ends_clip())));
  write_bytes(golden("v1_velocity.mcpr"), write_container(golden_velocity_clip()));
  write_bytes(golden("v1_velocity_expected.f32"), played(write_container(golden_velocity_clip())));
  write_bytes(golden("v1_axes.mcpr"), write_container(golden_turned_clip()));
  const std::vector<float> places = positions(write_container(golden_turned_clip()));
  write_bytes(golden("v1_axes_expected.f32"), std::as_bytes(std::span(places)));
  write_bytes(golden("v1_segments.mcpr"), write_container(golden_segmented_clip()));
  write_bytes(golden("v1_tiers.mcpr"), golden_tiers());
  write_bytes(golden("v1_segments_expected.f32"), played(write_container(golden_segmented_clip())));
  write_bytes(golden("v1_correction.mcpr"), write_container(golden_corrected_clip()));
  write_expected("v1_correction_expected.csv", golden_corrected_clip());
  make_bank(golden("v1_bank.mcpk"), find_bank_sources(files_of_bank()), {});
  write_learned_bank(golden("v1_learned.mcpk"));
  write_tiers_bank(golden("v1_tiers.mcpk"), true);
  write_stripped_bank(golden("v1_stripped.mcpk"));
  const BankFile stripped(golden("v1_stripped.mcpk"));
  write_bytes(golden("v1_coarse_expected.f32"), played(stripped.extract(stripped.entry(0))));
}

}  // namespace
}  // namespace mocapress::test
