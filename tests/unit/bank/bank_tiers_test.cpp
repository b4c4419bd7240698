// SPDX-License-Identifier: MIT
#include "core/runtime/format/bank_tiers.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <optional>
#include <vector>

#include "core/bank/bank.h"
#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/file_lock.h"
#include "core/codec/format/container.h"
#include "core/codec/format/tiers.h"
#include "core/runtime/own_memory.h"
#include "tests/support/opened_clip.h"
#include "tests/support/segmented_clip.h"
#include "tests/support/test_motion.h"

namespace mocapress {
namespace {

namespace fs = std::filesystem;

constexpr int kTiers = 3;

class BankTiersTest : public testing::Test {
 protected:
  BankTiersTest()
      : folder_(fs::temp_directory_path() / ("mocapress-bank-tiers-" + std::to_string(getpid()))) {
    fs::create_directories(folder_ / "clips");
    put("long", kTiers, {700, 300, 50});
    put("two", 2, SegmentLayout::whole(200));
    put("whole", 1, SegmentLayout::whole(100));
    put("z", kTiers, SegmentLayout::whole(300));
    make_bank(bank(), find_bank_sources({folder_ / "clips"}), {});
  }
  ~BankTiersTest() override { fs::remove_all(folder_); }

  void put(const std::string& name, int tiers, const SegmentLayout& layout) {
    const auto file =
        write_container(test::segmented_clip(test::smooth_motion(layout.frames), layout, true));
    const auto unmeasured = [](std::span<const std::byte>, int) { return TierError{1, 2}; };
    write_bytes(folder_ / "clips" / (name + ".mcpr"), with_tiers(file, tiers, unmeasured));
  }
  fs::path bank() const { return folder_ / "bank.mcpk"; }
  fs::path stripped(int tiers) const {
    const fs::path path = folder_ / ("stripped" + std::to_string(tiers) + ".mcpk");
    strip_bank(bank(), path, tiers);
    return path;
  }
  std::vector<std::byte> file(const std::string& name) const {
    return read_bytes(folder_ / "clips" / (name + ".mcpr"));
  }
  /// The tiers of a clip's file, up to so many.
  int tiers_of(const std::string& name, int most) const {
    return std::min(most, sections_of(file(name)).tiers.count);
  }

  fs::path folder_;
};

AlignedBytes aligned(const fs::path& path) {
  const std::vector<std::byte> read = read_bytes(path);
  AlignedBytes bytes(read.size());
  std::copy(read.begin(), read.end(), bytes.data());
  return bytes;
}

mcpr_limits limits_of(int tiers) {
  mcpr_limits limits = mcpr::default_limits();
  limits.tiers = static_cast<std::uint32_t>(tiers);
  return limits;
}

/// All frames of a clip that a bank gives; empty if it is refused.
std::vector<float> frames_in(const mcpk_bank* bank, std::uint32_t clip, int tiers = 0) {
  const mcpr_limits limits = limits_of(tiers);
  const auto loaded = mcpr::load(bank, clip, &limits);
  const std::uint32_t count = mcpr::describe(loaded->get()).frames;
  const mcpr_request request{};
  const AlignedBytes working(mcpr_scratch_bytes(loaded->get(), &request));
  std::vector<float> frames(count * mcpr_frame_values(loaded->get(), &request));
  mcpr_decode_frames(loaded->get(), &request, 0, count, frames.data(), working.data(),
                     working.size(), nullptr);
  return frames;
}

std::vector<float> frames_of(std::span<const std::byte> file, int tiers) {
  const mcpr_limits limits = limits_of(tiers);
  const test::OpenedClip opened(file, &limits);
  return opened.clip != nullptr ? opened.frames({}, 0, opened.info.frames) : std::vector<float>();
}

TEST_F(BankTiersTest, GiveEveryFileBackByteForByte) {
  const BankFile made(bank());
  EXPECT_EQ(mcpk_tiers(&made.bank(), nullptr), static_cast<std::uint32_t>(kTiers));
  for (std::uint32_t clip = 0; clip < made.clips(); ++clip)
    EXPECT_EQ(made.extract(made.entry(clip)), file(made.entry(clip).name)) << made.entry(clip).name;
}

TEST_F(BankTiersTest, PlayAsTheFilesDo) {
  const BankFile made(bank());
  for (std::uint32_t clip = 0; clip < made.clips(); ++clip)
    for (int tiers = 1; tiers <= kTiers; ++tiers) {
      const std::string name = made.entry(clip).name;
      const std::vector<float> expected = frames_of(file(name), tiers_of(name, tiers));
      EXPECT_FALSE(expected.empty());
      EXPECT_EQ(frames_in(&made.bank(), clip, tiers), expected) << name << ' ' << tiers;
    }
}

TEST_F(BankTiersTest, StateTheErrorsOfTheTiersAsked) {
  const BankFile made(bank());
  for (std::uint32_t clip = 0; clip < made.clips(); ++clip)
    for (int tiers = 1; tiers <= kTiers; ++tiers) {
      const std::string name = made.entry(clip).name;
      const std::vector<std::byte> single = file(name);
      const bool is_whole = tiers >= std::max(sections_of(single).tiers.count, 1);
      mcpr_limits limits = limits_of(tiers);
      mcpr_info info;
      ASSERT_EQ(mcpk_inspect(&made.bank(), clip, &limits, &info, nullptr), MCPR_OK);
      EXPECT_EQ(info.error, is_whole ? sections_of(single).eps_cm : 1) << name << ' ' << tiers;
      EXPECT_EQ(info.max_error, is_whole ? sections_of(single).max_error_cm : 2) << name;
      mcpr_info of_file;
      limits.tiers = static_cast<std::uint32_t>(tiers_of(name, tiers));
      ASSERT_EQ(mcpr_inspect(single.data(), single.size(), &limits, &of_file, nullptr), MCPR_OK);
      EXPECT_EQ(of_file.error, info.error);
      EXPECT_EQ(of_file.max_error, info.max_error);
    }
}

TEST_F(BankTiersTest, AStrippedBankPlaysTheTiersThatItHas) {
  const std::vector<std::byte> whole = read_bytes(bank());
  for (int tiers = 1; tiers <= kTiers; ++tiers) {
    const std::vector<std::byte> cut = read_bytes(stripped(tiers));
    EXPECT_EQ(cut.size() == whole.size(), tiers == kTiers);
    EXPECT_TRUE(
        std::equal(cut.begin() + sizeof(mcpk_bank), cut.end(), whole.begin() + sizeof(mcpk_bank)));
    const BankFile made(stripped(tiers));
    std::uint32_t present = 0;
    EXPECT_EQ(mcpk_tiers(&made.bank(), &present), static_cast<std::uint32_t>(kTiers));
    EXPECT_EQ(present, static_cast<std::uint32_t>(tiers));
    for (std::uint32_t clip = 0; clip < made.clips(); ++clip) {
      const std::string name = made.entry(clip).name;
      const int there = tiers_of(name, tiers);
      EXPECT_EQ(frames_in(&made.bank(), clip), frames_of(file(name), there)) << name;
      const auto extracted = made.extract(made.entry(clip));
      const bool has_all = there == sections_of(file(name)).tiers.count;
      EXPECT_EQ(extracted, has_all ? file(name) : file_of_tiers(file(name), there)) << name;
    }
  }
}

/// So a cooked bank is shipped without the finest tiers: it is made of a packed bank without them.
TEST_F(BankTiersTest, AStrippedBankIsCookedAsFarAsItGoes) {
  std::uintmax_t smaller = 0;
  for (int tiers = 1; tiers <= kTiers; ++tiers) {
    const fs::path path = folder_ / "cooked.mcpk";
    make_bank(path, find_bank_sources({stripped(tiers)}),
              {.form = runtime::BankForm::Cooked, .cooking = {.apply_ik = false}});
    EXPECT_GT(fs::file_size(path), smaller);
    smaller = fs::file_size(path);
    const BankFile cooked(path);
    for (std::uint32_t number = 0; number < cooked.clips(); ++number) {
      const runtime::BankEntry entry = cooked.entry(number);
      const mcpr_limits limits = limits_of(tiers_of(entry.name, tiers));
      const test::OpenedClip opened(file(entry.name), &limits);
      const std::vector<float> wanted =
          opened.frames({.output = MCPR_LOCAL}, 0, opened.info.frames);
      std::vector<mcpr_transform> pose(opened.info.joints);
      for (std::uint32_t t = 0; t < opened.info.frames; t += 37) {
        const mcpr_sample_request request{};
        ASSERT_EQ(mcpr_sample(cooked.cooked(entry), &request, t, pose.data()->rotation, nullptr),
                  MCPR_OK);
        for (std::size_t j = 0; j < pose.size(); ++j)
          for (std::size_t i = 0; i < 7; ++i)
            EXPECT_NEAR(i < 4 ? pose[j].rotation[i] : pose[j].translation[i - 4],
                        wanted[7 * (pose.size() * t + j) + i], i < 4 ? 5e-4 : 2e-3)
                << entry.name << ' ' << tiers;
      }
    }
  }
}

TEST_F(BankTiersTest, AStrippedBankTakesNoClips) {
  const fs::path cut = stripped(1);
  EXPECT_THROW(add_to_bank(cut, find_bank_sources({folder_ / "clips"}), {}), InputError);
  EXPECT_THROW(remove_from_bank(cut, {"long"}), InputError);
  EXPECT_THROW(strip_bank(cut, folder_ / "again.mcpk", 2), InputError);
  EXPECT_THROW(strip_bank(bank(), folder_ / "none.mcpk", 0), InputError);
}

TEST_F(BankTiersTest, StrippingWaitsForWhoeverChangesTheBankAtItsPlace) {
  const fs::path place = stripped(1);
  const std::vector<std::byte> before = read_bytes(place);
  std::optional<FileLock> held = FileLock::wait_for(place, [] { return false; });
  ASSERT_TRUE(held);
  int asked = 0;
  EXPECT_FALSE(strip_bank(bank(), place, 2, [&](const BankProgress&) { return ++asked < 3; }));
  EXPECT_EQ(asked, 3);
  EXPECT_EQ(read_bytes(place), before);
  held.reset();
  EXPECT_TRUE(strip_bank(bank(), place, 2));
  EXPECT_EQ(read_bytes(place), read_bytes(stripped(2)));
}

TEST_F(BankTiersTest, StayWithTheirClipsWhenOthersAreRemoved) {
  remove_from_bank(bank(), {"two"});
  const BankFile made(bank());
  ASSERT_EQ(made.clips(), 3U);
  for (std::uint32_t clip = 0; clip < made.clips(); ++clip)
    EXPECT_EQ(made.extract(made.entry(clip)), file(made.entry(clip).name));
  remove_from_bank(bank(), {"long", "z"});
  EXPECT_EQ(mcpk_tiers(&BankFile(bank()).bank(), nullptr), 1U);
}

TEST_F(BankTiersTest, NothingMayFollowABankWithoutThem) {
  remove_from_bank(bank(), {"long", "two", "z"});
  std::vector<std::byte> bytes = read_bytes(bank());
  bytes.insert(bytes.end(), 100, std::byte{0x5A});
  mcpk_bank head;
  std::memcpy(&head, bytes.data(), sizeof head);
  head.bytes = bytes.size();
  head.checksum = runtime::bank_checksum(&head, offsetof(mcpk_bank, checksum));
  std::memcpy(bytes.data(), &head, sizeof head);
  write_bytes(bank(), bytes);
  EXPECT_THROW(BankFile made(bank()), InputError);
}

/// A bank of which only the first tier is in memory, as while the rest is on its way.
TEST_F(BankTiersTest, AreLoadedToTheirPlacesOneByOne) {
  const AlignedBytes whole = aligned(bank());
  AlignedBytes memory(whole.size());
  const auto load = [&](std::uint64_t offset, std::uint64_t bytes) {
    std::memcpy(memory.data() + offset, whole.data() + offset, static_cast<std::size_t>(bytes));
  };
  std::memset(memory.data(), 0xAA, memory.size());
  load(0, MCPK_HEAD_BYTES);
  const mcpk_bank* made = nullptr;
  ASSERT_EQ(mcpk_open(memory.data(), memory.size(), 0, &made, nullptr), MCPR_OK);
  std::uint64_t offset = 0;
  std::uint64_t bytes = 0;
  const std::uint32_t clips = mcpr::describe(made).clips;
  ASSERT_EQ(mcpk_place(made, clips, &offset, &bytes, nullptr), MCPR_OK);
  load(offset, bytes);
  ASSERT_EQ(mcpk_open(memory.data(), memory.size(), 2, &made, nullptr), MCPR_OK);
  const auto clip = static_cast<std::uint32_t>(mcpk_find(made, "z"));
  for (int tier = 0; tier < kTiers; ++tier) {
    ASSERT_EQ(
        mcpk_tier_place(made, clip, static_cast<std::uint32_t>(tier), &offset, &bytes, nullptr),
        MCPR_OK);
    EXPECT_GT(bytes, 0U);
    load(offset, bytes);
    EXPECT_EQ(mcpk_check(made, clip, nullptr), MCPR_OK);
    EXPECT_EQ(frames_in(made, clip, tier + 1), frames_of(file("z"), tier + 1));
  }
  EXPECT_EQ(mcpk_tier_place(made, clip, kTiers, &offset, &bytes, nullptr), MCPR_ARGUMENT);
  ASSERT_EQ(mcpk_tier_place(made, clips, kTiers - 1, &offset, &bytes, nullptr), MCPR_OK);
  EXPECT_EQ(offset + bytes, whole.size());
}

TEST_F(BankTiersTest, DamageToThemIsFound) {
  const AlignedBytes whole = aligned(bank());
  const mcpk_bank* made = nullptr;
  ASSERT_EQ(mcpk_open(whole.data(), whole.size(), 1, &made, nullptr), MCPR_OK);
  for (std::size_t at = made->tables.offset; at < whole.size(); ++at) {
    whole.data()[at] ^= std::byte{1};
    EXPECT_NE(mcpk_open(whole.data(), whole.size(), 1, &made, nullptr), MCPR_OK) << at;
    whole.data()[at] ^= std::byte{1};
  }
  for (std::size_t size = made->tables.offset; size < whole.size(); ++size)
    EXPECT_NE(mcpk_open(whole.data(), size, 1, &made, nullptr), MCPR_OK) << size;
}

void play(const mcpk_bank* bank) {
  for (std::uint32_t clip = 0; clip < bank->clips; ++clip) frames_in(bank, clip);
}

/// Tables that make no sense, whose checksums are right.
TEST_F(BankTiersTest, TablesThatMakeNoSenseAreRefused) {
  const AlignedBytes whole = aligned(bank());
  auto* const head = reinterpret_cast<mcpk_bank*>(whole.data());
  std::byte* const tables = whole.data() + head->tables.offset;
  const std::uint64_t bytes = head->bytes;
  const auto is_refused = [&](std::uint64_t bytes_told) {
    head->bytes = bytes_told;
    head->tables_checksum =
        runtime::bank_checksum(tables, static_cast<std::size_t>(head->tables.bytes));
    head->checksum = runtime::bank_checksum(head, offsetof(mcpk_bank, checksum));
    const mcpk_bank* made = nullptr;
    return mcpk_open(whole.data(), whole.size(), 1, &made, nullptr) != MCPR_OK;
  };
  EXPECT_FALSE(is_refused(bytes));
  const std::size_t begins =
      runtime::BankTiers::kHeadBytes + (kTiers - 1) * runtime::BankTiers::kRegionBytes;
  for (std::size_t at = 0; at < head->tables.bytes; ++at)
    for (const int bits : {1, 0x80}) {
      tables[at] ^= static_cast<std::byte>(bits);
      const bool refused = is_refused(bytes);
      EXPECT_TRUE(refused || at >= begins) << at << ' ' << bits;
      // Bytes of one clip may seem to be the next one's: then it must not read beyond them.
      if (!refused) play(head);
      tables[at] ^= static_cast<std::byte>(bits);
    }
  EXPECT_TRUE(is_refused(bytes - 1));
}

}  // namespace
}  // namespace mocapress
