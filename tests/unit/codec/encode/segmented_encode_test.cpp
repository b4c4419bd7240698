// SPDX-License-Identifier: MIT
#include "core/codec/encode/segmented_encode.h"

#include <gtest/gtest.h>

#include <tbb/global_control.h>
#include <cmath>
#include <cstring>
#include <functional>

#include "core/base/error.h"
#include "core/base/random.h"
#include "core/codec/decode/decoder.h"
#include "core/codec/encode/encoder.h"
#include "core/codec/format/container.h"
#include "core/metrics/rate.h"
#include "resources/samples/generator/samples.h"
#include "tests/fuzz/file_sections.h"
#include "tests/support/opened_clip.h"
#include "tests/support/segmented_clip.h"
#include "tests/support/test_motion.h"

namespace mocapress::segmented_encode_test {
namespace {

using File = std::vector<std::byte>;

TEST(EvenSegments, AreFewAndAboutEvenAndAllowedByTheFormat) {
  Random random(1);
  for (int round = 0; round < 2000; ++round) {
    const SegmentPlan plan{256 + static_cast<int>(random.below(5000)),
                           1 + static_cast<int>(random.below(128))};
    const auto frames = static_cast<int>(random.below(100'000));
    const SegmentLayout layout = even_segments(frames, plan);
    ASSERT_EQ(layout.frames, frames);
    if (frames <= plan.longest) {
      ASSERT_EQ(layout.count(), 1);
      continue;
    }
    ASSERT_TRUE(runtime::may_be_segments(static_cast<std::uint32_t>(frames),
                                         static_cast<std::uint32_t>(layout.length),
                                         static_cast<std::uint32_t>(layout.overlap)));
    ASSERT_LE(layout.length, plan.longest);
    const int fewest = SegmentLayout{frames, plan.longest, layout.overlap}.count();
    ASSERT_LE(layout.count(), fewest);
    // As long as there are not more segments than frames in one, the last is about as long.
    if (fewest < layout.length / 8 && layout.length > 256) {
      ASSERT_GT(layout.frames_of(layout.count() - 1), layout.length / 2);
    }
  }
}

TEST(FramesOf, ContactsAreCountedFromTheFirstFrameAndEndWithTheLast) {
  const std::vector<ContactSpan> contacts = {{1, 0, 9}, {2, 5, 30}, {3, 20, 24}, {4, 30, 40}};
  const std::vector<ContactSpan> expected = {{2, 0, 19}, {3, 10, 14}};
  EXPECT_EQ(frames_of(contacts, 10, 20), expected);
}

const CompressedClip& clip() {
  static const CompressedClip shared =
      test::segmented_clip(test::smooth_motion(600), {600, 256, 40}, true, 0.03);
  return shared;
}

const File& file() {
  static const File shared = write_container(clip());
  return shared;
}

TEST(Segments, AreReadBackAsTheyWereWritten) {
  const CompressedClip read = read_container(file());
  ASSERT_TRUE(read.segments);
  EXPECT_EQ(read.segments->length, 256);
  EXPECT_EQ(read.segments->overlap, 40);
  EXPECT_EQ(read.segments->bytes, clip().segments->bytes);
  EXPECT_EQ(read.motion, clip().motion);
  EXPECT_TRUE(decode_uncorrected(read).clip.channels == decode_uncorrected(clip()).clip.channels);
  EXPECT_TRUE(decode_uncorrected(read).differences == decode_uncorrected(clip()).differences);
  EXPECT_EQ(read.motion_bytes(), read.motion.size() + 12 + 4 * 3 + 2 + 4 * 2);
  EXPECT_EQ(test::OpenedClip(file()).info.motion_bytes, read.motion_bytes());
}

TEST(Segments, TheCorrectionTakesWhatTheMotionAloneWouldNot) {
  CompressedClip without =
      test::segmented_clip(test::smooth_motion(600), {600, 256, 40}, false, 0.03);
  EXPECT_EQ(clip().correction_bytes(), clip().motion_bytes() - without.motion_bytes());
}

TEST(Segments, EveryPrefixAndEveryFlippedBitIsRefused) {
  for (std::size_t size = 0; size < file().size(); ++size) {
    const File prefix(file().begin(), file().begin() + static_cast<long>(size));
    EXPECT_THROW(read_container(prefix), FormatError) << size;
    EXPECT_EQ(test::OpenedClip(prefix).clip, nullptr) << size;
  }
  for (std::size_t bit = 0; bit < 8 * file().size(); bit += 5) {
    File flipped = file();
    flipped[bit / 8] ^= static_cast<std::byte>(1 << (bit % 8));
    EXPECT_THROW(read_container(flipped), FormatError) << bit;
    EXPECT_EQ(test::OpenedClip(flipped).clip, nullptr) << bit;
  }
}

std::size_t start_of(const File& bytes, const char* tag) {
  for (std::size_t at = 8; at + 12 <= bytes.size();) {
    if (std::memcmp(bytes.data() + at, tag, 4) == 0) return at;
    std::uint32_t size = 0;
    std::memcpy(&size, bytes.data() + at + 4, 4);
    at += 12 + size;
  }
  return bytes.size();
}

/// Both readers refuse it; where, within the section SEGS, or somewhere in MOTN.
void expect_refused(File changed, std::size_t first_offset, std::size_t last_offset,
                    const char* why) {
  test::mend_checksums(changed);
  const test::OpenedClip opened(changed);
  EXPECT_EQ(opened.clip, nullptr) << why;
  EXPECT_EQ(opened.result.status, MCPR_INVALID) << why;
  EXPECT_GE(opened.result.offset, first_offset) << why;
  EXPECT_LE(opened.result.offset, last_offset) << why;
  try {
    decode(read_container(changed));
    ADD_FAILURE() << why;
  } catch (const FormatError& error) {
    // While decoding, core counts offsets from the motion's first byte.
    const bool in_headers = last_offset < start_of(changed, "MOTN");
    if (in_headers) {
      EXPECT_EQ(error.byte_offset(), opened.result.offset) << why;
    }
  }
}

TEST(Segments, ImpossibleOnesAreRefusedWhereTheyStand) {
  const std::size_t payload = start_of(file(), "SEGS") + 12;
  const auto changed = [&](std::size_t field, std::uint32_t value) {
    File bytes = file();
    std::memcpy(bytes.data() + payload + 4 * field, &value, 4);
    return bytes;
  };
  for (const std::uint32_t length : {0U, 255U, 600U, 0xFFFFFFFFU})
    expect_refused(changed(0, length), payload, payload, "length");
  for (const std::uint32_t overlap : {0U, 129U, 256U, 0xFFFFFFFFU})
    expect_refused(changed(1, overlap), payload, payload, "overlap");
  for (const std::uint32_t count : {0U, 1U, 2U, 4U, 0xFFFFFFFFU})
    expect_refused(changed(2, count), payload + 8, payload + 8, "segments");
  const std::uint32_t size = clip().segments->bytes[1];
  for (const std::uint32_t wrong : {0U, size - 1, size + 1, 0xFFFFFFFFU})
    expect_refused(changed(4, wrong), payload + 12, payload + 12, "sizes");
}

TEST(Segments, BytesOfANeighbourAreRefusedInTheMotion) {
  const std::size_t payload = start_of(file(), "SEGS") + 12;
  const std::size_t motion = start_of(file(), "MOTN") + 12;
  const std::vector<std::uint32_t>& sizes = clip().segments->bytes;
  for (const int moved : {-static_cast<int>(sizes[0]), -40, -6, 6, 40}) {
    File bytes = file();
    const auto first = static_cast<std::uint32_t>(static_cast<int>(sizes[0]) + moved);
    const auto second = static_cast<std::uint32_t>(static_cast<int>(sizes[1]) - moved);
    std::memcpy(bytes.data() + payload + 12, &first, 4);
    std::memcpy(bytes.data() + payload + 16, &second, 4);
    expect_refused(bytes, motion, motion + clip().motion.size(), "boundary");
  }
}

TEST(Segments, SectionsOutOfPlaceAreRefused) {
  const std::size_t segments = start_of(file(), "SEGS");
  const std::size_t motion = start_of(file(), "MOTN");
  const File section(file().begin() + static_cast<long>(segments),
                     file().begin() + static_cast<long>(motion));
  const auto with_section_at = [&](std::size_t at, bool moved) {
    File bytes = file();
    bytes.insert(bytes.begin() + static_cast<long>(at), section.begin(), section.end());
    if (moved)
      bytes.erase(bytes.begin() + static_cast<long>(segments),
                  bytes.begin() + static_cast<long>(motion));
    else
      bytes[6] = static_cast<std::byte>(std::to_integer<int>(bytes[6]) + 1);
    return bytes;
  };
  const std::size_t end = file().size();
  const std::function<void(const File&)> refused = [](const File& bytes) {
    EXPECT_THROW(read_container(bytes), FormatError);
    EXPECT_EQ(test::OpenedClip(bytes).clip, nullptr);
  };
  refused(with_section_at(segments, false));  // twice
  refused(with_section_at(end, true));        // after the motion
  refused(with_section_at(start_of(file(), "CLIP"), true) /* before CLIP */);
  // One that is shorter, or longer, than its segments need.
  for (const int more : {-4, 4}) {
    File bytes = file();
    const auto size = static_cast<std::uint32_t>(static_cast<int>(section.size()) - 12 + more);
    std::memcpy(bytes.data() + segments + 4, &size, 4);
    if (more < 0)
      bytes.erase(bytes.begin() + static_cast<long>(motion) + more,
                  bytes.begin() + static_cast<long>(motion));
    else
      bytes.insert(bytes.begin() + static_cast<long>(motion), 4, std::byte{0});
    expect_refused(bytes, segments + 12, motion + 4, "size of SEGS");
  }
}

TEST(Segments, CodingsOfWordsRefuseSegments) {
  CompressedClip words = clip();
  words.coding = Coding::Rle16;
  words.provenance.method = Method::Standard;
  EXPECT_THROW(read_container(write_container(words)), FormatError);
}

/// Very many segments: frames of nothing that moves.
CompressedClip segments_of_nothing(int frames, std::uint32_t bytes_of_each) {
  Motion still;
  still.skeleton.add({.name = "stone"});
  still.clip.channels.resize(600, 0);
  CompressedClip bomb = test::segmented_clip(still, {600, 256, 128});
  const auto first = static_cast<std::ptrdiff_t>(bomb.segments->bytes[0]);
  const std::vector<std::byte> one(bomb.motion.begin(), bomb.motion.begin() + first);
  bomb.frames = frames;
  const auto count = static_cast<std::size_t>(SegmentLayout{bomb.frames, 256, 128}.count());
  bomb.segments->bytes.assign(count, bytes_of_each);
  bomb.segments->bytes[0] = static_cast<std::uint32_t>(one.size());
  bomb.motion = one;
  for (std::size_t k = 1; k < count; ++k)
    bomb.motion.insert(bomb.motion.end(), one.begin(), one.begin() + bytes_of_each);
  return bomb;
}

TEST(Segments, RefusesSegmentsWithoutBytes) {
  const File bytes = write_container(segments_of_nothing(1 << 20, 0));
  EXPECT_EQ(test::OpenedClip(bytes).result.status, MCPR_INVALID);
  EXPECT_THROW(decode(read_container(bytes)), FormatError);
}

TEST(Segments, ThirtyThousandOfThemOpenAndDecodeInTime) {
  constexpr int kFrames = 1 << 22;  // as many as a file may have
  const File bytes = write_container(segments_of_nothing(kFrames, 2));
  EXPECT_EQ(test::OpenedClip(bytes).result.status, MCPR_OK);
  // Work for all segments is done only once.
  EXPECT_EQ(decode(read_container(bytes)).frames(), kFrames);
}

TEST(Segments, AreVisitedInTimeAndNoMoreThanOneAtATime) {
  const Uncorrected whole = decode_uncorrected(clip());
  int next = 0;
  visit_decoded(clip(), [&](int first, Uncorrected& block) {
    EXPECT_EQ(first, next);
    const int frames = block.clip.frames();
    EXPECT_LE(frames, 256);
    EXPECT_EQ(block.clip.channels, whole.clip.channels.middleRows(first, frames));
    EXPECT_EQ(block.differences, whole.differences.middleRows(first, frames));
    next += frames;
  });
  EXPECT_EQ(next, 600);
}

constexpr int kFrames = 800;

/// A walk there and back again.
Motion long_walk() {
  const Motion walk = samples::walk_clip();
  const int once = walk.clip.frames();
  Motion longer{walk.skeleton, {walk.clip.sample_rate_hz, {}}};
  longer.clip.channels.resize(kFrames, walk.clip.channels.cols());
  for (int t = 0; t < kFrames; ++t) {
    const int in_two = t % (2 * once);
    longer.clip.channels.row(t) =
        walk.clip.channels.row(in_two < once ? in_two : 2 * once - 1 - in_two);
  }
  return longer;
}

const Encoder& walk() {
  static const Encoder shared(long_walk());
  return shared;
}

EncodeSettings options(Target target, int longest = 320) {
  EncodeSettings made{
      .method = Method::ClosedLoop, .weighting = Weighting::BoneEnds, .target = target};
  made.segments = {.longest = longest, .overlap = 24};
  return made;
}

TEST(SegmentedEncode, MeetsEveryKindOfTarget) {
  const auto encoded = [](Target target) { return walk().encode(options(target)); };
  const auto raw = static_cast<double>(raw_bytes(walk().motion().clip));
  const Encoding by_error = encoded({Target::Kind::Error, 0.3});
  EXPECT_EQ(by_error.compressed.segment_layout().count(), 3);
  EXPECT_LE(by_error.distortion.eps_bone_ends, 0.3);
  EXPECT_GT(by_error.distortion.eps_bone_ends, 0.96 * 0.3);
  const Encoding by_ratio = encoded({Target::Kind::Ratio, 60});
  EXPECT_NEAR(raw / static_cast<double>(by_ratio.compressed.motion_bytes()) / 60, 1, 0.02);
  const auto size = encoded({Target::Kind::Size, 4000}).compressed.motion_bytes();
  EXPECT_LE(size, 4000u);
  EXPECT_GT(size, 3840u);
}

TEST(SegmentedEncode, HoldsAHardMaximum) {
  for (const bool corrected : {false, true}) {
    EncodeSettings asked = options({Target::Kind::MaxError, 2});
    if (corrected) asked.correction.emplace().ratio = 16;
    const double max_cm = walk().encode(asked).distortion.max.cm;
    EXPECT_LE(max_cm, 2);
    // The cheapest found, which need not be the nearest: what a solver makes of a coarser motion
    // jumps.
    EXPECT_GT(max_cm, (corrected ? 0.9 : 0.97) * 2);
  }
}

TEST(SegmentedEncode, MeetsAVisibilityTarget) {
  const Encoding encoding = walk().encode(options({Target::Kind::Visibility, 1}));
  EXPECT_EQ(encoding.visibility.sight(), Sight::NotVisible);
  EXPECT_GT(encoding.visibility.worst().times_noticed(), 0.65);
}

TEST(SegmentedEncode, MeasuresTheClipThatTheFileDecodesTo) {
  const Encoding encoding = walk().encode(options({Target::Kind::Ratio, 60}));
  const CompressedClip read = read_container(write_container(encoding.compressed));
  EXPECT_EQ(read.segments->bytes.size(), 3u);
  EXPECT_EQ(decode(read).channels, encoding.decoded.channels);
}

TEST(SegmentedEncode, AShortClipIsNotCut) {
  const Encoding whole = walk().encode(options({Target::Kind::Ratio, 60}, kFrames));
  EXPECT_FALSE(whole.compressed.segments);
  const Encoding usual = walk().encode({.method = Method::ClosedLoop,
                                        .weighting = Weighting::BoneEnds,
                                        .target = {Target::Kind::Ratio, 60}});
  EXPECT_EQ(whole.compressed.motion, usual.compressed.motion);
}

TEST(SegmentedEncode, GivesTheSameBytesOnAnyNumberOfThreads) {
  const EncodeSettings ratio = options({Target::Kind::Ratio, 60});
  const Encoding many = walk().encode(ratio);
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  EXPECT_EQ(write_container(Encoder(long_walk()).encode(ratio).compressed),
            write_container(many.compressed));
}

TEST(SegmentedEncode, CancelledItGivesAClipThatDecodes) {
  for (const int after : {1, 7, 25}) {
    int calls = 0;
    const Encoding cut = walk().encode(options({Target::Kind::Error, 0.3}),
                                       [&](const EncodeProgress&) { return ++calls < after; });
    EXPECT_FALSE(cut.complete);
    EXPECT_EQ(calls, after) << "asked again after it was told to end";
    EXPECT_EQ(decode(read_container(write_container(cut.compressed))).frames(), kFrames);
  }
}

TEST(SegmentedEncode, ProgressGoesForwardThroughPassesAndSegments) {
  EncodeProgress before{.pass = 0, .iteration = 0};
  walk().encode(options({Target::Kind::Error, 0.3}), [&](const EncodeProgress& progress) {
    EXPECT_TRUE(progress.pass > before.pass ||
                (progress.pass == before.pass && progress.iteration > before.iteration));
    before = progress;
    return true;
  });
  EXPECT_GE(before.pass, 1);
}

TEST(SegmentedEncode, CorrectsTheSameFeetInEverySegment) {
  EncodeSettings corrected = options({Target::Kind::Ratio, 200});
  corrected.correction.emplace();
  const Encoding with = walk().encode(corrected);
  ASSERT_TRUE(with.correction);
  EXPECT_NEAR(compression_ratio(walk().motion().clip, with.compressed.motion_bytes()) / 200, 1,
              0.02);
  EXPECT_EQ(with.compressed.correction->effectors.size(), 2u);
  EXPECT_GT(with.compressed.correction_bytes(), 50u);
  const Encoding without = walk().encode(options({Target::Kind::Ratio, 200}));
  EXPECT_LT(with.footskate.total_cm, without.footskate.total_cm);
}

TEST(SegmentedEncode, HeedsContactsInEverySegment) {
  EncodeSettings planted = options({Target::Kind::Ratio, 200});
  planted.importance.contacts = 20;
  EXPECT_LT(walk().encode(planted).footskate.total_cm,
            walk().encode(options({Target::Kind::Ratio, 200})).footskate.total_cm);
}

TEST(SegmentedEncode, SeamsHaveNoMoreErrorThanElsewhereAndDoNotJump) {
  const Motion& motion = walk().motion();
  for (const double eps : {0.5, 0.1}) {
    const Encoding encoding = walk().encode(options({Target::Kind::Error, eps}));
    const SegmentLayout layout = encoding.compressed.segment_layout();
    const Eigen::MatrixXd error =
        landmark_tracks(motion.skeleton, encoding.decoded) - walk().original_tracks();
    struct {
      double squares = 0;
      double velocity_squares = 0;
      double largest = 0;
      double largest_velocity = 0;
      int frames = 0;
      double rms() const { return std::sqrt(squares / frames); }
      double velocity_rms() const { return std::sqrt(velocity_squares / frames); }
    } seam, elsewhere;
    for (int t = 1; t < layout.frames; ++t) {
      const bool at_seam = layout.stretch_at(t).shared >= 0 || layout.stretch_at(t - 1).shared >= 0;
      const Eigen::RowVectorXd velocity = error.row(t) - error.row(t - 1);
      auto& errors = at_seam ? seam : elsewhere;
      errors.squares += error.row(t).squaredNorm();
      errors.velocity_squares += velocity.squaredNorm();
      errors.largest = std::max(errors.largest, error.row(t).cwiseAbs().maxCoeff());
      errors.largest_velocity = std::max(errors.largest_velocity, velocity.cwiseAbs().maxCoeff());
      ++errors.frames;
    }
    EXPECT_LT(seam.rms(), 1.1 * elsewhere.rms());
    EXPECT_LT(seam.velocity_rms(), 1.1 * elsewhere.velocity_rms());
    EXPECT_LE(seam.largest, elsewhere.largest);
    EXPECT_LE(seam.largest_velocity, elsewhere.largest_velocity);
  }
}

/// The same figures, percentiles to the precision they have without distances.
void expect_same_figures(const Encoding& figures, const Encoding& whole) {
  EXPECT_EQ(figures.distortion.eps_bone_ends, whole.distortion.eps_bone_ends);
  EXPECT_EQ(figures.distortion.eps_joint_origins, whole.distortion.eps_joint_origins);
  EXPECT_EQ(figures.distortion.max.cm, whole.distortion.max.cm);
  EXPECT_EQ(figures.distortion.max.frame, whole.distortion.max.frame);
  EXPECT_NEAR(figures.distortion.p95, whole.distortion.p95,
              DistanceCounts::kPrecision * whole.distortion.p95);
  EXPECT_NEAR(figures.distortion.p99, whole.distortion.p99,
              DistanceCounts::kPrecision * whole.distortion.p99);
  EXPECT_EQ(figures.footskate.total_cm, whole.footskate.total_cm);
  EXPECT_EQ(figures.coefficient_ratio, whole.coefficient_ratio);
}

TEST(SegmentedEncode, AskedForFiguresAloneItGivesTheSameBytesAndFigures) {
  for (const int longest : {320, kFrames})
    for (const bool corrected : {false, true}) {
      EncodeSettings asked = options({Target::Kind::Ratio, 60}, longest);
      if (corrected) asked.correction.emplace().ratio = 16;
      const Encoding whole = walk().encode(asked);
      asked.figures_only = true;
      const Encoding figures = walk().encode(asked);
      EXPECT_EQ(write_container(figures.compressed), write_container(whole.compressed));
      expect_same_figures(figures, whole);
      EXPECT_EQ(whole.decoded.frames(), kFrames);
      EXPECT_EQ(whole.distortion.distances.rows(), kFrames);
      EXPECT_EQ(figures.decoded.frames(), 0);
      EXPECT_EQ(figures.distortion.distances.size(), 0);
      ASSERT_EQ(figures.correction.has_value(), corrected);
      if (!corrected) continue;
      EXPECT_EQ(figures.correction->fastest_knee, whole.correction->fastest_knee);
      EXPECT_EQ(figures.correction->report.iterations, whole.correction->report.iterations);
      EXPECT_EQ(figures.correction->uncorrected.frames(), 0);
      EXPECT_EQ(whole.correction->uncorrected.channels,
                decode_uncorrected(whole.compressed).clip.channels);
    }
}

TEST(SegmentedEncode, MeasuresTheSameInBlocksAsInOnePiece) {
  const Encoding encoding = walk().encode(options({Target::Kind::Ratio, 60}));
  const Motion& motion = walk().motion();
  const Distortion whole = measure(motion.skeleton, walk().original_body(), encoding.decoded);
  EXPECT_NEAR(encoding.distortion.eps_bone_ends, whole.eps_bone_ends, 1e-12);
  EXPECT_EQ(encoding.distortion.max.cm, whole.max.cm);
  EXPECT_TRUE(encoding.distortion.distances == whole.distances);
  EXPECT_EQ(encoding.footskate.total_cm,
            measure_footskate(walk().contacts(), walk().original_tracks(),
                              landmark_tracks(motion.skeleton, encoding.decoded),
                              motion.clip.sample_rate_hz)
                .total_cm);
}

}  // namespace
}  // namespace mocapress::segmented_encode_test
