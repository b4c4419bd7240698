// SPDX-License-Identifier: MIT
#include "core/report/review_page.h"

#include <gmock/gmock.h>

#include <array>

#include "core/base/error.h"
#include "core/batch/batch.h"

namespace mocapress::test {
namespace {

using testing::HasSubstr;
using testing::Not;

constexpr std::array<std::byte, 3> kOriginal{std::byte{'f'}, std::byte{'o'}, std::byte{'o'}};
constexpr std::array<std::byte, 1> kCompressed{std::byte{'f'}};

TEST(ReviewPage, HasBothFilesOfAClip) {
  EXPECT_EQ(review_script("walks/slow", kOriginal, kCompressed),
            "mocapressReview(\"walks/slow\", \"Zm9v\",\n\"Zg==\");\n");
}

TEST(ReviewPage, EndsNoScriptByTheNameOfAClip) {
  const std::string script = review_script("a</script>&\"b", kOriginal, kCompressed);
  EXPECT_THAT(script, Not(HasSubstr("</script>")));
  EXPECT_THAT(script, HasSubstr(R"("a\u003c/script\u003e\u0026\"b")"));
  EXPECT_THAT(review_page("a</script>", {"<fact>"}, script), Not(HasSubstr("a</script>")));
}

TEST(ReviewPage, TellsItsFactsWithoutScript) {
  const std::string page = review_page("a & b", {"28:1", "rejected <ana>"}, "");
  EXPECT_THAT(page, HasSubstr("<noscript><h1>a &amp; b</h1><ul><li>28:1</li>"
                              "<li>rejected &lt;ana&gt;</li></ul>"));
}

TEST(ReviewPage, CarriesTheViewerAndNeedsNothingElse) {
  const std::string page = review_page("walk", {}, "mocapressReview();", {}, {}, kOriginal);
  EXPECT_THAT(page, HasSubstr("<script id=\"viewer\" type=\"text/plain\">Zm9v</script>"));
  EXPECT_THAT(page, HasSubstr("mocapressReview();"));
  for (const char* reference : {"src=\"", "href=\""}) EXPECT_THAT(page, Not(HasSubstr(reference)));
}

TEST(ReviewPage, IsRefusedToBatchesOfABuildWithoutTheViewer) {
  const Batch batch{.formats = {OutputFormat::Mcpr, OutputFormat::Review}};
  if (has_review_viewer())
    EXPECT_NO_THROW(check(batch));
  else
    EXPECT_THROW(check(batch), Error);
}

}  // namespace
}  // namespace mocapress::test
