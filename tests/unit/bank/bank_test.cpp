// SPDX-License-Identifier: MIT
#include "core/bank/bank.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <span>
#include <thread>
#include <vector>

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/file_lock.h"
#include "core/base/random.h"
#include "core/base/utf8_path.h"
#include "core/codec/encode/encoder.h"
#include "core/codec/encode/track_encoder.h"
#include "core/codec/format/container.h"
#include "core/runtime/format/coded_error.h"
#include "core/runtime/format/packed_clip.h"
#include "core/runtime/own_memory.h"
#include "tests/support/cooked_clip.h"
#include "tests/support/opened_clip.h"
#include "tests/support/segmented_clip.h"
#include "tests/support/some_tracks.h"
#include "tests/support/test_motion.h"
#include "tests/support/turned_forms.h"

namespace mocapress {
namespace {

namespace fs = std::filesystem;
using test::CookedClip;
using test::OpenedClip;

std::vector<std::byte> encoded(const Motion& motion, EncodeSettings options = {}) {
  options.method = Method::ClosedLoop;
  return write_container(Encoder(motion).encode(options).compressed);
}

/// A clip with orders of its own, so that its skeleton in the file differs from the others.
std::vector<std::byte> encoded_in_order(const Motion& motion, RotationOrder order) {
  RotationForms forms = rotation_forms(motion.skeleton);
  for (RotationForm& form : forms) form.order = order;
  CompressedClip clip =
      test::segmented_clip(with_forms(motion, forms), SegmentLayout::whole(motion.clip.frames()));
  clip.skeleton = motion.skeleton;
  clip.forms = forms;
  return write_container(clip);
}

class BankTest : public testing::Test {
 protected:
  BankTest() : folder_(fs::temp_directory_path() / ("mocapress-bank-" + std::to_string(getpid()))) {
    fs::remove_all(folder_);
    fs::create_directories(folder_ / "clips/walks");
    const Motion motion = test::smooth_motion(60);
    put("plain", encoded(motion));
    put("exact", encoded(motion, {.ends = Ends::Exact}));
    put("rle", encoded(motion, {.coding = Coding::Rle16}));
    put("walks/zyx", encoded_in_order(motion, RotationOrder::Zyx));
    put("walks/yxz", encoded_in_order(motion, RotationOrder::Yxz));
    put("still",
        write_container(test::segmented_clip(test::smooth_motion(1), SegmentLayout::whole(1))));
    put("long", with_tracks(write_container(test::segmented_clip(test::smooth_motion(700),
                                                                 {700, 300, 50}, true)),
                            test::some_tracks(700), 0.002));
    CompressedClip turned = test::segmented_clip(test::smooth_motion(50), SegmentLayout::whole(50));
    turned.forms = test::turned_forms(turned.skeleton);
    put("turned", write_container(turned));
  }
  ~BankTest() override { fs::remove_all(folder_); }

  void put(const std::string& name, const std::vector<std::byte>& bytes) {
    write_bytes(folder_ / "clips" / utf8_path(name + ".mcpr"), bytes);
  }
  std::vector<std::byte> file(const std::string& name) const {
    return read_bytes(folder_ / "clips" / utf8_path(name + ".mcpr"));
  }
  fs::path bank() const { return folder_ / "bank.mcpk"; }

  void make(const BankOptions& options = {}) {
    // No engine plays this file, so only packed banks take it.
    if (options.form == runtime::BankForm::Cooked) fs::remove(folder_ / "clips/rle.mcpr");
    make_bank(bank(), find_bank_sources({folder_ / "clips"}), options);
  }

  fs::path folder_;
};

TEST_F(BankTest, GivesEveryFileBackByteForByte) {
  make();
  const BankFile made(bank());
  ASSERT_EQ(made.clips(), 8U);
  for (std::uint32_t clip = 0; clip < made.clips(); ++clip) {
    const runtime::BankEntry entry = made.entry(clip);
    EXPECT_EQ(made.extract(entry), file(entry.name)) << entry.name;
  }
}

TEST_F(BankTest, CutShortWhileItIsReadIsStillWhole) {
  make();
  const BankFile made(bank());
  fs::resize_file(bank(), 100);
  EXPECT_EQ(made.extract(made.entry(0)), file(made.entry(0).name));
  EXPECT_THROW(BankFile cut(bank()), InputError);
}

/// Other writers may store errors with any bits of a float.
TEST_F(BankTest, GivesErrorsBackThatHaveNoCode) {
  const auto put_errors = [&](const std::string& name, float eps, float most) {
    CompressedClip clip = test::segmented_clip(test::smooth_motion(20), SegmentLayout::whole(20));
    std::vector<std::byte> bytes = write_container(clip);
    // A section is its tag, size and checksum, then its payload.
    const auto tag = std::as_bytes(std::span("CLIP", 4));
    std::byte* const section = &*std::search(bytes.begin(), bytes.end(), tag.begin(), tag.end());
    std::byte* const payload = section + runtime::kSectionHead;
    std::memcpy(payload + runtime::kErrorsAt, &eps, sizeof eps);
    std::memcpy(payload + runtime::kErrorsAt + 4, &most, sizeof most);
    std::uint8_t head[8];
    std::memcpy(head, section, sizeof head);
    const std::uint32_t checksum = runtime::section_checksum(
        head, reinterpret_cast<const std::uint8_t*>(payload), runtime::kDescriptionBytes);
    std::memcpy(section + 8, &checksum, sizeof checksum);
    put(name, bytes);
  };
  put_errors("walks/e-most", 0.123456789F, 1e30F);
  put_errors("walks/e-none", 0, 0);
  put_errors("walks/e-one", 0.5F, 1.1F);
  put_errors("walks/e-small", 1e-12F, 0x1p-21F);
  put_errors("walks/e-whole", 0.25F, 1023.5F);
  make();
  const BankFile made(bank());
  for (const char* const name :
       {"walks/e-most", "walks/e-none", "walks/e-one", "walks/e-small", "walks/e-whole"}) {
    const std::int32_t clip = mcpk_find(&made.bank(), name);
    ASSERT_GE(clip, 0);
    const runtime::BankEntry entry = made.entry(static_cast<std::uint32_t>(clip));
    EXPECT_EQ(made.extract(entry), file(name)) << name;
  }
}

TEST(CodedErrors, AreFloatsOf12Bits) {
  std::uint16_t code = 0;
  for (std::uint32_t i = 0; i <= 0xFFFF; ++i) {
    const float error = runtime::error_from(static_cast<std::uint16_t>(i));
    ASSERT_TRUE(runtime::find_error_code(error, code));
    ASSERT_EQ(code, i);
    ASSERT_EQ(runtime::rounded_error(error), error);
  }
  for (const float error : {1e-5F, 0.0512F, 0.5F, 0.3333F, 1.99999F, 66.6F}) {
    const float rounded = runtime::rounded_error(error);
    EXPECT_TRUE(runtime::find_error_code(rounded, code));
    EXPECT_NEAR(rounded, error, error / 4096);
  }
  for (const float error : {-1.0F, 1e9F, 1e-9F, 0.1F})
    EXPECT_FALSE(runtime::find_error_code(error, code));
}

TEST_F(BankTest, SkeletonsThatDifferInOrdersStandOnce) {
  make();
  const std::uint32_t all = BankFile(bank()).bank().count(runtime::BankItem::Part);
  put("walks/xzy", encoded_in_order(test::smooth_motion(60), RotationOrder::Xzy));
  make();
  // A different skeleton would add a part, and so do other orders of rotations.
  EXPECT_EQ(BankFile(bank()).bank().count(runtime::BankItem::Part), all);
}

TEST_F(BankTest, PlaysAsItsFilesDo) {
  make();
  const BankFile made(bank());
  for (std::uint32_t clip = 0; clip < made.clips(); ++clip) {
    const std::string name = made.entry(clip).name;
    const OpenedClip alone(file(name));
    mcpr_info info{};
    mcpr_result result;
    mcpk_inspect(&made.bank(), clip, nullptr, &info, &result);
    EXPECT_EQ(result.status, alone.result.status) << name;
    if (result.status != MCPR_OK) continue;
    EXPECT_EQ(info.motion_bytes, alone.info.motion_bytes);
    OpenedClip banked(std::vector<std::byte>{});
    const AlignedBytes scratch(info.read_bytes);
    std::size_t size = 0;
    ASSERT_EQ(
        mcpk_read(&made.bank(), clip, nullptr, scratch.data(), scratch.size(), &size, nullptr),
        MCPR_OK);
    banked.resident.emplace(size);
    ASSERT_EQ(mcpr_build(scratch.data(), scratch.size(), banked.resident->data(), size,
                         &banked.clip, nullptr),
              MCPR_OK);
    for (const mcpr_output output : {MCPR_CHANNELS, MCPR_LOCAL, MCPR_POSITIONS}) {
      const mcpr_request request{.output = output, .apply_ik = 1};
      EXPECT_EQ(banked.frames(request, 0, info.frames), alone.frames(request, 0, info.frames))
          << name;
    }
    EXPECT_EQ(banked.tracks(0, info.frames), alone.tracks(0, info.frames)) << name;
  }
}

TEST_F(BankTest, CookedClipsGiveThePosesOfClipsCookedAlone) {
  make({.form = runtime::BankForm::Cooked});
  const BankFile made(bank());
  ASSERT_EQ(made.clips(), 7U);
  for (std::uint32_t clip = 0; clip < made.clips(); ++clip) {
    const std::string name = made.entry(clip).name;
    const OpenedClip opened(file(name));
    const CookedClip alone(opened.clip, {.apply_ik = 1, .ik_error = opened.info.error});
    const mcpr_cooked* cooked = nullptr;
    ASSERT_EQ(mcpk_cooked(&made.bank(), clip, &cooked, nullptr), MCPR_OK) << name;
    const mcpr_cooked_info info = mcpr::describe(cooked);
    EXPECT_LT(info.bytes, alone.bytes->size());
    for (const mcpr_layout layout : {MCPR_TRANSFORMS, MCPR_ARRAYS})
      for (double frame = 0; frame < info.frames; frame += 0.7) {
        const mcpr_sample_request request{.layout = layout};
        std::vector<float> pose(mcpr_sample_values(cooked, &request));
        ASSERT_EQ(mcpr_sample(cooked, &request, frame, pose.data(), nullptr), MCPR_OK);
        ASSERT_EQ(pose, alone.sample(request, frame)) << name << " at " << frame;
      }
    EXPECT_EQ(OpenedClip::frames_of(mcpr_cooked_tracks(cooked), 0, info.frames),
              opened.tracks(0, info.frames))
        << name;
    for (std::uint32_t j = 0; j < info.joints; ++j) {
      mcpr_joint expected{};
      mcpr_joint joint{};
      ASSERT_EQ(mcpr_clip_joint(opened.clip, j, &expected, nullptr), MCPR_OK);
      ASSERT_EQ(mcpk_joint(&made.bank(), clip, j, &joint, nullptr), MCPR_OK);
      EXPECT_STREQ(joint.name, expected.name);
      EXPECT_EQ(joint.parent, expected.parent);
      EXPECT_TRUE(std::equal(joint.offset, joint.offset + 3, expected.offset));
      EXPECT_EQ(mcpk_find_joint(&made.bank(), clip, expected.name),
                mcpr_find_joint(opened.clip, expected.name));
    }
  }
}

TEST_F(BankTest, TellsSkeletonsByNumberAndHash) {
  Motion renamed = test::smooth_motion(20);
  Skeleton skeleton;
  for (Joint joint : renamed.skeleton.joints()) {
    joint.name += "2";
    skeleton.add(joint);
  }
  renamed.skeleton = skeleton;
  put("walks/renamed", encoded(renamed));
  for (const runtime::BankForm form : {runtime::BankForm::Packed, runtime::BankForm::Cooked}) {
    make({.form = form});
    const BankFile made(bank());
    const SkeletonsInBank skeletons = made.skeletons();
    for (std::uint32_t clip = 0; clip < made.clips(); ++clip) {
      const std::string name = made.entry(clip).name;
      const OpenedClip alone(file(name));
      const std::uint64_t hash = skeletons.all[skeletons.of_clip[clip]].hash;
      EXPECT_EQ(hash, alone.clip != nullptr ? mcpr_skeleton_hash(alone.clip) : hash) << name;
      if (form == runtime::BankForm::Cooked) {
        EXPECT_EQ(mcpk_skeleton_hash(&made.bank(), clip), hash) << name;
        EXPECT_LT(static_cast<std::uint32_t>(mcpk_skeleton(&made.bank(), clip)),
                  mcpr::describe(&made.bank()).skeletons);
      }
      for (std::uint32_t other = 0; other < clip; ++other) {
        if (mcpk_skeleton(&made.bank(), clip) == mcpk_skeleton(&made.bank(), other)) {
          EXPECT_EQ(skeletons.of_clip[clip], skeletons.of_clip[other]) << name;
        }
      }
    }
    const auto number = [&](const char* name) {
      return skeletons.of_clip[static_cast<std::size_t>(mcpk_find(&made.bank(), name))];
    };
    EXPECT_EQ(number("walks/zyx"), number("walks/yxz"));
    EXPECT_EQ(number("walks/zyx"), number("plain"));
    EXPECT_NE(number("walks/renamed"), number("plain"));
    EXPECT_EQ(mcpk_skeleton(&made.bank(), made.clips()), -1);
    EXPECT_EQ(mcpk_skeleton(nullptr, 0), -1);
  }
}

TEST_F(BankTest, CooksIkAsAskedAndSaysWhatItTakes) {
  const auto bytes_with = [&](const Cooking& cooking, std::uint64_t& ik_bytes) {
    make_bank(bank(), {{"long", folder_ / "clips/long.mcpr", {}}},
              {.form = runtime::BankForm::Cooked, .cooking = cooking},
              [&](const BankProgress& progress) {
                ik_bytes = progress.ik_bytes;
                return true;
              });
    return fs::file_size(bank());
  };
  std::uint64_t with_none = 0;
  std::uint64_t with_some = 0;
  std::uint64_t with_all = 0;
  const std::uint64_t none = bytes_with({.apply_ik = false}, with_none);
  const std::uint64_t some = bytes_with({.ik_error = 0.5F}, with_some);
  const std::uint64_t all = bytes_with({.ik_error = 0.0F}, with_all);
  EXPECT_EQ(with_none, 0U);
  EXPECT_LT(with_some, with_all);
  EXPECT_NEAR(static_cast<double>(some - none), static_cast<double>(with_some), 256);
  EXPECT_NEAR(static_cast<double>(all - none), static_cast<double>(with_all), 256);
}

TEST_F(BankTest, FindsEveryNameAndNoOther) {
  const std::vector<std::byte> plain = file("plain");
  fs::remove_all(folder_ / "clips");
  fs::create_directories(folder_ / "clips/a");
  std::vector<std::string> names = {"a/\xC3\xA9t\xC3\xA9", "zz", std::string(200, 'n'),
                                    std::string(255 - 5, 'n'), "n" + std::string(200, 'm')};
  for (int i = 0; i < 100; ++i) names.push_back("a/" + std::to_string(i));
  for (const std::string& name : names) put(name, plain);
  make();
  const BankFile made(bank());
  ASSERT_EQ(made.clips(), names.size());
  for (const std::string& name : names) {
    const std::int32_t clip = mcpk_find(&made.bank(), name.c_str());
    ASSERT_GE(clip, 0) << name;
    char found[MCPK_NAME_BYTES];
    EXPECT_EQ(mcpk_name(&made.bank(), static_cast<std::uint32_t>(clip), found), name.size());
    EXPECT_EQ(found, name);
    EXPECT_EQ(mcpk_find(&made.bank(), (name + "0000").c_str()), -1);
    EXPECT_EQ(mcpk_find(&made.bank(), ("!" + name).c_str()), -1);
  }
  EXPECT_EQ(mcpk_find(&made.bank(), ""), -1);
}

TEST_F(BankTest, KeepsTagsAndTexts) {
  make({.tags = {"walk", "take=2", "walk"}, .texts = {{"licence", "CC0"}, {"by", ""}}});
  add_to_bank(bank(), {{"other", folder_ / "clips/plain.mcpr", {}}},
              {.tags = {"run"}, .texts = {{"by", "us"}}});
  const BankFile made(bank());
  EXPECT_EQ(made.texts(), (BankTexts{{"licence", "CC0"}, {"by", "us"}}));
  const auto plain = static_cast<std::uint32_t>(mcpk_find(&made.bank(), "plain"));
  const auto other = static_cast<std::uint32_t>(mcpk_find(&made.bank(), "other"));
  EXPECT_EQ(made.describe(plain).tags.size(), 2U);
  EXPECT_STREQ(mcpk_tag(&made.bank(), other, 0), "run");
  EXPECT_EQ(mcpk_tag(&made.bank(), other, 1), nullptr);
  EXPECT_STREQ(mcpk_key(&made.bank(), 0), "licence");
  EXPECT_STREQ(mcpk_value(&made.bank(), 0), "CC0");
  EXPECT_EQ(mcpk_key(&made.bank(), 2), nullptr);
}

class BothForms : public BankTest, public testing::WithParamInterface<runtime::BankForm> {};

TEST_P(BothForms, ClipsCanBeLoadedOneByOne) {
  make({.form = GetParam()});
  const std::vector<std::byte> whole = read_bytes(bank());
  const BankFile expected(bank());
  AlignedBytes memory(whole.size());
  std::memset(memory.data(), 0xAA, whole.size());
  const auto load = [&](std::uint64_t offset, std::uint64_t bytes) {
    std::memcpy(static_cast<std::byte*>(memory.data()) + offset, whole.data() + offset, bytes);
  };
  load(0, MCPK_HEAD_BYTES);
  const mcpk_bank* bank = nullptr;
  ASSERT_EQ(mcpk_open(memory.data(), whole.size(), 0, &bank, nullptr), MCPR_OK);
  EXPECT_NE(mcpk_open(memory.data(), whole.size(), 2, &bank, nullptr), MCPR_OK);
  std::uint64_t offset = 0;
  std::uint64_t bytes = 0;
  ASSERT_EQ(mcpk_place(bank, bank->clips, &offset, &bytes, nullptr), MCPR_OK);
  load(offset, bytes);
  ASSERT_EQ(mcpk_open(memory.data(), whole.size(), 2, &bank, nullptr), MCPR_OK);
  EXPECT_NE(mcpk_open(memory.data(), whole.size(), 1, &bank, nullptr), MCPR_OK);
  EXPECT_EQ(mcpk_place(bank, bank->clips + 1, &offset, &bytes, nullptr), MCPR_ARGUMENT);
  for (std::uint32_t clip = 0; clip < bank->clips; ++clip) {
    ASSERT_EQ(mcpk_place(bank, clip, &offset, &bytes, nullptr), MCPR_OK);
    EXPECT_EQ(offset, expected.entry(clip).place.offset);
    if (bank->is_cooked()) {
      EXPECT_NE(mcpk_check(bank, clip, nullptr), MCPR_OK) << "not there yet";
    }
    load(offset, bytes);
    EXPECT_EQ(mcpk_check(bank, clip, nullptr), mcpk_check(&expected.bank(), clip, nullptr));
  }
}

TEST_P(BothForms, AddingOneByOneMakesTheBytesOfMakingAllAtOnce) {
  make({.form = GetParam()});
  const std::vector<std::byte> at_once = read_bytes(bank());
  std::vector<BankSource> sources = find_bank_sources({folder_ / "clips"});
  std::ranges::sort(sources, {}, &BankSource::name);
  make_bank(bank(), {sources.front()}, {.form = GetParam()});
  for (const BankSource& source : sources) add_to_bank(bank(), {source}, {});
  EXPECT_EQ(read_bytes(bank()), at_once);
}

TEST_P(BothForms, IsTheSameOfFilesAndOfBanksWhoseNamesAlternate) {
  make({.form = GetParam()});
  std::vector<BankSource> sources = find_bank_sources({folder_ / "clips"});
  std::ranges::sort(sources, {}, &BankSource::name);
  std::vector<BankSource> halves[2];
  for (std::size_t i = 0; i < sources.size(); ++i) halves[i % 2].push_back(sources[i]);
  for (const int half : {0, 1})
    make_bank(folder_ / (std::to_string(half) + ".mcpk"), halves[half], {});
  make_bank(folder_ / "merged.mcpk", find_bank_sources({folder_ / "0.mcpk", folder_ / "1.mcpk"}),
            {.form = GetParam()});
  EXPECT_EQ(read_bytes(folder_ / "merged.mcpk"), read_bytes(bank()));
}

TEST_P(BothForms, AddingReplacesByName) {
  make({.form = GetParam()});
  const std::uint32_t clips = BankFile(bank()).clips();
  add_to_bank(bank(), {{"plain", folder_ / "clips/still.mcpr", {}}}, {});
  const BankFile made(bank());
  EXPECT_EQ(made.clips(), clips);
  const auto plain = static_cast<std::uint32_t>(mcpk_find(&made.bank(), "plain"));
  EXPECT_EQ(made.describe(plain).frames, 1);
  EXPECT_TRUE(made.play(plain));
}

TEST_P(BothForms, RemovingMakesTheBytesOfABankThatNeverHadThem) {
  make({.form = GetParam()});
  std::vector<BankSource> sources = find_bank_sources({folder_ / "clips"});
  const auto is_turned = [](const BankSource& source) {
    return source.name == "turned" || source.name == "walks/zyx";
  };
  std::erase_if(sources, is_turned);
  ASSERT_TRUE(remove_from_bank(bank(), {"walks/zyx", "turned", "turned"}));
  make_bank(folder_ / "never.mcpk", sources, {.form = GetParam()});
  EXPECT_EQ(read_bytes(bank()), read_bytes(folder_ / "never.mcpk"));
}

TEST_P(BothForms, RemovingAllLeavesAnEmptyBankAndWhatIsNotThereNothing) {
  make({.form = GetParam(), .texts = {{"by", "us"}}});
  const std::vector<std::byte> before = read_bytes(bank());
  EXPECT_THROW(remove_from_bank(bank(), {"plain", "no such"}), InputError);
  EXPECT_EQ(read_bytes(bank()), before);
  std::vector<std::string> names;
  const BankFile full(bank());
  for (std::uint32_t clip = 0; clip < full.clips(); ++clip)
    names.emplace_back(full.entry(clip).name);
  ASSERT_TRUE(remove_from_bank(bank(), names));
  const BankFile empty(bank());
  EXPECT_EQ(empty.clips(), 0U);
  EXPECT_EQ(empty.texts(), (BankTexts{{"by", "us"}}));
}

// Each process reads the bank before it writes it. Without waiting, most additions would be lost.
TEST_F(BankTest, ManyWhoAddAtOnceAllAddTheirs) {
  make_bank(bank(), {}, {});
  {
    std::vector<std::jthread> adding;
    for (int i = 0; i < 12; ++i)
      adding.emplace_back([this, i] {
        add_to_bank(bank(), {{std::to_string(i), folder_ / "clips/still.mcpr", {}}}, {});
      });
  }
  EXPECT_EQ(BankFile(bank()).clips(), 12U);
}

TEST_F(BankTest, WhoWaitsForAnotherCanStop) {
  make();
  const std::vector<std::byte> before = read_bytes(bank());
  const auto held = FileLock::wait_for(bank(), [] { return false; });
  ASSERT_TRUE(held);
  int asked = 0;
  EXPECT_FALSE(remove_from_bank(bank(), {"plain"}, [&](const BankProgress& progress) {
    EXPECT_EQ(progress.clips, 0U);
    return ++asked < 3;
  }));
  EXPECT_EQ(asked, 3);
  EXPECT_EQ(read_bytes(bank()), before);
}

TEST_P(BothForms, AFailureLeavesTheOldBank) {
  make({.form = GetParam()});
  const std::vector<std::byte> before = read_bytes(bank());
  write_text(folder_ / "wrong.mcpr", "no clip");
  EXPECT_THROW(add_to_bank(bank(), {{"a", folder_ / "wrong.mcpr", {}}}, {}), InputError);
  EXPECT_THROW(
      make_bank(bank(),
                {{"a", folder_ / "clips/plain.mcpr", {}}, {"a", folder_ / "clips/still.mcpr", {}}},
                {.form = GetParam()}),
      InputError);
  EXPECT_EQ(read_bytes(bank()), before);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()), 3);
}

/// A bank of clips so similar that a few teach much.
class LearnedBank : public BankTest {
 protected:
  LearnedBank() {
    fs::create_directories(folder_ / "clips/more");
    for (int i = 0; i < 80; ++i)
      put("more/" + std::to_string(100 + i), encoded(test::smooth_motion(60 + i % 9)));
  }
};

TEST_F(LearnedBank, IsSmallerAndGivesEveryFileBackByteForByteThoseAddedLaterToo) {
  make();
  const std::uint64_t plain = BankFile(bank()).bank().bytes;
  make({.learn = true});
  EXPECT_LT(BankFile(bank()).bank().bytes, plain);
  put("later", encoded(test::smooth_motion(77)));
  add_to_bank(bank(), {{"later", folder_ / "clips/later.mcpr", {}}}, {});
  const BankFile made(bank());
  for (std::uint32_t clip = 0; clip < made.clips(); ++clip) {
    const runtime::BankEntry entry = made.entry(clip);
    EXPECT_EQ(made.extract(entry), file(entry.name)) << entry.name;
    EXPECT_TRUE(made.play(clip)) << entry.name;
  }
  const auto later = static_cast<std::uint32_t>(mcpk_find(&made.bank(), "later"));
  EXPECT_LT(made.describe(later).motion_bytes, sections_of(file("later")).motion_bytes());
}

TEST_F(LearnedBank, CanBeStoppedWhileItLearns) {
  int asked = 0;
  const bool is_whole = make_bank(bank(), find_bank_sources({folder_ / "clips"}), {.learn = true},
                                  [&](const BankProgress& progress) {
                                    EXPECT_EQ(progress.done, 0U);
                                    return ++asked < 20;
                                  });
  EXPECT_FALSE(is_whole);
  EXPECT_EQ(asked, 20);
  EXPECT_FALSE(fs::exists(bank()));
}

TEST_F(BankTest, LearnsNothingFromAFewClips) {
  make();
  const std::vector<std::byte> plain = read_bytes(bank());
  make({.learn = true});
  EXPECT_EQ(read_bytes(bank()), plain);
}

/// A bank in memory with changed bytes.
class HostileBank : public BothForms {
 protected:
  HostileBank() {
    for (const char* const name : {"exact", "turned", "long", "walks/zyx"})
      fs::remove(folder_ / "clips" / (std::string(name) + ".mcpr"));
    make({.form = GetParam(), .tags = {"t"}, .texts = {{"k", "v"}}});
    bytes_ = read_bytes(bank());
  }

  static mcpr_status open(const std::vector<std::byte>& bytes, int check) {
    const AlignedBytes memory(std::max<std::size_t>(bytes.size(), 1));
    std::ranges::copy(bytes, memory.data());
    const mcpk_bank* bank = nullptr;
    return mcpk_open(memory.data(), bytes.size(), check, &bank, nullptr);
  }

  std::vector<std::byte> bytes_;
};

TEST_P(HostileBank, EveryTruncationIsRefused) {
  for (std::size_t size = 0; size < bytes_.size(); ++size) {
    const std::vector<std::byte> cut(bytes_.begin(),
                                     bytes_.begin() + static_cast<std::ptrdiff_t>(size));
    EXPECT_NE(open(cut, 0), MCPR_OK) << size;
  }
}

TEST_P(HostileBank, EveryFlippedBitIsRefused) {
  ASSERT_EQ(open(bytes_, 1), MCPR_OK);
  for (std::size_t i = 0; i < bytes_.size(); ++i) {
    const std::byte flip{static_cast<unsigned char>(1U << (i % 8))};
    bytes_[i] ^= flip;
    EXPECT_NE(open(bytes_, 1), MCPR_OK) << i;
    bytes_[i] ^= flip;
  }
}

INSTANTIATE_TEST_SUITE_P(Forms, BothForms,
                         testing::Values(runtime::BankForm::Packed, runtime::BankForm::Cooked));
INSTANTIATE_TEST_SUITE_P(Forms, HostileBank,
                         testing::Values(runtime::BankForm::Packed, runtime::BankForm::Cooked));

}  // namespace
}  // namespace mocapress
