// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/batch/batch_memory.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QStandardPaths>

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/batch/format_options_json.h"
#include "core/batch/preset_json.h"

namespace mocapress {
namespace {

QJsonValue toJson(const Preset& preset) {
  return QJsonDocument::fromJson(QByteArray::fromStdString(presets_text({&preset, 1}))).object();
}

/// Throws Error.
Preset presetFrom(const QJsonValue& json) {
  const QByteArray text = QJsonDocument(json.toObject()).toJson();
  return parse_presets("", text.toStdString()).front();
}

QJsonValue toJson(const ReadOptions& reading) {
  Json json = Json::object();
  put(json, reading);
  return QJsonDocument::fromJson(QByteArray::fromStdString(json.dump())).object();
}

/// Throws Error.
ReadOptions readingFrom(const QJsonValue& json) {
  const QByteArray text = QJsonDocument(json.toObject()).toJson();
  return format_options(parse_json("", text.toStdString()));
}

QueuedClip clipFrom(const QJsonObject& json) {
  QueuedClip clip;
  clip.source.path = json[QStringLiteral("path")].toString().toStdString();
  clip.source.folder = json[QStringLiteral("folder")].toString().toStdString();
  clip.skeleton = json[QStringLiteral("skeleton")].toString().toStdString();
  clip.reading = readingFrom(json[QStringLiteral("reading")]);
  clip.review = {verdict_named(json[QStringLiteral("verdict")].toString().toStdString()),
                 json[QStringLiteral("note")].toString().toStdString()};
  clip.left_out = json[QStringLiteral("left_out")].toBool();
  if (json[QStringLiteral("preset")].isObject())
    clip.own = presetFrom(json[QStringLiteral("preset")]);
  return clip;
}

BatchSettings settingsFrom(const QJsonObject& json) {
  BatchSettings settings;
  settings.folder = json[QStringLiteral("folder")].toString();
  settings.names = json[QStringLiteral("names")].toString(settings.names);
  settings.overwrite = json[QStringLiteral("overwrite")].toBool();
  settings.formats.clear();
  for (const QJsonValue& format : json[QStringLiteral("formats")].toArray())
    if (const auto known = output_format(format.toString().toStdString()))
      settings.formats.push_back(*known);
  return settings;
}

/// What cannot be taken over now stays for another time.
void takeOver(const QString& old, const QString& file) {
  try {
    QDir().mkpath(QFileInfo(file).absolutePath());
    write_text(file.toStdU16String(), read_text(old.toStdU16String()));
    QFile::remove(old);
  } catch (const Error&) {
  }
}

}  // namespace

RememberedBatch rememberedBatch(const QString& file) {
  QFile stored(file);
  if (!stored.open(QIODevice::ReadOnly)) return {};
  const QJsonObject json = QJsonDocument::fromJson(stored.readAll()).object();
  if (json.isEmpty()) return {};
  try {
    RememberedBatch batch{settingsFrom(json), presetFrom(json[QStringLiteral("common")]), {}};
    for (const QJsonValue& clip : json[QStringLiteral("clips")].toArray())
      batch.clips.push_back(clipFrom(clip.toObject()));
    return batch;
  } catch (const Error&) {
    return {};
  }
}

void rememberBatch(const QString& file, const RememberedBatch& batch) {
  QJsonArray clips;
  for (const QueuedClip& clip : batch.clips)
    clips.append(QJsonObject{
        {QStringLiteral("path"), QString::fromStdString(clip.source.path)},
        {QStringLiteral("folder"), QString::fromStdString(clip.source.folder)},
        {QStringLiteral("skeleton"), QString::fromStdString(clip.skeleton)},
        {QStringLiteral("reading"), toJson(clip.reading)},
        {QStringLiteral("verdict"), QString::fromStdString(std::string(name(clip.review.verdict)))},
        {QStringLiteral("note"), QString::fromStdString(clip.review.note)},
        {QStringLiteral("left_out"), clip.left_out},
        {QStringLiteral("preset"), clip.own ? toJson(*clip.own) : QJsonValue()}});
  QJsonArray formats;
  for (const OutputFormat format : batch.settings.formats)
    formats.append(QString::fromStdString(std::string(name(format))));
  const QJsonObject json{{QStringLiteral("folder"), batch.settings.folder},
                         {QStringLiteral("names"), batch.settings.names},
                         {QStringLiteral("overwrite"), batch.settings.overwrite},
                         {QStringLiteral("formats"), formats},
                         {QStringLiteral("common"), toJson(batch.common)},
                         {QStringLiteral("clips"), clips}};
  QDir().mkpath(QFileInfo(file).absolutePath());
  write_text(file.toStdU16String(), QJsonDocument(json).toJson().toStdString());
}

QString batchMemory() {
  const auto file_in = [](QStandardPaths::StandardLocation location) {
    return QDir(QStandardPaths::writableLocation(location)).filePath(QStringLiteral("batch.json"));
  };
  const QString file = file_in(QStandardPaths::AppDataLocation);
  const QString once = file_in(QStandardPaths::CacheLocation);  // until November 2026
  if (QFile::exists(once) && !QFile::exists(file)) takeOver(once, file);
  return file;
}

}  // namespace mocapress
