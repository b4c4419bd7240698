// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/library/project.h"

#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <algorithm>
#include <array>

#include "app/studio/document/settings_json.h"
#include "core/base/error.h"
#include "core/base/file.h"

namespace mocapress {
namespace {

const QString kFormat = QStringLiteral("mocapress-project");
constexpr int kVersion = 1;
constexpr std::array kVerdicts = {"", "approved", "rejected"};  // by Verdict

QJsonObject toJson(const Outcome& outcome) {
  return {{QStringLiteral("ratio"), outcome.ratio},
          {QStringLiteral("eps-cm"), outcome.eps_cm},
          {QStringLiteral("max-cm"), outcome.max_cm},
          {QStringLiteral("bytes"), static_cast<double>(outcome.motion_bytes)},
          {QStringLiteral("met"), outcome.met}};
}

Outcome outcomeFrom(const QJsonObject& json) {
  return {json.value(QStringLiteral("ratio")).toDouble(),
          json.value(QStringLiteral("eps-cm")).toDouble(),
          json.value(QStringLiteral("max-cm")).toDouble(),
          static_cast<std::size_t>(json.value(QStringLiteral("bytes")).toDouble()),
          json.value(QStringLiteral("met")).toBool()};
}

QJsonArray toJson(const std::vector<Pin>& pins) {
  QJsonArray json;
  for (const Pin& pin : pins)
    json << QJsonObject{{QStringLiteral("name"), pin.name},
                        {QStringLiteral("colour"), pin.colour.name()},
                        {QStringLiteral("settings"), toJson(ClipSettings{pin.options, {}, {}})}};
  return json;
}

Pin pinFrom(const QJsonObject& json) {
  return {json.value(QStringLiteral("name")).toString(),
          QColor(json.value(QStringLiteral("colour")).toString()),
          settingsFrom(json.value(QStringLiteral("settings")).toObject()).encode};
}

template <typename Enum>
QString wordOf(Enum value) {
  return QString::fromLatin1(name(value).data(), static_cast<qsizetype>(name(value).size()));
}

/// Only what is set.
QJsonObject toJson(const ReadOptions& reading) {
  QJsonObject json;
  if (reading.sample_rate_hz) json.insert(QStringLiteral("rate-hz"), *reading.sample_rate_hz);
  if (reading.cm_per_unit) json.insert(QStringLiteral("cm-per-unit"), *reading.cm_per_unit);
  if (reading.up) json.insert(QStringLiteral("up"), wordOf(*reading.up));
  if (reading.bvh_root) json.insert(QStringLiteral("bvh-root"), wordOf(*reading.bvh_root));
  return json;
}

/// What no reader could use is as if it were not there.
ReadOptions readingFrom(const QJsonObject& json) {
  const auto positive = [&](const QString& key) {
    const double value = json.value(key).toDouble();
    return value > 0 ? std::optional(value) : std::nullopt;
  };
  ReadOptions reading{.sample_rate_hz = positive(QStringLiteral("rate-hz")),
                      .cm_per_unit = positive(QStringLiteral("cm-per-unit"))};
  for (const UpAxis up : {UpAxis::Y, UpAxis::Z})
    if (json.value(QStringLiteral("up")).toString() == wordOf(up)) reading.up = up;
  for (const auto convention : {TranslationConvention::Adds, TranslationConvention::Replaces})
    if (json.value(QStringLiteral("bvh-root")).toString() == wordOf(convention))
      reading.bvh_root = convention;
  return reading;
}

QJsonObject toJson(const ProjectClip& clip, const QDir& folder) {
  QJsonObject json{{QStringLiteral("path"), folder.relativeFilePath(clip.path)}};
  if (!clip.skeleton.isEmpty())
    json.insert(QStringLiteral("skeleton"), folder.relativeFilePath(clip.skeleton));
  if (clip.reading != ReadOptions()) json.insert(QStringLiteral("reading"), toJson(clip.reading));
  if (clip.settings) json.insert(QStringLiteral("settings"), toJson(*clip.settings));
  if (clip.outcome) json.insert(QStringLiteral("outcome"), toJson(*clip.outcome));
  if (clip.verdict != Verdict::None)
    json.insert(QStringLiteral("verdict"),
                QLatin1String(kVerdicts[static_cast<std::size_t>(clip.verdict)]));
  if (!clip.note.isEmpty()) json.insert(QStringLiteral("note"), clip.note);
  if (!clip.pins.empty()) json.insert(QStringLiteral("pins"), toJson(clip.pins));
  return json;
}

QString absolute(const QJsonValue& path, const QDir& folder) {
  return path.toString().isEmpty() ? QString()
                                   : QDir::cleanPath(folder.absoluteFilePath(path.toString()));
}

ProjectClip clipFrom(const QJsonObject& json, const QDir& folder) {
  ProjectClip clip;
  clip.path = absolute(json.value(QStringLiteral("path")), folder);
  if (clip.path.isEmpty()) throw Error("a clip without a path");
  clip.skeleton = absolute(json.value(QStringLiteral("skeleton")), folder);
  clip.reading = readingFrom(json.value(QStringLiteral("reading")).toObject());
  if (json.contains(QStringLiteral("settings")))
    clip.settings = settingsFrom(json.value(QStringLiteral("settings")).toObject());
  if (json.contains(QStringLiteral("outcome")))
    clip.outcome = outcomeFrom(json.value(QStringLiteral("outcome")).toObject());
  const QString verdict = json.value(QStringLiteral("verdict")).toString();
  for (std::size_t i = 0; i < kVerdicts.size(); ++i)
    if (verdict == QLatin1String(kVerdicts[i])) clip.verdict = static_cast<Verdict>(i);
  clip.note = json.value(QStringLiteral("note")).toString();
  for (const auto& pin : json.value(QStringLiteral("pins")).toArray())
    clip.pins.push_back(pinFrom(pin.toObject()));
  return clip;
}

}  // namespace

ProjectClip* Project::find(const QString& path) {
  const auto found = std::find_if(clips.begin(), clips.end(),
                                  [&](const ProjectClip& clip) { return clip.path == path; });
  return found == clips.end() ? nullptr : &*found;
}

bool isProjectFile(const QString& path) {
  return path.endsWith(QLatin1String(".mocapress"), Qt::CaseInsensitive);
}

QByteArray projectText(const Project& project, const QDir& folder) {
  QJsonArray clips;
  for (const ProjectClip& clip : project.clips) clips << toJson(clip, folder);
  QJsonObject json{{QStringLiteral("format"), kFormat},
                   {QStringLiteral("version"), kVersion},
                   {QStringLiteral("clips"), clips}};
  if (!project.current.isEmpty())
    json.insert(QStringLiteral("current"), folder.relativeFilePath(project.current));
  return QJsonDocument(json).toJson();
}

Project parseProject(const QByteArray& text, const QDir& folder) {
  QJsonParseError error;
  const QJsonObject json = QJsonDocument::fromJson(text, &error).object();
  if (error.error != QJsonParseError::NoError)
    throw Error("no project: " + error.errorString().toStdString() + " at byte " +
                std::to_string(error.offset));
  if (json.value(QStringLiteral("format")).toString() != kFormat) throw Error("no project file");
  if (json.value(QStringLiteral("version")).toInt() > kVersion)
    throw Error("the project was saved by a newer version of Mocapress");
  Project project;
  project.current = absolute(json.value(QStringLiteral("current")), folder);
  for (const auto& clip : json.value(QStringLiteral("clips")).toArray())
    project.clips.push_back(clipFrom(clip.toObject(), folder));
  return project;
}

Project readProject(const QString& path) {
  const QByteArray text = QByteArray::fromStdString(read_text(path.toStdU16String()));
  try {
    return parseProject(text, QFileInfo(path).dir());
  } catch (const Error& error) {
    throw Error(path.toStdString() + ": " + error.what());
  }
}

void writeProject(const QString& path, const Project& project) {
  const QDir folder = QFileInfo(path).dir();
  folder.mkpath(QStringLiteral("."));
  const QByteArray text = projectText(project, folder);
  write_text(path.toStdU16String(), {text.constData(), static_cast<std::size_t>(text.size())});
}

}  // namespace mocapress
