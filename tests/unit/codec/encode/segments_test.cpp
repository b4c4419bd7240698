// SPDX-License-Identifier: MIT
#include "core/codec/encode/segments.h"

#include <gtest/gtest.h>

#include <cstring>
#include <functional>

#include "core/base/error.h"
#include "core/base/random.h"
#include "core/codec/decode/decoder.h"
#include "core/codec/format/container.h"
#include "tests/fuzz/file_sections.h"
#include "tests/support/opened_clip.h"
#include "tests/support/segmented_clip.h"
#include "tests/support/test_motion.h"

namespace mocapress {
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
    // What decoding refuses, core counts from the motion's first byte.
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

TEST(Segments, WordsHaveNone) {
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

TEST(Segments, OfNoBytesAreRefused) {
  const File bytes = write_container(segments_of_nothing(1 << 20, 0));
  EXPECT_EQ(test::OpenedClip(bytes).result.status, MCPR_INVALID);
  EXPECT_THROW(decode(read_container(bytes)), FormatError);
}

TEST(Segments, ThirtyThousandOfThemOpenAndDecodeInTime) {
  constexpr int kFrames = 1 << 22;  // as many as a file may have
  const File bytes = write_container(segments_of_nothing(kFrames, 2));
  EXPECT_EQ(test::OpenedClip(bytes).result.status, MCPR_OK);
  // What concerns all of them is done but once.
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

}  // namespace
}  // namespace mocapress
