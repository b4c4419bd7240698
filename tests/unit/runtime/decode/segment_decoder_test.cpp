// SPDX-License-Identifier: MIT
// Decodes segmented clips by the C interface. Every part equals that part of the whole, and the
// whole equals what core decodes.
#include "core/runtime/decode/segment_decoder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>

#include "core/base/random.h"
#include "core/codec/decode/decoder.h"
#include "core/codec/format/container.h"
#include "tests/support/opened_clip.h"
#include "tests/support/segmented_clip.h"
#include "tests/support/test_motion.h"
#include "tests/unit/runtime/paths.h"

namespace mocapress {
namespace {

using test::OpenedClip;

struct Case {
  CompressedClip compressed;
  OpenedClip opened;
  explicit Case(const SegmentLayout& layout)
      : compressed(test::segmented_clip(test::smooth_motion(layout.frames), layout, true)),
        opened(write_container(compressed)) {}

  /// Decoded values as a matrix, frames x columns.
  Eigen::MatrixXf frames(const mcpr_request& request, int first, int count) const {
    return rows(opened.frames(request, static_cast<std::uint32_t>(first),
                              static_cast<std::uint32_t>(count)),
                request);
  }
  Eigen::MatrixXf whole(const mcpr_request& request) const {
    return frames(request, 0, compressed.frames);
  }
  Eigen::MatrixXf moment(const mcpr_request& request, double frame) const {
    return rows(opened.moment(request, frame), request);
  }

 private:
  Eigen::MatrixXf rows(const std::vector<float>& values, const mcpr_request& request) const {
    const auto columns = static_cast<Eigen::Index>(mcpr_frame_values(opened.clip, &request));
    return Eigen::Map<const Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>(
        values.data(), std::ssize(values) / columns, columns);
  }
};

const Case& three_segments() {
  static const Case shared(SegmentLayout{700, 300, 40});
  return shared;
}

TEST(SegmentDecoder, MatchesCoreToTheBitForEveryLayout) {
  for (const SegmentLayout layout : {SegmentLayout{700, 300, 40}, SegmentLayout{600, 256, 128},
                                     SegmentLayout{257, 256, 1}, SegmentLayout{512, 256, 1}}) {
    const Case clip(layout);
    ASSERT_NE(clip.opened.clip, nullptr) << clip.opened.result.message;
    const CompressedClip read = read_container(write_container(clip.compressed));
    EXPECT_EQ(clip.whole({}), decode_uncorrected(read).clip.channels.cast<float>());
    EXPECT_EQ(clip.whole({.apply_ik = 1}), decode(read).channels.cast<float>());
    EXPECT_NE(clip.whole({}), clip.whole({.apply_ik = 1}));
  }
}

TEST(SegmentDecoder, AnyWindowEqualsThatPartOfTheWhole) {
  Random random(1);
  const std::uint16_t some[] = {9, 3, 14};
  for (const Case& clip : {std::cref(three_segments()), std::cref(*[] {
                             static const Case tight(SegmentLayout{600, 256, 128});
                             return &tight;
                           }())}) {
    const int frames = clip.compressed.frames;
    const SegmentLayout layout = clip.compressed.segment_layout();
    for (const mcpr_request& request :
         {mcpr_request{}, mcpr_request{.output = MCPR_POSITIONS, .apply_ik = 1},
          mcpr_request{.apply_ik = 1, .channels = some, .channel_count = 3},
          mcpr_request{.bands_left_out = 2}, mcpr_request{.bands_left_out = 40}}) {
      const Eigen::MatrixXf whole = clip.whole(request);
      for (int round = 0; round < 30; ++round) {
        // Starts near a boundary: before it, in it or after it.
        const int seam = layout.first(1 + static_cast<int>(random.below(2)));
        const int first =
            std::clamp(seam - 60 + static_cast<int>(random.below(180)), 0, frames - 1);
        const int count = 1 + static_cast<int>(random.below(
                                  static_cast<std::uint64_t>(std::min(300, frames - first))));
        EXPECT_EQ(clip.frames(request, first, count), whole.middleRows(first, count));
        EXPECT_EQ(clip.moment(request, first), whole.row(first));
      }
    }
  }
}

TEST(SegmentDecoder, BlendsBothSegmentsInAnOverlap) {
  const Case& clip = three_segments();
  const SegmentLayout layout = clip.compressed.segment_layout();
  const Eigen::MatrixXf whole = clip.whole({});
  std::vector<Eigen::MatrixXf> parts;
  std::size_t byte = 0;
  for (int k = 0; k < layout.count(); ++k) {
    CompressedClip part = clip.compressed;
    part.frames = layout.frames_of(k);
    const auto size = clip.compressed.segments->bytes[static_cast<std::size_t>(k)];
    part.motion.assign(clip.compressed.motion.begin() + static_cast<std::ptrdiff_t>(byte),
                       clip.compressed.motion.begin() + static_cast<std::ptrdiff_t>(byte + size));
    part.segments.reset();
    byte += size;
    parts.push_back(decode_uncorrected(part).clip.channels.cast<float>());
  }
  float apart = 0;
  for (int k = 1; k < layout.count(); ++k)
    for (int i = 0; i < layout.overlap; ++i) {
      const Eigen::RowVectorXf before =
          parts[static_cast<std::size_t>(k - 1)].row(layout.hop() + i);
      const Eigen::RowVectorXf after = parts[static_cast<std::size_t>(k)].row(i);
      const float share = static_cast<float>(i + 1) / static_cast<float>(layout.overlap + 1);
      const Eigen::RowVectorXf expected = before + share * (after - before);
      EXPECT_LT((whole.row(layout.first(k) + i) - expected).cwiseAbs().maxCoeff(), 1e-5F);
      apart = std::max(apart, (after - before).cwiseAbs().maxCoeff());
    }
  EXPECT_GT(apart, 0.01F) << "segments so alike show no blend";
}

TEST(SegmentDecoder, EveryPathGivesTheSameBits) {
  const Case& clip = three_segments();
  for (const mcpr_path path : existing_paths())
    for (const std::uint32_t left_out : {0U, 3U})
      EXPECT_EQ(clip.whole({.apply_ik = 1, .bands_left_out = left_out, .path = path}),
                clip.whole({.apply_ik = 1, .bands_left_out = left_out}));
}

TEST(SegmentDecoder, InterpolatesLinearlyInAnOverlap) {
  const Case& clip = three_segments();
  const Eigen::MatrixXf whole = clip.whole({});
  for (const double frame : {259.5, 270.25, 299.75, 300.5, 519.5}) {
    const auto before = static_cast<Eigen::Index>(frame);
    const auto share = static_cast<float>(frame - static_cast<double>(before));
    const Eigen::MatrixXf expected =
        whole.row(before) + share * (whole.row(before + 1) - whole.row(before));
    EXPECT_TRUE(clip.moment({}, frame).isApprox(expected, 1e-6F)) << frame;
  }
}

TEST(SegmentDecoder, SubsetsHaveTheSameBits) {
  const Case& clip = three_segments();
  const std::uint16_t some[] = {9, 3, 14};
  for (const int corrected : {0, 1}) {
    const Eigen::MatrixXf whole = clip.whole({.apply_ik = corrected});
    const Eigen::MatrixXf chosen =
        clip.whole({.apply_ik = corrected, .channels = some, .channel_count = 3});
    for (Eigen::Index i = 0; i < 3; ++i) EXPECT_EQ(chosen.col(i), whole.col(some[i]));
  }
}

TEST(SegmentDecoder, UsesExactlyTheStatedMemory) {
  // A signal of metres, which only one segment decodes in double precision.
  Motion motion = test::smooth_motion(700);
  motion.clip.channels.col(0).tail(150).array() += 5000;
  const OpenedClip opened(write_container(test::segmented_clip(motion, {700, 300, 40})));
  ASSERT_NE(opened.clip, nullptr) << opened.result.message;
  for (const mcpr_request& request : {mcpr_request{}, mcpr_request{.output = MCPR_POSITIONS},
                                      mcpr_request{.bands_left_out = 3}}) {
    const std::size_t need = mcpr_scratch_bytes(opened.clip, &request);
    const AlignedBytes scratch(need + 64);
    std::memset(scratch.data(), 0x5A, scratch.size());
    std::vector<float> out(700 * mcpr_frame_values(opened.clip, &request));
    const auto decode_with = [&](std::size_t size) {
      return mcpr_decode_frames(opened.clip, &request, 0, 700, out.data(), scratch.data(), size,
                                nullptr);
    };
    EXPECT_EQ(decode_with(need - 1), MCPR_MEMORY);
    EXPECT_EQ(decode_with(need), MCPR_OK);
    for (std::size_t i = need; i < scratch.size(); ++i)
      ASSERT_EQ(scratch.data()[i], std::byte{0x5A}) << i;
  }
}

TEST(SegmentDecoder, AClipInSegmentsMayBeMovedAsBytes) {
  const Case& clip = three_segments();
  const AlignedBytes moved(clip.opened.resident->size());
  std::memcpy(moved.data(), clip.opened.resident->data(), moved.size());
  const mcpr_request request{.output = MCPR_POSITIONS, .apply_ik = 1};
  const AlignedBytes scratch(mcpr_scratch_bytes(clip.opened.clip, &request));
  const auto* const there = reinterpret_cast<const mcpr_clip*>(moved.data());
  std::vector<float> out(700 * mcpr_frame_values(there, &request));
  ASSERT_EQ(mcpr_decode_frames(there, &request, 0, 700, out.data(), scratch.data(), scratch.size(),
                               nullptr),
            MCPR_OK);
  EXPECT_EQ(out, clip.opened.frames(request, 0, 700));
}

TEST(SegmentDecoder, LimitsCountSharedFramesTwice) {
  const auto file = write_container(three_segments().compressed);
  mcpr_limits limits = mcpr::default_limits();
  const std::uint64_t values = three_segments().opened.info.channels + 6;
  limits.values = 779 * values;
  EXPECT_EQ(OpenedClip(file, &limits).result.status, MCPR_LIMIT);
  limits.values = 780 * values;
  EXPECT_EQ(OpenedClip(file, &limits).result.status, MCPR_OK);
}

TEST(SegmentDecoder, ReadingNeedsMemoryForOneSegmentAndTheCodedBytes) {
  const auto file_of = [](int frames) {
    return write_container(
        test::segmented_clip(test::smooth_motion(frames), {frames, 256, 16}, true));
  };
  const OpenedClip few(file_of(700));
  const OpenedClip many(file_of(7000));
  ASSERT_NE(many.clip, nullptr) << many.result.message;
  constexpr std::size_t kMoreSegments = 26;
  EXPECT_LT(many.info.read_bytes - few.info.read_bytes,
            many.info.motion_bytes - few.info.motion_bytes + 24 * kMoreSegments + 64);
}

TEST(SegmentDecoder, TheFileIsNotNeededAfterReading) {
  auto file = write_container(three_segments().compressed);
  const AlignedBytes scratch(three_segments().opened.info.read_bytes);
  std::size_t size = 0;
  ASSERT_EQ(
      mcpr_read(file.data(), file.size(), nullptr, scratch.data(), scratch.size(), &size, nullptr),
      MCPR_OK);
  std::fill(file.begin(), file.end(), std::byte{0x5A});
  const AlignedBytes resident(size);
  for (int built = 0; built < 2; ++built) {  // building may be repeated
    const mcpr_clip* clip = nullptr;
    ASSERT_EQ(mcpr_build(scratch.data(), scratch.size(), resident.data(), size, &clip, nullptr),
              MCPR_OK);
    for (const mcpr_request& request :
         {mcpr_request{}, mcpr_request{.output = MCPR_POSITIONS, .apply_ik = 1}}) {
      const AlignedBytes frame_scratch(mcpr_scratch_bytes(clip, &request));
      std::vector<float> out(700 * mcpr_frame_values(clip, &request));
      ASSERT_EQ(mcpr_decode_frames(clip, &request, 0, 700, out.data(), frame_scratch.data(),
                                   frame_scratch.size(), nullptr),
                MCPR_OK);
      EXPECT_EQ(out, three_segments().opened.frames(request, 0, 700));
    }
  }
}

}  // namespace
}  // namespace mocapress
