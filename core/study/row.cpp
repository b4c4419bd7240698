// SPDX-License-Identifier: MIT
#include "core/study/row.h"

#include <algorithm>
#include <string>
#include <utility>

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/utf8_path.h"
#include "core/mocapress/settings_json.h"
#include "core/report/measurement_json.h"
#include "core/report/report_stamp.h"
#include "core/study/plan.h"

namespace mocapress {

bool StudyRow::reached() const {
  const Target& target = settings.target;
  return measured &&
         mocapress::reached(target, measured->quantity(target.kind, settings.weighting));
}

std::string StudyRow::key() const {
  return fingerprint + '|' + dumped(row_json(settings));
}

namespace {

Json to_json(const StudyRow& row) {
  Json json = {{"clip", row.clip}, {"fingerprint", row.fingerprint}};
  json.update(row_json(row.settings));
  json["jobs"] = row.jobs;
  const auto add = [&](const char* key, Json value) {
    json[key] = row.measured ? std::move(value) : Json();
  };
  add("reached", row.reached());
  add_measurement(json, row.measured, row.settings.weighting);
  add("encode_seconds", row.measured ? Json(row.measured->encode_seconds) : Json());
  add("ms_per_frame", row.measured ? Json(row.measured->ms_per_frame()) : Json());
  json["verdict"] = text_or_null(name(row.review.verdict));
  json["note"] = text_or_null(row.review.note);
  json["error"] = text_or_null(row.error);
  return json;
}

StudyRow row_from(const Json& json) {
  StudyRow row;
  json.at("clip").get_to(row.clip);
  json.at("fingerprint").get_to(row.fingerprint);
  row.settings = settings_of_row(json);
  json.at("jobs").get_to(row.jobs);
  row.review = {verdict_named(optional_at<std::string>(json, "verdict").value_or("")),
                optional_at<std::string>(json, "note").value_or("")};
  row.error = optional_at<std::string>(json, "error").value_or("");
  if (!json.at("frames").is_null()) row.measured = measurement_of(json);
  return row;
}

/// A row for a report, with a stamp that names the program and the time.
Json stamped_json(const StudyRow& row, const ReportStamp& stamp) {
  Json json = to_json(row);
  json["program"] = stamp.program;
  json["reported"] = stamp.time;
  return json;
}

std::string csv_field(const Json& value) {
  if (value.is_null()) return "";
  if (!value.is_string()) return dumped(value);
  return csv_quoted(value.get_ref<const std::string&>());
}

}  // namespace

std::string to_json_line(const StudyRow& row) {
  return dumped(to_json(row));
}

std::optional<StudyRow> parse_row(std::string_view line) {
  try {
    return row_from(parse_json("", line));
  } catch (const Json::exception&) {
    return std::nullopt;
  } catch (const Error&) {
    return std::nullopt;
  }
}

std::string rows_json(std::span<const StudyRow> rows) {
  const ReportStamp stamp = report_stamp();
  std::string text = "[";
  for (const StudyRow& row : rows)
    text += (text.size() > 1 ? ",\n" : "\n") + dumped(stamped_json(row, stamp));
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
  const ReportStamp stamp = report_stamp();
  add_line(stamped_json(StudyRow{}, stamp), true);
  for (const StudyRow& row : rows) add_line(stamped_json(row, stamp), false);
  return text;
}

namespace {

/// The complete rows of a text, parsed and as lines.
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
  if (text.size() != lines_.size()) throw InputError(utf8(path), 0, 0, "cannot be read");
  WholeRows whole(text);
  rows_ = std::move(whole.rows);
  if (whole.lines != text) lines_.replace([&](StagedFile& file) { file.write(whole.lines); });
}

void RowsFile::append(const StudyRow& row) {
  lines_.append(to_json_line(row));
}

}  // namespace mocapress
