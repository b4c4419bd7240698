// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/library/project.h"

#include <QDateTime>
#include <QFileInfo>
#include <algorithm>

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/batch/format_options_json.h"
#include "core/metrics/sight_limits_json.h"
#include "core/mocapress/settings_json.h"
#include "core/report/verdict.h"

namespace mocapress {
namespace {

constexpr const char* kFormat = "mocapress-project";
constexpr int kVersion = 1;

/// Reads an optional value. Throws the JSON library's exceptions for a wrong type.
template <typename Value>
Value valueAt(const Json& json, const char* key) {
  const auto found = json.find(key);
  return found == json.end() || found->is_null() ? Value() : found->get<Value>();
}

QString textAt(const Json& json, const char* key) {
  return QString::fromStdString(valueAt<std::string>(json, key));
}

std::vector<std::string> texts(const QStringList& lines) {
  std::vector<std::string> all;
  for (const QString& line : lines) all.push_back(line.toStdString());
  return all;
}

Json toJson(const Outcome& outcome) {
  return {{"ratio", outcome.ratio},
          {"eps_cm", outcome.eps_cm},
          {"max_cm", outcome.max_cm},
          {"bytes", outcome.motion_bytes},
          {"met", outcome.met},
          {"visibility", outcome.sight ? Json(name(*outcome.sight)) : Json()},
          {"limits", to_json(outcome.limits, false)},
          {"slide_cm", outcome.slide_cm ? Json(*outcome.slide_cm) : Json()},
          {"warnings", texts(outcome.warnings)},
          {"worst_frame", outcome.worst_frame ? Json(*outcome.worst_frame) : Json()},
          {"worst_point", outcome.worst_point},
          {"source", outcome.source},
          {"made_by", outcome.settings}};
}

std::optional<Sight> sightNamed(const std::string& word) {
  for (const Sight sight : {Sight::NotVisible, Sight::Borderline, Sight::Visible})
    if (name(sight) == word) return sight;
  return {};
}

Outcome outcomeFrom(const Json& json) {
  Outcome outcome{valueAt<double>(json, "ratio"), valueAt<double>(json, "eps_cm"),
                  valueAt<double>(json, "max_cm"), valueAt<std::size_t>(json, "bytes"),
                  valueAt<bool>(json, "met")};
  outcome.sight = sightNamed(valueAt<std::string>(json, "visibility"));
  if (json.contains("limits")) outcome.limits = limits_from(json["limits"]);
  if (json.contains("slide_cm") && !json["slide_cm"].is_null())
    outcome.slide_cm = json["slide_cm"].get<double>();
  for (const std::string& warning : valueAt<std::vector<std::string>>(json, "warnings"))
    outcome.warnings << QString::fromStdString(warning);
  if (json.contains("worst_frame") && !json["worst_frame"].is_null())
    outcome.worst_frame = json["worst_frame"].get<int>();
  outcome.worst_point = valueAt<std::string>(json, "worst_point");
  outcome.source = valueAt<std::string>(json, "source");
  outcome.settings = valueAt<std::string>(json, "made_by");
  return outcome;
}

Json toJson(const InputStamp& stamp) {
  return {{"bytes", stamp.bytes}, {"newest_ns", stamp.newest_ns}, {"hash", stamp.source}};
}

InputStamp stampFrom(const Json& json) {
  const auto hash = valueAt<std::string>(json, "hash");
  return {valueAt<std::uintmax_t>(json, "bytes"), valueAt<std::int64_t>(json, "newest_ns"), hash,
          hash};
}

/// Leaves out settings that no clip can be compressed with, such as an impossible target: reading
/// them back would fail.
void put(Json& json, const NamedSettings& settings) {
  try {
    check(settings.preset);
    json["settings"] = toJson(settings);
  } catch (const Error&) {
  }
}

Json toJson(const Pin& pin) {
  Json json{{"name", pin.name.toStdString()}, {"colour", pin.colour.name().toStdString()}};
  put(json, pin.settings);
  return json;
}

Pin pinFrom(const Json& json) {
  return {textAt(json, "name"), QColor(textAt(json, "colour")),
          namedSettingsFrom(json.at("settings"))};
}

Json toJson(const ProjectClip& clip, const QDir& folder) {
  const auto relative = [&](const QString& path) {
    return folder.relativeFilePath(path).toStdString();
  };
  Json json{{"path", relative(clip.path)}};
  if (!clip.skeleton.isEmpty()) json["skeleton"] = relative(clip.skeleton);
  if (clip.reading != ReadOptions()) put(json["reading"] = Json::object(), clip.reading);
  if (clip.settings) put(json, *clip.settings);
  if (clip.outcome) json["outcome"] = toJson(*clip.outcome);
  if (clip.review != ClipReview()) put(json, clip.review);
  if (clip.notes_beside) json["notes_beside"] = true;
  if (!clip.rig.empty()) json["rig"] = clip.rig;
  if (!clip.stamp.hash.empty()) json["files"] = toJson(clip.stamp);
  for (const Pin& pin : clip.pins) json["pins"].push_back(toJson(pin));
  return json;
}

QString absoluteAt(const Json& json, const char* key, const QDir& folder) {
  const QString path = textAt(json, key);
  return path.isEmpty() ? QString() : QDir::cleanPath(folder.absoluteFilePath(path));
}

ProjectClip clipFrom(const Json& json, const QDir& folder) {
  ProjectClip clip;
  clip.path = absoluteAt(json, "path", folder);
  if (clip.path.isEmpty()) throw Error("a clip without a path");
  clip.skeleton = absoluteAt(json, "skeleton", folder);
  if (json.contains("reading")) clip.reading = format_options(json["reading"]);
  if (json.contains("settings")) clip.settings = namedSettingsFrom(json["settings"]);
  if (json.contains("outcome")) clip.outcome = outcomeFrom(json["outcome"]);
  clip.review = review_from(json);
  clip.notes_beside = valueAt<bool>(json, "notes_beside");
  clip.rig = valueAt<std::string>(json, "rig");
  if (json.contains("files")) clip.stamp = stampFrom(json["files"]);
  for (const Json& pin : valueAt<Json>(json, "pins"))
    if (pin.contains("settings")) clip.pins.push_back(pinFrom(pin));
  return clip;
}

CharacterFiles charactersFrom(const Json& json, const QDir& folder) {
  CharacterFiles characters;
  const auto by_rig = valueAt<Json>(json, "characters");
  for (const auto& [rig, path] : by_rig.items())
    characters.emplace(rig, absoluteAt(by_rig, rig.c_str(), folder));
  return characters;
}

Project projectFrom(const Json& json, const QDir& folder) {
  if (valueAt<std::string>(json, "format") != kFormat) throw Error("no project file");
  if (valueAt<int>(json, "version") > kVersion)
    throw Error("the project was saved by a newer version of Mocapress");
  Project project;
  project.current = clipKey(absoluteAt(json, "current", folder),
                            json.contains("current_take")
                                ? std::optional(valueAt<std::string>(json, "current_take"))
                                : std::nullopt);
  project.characters = charactersFrom(json, folder);
  project.shows_skin = json.value("show_skin", true);
  for (const Json& clip : valueAt<Json>(json, "clips"))
    project.clips.push_back(clipFrom(clip, folder));
  if (json.contains("batch")) project.batch = batchFrom(json["batch"], folder);
  return project;
}

}  // namespace

std::string settingsHash(const ProjectClip& clip) {
  return clip.settings ? settings_hash(clip.settings->preset, clip.reading) : std::string();
}

Staleness staleVerdict(const ProjectClip& clip) {
  if (clip.review.verdict == Verdict::None) return Staleness::None;
  if (clip.missing) return Staleness::Missing;
  return staleness(clip.review.source_hash, clip.review.settings_hash, clip.stamp.source,
                   settingsHash(clip));
}

std::optional<std::string> staleNote(const ProjectClip& clip, const FrameNote& note) {
  return stale_reason(note, clip.stamp.source, settingsHash(clip));
}

Staleness outdated(const ProjectClip& clip) {
  if (!clip.outcome) return Staleness::None;
  if (clip.missing) return Staleness::Missing;
  const Staleness files_and_settings = staleness(clip.outcome->source, clip.outcome->settings,
                                                 clip.stamp.source, settingsHash(clip));
  // The hash does not cover limits that change no bytes.
  const bool judged_otherwise =
      clip.settings && clip.outcome->sight &&
      clip.outcome->limits.of_cues != clip.settings->preset.limits.of_cues;
  return files_and_settings == Staleness::None && judged_otherwise ? Staleness::Settings
                                                                   : files_and_settings;
}

void bindVerdict(ProjectClip& clip) {
  ClipReview& review = clip.review;
  if (review.verdict == Verdict::None || !review.source_hash.empty() || clip.outcome) return;
  const QDateTime given = QDateTime::fromString(QString::fromStdString(review.time), Qt::ISODate);
  if (given.isValid() && clip.stamp.newest_ns / 1'000'000'000 <= given.toSecsSinceEpoch())
    review.source_hash = clip.stamp.source;
}

QHash<QString, int> Project::rows() const {
  QHash<QString, int> rows;
  for (std::size_t row = 0; row < clips.size(); ++row)
    rows.insert(clips[row].key(), static_cast<int>(row));
  return rows;
}

ProjectClip* Project::find(const QString& key) {
  const auto found = std::find_if(clips.begin(), clips.end(),
                                  [&](const ProjectClip& clip) { return clip.key() == key; });
  return found == clips.end() ? nullptr : &*found;
}

ProjectClip* Project::findFile(const QString& path) {
  const auto found = std::find_if(clips.begin(), clips.end(),
                                  [&](const ProjectClip& clip) { return clip.path == path; });
  return found == clips.end() ? nullptr : &*found;
}

bool isProjectFile(const QString& path) {
  return path.endsWith(QLatin1String(".mocapress"), Qt::CaseInsensitive);
}

QByteArray projectText(const Project& project, const QDir& folder) {
  Json json{{"format", kFormat}, {"version", kVersion}, {"clips", Json::array()}};
  if (!project.current.isEmpty()) {
    const QStringList path_and_take = project.current.split(QLatin1Char('\n'));
    json["current"] = folder.relativeFilePath(path_and_take[0]).toStdString();
    if (path_and_take.size() > 1) json["current_take"] = path_and_take[1].toStdString();
  }
  for (const auto& [rig, path] : project.characters)
    json["characters"][rig] = path.isEmpty() ? "" : folder.relativeFilePath(path).toStdString();
  if (!project.shows_skin) json["show_skin"] = false;
  for (const ProjectClip& clip : project.clips) json["clips"].push_back(toJson(clip, folder));
  if (project.batch) json["batch"] = toJson(*project.batch, folder);
  return QByteArray::fromStdString(dumped(json, 2) + '\n');
}

Project parseProject(const QByteArray& text, const QDir& folder) {
  try {
    return projectFrom(parse_json("project", text.toStdString()), folder);
  } catch (const Json::exception& error) {
    throw Error(std::string("no project: ") + error.what());
  }
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
