// SPDX-License-Identifier: MIT
#include "core/report/blind_test_record.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/path_kind.h"
#include "core/base/utf8_path.h"
#include "core/metrics/sight_limits_json.h"

namespace mocapress {
namespace {

constexpr JsonLimits kMost = {.depth = 8, .values = 10'000'000};

Cue cue_named(const std::string& word) {
  for (std::size_t c = 0; c < kCues; ++c)
    if (name(static_cast<Cue>(c)) == word) return static_cast<Cue>(c);
  throw Error("a blind test has an unknown cue: " + word);
}

/// Reads a record. Throws Error and the JSON library's exceptions.
BlindTestRecord read_record(const Json& json) {
  BlindTestRecord record;
  json.at("viewer").get_to(record.viewer);
  json.at("clip").get_to(record.clip);
  json.at("character").get_to(record.character);
  json.at("time").get_to(record.time);
  record.cue = cue_named(json.at("cue").get<std::string>());
  record.limits = limits_from(json.at("limits"));
  json.at("levels").get_to(record.levels);
  for (const Json& answer : json.at("answers"))
    record.answers.push_back({answer.at(0).get<double>(), answer.at(1).get<bool>()});
  const auto is_level = [](double level) { return std::isfinite(level) && level > 0; };
  if (record.levels.empty() || !std::ranges::all_of(record.levels, is_level) ||
      !std::ranges::all_of(record.answers,
                           [&](const BlindAnswer& answer) { return is_level(answer.level); }))
    throw Error("a blind test has a level that is not above 0");
  return record;
}

}  // namespace

int BlindTestRecord::right() const {
  return static_cast<int>(
      std::ranges::count_if(answers, [](const BlindAnswer& answer) { return answer.right; }));
}

ThresholdFit BlindTestRecord::fit() const {
  const auto [least, most] = std::minmax_element(levels.begin(), levels.end());
  return fit_threshold(answers, *least, *most);
}

Json to_json(const BlindTestRecord& record) {
  const ThresholdFit fit = record.fit();
  Json answers = Json::array();
  for (const BlindAnswer& answer : record.answers)
    answers.push_back(Json::array({answer.level, answer.right}));
  return {{"viewer", record.viewer},
          {"clip", record.clip},
          {"character", record.character},
          {"time", record.time},
          {"cue", name(record.cue)},
          {"limits", to_json(record.limits, true)},
          {"levels", record.levels},
          {"right", record.right()},
          {"p", record.p()},
          {"threshold", fit.found ? Json(fit.curve.threshold) : Json()},
          {"threshold_low", fit.found ? Json(fit.low) : Json()},
          {"threshold_high", fit.found ? Json(fit.high) : Json()},
          {"answers", answers}};
}

BlindTestRecord blind_test_from(const Json& json) {
  try {
    return read_record(json);
  } catch (const Json::exception&) {
    throw Error("a blind test lacks a value, or has one of another type");
  }
}

std::vector<BlindTestRecord> read_blind_tests(const std::filesystem::path& path) {
  if (!is_there(path)) return {};
  const std::string file = utf8(path);
  const Json json = parse_json(file, read_text(path), kMost);
  std::vector<BlindTestRecord> records;
  try {
    if (!json.is_array()) throw Error("is not a list of blind tests");
    for (const Json& one : json) records.push_back(blind_test_from(one));
  } catch (const Error& error) {
    throw InputError(file, 0, 0, error.what());
  }
  return records;
}

void add_blind_test(const std::filesystem::path& path, const BlindTestRecord& record) {
  Json all = Json::array();
  for (const BlindTestRecord& before : read_blind_tests(path)) all.push_back(to_json(before));
  all.push_back(to_json(record));
  write_text(path, dumped(all, 1) + '\n');
}

SightLimits limits_by(const std::vector<BlindTestRecord>& records, const SightLimits& otherwise) {
  SightLimits limits = otherwise;
  for (std::size_t c = 0; c < kCues; ++c) {
    const auto cue = static_cast<Cue>(c);
    double least = 0;  // sums of logarithms, as is `share`
    double share = 0;
    int count = 0;
    for (const BlindTestRecord& record : records) {
      const ThresholdFit fit = record.cue == cue ? record.fit() : ThresholdFit();
      if (!fit.found) continue;
      const CueLimit& tested = record.limits.of(cue);
      least += std::log(tested.least * fit.curve.threshold);
      share += std::log(std::max(tested.share, 1e-9) * fit.curve.threshold);
      ++count;
    }
    if (count == 0) continue;
    limits.of(cue).least = std::exp(least / count);
    if (limits.of(cue).share > 0) limits.of(cue).share = std::exp(share / count);
  }
  return limits;
}

}  // namespace mocapress
