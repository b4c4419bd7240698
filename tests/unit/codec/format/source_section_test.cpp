// SPDX-License-Identifier: MIT
#include "core/codec/format/source_section.h"

#include <gtest/gtest.h>

#include <limits>

#include "core/base/byte_cursor.h"
#include "core/base/error.h"
#include "core/base/random.h"
#include "core/codec/format/container.h"
#include "core/codec/format/section_writer.h"
#include "tests/support/opened_clip.h"
#include "tests/support/segmented_clip.h"
#include "tests/support/test_motion.h"

namespace mocapress::source_section_test {
namespace {

using Bytes = std::vector<std::byte>;

const SourceFormat kInches{.kind = SourceFormat::Kind::Bvh,
                           .cm_per_unit = 2.54,
                           .up = UpAxis::Z,
                           .root = TranslationConvention::Replaces};

Bytes small_file() {
  return write_container(test::segmented_clip(test::smooth_motion(40), SegmentLayout::whole(40)));
}

/// A file whose section srce has these bytes.
Bytes with_payload(const Bytes& payload) {
  const Bytes file = small_file();
  ByteWriter writer;
  writer.append(std::span(file).first(6));
  writer.write(std::uint16_t{4});
  writer.append(std::span(file).subspan(8));
  write_section(writer, "srce", payload);
  return writer.release();
}

/// As FORMAT.md lays it out.
Bytes payload(int kind, int up, int root, double cm_per_unit) {
  ByteWriter writer;
  for (const int value : {kind, up, root}) writer.write(static_cast<std::uint8_t>(value));
  writer.write(cm_per_unit);
  return writer.release();
}

TEST(SourceSection, ComesBackAsItWasWritten) {
  for (const SourceFormat& source :
       {kInches, SourceFormat{.kind = SourceFormat::Kind::Acclaim, .cm_per_unit = 2.54 / 0.45},
        SourceFormat{.kind = SourceFormat::Kind::Fbx, .up = UpAxis::Z},
        SourceFormat{.kind = SourceFormat::Kind::Gltf, .cm_per_unit = 100},
        SourceFormat{.kind = SourceFormat::Kind::Bvh, .root = TranslationConvention::Adds}})
    EXPECT_EQ(source_of(with_source(small_file(), source)), source);
}

TEST(SourceSection, IsLaidOutAsTheFormatSays) {
  EXPECT_EQ(with_source(small_file(), kInches), with_payload(payload(1, 1, 1, 2.54)));
}

TEST(SourceSection, IsSkippedByReadersThatDoNotWantIt) {
  const Bytes plain = small_file();
  const Bytes named = with_source(plain, kInches);
  EXPECT_EQ(read_container(named).motion, read_container(plain).motion);
  const test::OpenedClip clip(named);
  ASSERT_NE(clip.clip, nullptr) << clip.result.message;
  EXPECT_EQ(clip.frames({}, 0, 40), test::OpenedClip(plain).frames({}, 0, 40));
}

TEST(SourceSection, IsThereOnceHoweverOftenItIsWritten) {
  const Bytes plain = small_file();
  const Bytes named = with_source(plain, kInches);
  EXPECT_EQ(with_source(with_source(plain, {.kind = SourceFormat::Kind::Acclaim}), kInches), named);
  EXPECT_EQ(with_source(named, {}), plain);
  EXPECT_EQ(source_of(plain), SourceFormat());
}

TEST(SourceSection, IsLeftOutWhereNoReaderWouldTakeItsUnit) {
  for (const double unit : {0.0, 1e-12, 1e12, std::numeric_limits<double>::quiet_NaN()})
    EXPECT_EQ(source_of(with_source(small_file(),
                                    {.kind = SourceFormat::Kind::Bvh, .cm_per_unit = unit})),
              SourceFormat());
}

TEST(SourceSection, RefusesWhatTheFormatDoesNotName) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  EXPECT_NO_THROW(source_of(with_payload(payload(2, 0, 2, 1))));
  for (const Bytes& bad :
       {payload(0, 0, 0, 1), payload(5, 0, 0, 1), payload(1, 2, 0, 1), payload(1, 0, 3, 1),
        payload(1, 0, 0, 0), payload(1, 0, 0, -1), payload(1, 0, 0, kInfinity), Bytes(), Bytes(10),
        Bytes(12, std::byte{1})})
    EXPECT_THROW(source_of(with_payload(bad)), FormatError);
}

TEST(SourceSection, SurvivesCutsAndMutations) {
  const Bytes whole = with_source(small_file(), kInches);
  for (std::size_t size = 0; size < whole.size(); ++size)
    EXPECT_THROW(source_of(std::span(whole).first(size)), FormatError) << size;
  Random random(3);
  for (int round = 0; round < 2000; ++round) {
    Bytes bytes = payload(1, 0, 1, 2.54);
    for (int i = 0; i < 2; ++i)
      bytes[random.below(bytes.size())] = static_cast<std::byte>(random.below(256));
    const Bytes mutated = with_payload(bytes);
    EXPECT_NO_THROW(read_container(mutated));  // it knows nothing of the section
    try {
      // Reading and writing again gives the same section.
      EXPECT_EQ(with_source(mutated, source_of(mutated)), mutated);
    } catch (const FormatError&) {
    }
  }
}

}  // namespace
}  // namespace mocapress::source_section_test
