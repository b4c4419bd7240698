// SPDX-License-Identifier: MIT
#include "core/batch/queue_json.h"

#include "core/base/error.h"
#include "core/batch/preset_json.h"
#include "core/study/json_value.h"

namespace mocapress {
namespace {

template <typename T>
std::optional<T> value_if_any(const Json& json, const char* key) {
  const auto found = json.find(key);
  if (found == json.end() || found->is_null()) return std::nullopt;
  return found->get<T>();
}

template <typename Enum>
std::optional<Enum> word_at(const Json& json, const std::string& key,
                            std::initializer_list<Enum> values) {
  const auto word = value_if_any<std::string>(json, key.c_str());
  if (!word) return std::nullopt;
  for (const Enum value : values)
    if (*word == name(value)) return value;
  throw Error("has a " + key + " that is not known: " + *word);
}

/// Only what is set, under keys that begin with `prefix`.
void put(Json& json, const std::string& prefix, const ReadOptions& options) {
  if (options.sample_rate_hz) json[prefix + "rate_hz"] = *options.sample_rate_hz;
  if (options.cm_per_unit) json[prefix + "cm_per_unit"] = *options.cm_per_unit;
  if (options.up) json[prefix + "up"] = name(*options.up);
  if (options.bvh_root) json[prefix + "bvh_root"] = name(*options.bvh_root);
}

ReadOptions format_options(const Json& json, const std::string& prefix) {
  return {.sample_rate_hz = value_if_any<double>(json, (prefix + "rate_hz").c_str()),
          .cm_per_unit = value_if_any<double>(json, (prefix + "cm_per_unit").c_str()),
          .up = word_at(json, prefix + "up", {UpAxis::Y, UpAxis::Z}),
          .bvh_root = word_at(json, prefix + "bvh_root",
                              {TranslationConvention::Adds, TranslationConvention::Replaces})};
}

BatchItem item_from(const Json& json, std::size_t presets) {
  BatchItem item;
  json.at("input").get_to(item.input);
  item.skeleton = value_if_any<std::string>(json, "skeleton").value_or("");
  json.at("output").get_to(item.output);
  json.at("preset").get_to(item.preset);
  if (item.preset >= presets) throw Error(item.input + " has a preset that is not there");
  item.review = {verdict_named(value_if_any<std::string>(json, "verdict").value_or("")),
                 value_if_any<std::string>(json, "note").value_or("")};
  // The same rules as for a name that a pattern makes.
  item.output = output_name(item.output, {item.input, {}, {}}, {});
  return item;
}

}  // namespace

std::string queue_text(const Batch& batch) {
  Json json = {{"mocapress_queue", 1},
               {"presets", Json::array()},
               {"formats", Json::array()},
               {"clips", Json::array()}};
  put(json, "", batch.reading);
  put(json, "out_", batch.writing);
  for (const Preset& preset : batch.presets) json["presets"].push_back(to_json(preset));
  for (const OutputFormat format : batch.formats) json["formats"].push_back(name(format));
  for (const BatchItem item : batch.items)
    json["clips"].push_back({{"input", item.input},
                             {"skeleton", item.skeleton.empty() ? Json() : Json(item.skeleton)},
                             {"output", item.output},
                             {"preset", item.preset},
                             {"verdict", text_or_null(name(item.review.verdict))},
                             {"note", text_or_null(item.review.note)}});
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
      if (!known) throw Error("has a format that is not known: " + format.get<std::string>());
      batch.formats.push_back(*known);
    }
    batch.reading = format_options(json, "");
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
