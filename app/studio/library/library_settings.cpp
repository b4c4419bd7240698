// SPDX-License-Identifier: GPL-3.0-or-later
// Settings and characters of the clips of a library, for many at once.
#include <QFileInfo>
#include <algorithm>
#include <set>
#include <utility>

#include "app/studio/document/edit_step.h"
#include "app/studio/document/own_limits.h"
#include "app/studio/document/session.h"
#include "app/studio/document/settings_field.h"
#include "app/studio/library/library.h"

namespace mocapress {

void Library::setPreset(const std::vector<int>& rows, const Settings& preset) {
  change(
      rows, [] { return tr("Preset"); },
      [&](NamedSettings& settings) {
        const Settings before = std::exchange(settings.preset, preset);
        if (!preset.contacts) settings.preset.contacts = before.contacts;
        if (preset.ranges.empty()) settings.preset.ranges = before.ranges;
        if (!preset.loop) settings.preset.loop = before.loop;
      });
}

void Library::copySettings(int row) {
  const ProjectClip& clip = project_.clips[static_cast<std::size_t>(row)];
  copied_ = clip.settings.value_or(NamedSettings{usualPreset(), {}});
}

void Library::pasteSettings(const std::vector<int>& rows) {
  if (!copied_) return;
  change(
      rows, [] { return tr("Paste Settings"); },
      [this](NamedSettings& settings) {
        const Settings before = settings.preset;
        settings = *copied_;
        settings.preset.contacts = before.contacts;
        settings.preset.ranges = before.ranges;
        settings.preset.loop = before.loop;
      });
}

void Library::pasteImportance(const std::vector<int>& rows) {
  if (!copied_) return;
  change(
      rows, [] { return tr("Paste Importance"); },
      [this](NamedSettings& settings) { settings.preset.importance = copied_->preset.importance; });
}

void Library::takeOwnLimits() {
  std::vector<int> rows;
  for (std::size_t row = 0; row < project_.clips.size(); ++row) {
    std::optional<NamedSettings>& settings = project_.clips[row].settings;
    if (!settings) continue;
    settings->preset.limits.of_cues = ownLimits().limits.of_cues;
    rows.push_back(static_cast<int>(row));
  }
  showRows(rows);
  emit currentChanged();
}

/// Changes settings of several clips in one step. Clips that were never tuned begin with the usual
/// settings.
void Library::change(const std::vector<int>& rows, const std::function<QString()>& name,
                     const std::function<void(NamedSettings&)>& change) {
  SettingsByKey before, after;
  for (const int row : rows) {
    const ProjectClip& clip = project_.clips[static_cast<std::size_t>(row)];
    NamedSettings settings = clip.settings.value_or(NamedSettings{usualPreset(), {}});
    change(settings);
    settings.preset.limits = withOwnLimits(settings.preset.limits);
    if (clip.settings && settings.preset == clip.settings->preset &&
        settings.contacts == clip.settings->contacts)
      continue;
    before.emplace(clip.key(), clip.settings);
    after.emplace(clip.key(), settings);
  }
  if (after.empty()) return;
  const auto text = [name, count = static_cast<int>(after.size())] {
    return count == 1 ? name() : tr("%1, %Ln Clip(s)", nullptr, count).arg(name());
  };
  history_.push(new EditStep(
      text, [this, after] { apply(after); }, [this, before] { apply(before); }));
}

void Library::putCharacter(const std::vector<int>& rows, const QString& file) {
  std::set<std::string> rigs;
  for (const int row : rows)
    if (const std::string& rig = project_.clips[static_cast<std::size_t>(row)].rig; !rig.empty())
      rigs.insert(rig);
  if (rigs.empty()) return;
  const auto put_on = [this, rigs](const std::optional<PutCharacter>& put) {
    Session::CharacterChanges before, after;
    const Characters& now = session_->document().characters();
    for (const std::string& rig : rigs) {
      const auto found = now.find(rig);
      before[rig] = found == now.end() ? std::nullopt : std::optional(found->second);
      after[rig] = put;
    }
    history_.push(new EditStep([] { return tr("Character"); },
                               [this, after] { session_->putCharacters(after); },
                               [this, before] { session_->putCharacters(before); }));
  };
  if (file.isEmpty()) return put_on(std::nullopt);
  reading_character_.start(
      [path = QFileInfo(file).absoluteFilePath()](const Job&) {
        return PutCharacter{read_character(path.toStdU16String()), path, {}};
      },
      put_on, [this](const QString& message) { emit failed(message); });
}

void Library::apply(const SettingsByKey& settings) {
  std::vector<int> rows;
  for (std::size_t row = 0; row < project_.clips.size(); ++row) {
    ProjectClip& clip = project_.clips[row];
    const auto found = settings.find(clip.key());
    if (found == settings.end()) continue;
    clip.bytes_before.reset();
    if (clip.outcome && outdated(clip) == Staleness::None)
      clip.bytes_before = clip.outcome->motion_bytes;
    clip.settings = found->second;
    clip.failure.clear();
    recallOutcome(clip);
    rows.push_back(static_cast<int>(row));
  }
  showRows(rows);
  if (const ProjectClip* open = openNow();
      open && open->settings && settings.count(open->key()) > 0)
    session_->takeSettings(settingsFor(*open->settings, session_->document().original()->motion()));
  emit currentChanged();
}

/// True if the open clip has these settings.
bool Library::isAsNow(const NamedSettings& settings) const {
  const Document& document = session_->document();
  return firstDifference(settingsFor(settings, document.original()->motion()),
                         document.settings()) == SettingsField::None;
}

/// The settings of the open clip.
NamedSettings Library::settingsNow() const {
  const Document& document = session_->document();
  NamedSettings settings = namedSettings(document.settings(), *document.skeleton());
  // Keeps a built-in preset as a batch has it, without the names of this clip's joints.
  for (const Settings& preset : built_in_presets()) {
    if (preset.name != settings.preset.name ||
        !isAsPreset(document.settings(), preset, *document.skeleton()))
      continue;
    const Settings own = std::exchange(settings.preset, preset);
    settings.preset.contacts = own.contacts;
    settings.preset.ranges = own.ranges;
    settings.preset.loop = own.loop;
    settings.preset.limits = own.limits;  // a batch would not add the user's limits
  }
  return settings;
}

void Library::noteSettings() {
  ProjectClip* clip = openNow();
  if (!clip) return;
  const auto state = [clip] { return std::pair(staleVerdict(*clip), outdated(*clip)); };
  const auto before = state();
  // Settings that have not changed since opening are kept as they were written.
  if (clip->settings && isAsNow(*clip->settings)) return;
  clip->settings = settingsNow();
  clip->failure.clear();
  touch();
  if (state() == before) return;
  show(*clip);
  emit currentChanged();
}

/// A character whose file is gone stays in the project: the file may be back another day.
void Library::noteCharacters() {
  CharacterFiles files = filesOf(session_->document().characters());
  if (files == project_.characters) return;
  project_.characters = std::move(files);
  touch();
}

}  // namespace mocapress
