// SPDX-License-Identifier: MIT
#include <filesystem>
#include <map>
#include <vector>

#include "core/report/html_table.h"
#include "core/study/report_tables.h"

namespace mocapress {

using namespace html;

namespace {

/// All that one method failed to do with one clip.
struct Failure {
  std::vector<std::string> steps;    // targets answered by the nearest step
  std::vector<std::string> targets;  // targets not answered
  std::string why;                   // of the first
};

std::string target_text(const Target& target) {
  switch (target.kind) {
    case Target::Kind::Ratio:
      return format_shortest(target.value) + ":1";
    case Target::Kind::CoefficientRatio:
      return "r = " + format_shortest(target.value);
    case Target::Kind::Size:
      return format_shortest(target.value) + " bytes";
    case Target::Kind::Error:
    case Target::Kind::MaxError:
      return format_shortest(target.value) + " cm";
    case Target::Kind::Visibility:
      return format_shortest(target.value) + " times noticed";
  }
  return "";
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

}  // namespace

std::string failure_table(const Results& results) {
  std::map<std::pair<std::string, std::string>, Failure> failures;  // by clip and method
  for (const StudyRow& row : results.rows()) {
    if (row.reached()) continue;
    const bool unread = row.fingerprint.empty();
    Failure& failure = failures[{row.clip, unread ? "every method" : row.method}];
    if (row.measured) {
      failure.steps.push_back(target_text(row.target) + " gave " + ratio_text(row.measured->ratio));
      continue;
    }
    if (!unread) failure.targets.push_back(target_text(row.target));
    if (failure.why.empty()) failure.why = row.error;
  }
  std::string body;
  for (const auto& [of, failure] : failures)
    body += line(row_head(std::filesystem::path(of.first).filename().string()) +
                 cell(escaped(of.second), "name") + cell(joined(failure.targets), "wrap") +
                 cell(escaped(failure.why), "wrap") + cell(joined(failure.steps), "wrap"));
  if (body.empty()) return "";
  const auto left = attribute("class", "name");
  return element(
      "details", "",
      element("summary", "",
              std::to_string(failures.size()) + " pairs of clip and method missed a target") +
          table(line(head("Clip", left) + head("method", left) + head("out of reach", left) +
                     head("why (the first)", left) + head("nearest step", left)),
                body));
}

}  // namespace mocapress
