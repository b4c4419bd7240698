// SPDX-License-Identifier: MIT
// Reads any bytes as a text that users and batches keep. A text is refused, or comes back when it
// is written. The first byte chooses the kind of text.
#include <cstdlib>
#include <string>

#include "core/base/error.h"
#include "core/batch/project_batch.h"
#include "core/batch/queue_json.h"
#include "core/batch/row.h"
#include "core/formats/csv.h"
#include "core/mocapress/settings_json.h"
#include "core/study/row.h"

namespace {

using namespace mocapress;

void read_presets(const std::string& text) {
  const std::vector<Settings> presets = parse_presets("fuzz.json", text);
  if (parse_presets("again.json", presets_text(presets)) != presets) std::abort();
}

void read_settings(const std::string& text) {
  const Settings settings = settings_from_json(text);
  if (settings_from_json(settings_to_json(settings)) != settings) std::abort();
}

void read_queue(const std::string& text) {
  const std::string once = queue_text(parse_queue("fuzz.json", text));
  if (queue_text(parse_queue("again.json", once)) != once) std::abort();
}

void read_project(const std::string& text) {
  Batch batch{.presets = {Settings{}}};
  add_project(batch, "fuzz.mocapress", text, "{stem}");
}

void read_batch_row(const std::string& text) {
  const auto row = parse_batch_row(text);
  if (!row) return;
  stale_reason(*row);
  to_csv_line(*row);
  to_report_line(*row);
  const std::string line = to_journal_line(*row);
  const auto again = parse_batch_row(line);
  if (!again || to_journal_line(*again) != line) std::abort();
}

void read_study_row(const std::string& text) {
  parse_row(text);
}

void read_tracks(const std::string& text) {
  for (const int frames : {1, 3}) read_csv_tracks("fuzz.csv", text, frames);
}

constexpr void (*kTextKinds[])(const std::string&) = {read_presets, read_settings,  read_queue,
                                                      read_project, read_batch_row, read_study_row,
                                                      read_tracks};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::string text(reinterpret_cast<const char*>(data) + 1, size - 1);
  try {
    kTextKinds[*data % std::size(kTextKinds)](text);
  } catch (const Error&) {
    return 0;
  }
  return 0;
}
