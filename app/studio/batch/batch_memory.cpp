// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/batch/batch_memory.h"

#include "core/bank/bank.h"
#include "core/batch/format_options_json.h"
#include "core/mocapress/settings_json.h"
#include "core/report/verdict.h"

namespace mocapress {
namespace {

/// Makes a path relative to the folder, so that a project can be moved with its files. An empty
/// path stays empty.
std::string relative(const QString& path, const QDir& folder) {
  return path.isEmpty() ? std::string() : folder.relativeFilePath(path).toStdString();
}

std::string relative(const std::string& path, const QDir& folder) {
  return relative(QString::fromStdString(path), folder);
}

QString absoluteAt(const Json& json, const char* key, const QDir& folder) {
  const QString path = QString::fromStdString(json.at(key).get<std::string>());
  return path.isEmpty() ? path : QDir::cleanPath(folder.absoluteFilePath(path));
}

Json toJson(ReadOptions reading, const QDir& folder) {
  if (reading.character) reading.character = relative(*reading.character, folder);
  Json json = Json::object();
  put(json, reading);
  return json;
}

Json toJson(const QueuedClip& clip, const QDir& folder) {
  Json json{{"path", relative(clip.source.path, folder)},
            {"folder", clip.source.folder},
            {"skeleton", relative(clip.skeleton, folder)},
            {"reading", toJson(clip.reading, folder)},
            {"left_out", clip.left_out},
            {"preset", clip.own ? to_json(*clip.own) : Json()}};
  put(json, clip.review);
  return json;
}

QueuedClip clipFrom(const Json& json, const QDir& folder) {
  QueuedClip clip;
  clip.source.path = absoluteAt(json, "path", folder).toStdString();
  clip.source.folder = json.at("folder").get<std::string>();
  clip.skeleton = absoluteAt(json, "skeleton", folder).toStdString();
  clip.reading = format_options(json.at("reading"));
  if (clip.reading.character)
    clip.reading.character = absoluteAt(json.at("reading"), "character", folder).toStdString();
  clip.review = review_from(json);
  clip.left_out = json.at("left_out").get<bool>();
  if (const Json& own = json.at("preset"); !own.is_null()) clip.own = preset_from(own);
  return clip;
}

BatchSettings settingsFrom(const Json& json, const QDir& folder) {
  BatchSettings settings;
  settings.folder = absoluteAt(json, "folder", folder);
  settings.names = QString::fromStdString(json.at("names").get<std::string>());
  settings.overwrite = json.at("overwrite").get<bool>();
  settings.character = absoluteAt(json, "character", folder);
  settings.formats.clear();
  for (const Json& format : json.at("formats"))
    if (const auto known = output_format(format.get<std::string>()))
      settings.formats.push_back(*known);
  if (const Json& bank = json.at("bank"); bank.is_string())
    settings.bank = bank_form(bank.get<std::string>());
  settings.learn = json.at("learn").get<bool>();
  return settings;
}

}  // namespace

Json toJson(const RememberedBatch& batch, const QDir& folder) {
  Json formats = Json::array();
  for (const OutputFormat format : batch.settings.formats) formats.push_back(name(format));
  Json clips = Json::array();
  for (const QueuedClip& clip : batch.clips) clips.push_back(toJson(clip, folder));
  return {{"folder", relative(batch.settings.folder, folder)},
          {"names", batch.settings.names.toStdString()},
          {"overwrite", batch.settings.overwrite},
          {"character", relative(batch.settings.character, folder)},
          {"formats", formats},
          {"bank", batch.settings.bank ? Json(name(*batch.settings.bank)) : Json()},
          {"learn", batch.settings.learn},
          {"common", to_json(batch.common)},
          {"clips", clips}};
}

RememberedBatch batchFrom(const Json& json, const QDir& folder) {
  RememberedBatch batch{settingsFrom(json, folder), preset_from(json.at("common")), {}};
  for (const Json& clip : json.at("clips")) batch.clips.push_back(clipFrom(clip, folder));
  return batch;
}

}  // namespace mocapress
