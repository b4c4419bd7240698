// SPDX-License-Identifier: MIT
// Web pages on which a reader turns and plays a clip and its original. They open from disk without
// a server. The viewer is JavaScript (core/report/viewer); a build contains it if
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

/// True if this build contains the viewer.
bool has_review_viewer();

/// Tells why a build has no viewer, and how to get one.
inline constexpr const char* kNoReviewViewer =
    "this program was built without the viewer of review pages: core/report/viewer/build makes it "
    "where npm and emscripten are";

/// Makes a script that adds one clip to a page, from two .mcpr files that the runtime plays. `name`
/// is the clip's name in the page. If a page does not have the script itself, it loads the file
/// NAME.review.js beside it.
std::string review_script(std::string_view name, std::span<const std::byte> original,
                          std::span<const std::byte> compressed);

inline constexpr const char* kReviewExtension = ".review.js";

/// The viewer as a section of a page, hidden until a clip is opened. The section is well-formed
/// XML, and its scripts need say() of say_script().
std::string review_section(std::span<const std::byte> viewer = review_viewer());

/// The texts that say_script() needs on pages with review_section().
std::span<const char* const> review_texts();

/// Makes a script that adds a button for a clip where the script stands. It must stand below
/// review_section().
std::string review_button(std::string_view name, const std::vector<std::string>& facts);

/// Makes a script that adds a button for the viewer to each row of the table `clips`. The heads of
/// its rows must be the clips' names.
std::string review_buttons();

/// A note on a frame. A click on it takes the viewer to that frame.
struct ReviewNote {
  int frame = 0;
  std::string text;
};

/// Reviewers' remarks on a clip: verdict and note on the whole clip, and notes on frames.
struct ReviewRemarks {
  std::vector<std::string> texts;
  std::vector<ReviewNote> notes;
};

/// Makes a page for one clip that needs no other file. Facts are short texts about the clip.
std::string review_page(std::string_view name, const std::vector<std::string>& facts,
                        const std::string& script, const ReportLanguage& say = {},
                        const std::vector<ReviewNote>& notes = {},
                        std::span<const std::byte> viewer = review_viewer());

}  // namespace mocapress
