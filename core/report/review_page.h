// SPDX-License-Identifier: MIT
// Pages on which a reader turns and plays a clip: the original and what it was compressed to. They
// open from disk, without a server. The viewer is JavaScript (core/report/viewer); a build has it
// where core/report/viewer/build had made it before.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/report/review_viewer.h"

namespace mocapress {

/// Whether this build has the viewer.
bool has_review_viewer();

/// Says why it has none, and how to get it.
inline constexpr const char* kNoReviewViewer =
    "this program was built without the viewer of review pages: core/report/viewer/build makes it "
    "where npm and emscripten are";

/// A script that gives a page one clip, of which both files are .mcpr that the runtime plays.
/// `name` is the clip's in the page. A page finds the script of a clip beside it as NAME.review.js.
std::string review_script(std::string_view name, std::span<const std::byte> original,
                          std::span<const std::byte> compressed);

inline constexpr const char* kReviewExtension = ".review.js";

/// The viewer as a section of a page, hidden until a clip is shown. It is well-formed XML.
std::string review_section(std::span<const std::byte> viewer = review_viewer());

/// A script that puts a button to show the clip into each row of the table `clips`, whose rows are
/// headed by the clips' names.
std::string review_buttons();

/// A page of one clip, with all that it needs in it. Facts are short texts about the clip.
std::string review_page(std::string_view name, const std::vector<std::string>& facts,
                        const std::string& script,
                        std::span<const std::byte> viewer = review_viewer());

}  // namespace mocapress
