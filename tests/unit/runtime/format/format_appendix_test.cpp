// SPDX-License-Identifier: MIT
// The tables in FORMAT.md's appendix match those in the program.
#include <gtest/gtest.h>

#include <cstddef>
#include <string>
#include <vector>

#include "core/base/file.h"
#include "core/runtime/format/coefficient_priors.h"
#include "core/runtime/format/mixed_bit.h"
#include "core/runtime/format/value_prediction.h"

namespace mocapress::test {
namespace {

constexpr const char* kFormatPage = MOCAPRESS_SOURCE_DIR "/core/runtime/format/FORMAT.md";

struct AppendixTable {
  std::string heading;
  std::string text;  // between the fences, without the last newline
};

/// Formats numbers in rows: "1 2 3\n4 5 6".
template <typename Numbers>
std::string rows_of_numbers(const Numbers& numbers, std::size_t in_a_row) {
  std::string text;
  std::size_t i = 0;
  for (const auto number : numbers) {
    if (i > 0) text += i % in_a_row == 0 ? '\n' : ' ';
    text += std::to_string(static_cast<int>(number));
    ++i;
  }
  return text;
}

std::string quoted_lines(const std::string& letters) {
  constexpr std::size_t kLine = 100;
  std::string text;
  for (std::size_t i = 0; i < letters.size(); i += kLine)
    text += (i > 0 ? "\n\"" : "\"") + letters.substr(i, kLine) + '"';
  return text;
}

std::vector<AppendixTable> appendix_of_the_program() {
  std::vector<int> scale_weights;
  for (const auto& level : runtime::kScaleWeights)
    for (const auto weight : level) scale_weights.push_back(weight);
  return {{"### A.1", rows_of_numbers(scale_weights, runtime::kScaleFeatures)},
          {"### A.2", quoted_lines(std::string(runtime::context_priors()))},
          {"### A.3", quoted_lines(std::string(runtime::context_trust()))},
          {"### A.4", rows_of_numbers(runtime::weight_priors(), runtime::MixingWeights::kMost)}};
}

struct TextRange {
  std::size_t begin = 0;
  std::size_t size = 0;
};

/// The text between the first fences below a heading; empty if there are none.
TextRange fenced_below(const std::string& page, const std::string& heading) {
  const std::string fence = "\n```";
  const std::size_t at = page.find('\n' + heading + ' ');
  if (at == std::string::npos) return {};
  const std::size_t opened = page.find(fence + '\n', at);
  if (opened == std::string::npos) return {};
  const std::size_t begin = opened + fence.size() + 1;
  const std::size_t end = page.find(fence, begin);
  return end == std::string::npos ? TextRange{} : TextRange{begin, end - begin};
}

TEST(FormatAppendix, MatchesTheTablesOfTheProgram) {
  const std::string page = read_text(kFormatPage);
  for (const AppendixTable& table : appendix_of_the_program()) {
    const TextRange range = fenced_below(page, table.heading);
    EXPECT_EQ(page.substr(range.begin, range.size), table.text) << table.heading;
  }
}

/// Run this by hand after tests/bench/fit_priors.cpp has made new priors.
TEST(FormatAppendix, DISABLED_TablesAreWrittenAnew) {
  std::string page = read_text(kFormatPage);
  for (const AppendixTable& table : appendix_of_the_program()) {
    const TextRange range = fenced_below(page, table.heading);
    ASSERT_GT(range.size, 0U) << table.heading;
    page.replace(range.begin, range.size, table.text);
  }
  write_text(kFormatPage, page);
}

}  // namespace
}  // namespace mocapress::test
