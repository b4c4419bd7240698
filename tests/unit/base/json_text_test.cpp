// SPDX-License-Identifier: MIT
#include "core/base/json_text.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "core/base/error.h"

namespace mocapress::json_text_test {
namespace {

std::string refusal(const std::string& text, const JsonLimits& limits = {4, 100}) {
  try {
    parse_json("a.json", text, limits);
    return "parsed";
  } catch (const InputError& error) {
    return error.what();
  }
}

TEST(JsonText, KeysComeBackInTheOrderTheyWereWritten) {
  const std::string text = R"({"z":1,"a":[true,null,"b"],"m":0.1})";
  EXPECT_EQ(dumped(parse_json("a.json", text)), text);
}

TEST(JsonText, RefusalsNameLineAndColumn) {
  EXPECT_EQ(refusal(""), "a.json:1:1: is not JSON from here on");
  EXPECT_EQ(refusal("{\n  \"asset\": }"), "a.json:2:12: is not JSON from here on");
  EXPECT_EQ(refusal("1e999"), "a.json: holds a number that is too large");
}

TEST(JsonText, MoreThanTheLimitsIsRefused) {
  EXPECT_EQ(refusal("[[[[1]]]]"), "parsed");
  EXPECT_EQ(refusal("[[[[[1]]]]]"), "a.json: nests its JSON more than 4 deep");
  std::string many = "[0";
  for (int i = 0; i < 100; ++i) many += ",0";
  EXPECT_EQ(refusal(many + "]"), "a.json: holds too many JSON values");
}

TEST(JsonText, BytesThatAreNoUtf8AreReplaced) {
  EXPECT_EQ(dumped(Json("a\xff")), "\"a\xEF\xBF\xBD\"");
}

}  // namespace
}  // namespace mocapress::json_text_test
