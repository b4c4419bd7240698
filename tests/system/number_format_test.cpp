// SPDX-License-Identifier: MIT
// Text for programs is the same in every locale: no source formats or parses fractions by functions
// that follow the locale. core/base/number_text.h has functions that do not.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <regex>
#include <string>
#include <vector>

#include "core/base/file.h"

namespace mocapress::test::number_format_test {
namespace {

namespace fs = std::filesystem;

/// Uses of the locale in a source, each with its line.
std::vector<std::string> findings(const std::string& path, const std::string& text) {
  static const std::regex kLocal(R"(%[-+#0]*(\d+|\*)?(\.(\d+|\*))?[lL]?[eEfFgG]\b)"
                                 R"(|\b(asprintf|atof|sto(d|f|ld)|strto(d|f|ld)|sscanf)\s*\()"
                                 R"(|\bsetprecision\b)");
  std::vector<std::string> found;
  std::sregex_iterator match(text.begin(), text.end(), kLocal);
  for (; match != std::sregex_iterator(); ++match) {
    const auto line = std::count(text.begin(), text.begin() + match->position(), '\n') + 1;
    found.push_back(path + ":" + std::to_string(line) + ": " + match->str());
  }
  return found;
}

TEST(NumberFormat, FollowsNoLocaleInAnySource) {
  const fs::path root = MOCAPRESS_SOURCE_DIR;
  int files = 0;
  for (const char* top : {"core", "widgets", "app", "resources/samples"})
    for (const auto& entry : fs::recursive_directory_iterator(root / top)) {
      const std::string extension = entry.path().extension();
      if (extension != ".cpp" && extension != ".h" && extension != ".c") continue;
      const std::string path = fs::relative(entry.path(), root).generic_string();
      if (path.find("/example/") != std::string::npos)
        continue;  // programs of their own, with output for people
      EXPECT_THAT(findings(path, read_text(entry.path())), testing::IsEmpty());
      ++files;
    }
  EXPECT_GT(files, 300) << "the walk over the sources missed some";
}

TEST(NumberFormatChecker, FindsWhatFollowsTheLocale) {
  for (const char* bad : {R"(printf("%f", x))", R"(snprintf(t, 9, "%.*f", 2, x))", R"("%8.3g s")",
                          R"("%-6.1Lf")", R"("%.17g|")", "std::stod(text)", "strtod (text, &end)",
                          "QString::asprintf(format)", "out << std::setprecision(3)"})
    EXPECT_EQ(findings("a.cpp", bad).size(), 1u) << bad;
}

TEST(NumberFormatChecker, PassesIntegersTextsAndPlacesOfTranslations) {
  for (const char* good : {R"(printf("%d of %zu, %s: %016llx", a, b, c, d))", R"(tr("%L1 cm"))",
                           R"(tr("%1, %L2 % of all"))", "50% grey", "fixed_text(x, 2)",
                           "QLocale().toString(x, 'f', 2)"})
    EXPECT_THAT(findings("a.cpp", good), testing::IsEmpty()) << good;
}

}  // namespace
}  // namespace mocapress::test::number_format_test
