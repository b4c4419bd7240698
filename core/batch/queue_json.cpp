// SPDX-License-Identifier: MIT
#include "core/batch/queue_json.h"

#include "core/bank/bank.h"
#include "core/base/error.h"
#include "core/batch/format_options_json.h"
#include "core/mocapress/settings_json.h"
#include "core/report/verdict.h"

namespace mocapress {
namespace {

std::string text_at(const Json& json, const char* key) {
  const auto found = json.find(key);
  return found == json.end() || found->is_null() ? "" : found->get<std::string>();
}

BatchItem item_from(const Json& json, std::size_t presets) {
  BatchItem item;
  json.at("input").get_to(item.input);
  item.skeleton = text_at(json, "skeleton");
  json.at("output").get_to(item.output);
  json.at("preset").get_to(item.preset);
  if (item.preset >= presets) throw Error(item.input + " has an unknown preset");
  item.review = review_from(json);
  if (const auto reading = json.find("reading"); reading != json.end() && !reading->is_null())
    item.reading = format_options(*reading);
  // An output in a queue must obey the same rules as an output made from a pattern.
  item.output = output_name(item.output, {item.input, {}, {}}, {});
  return item;
}

}  // namespace

std::string queue_text(const Batch& batch) {
  Json json = {{"mocapress_queue", 1},
               {"presets", Json::array()},
               {"formats", Json::array()},
               {"clips", Json::array()}};
  put(json, batch.reading);
  put(json, batch.writing, "out_");
  for (const Settings& preset : batch.presets) json["presets"].push_back(to_json(preset));
  for (const OutputFormat format : batch.formats) json["formats"].push_back(name(format));
  if (batch.bank) json["bank"] = name(*batch.bank);
  if (batch.learn) json["learn"] = true;
  for (const BatchItem item : batch.items) {
    Json reading;
    if (item.reading) put(reading = Json::object(), *item.reading);
    Json clip = {{"input", item.input},
                 {"skeleton", item.skeleton.empty() ? Json() : Json(item.skeleton)},
                 {"reading", reading},
                 {"output", item.output},
                 {"preset", item.preset}};
    put(clip, item.review);
    json["clips"].push_back(std::move(clip));
  }
  return dumped(json, 1) + '\n';
}

Batch parse_queue(const std::string& file, const std::string& text) {
  const Json json = parse_json(file, text);
  try {
    if (!json.is_object() || json.value("mocapress_queue", 0) != 1)
      throw Error("is not a queue of clips");
    Batch batch;
    for (const Json& preset : json.at("presets")) batch.presets.push_back(preset_from(preset));
    batch.formats.clear();
    for (const Json& format : json.at("formats")) {
      const auto known = output_format(format.get<std::string>());
      if (!known) throw Error("has an unknown format: " + format.get<std::string>());
      batch.formats.push_back(*known);
    }
    if (const std::string form = text_at(json, "bank"); !form.empty()) {
      batch.bank = bank_form(form);
      if (!batch.bank) throw Error("has an unknown form of bank: " + form);
    }
    batch.learn = json.value("learn", false);
    check(batch);
    batch.reading = format_options(json);
    batch.writing = format_options(json, "out_");
    for (const Json& clip : json.at("clips"))
      batch.items.push_back(item_from(clip, batch.presets.size()));
    mark_collisions(batch);
    return batch;
  } catch (const Json::exception& error) {
    throw InputError(file, 0, 0, std::string("is not a queue of clips: ") + error.what());
  } catch (const Error& error) {
    throw InputError(file, 0, 0, error.what());
  }
}

}  // namespace mocapress
