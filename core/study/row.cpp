// SPDX-License-Identifier: MIT
#include "core/study/row.h"

#include <algorithm>
#include <string>
#include <utility>

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/number_text.h"
#include "core/mocapress/settings_json.h"
#include "core/report/measurement_json.h"
#include "core/study/plan.h"

namespace mocapress {

bool StudyRow::reached() const {
  return measured && mocapress::reached(target, measured->quantity(target.kind, weighting));
}

std::string StudyRow::key() const {
  std::string key = fingerprint + '|' + method + '|';
  for (const std::string_view word :
       {name(target.kind), name(weighting), coding ? name(*coding) : std::string_view()})
    key.append(word).append("|");
  return key + '|' + shortest_text(target.value) + '|' + std::to_string(seed) + '|' +
         shortest_text(ik_ratio.value_or(0));
}

namespace {

/// The one of `values` whose name() the text is. Throws like the JSON library does.
template <typename Enum>
Enum value_named(const Json& text, std::initializer_list<Enum> values) {
  for (const Enum value : values)
    if (name(value) == text.get_ref<const std::string&>()) return value;
  throw Json::other_error::create(501, "unknown word", &text);
}

/// The columns of a measurement, all of them null without one.
void add_measurement(Json& json, const StudyRow& row) {
  const Measurement none;
  const Measurement& m = row.measured ? *row.measured : none;
  const auto add = [&](const char* key, Json value) {
    json[key] = row.measured ? std::move(value) : Json();
  };
  add("reached", row.reached());
  add("frames", m.frames);
  add("channels", m.channels);
  add("sample_rate_hz", m.sample_rate_hz);
  add("raw_bytes", m.raw_bytes);
  add("motion_bytes", m.motion_bytes);
  add("file_bytes", m.file_bytes);
  add("ratio", m.ratio);
  add_errors(m, row.weighting, add);
  add("contacts", m.contacts);
  add("footskate_cm", or_null(m.footskate_cm));
  add("footskate_mean_cm", m.slide ? Json(m.slide->mean_cm) : Json());
  add("footskate_worst_cm", m.slide ? Json(m.slide->worst_cm) : Json());
  add("ik_bytes", or_null(m.ik_bytes));
  add("knee_speed_ratio", or_null(m.knee_speed_ratio));
  add("iterations", or_null(m.iterations));
  add("encode_seconds", m.encode_seconds);
  add("ms_per_frame", m.ms_per_frame());
}

Json to_json(const StudyRow& row) {
  Json json = {{"clip", row.clip},
               {"fingerprint", row.fingerprint},
               {"method", row.method},
               {"target", name(row.target.kind)},
               {"target_value", row.target.value},
               {"weighting", name(row.weighting)},
               {"coding", row.coding ? Json(name(*row.coding)) : Json()},
               {"seed", row.seed},
               {"ik_ratio", or_null(row.ik_ratio)},
               {"jobs", row.jobs}};
  add_measurement(json, row);
  json["verdict"] = text_or_null(name(row.review.verdict));
  json["note"] = text_or_null(row.review.note);
  json["error"] = text_or_null(row.error);
  return json;
}

StudyRow row_from(const Json& json) {
  StudyRow row;
  json.at("clip").get_to(row.clip);
  json.at("fingerprint").get_to(row.fingerprint);
  json.at("method").get_to(row.method);
  const auto kind = target_kind(json.at("target").get_ref<const std::string&>());
  if (!kind) throw Json::other_error::create(501, "unknown target", &json);
  row.target = {*kind, json.at("target_value").get<double>()};
  row.weighting = value_named(json.at("weighting"), kWeightings);
  row.coding.reset();
  if (!json.at("coding").is_null())
    row.coding = value_named(json.at("coding"), {Coding::Rle16, Coding::Deflate, Coding::Adaptive});
  json.at("seed").get_to(row.seed);
  row.ik_ratio = optional_at<double>(json, "ik_ratio");
  json.at("jobs").get_to(row.jobs);
  row.review = {verdict_named(optional_at<std::string>(json, "verdict").value_or("")),
                optional_at<std::string>(json, "note").value_or("")};
  row.error = optional_at<std::string>(json, "error").value_or("");
  if (!json.at("frames").is_null()) row.measured = measurement_of(json);
  return row;
}

std::string csv_field(const Json& value) {
  if (value.is_null()) return "";
  if (!value.is_string()) return value.dump();
  return csv_quoted(value.get_ref<const std::string&>());
}

}  // namespace

std::string to_json_line(const StudyRow& row) {
  return dumped(to_json(row));
}

std::optional<StudyRow> parse_row(std::string_view line) {
  try {
    return row_from(Json::parse(line));
  } catch (const Json::exception&) {
    return std::nullopt;
  }
}

std::string rows_json(std::span<const StudyRow> rows) {
  std::string text = "[";
  for (const StudyRow& row : rows) text += (text.size() > 1 ? ",\n" : "\n") + to_json_line(row);
  return text + "\n]\n";
}

std::string rows_csv(std::span<const StudyRow> rows) {
  std::string text;
  const auto add_line = [&](const Json& row, bool keys) {
    bool first = true;
    for (const auto& [key, value] : row.items()) {
      if (!first) text += ',';
      text += keys ? key : csv_field(value);
      first = false;
    }
    text += '\n';
  };
  add_line(to_json(StudyRow{}), true);
  for (const StudyRow& row : rows) add_line(to_json(row), false);
  return text;
}

namespace {

/// The lines that are whole rows.
struct WholeRows {
  explicit WholeRows(const std::string& text) {
    for (std::size_t begin = 0; begin < text.size();) {
      const std::size_t end = std::min(text.find('\n', begin), text.size());
      const std::string line = text.substr(begin, end - begin);
      if (auto row = parse_row(line)) {
        rows.push_back(std::move(*row));
        lines += line + '\n';
      }
      begin = end + 1;
    }
  }

  std::vector<StudyRow> rows;
  std::string lines;
};

}  // namespace

std::vector<StudyRow> read_rows(const std::filesystem::path& path) {
  return WholeRows(read_text(path)).rows;
}

RowsFile::RowsFile(const std::filesystem::path& path) : lines_(path) {
  const std::string text = lines_.read(0, lines_.size());
  if (text.size() != lines_.size()) throw InputError(path.string(), 0, 0, "cannot be read");
  WholeRows whole(text);
  rows_ = std::move(whole.rows);
  if (whole.lines != text) lines_.replace([&](StagedFile& file) { file.write(whole.lines); });
}

void RowsFile::append(const StudyRow& row) {
  lines_.append(to_json_line(row));
}

}  // namespace mocapress
