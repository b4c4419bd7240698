// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/batch/batch_memory.h"

#include <QDir>
#include <QFileInfo>
#include <QStandardPaths>

#include "core/bank/bank.h"
#include "core/base/error.h"
#include "core/base/file.h"
#include "core/batch/format_options_json.h"
#include "core/mocapress/settings_json.h"

namespace mocapress {
namespace {

Json toJson(const ReadOptions& reading) {
  Json json = Json::object();
  put(json, reading);
  return json;
}

Json toJson(const QueuedClip& clip) {
  return {{"path", clip.source.path},
          {"folder", clip.source.folder},
          {"skeleton", clip.skeleton},
          {"reading", toJson(clip.reading)},
          {"verdict", name(clip.review.verdict)},
          {"note", clip.review.note},
          {"left_out", clip.left_out},
          {"preset", clip.own ? to_json(*clip.own) : Json()}};
}

QueuedClip clipFrom(const Json& json) {
  QueuedClip clip;
  clip.source.path = json.at("path").get<std::string>();
  clip.source.folder = json.at("folder").get<std::string>();
  clip.skeleton = json.at("skeleton").get<std::string>();
  clip.reading = format_options(json.at("reading"));
  clip.review = {verdict_named(json.at("verdict").get<std::string>()),
                 json.at("note").get<std::string>()};
  clip.left_out = json.at("left_out").get<bool>();
  if (const Json& own = json.at("preset"); !own.is_null()) clip.own = preset_from(own);
  return clip;
}

BatchSettings settingsFrom(const Json& json) {
  BatchSettings settings;
  settings.folder = QString::fromStdString(json.at("folder").get<std::string>());
  settings.names = QString::fromStdString(json.at("names").get<std::string>());
  settings.overwrite = json.at("overwrite").get<bool>();
  settings.character = QString::fromStdString(json.value("character", std::string()));
  settings.formats.clear();
  for (const Json& format : json.at("formats"))
    if (const auto known = output_format(format.get<std::string>()))
      settings.formats.push_back(*known);
  if (const auto bank = json.find("bank"); bank != json.end() && bank->is_string())
    settings.bank = bank_form(bank->get<std::string>());
  settings.learn = json.value("learn", false);
  return settings;
}

}  // namespace

RememberedBatch rememberedBatch(const QString& file) {
  if (!QFileInfo::exists(file)) return {};
  try {
    const Json json = parse_json(file.toStdString(), read_text(file.toStdU16String()));
    RememberedBatch batch{settingsFrom(json), preset_from(json.at("common")), {}};
    for (const Json& clip : json.at("clips")) batch.clips.push_back(clipFrom(clip));
    return batch;
  } catch (const Error&) {
  } catch (const Json::exception&) {
  }
  return {};
}

void rememberBatch(const QString& file, const RememberedBatch& batch) {
  Json formats = Json::array();
  for (const OutputFormat format : batch.settings.formats) formats.push_back(name(format));
  Json clips = Json::array();
  for (const QueuedClip& clip : batch.clips) clips.push_back(toJson(clip));
  const Json json{{"folder", batch.settings.folder.toStdString()},
                  {"names", batch.settings.names.toStdString()},
                  {"overwrite", batch.settings.overwrite},
                  {"character", batch.settings.character.toStdString()},
                  {"formats", formats},
                  {"bank", batch.settings.bank ? Json(name(*batch.settings.bank)) : Json()},
                  {"learn", batch.settings.learn},
                  {"common", to_json(batch.common)},
                  {"clips", clips}};
  QDir().mkpath(QFileInfo(file).absolutePath());
  write_text(file.toStdU16String(), dumped(json, 2) + '\n');
}

QString batchMemory() {
  return QDir(QStandardPaths::writableLocation(QStandardPaths::AppDataLocation))
      .filePath(QStringLiteral("batch.json"));
}

}  // namespace mocapress
