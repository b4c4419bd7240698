// SPDX-License-Identifier: MIT
#include "core/formats/take_choice.h"

#include <gtest/gtest.h>

namespace mocapress {
namespace {

const std::vector<TakeName> kTakes = {{"smile", false}, {"walk"}, {"jump"}, {"2"}};

std::size_t chosen(const std::optional<std::string>& wanted, Warnings& warnings) {
  return choose_take("file.glb", kTakes, wanted, warnings);
}

TEST(TakeChoice, IsTheFirstThatMovesAndSaysWhichOthersThereAre) {
  Warnings warnings;
  EXPECT_EQ(chosen({}, warnings), 1u);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(warnings[0].text(), "file.glb: take walk is read; there are also smile, jump, 2");
}

TEST(TakeChoice, GoesByNameBeforeItGoesByNumber) {
  Warnings warnings;
  EXPECT_EQ(chosen("jump", warnings), 2u);
  EXPECT_EQ(chosen("2", warnings), 3u);
  EXPECT_EQ(chosen("3", warnings), 2u);
  EXPECT_TRUE(warnings.empty());
}

TEST(TakeChoice, RefusesWhatIsNeitherAndNamesWhatThereIs) {
  for (const char* wanted : {"run", "0", "5", "1.5", ""}) {
    Warnings warnings;
    EXPECT_THROW(chosen(wanted, warnings), InputError) << wanted;
  }
}

TEST(TakeChoice, NamesOnlyTheFirstOfMany) {
  Warnings warnings;
  choose_take("file.glb", std::vector<TakeName>(20, TakeName{"t"}), {}, warnings);
  EXPECT_EQ(warnings.at(0).text(),
            "file.glb: take t is read; there are also t, t, t, t, t, t, t, t and 11 more");
}

TEST(TakeChoice, StaysASentenceWhereNamesAreLong) {
  const std::vector<TakeName> takes(20, TakeName{std::string(26'000, 'a')});
  Warnings warnings;
  choose_take("f", takes, {}, warnings);
  EXPECT_LE(warnings.at(0).message.size(), 200u);
  EXPECT_TRUE(warnings[0].message.ends_with(" and 17 more"));
}

TEST(TakeChoice, SaysThatAFileWithoutTakesMayBeACharacter) {
  Warnings warnings;
  try {
    choose_take("f", {}, {}, warnings);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("as its character"), std::string::npos);
  }
}

TEST(TakeChoice, OffersWhatMovesAndEachKeyChoosesItsOwn) {
  const std::vector<TakeName> takes = {{"smile", false}, {"walk"}, {"jump"}, {"walk"}, {"jump"}};
  const Takes offered = choices(takes, 3);
  EXPECT_EQ(offered.keys, (std::vector<std::string>{"walk", "jump", "4", "5"}));
  EXPECT_EQ(offered.read, 2u);
  Warnings warnings;
  std::vector<std::size_t> chosen;
  for (const std::string& key : offered.keys)
    chosen.push_back(choose_take("file.glb", takes, key, warnings));
  EXPECT_EQ(chosen, (std::vector<std::size_t>{1, 2, 3, 4}));
}

}  // namespace
}  // namespace mocapress
