// SPDX-License-Identifier: MIT
#include "core/report/review_page.h"

#include <nlohmann/json.hpp>

#include "core/base/base64.h"
#include "core/report/markup.h"
#include "core/report/page_script.h"
#include "core/report/report_style.h"
#include "core/report/review_script.h"

namespace mocapress {
namespace {

std::string_view text_of(std::span<const std::byte> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// The arguments of the scripts' functions that show a clip.
std::string shown(std::string_view name, const std::vector<std::string>& facts,
                  const std::vector<ReviewNote>& notes = {}) {
  Json all = Json::array();
  for (const ReviewNote& note : notes) all.push_back({{"frame", note.frame}, {"text", note.text}});
  return "(" + in_script(Json(std::string(name))) + ", " + in_script(Json(facts)) + ", " +
         in_script(all) + ");";
}

}  // namespace

bool has_review_viewer() {
  return !review_viewer().empty();
}

std::string review_script(std::string_view name, std::span<const std::byte> original,
                          std::span<const std::byte> compressed) {
  return "mocapressReview(" + in_script(Json(std::string(name))) + ", \"" +
         base64_of(text_of(original)) + "\",\n\"" + base64_of(text_of(compressed)) + "\");\n";
}

std::string review_section(std::span<const std::byte> viewer) {
  return element("style", "", kReviewStyle) +
         element("section",
                 attribute("id", "review") + attribute("class", "review") +
                     attribute("hidden", "hidden"),
                 "") +
         "<!-- Mocapress and three.js, MIT: both licences stand on top of the script that this "
         "text unpacks to (base64, gzip). -->" +
         element("script", attribute("id", "viewer") + attribute("type", "text/plain"),
                 base64_of(text_of(viewer))) +
         element("script", "", kReviewScript);
}

std::span<const char* const> review_texts() {
  return kReviewTexts;
}

std::string review_button(std::string_view name, const std::vector<std::string>& facts) {
  return element("script", "", "addReviewButton" + shown(name, facts));
}

std::string review_buttons() {
  return kReviewButtons;
}

std::string review_page(std::string_view name, const std::vector<std::string>& facts,
                        const std::string& script, const ReportLanguage& say,
                        const std::vector<ReviewNote>& notes, std::span<const std::byte> viewer) {
  std::string list;
  for (const std::string& fact : facts) list += element("li", "", escaped(fact));
  for (const ReviewNote& note : notes) list += element("li", "", escaped(note.text));
  return html::page_begin(say.code, escaped(name), kReportStyle) +
         element("noscript", "",
                 element("h1", "", escaped(name)) + element("ul", "", list) +
                     element("p", "", say("The viewer needs JavaScript."))) +
         element("script", "", say_script(say, {kReviewTexts})) + review_section(viewer) +
         element("script", "", script) +
         element("script", "", "showClip" + shown(name, facts, notes)) + "</main></body></html>\n";
}

}  // namespace mocapress
