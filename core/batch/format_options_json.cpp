// SPDX-License-Identifier: MIT
#include "core/batch/format_options_json.h"

#include <initializer_list>

namespace mocapress {
namespace {

template <typename T>
std::optional<T> value_if_any(const Json& json, const std::string& key) {
  return json.contains(key) ? optional_at<T>(json, key.c_str()) : std::nullopt;
}

template <typename Enum>
std::optional<Enum> word_at(const Json& json, const std::string& key,
                            std::initializer_list<Enum> values) {
  const auto word = value_if_any<std::string>(json, key);
  if (!word) return std::nullopt;
  for (const Enum value : values)
    if (*word == name(value)) return value;
  throw Error("has an unknown " + key + ": " + *word);
}

}  // namespace

void put(Json& json, const ReadOptions& options, const std::string& prefix) {
  if (options.sample_rate_hz) json[prefix + "rate_hz"] = *options.sample_rate_hz;
  if (options.cm_per_unit) json[prefix + "cm_per_unit"] = *options.cm_per_unit;
  if (options.up) json[prefix + "up"] = name(*options.up);
  if (options.bvh_root) json[prefix + "bvh_root"] = name(*options.bvh_root);
  if (options.take) json[prefix + "take"] = *options.take;
  if (options.character) json[prefix + "character"] = *options.character;
  if (options.fbx_version) json[prefix + "fbx_version"] = *options.fbx_version;
}

ReadOptions format_options(const Json& json, const std::string& prefix) {
  return {.sample_rate_hz = value_if_any<double>(json, prefix + "rate_hz"),
          .cm_per_unit = value_if_any<double>(json, prefix + "cm_per_unit"),
          .up = word_at(json, prefix + "up", {UpAxis::Y, UpAxis::Z}),
          .bvh_root = word_at(json, prefix + "bvh_root",
                              {TranslationConvention::Adds, TranslationConvention::Replaces}),
          .take = value_if_any<std::string>(json, prefix + "take"),
          .character = value_if_any<std::string>(json, prefix + "character"),
          .fbx_version = value_if_any<int>(json, prefix + "fbx_version")};
}

}  // namespace mocapress
