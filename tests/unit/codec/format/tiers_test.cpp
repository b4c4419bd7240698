// SPDX-License-Identifier: MIT
#include "core/codec/format/tiers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "core/codec/decode/decoder.h"
#include "core/codec/encode/encoder.h"
#include "core/codec/format/container.h"
#include "core/codec/format/format_error.h"
#include "core/codec/format/section_writer.h"
#include "core/codec/format/source_section.h"
#include "core/codec/format/varint.h"
#include "tests/support/opened_clip.h"
#include "tests/support/segmented_clip.h"
#include "tests/support/test_motion.h"

namespace mocapress::tiers_test {
namespace {

constexpr int kTiers = 3;

/// Files in one segment and in several, and one with an IK correction and with corrected ends.
std::vector<std::vector<std::byte>> files() {
  const Motion motion = test::smooth_motion(700);
  const auto in_segments = [&](const SegmentLayout& layout) {
    return write_container(test::segmented_clip(motion, layout, true));
  };
  const Encoding with_ends =
      Encoder(test::smooth_motion(120))
          .encode({.target = {Target::Kind::Error, 0.5}, .ends = Ends::Exact});
  return {in_segments(SegmentLayout::whole(700)), in_segments({700, 300, 40}),
          write_container(with_ends.compressed)};
}

TierError unmeasured(std::span<const std::byte> file, int tiers) {
  const int left_out = sections_of(file, tiers).bands_left_out();
  return {static_cast<float>(left_out), static_cast<float>(2 * left_out)};
}

std::vector<std::byte> tiered(std::span<const std::byte> file) {
  return with_tiers(file, kTiers, unmeasured);
}

std::vector<float> all_frames(std::span<const std::byte> file, std::uint32_t tiers,
                              std::uint32_t bands_left_out = 0) {
  mcpr_limits limits = mcpr::default_limits();
  limits.tiers = tiers;
  const test::OpenedClip opened(file, &limits);
  if (opened.clip == nullptr) return {};
  mcpr_request request{};
  request.apply_ik = 1;
  request.bands_left_out = bands_left_out;
  return opened.frames(request, 0, opened.info.frames);
}

mcpr_tier tier_of(std::span<const std::byte> file, std::uint32_t tier) {
  mcpr_tier found{};
  EXPECT_EQ(mcpr_tier_of(file.data(), MCPR_TIERS_HEAD_BYTES, tier, &found, nullptr), MCPR_OK);
  return found;
}

TEST(Tiers, TogetherHaveTheMotionOfTheFile) {
  for (const auto& file : files()) {
    const std::vector<std::byte> cut = tiered(file);
    ASSERT_EQ(sections_of(cut).tiers.count, kTiers);
    EXPECT_FALSE(all_frames(file, 0).empty());
    EXPECT_EQ(all_frames(cut, 0), all_frames(file, 0));
    EXPECT_EQ(all_frames(cut, kTiers), all_frames(file, 0));
    EXPECT_EQ(decode(read_container(cut)).channels, decode(read_container(file)).channels);
    EXPECT_EQ(without_tiers(cut), file);
    EXPECT_EQ(tiered(cut), cut);
  }
}

TEST(Tiers, CostTheirSectionsAlone) {
  for (const auto& file : files()) {
    const std::size_t segments = sections_of(file).segments_bytes == 0
                                     ? 0
                                     : static_cast<std::size_t>(sections_of(file).segments.count());
    const std::vector<std::byte> cut = tiered(file);
    std::vector<std::byte> sizes;
    const runtime::TierTable table = sections_of(cut).tiers;
    for (int t = 0; t < kTiers; ++t) write_varint(sizes, table.tier[t].bytes);
    EXPECT_EQ(cut.size(), file.size() + 12 + 1 + sizes.size() + (5 + 4) * (kTiers - 1) +
                              4 * segments * (kTiers - 1));
  }
}

TEST(Tiers, APrefixHasTheMotionWithoutItsFinestBands) {
  for (const auto& file : files()) {
    const std::vector<std::byte> cut = tiered(file);
    for (std::uint32_t t = 0; t < kTiers; ++t) {
      const mcpr_tier tier = tier_of(cut, t);
      // A copy of just that size, so that the address sanitizer sees every read past it.
      const std::vector<std::byte> prefix(cut.begin(), cut.begin() + static_cast<long>(tier.bytes));
      const std::vector<float> frames = all_frames(prefix, t + 1);
      ASSERT_FALSE(frames.empty());
      EXPECT_EQ(frames, all_frames(file, 0, tier.bands_left_out));
      EXPECT_EQ(all_frames(cut, t + 1), frames);
      EXPECT_EQ(all_frames(file_of_tiers(prefix, static_cast<int>(t) + 1), 0), frames);
    }
    EXPECT_EQ(tier_of(cut, kTiers - 1).bytes, cut.size());
    EXPECT_EQ(tier_of(cut, kTiers - 1).bands_left_out, 0);
  }
}

TEST(Tiers, StateTheErrorOfEachTier) {
  const std::vector<std::byte> cut = tiered(files().back());
  for (std::uint32_t t = 0; t + 1 < kTiers; ++t) {
    const mcpr_tier tier = tier_of(cut, t);
    EXPECT_GT(tier.error, 0);
    EXPECT_EQ(tier.error, static_cast<float>(tier.bands_left_out));
    EXPECT_EQ(tier.max_error, 2 * tier.error);
  }
  EXPECT_EQ(tier_of(cut, kTiers - 1).error, 0) << "CLIP has it";
  EXPECT_EQ(sections_of(cut).tiers.tier[kTiers - 1].eps_cm, sections_of(cut).eps_cm);
}

TEST(Tiers, KeepWhatIsSaidOfTheSource) {
  SourceFormat source{SourceFormat::Kind::Bvh};
  source.cm_per_unit = 2.5;
  const std::vector<std::byte> cut = tiered(with_source(files().front(), source));
  EXPECT_EQ(source_of(file_of_tiers(cut, 1)).cm_per_unit, 2.5);
}

TEST(Tiers, KeepOptionalSectionsThatAreUnknown) {
  const std::vector<std::byte> note(40, std::byte{0x5A});
  const std::vector<std::byte> cut = tiered(with_section(files().front(), "note", note));
  const std::vector<std::byte> coarse = file_of_tiers(cut, 1);
  EXPECT_NE(std::search(coarse.begin(), coarse.end(), note.begin(), note.end()), coarse.end());
  EXPECT_EQ(with_section(coarse, "note", std::nullopt), file_of_tiers(tiered(files().front()), 1));
}

TEST(Tiers, NeedEveryByteUpToTheirEnd) {
  const std::vector<std::byte> cut = tiered(files()[1]);
  const std::size_t first_tier = tier_of(cut, 0).bytes;
  for (std::size_t size = 0; size < cut.size(); ++size) {
    const std::vector<std::byte> prefix(cut.begin(), cut.begin() + static_cast<long>(size));
    mcpr_limits limits = mcpr::default_limits();
    limits.tiers = 1;
    mcpr_info info;
    EXPECT_NE(mcpr_inspect(prefix.data(), size, nullptr, &info, nullptr), MCPR_OK) << size;
    EXPECT_EQ(mcpr_inspect(prefix.data(), size, &limits, &info, nullptr) == MCPR_OK,
              size >= first_tier)
        << size;
  }
}

TEST(Tiers, AFileWithoutTiersHasNone) {
  const std::vector<std::byte> file = files().front();
  mcpr_tier tier;
  for (const std::size_t size : {file.size(), std::size_t{MCPR_TIERS_HEAD_BYTES}})
    EXPECT_EQ(mcpr_tier_of(file.data(), size, 0, &tier, nullptr), MCPR_ARGUMENT);
  EXPECT_EQ(mcpr_tier_of(tiered(file).data(), MCPR_TIERS_HEAD_BYTES, kTiers, &tier, nullptr),
            MCPR_ARGUMENT);
  EXPECT_EQ(without_tiers(file), file);
  EXPECT_THROW(file_of_tiers(file, 1), FormatError);
}

/// The file with another byte in a section that begins at `start`, whose checksum is right again.
std::vector<std::byte> with_byte(std::vector<std::byte> file, std::size_t start, std::size_t at,
                                 int bits) {
  std::uint8_t head[8];
  std::memcpy(head, file.data() + start, sizeof head);
  std::uint32_t size = 0;
  std::memcpy(&size, head + 4, sizeof size);
  file[start + 12 + at] ^= static_cast<std::byte>(bits);
  const std::uint32_t checksum = runtime::section_checksum(
      head, reinterpret_cast<const std::uint8_t*>(file.data()) + start + 12, size);
  std::memcpy(file.data() + start + 8, &checksum, sizeof checksum);
  return file;
}

constexpr std::size_t kStart = runtime::kFileHead;  // where TIER begins

TEST(Tiers, AreRefusedWhereTheyDoNotFitTheFile) {
  for (const auto& file : files()) {
    const std::vector<std::byte> cut = tiered(file);
    const runtime::TierTable table = sections_of(cut).tiers;
    std::vector<bool> informs = {false};  // the errors only inform
    for (int t = 0; t < kTiers; ++t) {
      std::vector<std::byte> size;
      write_varint(size, table.tier[t].bytes);
      informs.insert(informs.end(), size.size() + (t > 0 ? 4 : 0), false);
      if (t + 1 < kTiers) informs.insert(informs.end(), {false, true, true, true, true});
    }
    ASSERT_EQ(kStart + runtime::kSectionHead + informs.size(), table.end);
    for (std::size_t at = 0; at < informs.size(); ++at) {
      if (informs[at]) continue;
      for (const int bits : {1, 2, 0x40, 0x80}) {
        const std::vector<std::byte> changed = with_byte(cut, kStart, at, bits);
        const auto refuses = [&](std::uint32_t tiers) {
          return all_frames(changed, tiers).empty();
        };
        EXPECT_TRUE(refuses(0) || refuses(1) || refuses(2)) << at << ' ' << bits;
      }
    }
  }
}

/// The file with another byte in a finer tier, whose checksum is right again.
std::vector<std::byte> with_byte_of_tier(const std::vector<std::byte>& file, std::size_t at) {
  const runtime::TierTable tiers = sections_of(file).tiers;
  std::vector<std::byte> changed = file;
  changed[at] ^= std::byte{0x55};
  std::vector<TierBytes> bytes;
  for (int t = 0; t < kTiers; ++t) {
    const std::size_t size = tiers.tier[t].bytes;
    bytes.push_back(tier_bytes(std::span(changed).subspan(tiers.file_bytes(t) - size, size)));
  }
  ByteWriter whole;
  whole.append(std::span(file).first(kStart));
  write_section(whole, "TIER", write_tiers(tiers, bytes));
  whole.append(std::span(changed).subspan(tiers.end));
  return whole.release();
}

TEST(Tiers, DamageIsToldWhereItIs) {
  for (const auto& file : files()) {
    const std::vector<std::byte> cut = tiered(file);
    int refused = 0;
    for (std::uint32_t t = 0; t + 1 < kTiers; ++t) {
      const std::size_t first = tier_of(cut, t).bytes;
      const std::size_t end = tier_of(cut, t + 1).bytes;
      for (const std::size_t at : {first, (first + end) / 2, end - 1}) {
        std::vector<std::byte> damaged = cut;
        damaged[at] ^= std::byte{0x55};
        const mcpr_result told = test::OpenedClip(damaged).result;
        EXPECT_EQ(told.status, MCPR_DAMAGED);
        EXPECT_EQ(told.offset, first) << "where the tier begins";
      }
      for (std::size_t at = first; at < end; at += 3) {  // all take thrice as long
        const test::OpenedClip opened(with_byte_of_tier(cut, at));
        if (opened.clip != nullptr) continue;  // it has other values
        ++refused;
        EXPECT_GE(opened.result.offset, at);
        EXPECT_LE(opened.result.offset, cut.size());
      }
    }
    EXPECT_GT(refused, 0);
  }
}

TEST(Tiers, AreFewerWhereBandsAreFew) {
  const Motion motion = test::smooth_motion(8);
  const auto file =
      write_container(test::segmented_clip(motion, SegmentLayout::whole(8), false, 1));
  const std::vector<std::byte> cut = with_tiers(file, 8, unmeasured);
  EXPECT_LT(sections_of(cut).tiers.count, 8);
  EXPECT_EQ(all_frames(cut, 0), all_frames(file, 0));
}

}  // namespace
}  // namespace mocapress::tiers_test
