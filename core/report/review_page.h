// SPDX-License-Identifier: MIT
// Web pages on which a reader turns and plays a clip and its original. They open from disk without
// a server. The viewer is JavaScript (core/report/viewer); a build includes it if
// core/report/viewer/build was run before.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/report/report_language.h"
#include "core/report/review_viewer.h"

namespace mocapress {

/// True if this build includes the viewer.
bool has_review_viewer();

/// Tells why a build has no viewer, and how to get it.
inline constexpr const char* kNoReviewViewer =
    "this program was built without the viewer of review pages: core/report/viewer/build makes it "
    "where npm and emscripten are";

/// A script that adds one clip to a page, from two .mcpr files that the runtime plays. `name` is
/// the clip's name in the page. A page finds the script of a clip beside it as NAME.review.js.
std::string review_script(std::string_view name, std::span<const std::byte> original,
                          std::span<const std::byte> compressed);

inline constexpr const char* kReviewExtension = ".review.js";

/// The viewer as a section of a page, hidden until a clip is opened. It is well-formed XML. Its
/// scripts call say() of say_script().
std::string review_section(std::span<const std::byte> viewer = review_viewer());

/// The texts for say_script() on pages with that section.
std::span<const char* const> review_texts();

/// A script that adds a button for a clip of the page where it stands, below review_section().
std::string review_button(std::string_view name, const std::vector<std::string>& facts);

/// A script that adds a button for the viewer to each row of the table `clips`, whose row headings
/// are the clips' names.
std::string review_buttons();

/// A note on a frame. The viewer goes there when the note is clicked.
struct ReviewNote {
  int frame = 0;
  std::string text;
};

/// Remarks of reviewers on a clip: verdict and note of the whole clip, and notes on frames.
struct ReviewRemarks {
  std::vector<std::string> texts;
  std::vector<ReviewNote> notes;
};

/// A self-contained page for one clip. Facts are short texts about the clip.
std::string review_page(std::string_view name, const std::vector<std::string>& facts,
                        const std::string& script, const ReportLanguage& say = {},
                        const std::vector<ReviewNote>& notes = {},
                        std::span<const std::byte> viewer = review_viewer());

}  // namespace mocapress
