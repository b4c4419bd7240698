// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/document/preset_shelf.h"

#include <QDir>
#include <QFileInfo>
#include <QPointer>
#include <QStandardPaths>
#include <QUndoStack>
#include <algorithm>

#include "app/studio/document/edit_step.h"
#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/path_kind.h"
#include "core/mocapress/settings_json.h"

namespace mocapress {
namespace {

std::filesystem::path pathOf(const QString& text) {
  return text.toStdU16String();
}

}  // namespace

PresetShelf::PresetShelf(const QString& file, QObject* parent) : QObject(parent), file_(file) {
  try {
    if (!is_there(pathOf(file_))) return;
    own_ = parse_presets(file_.toStdString(), read_text(pathOf(file_)));
  } catch (const Error&) {
    unreadable_ = true;  // the file stays as it is until write()
  }
}

QString PresetShelf::usualFile() {
  return QDir(QStandardPaths::writableLocation(QStandardPaths::AppConfigLocation))
      .filePath(QStringLiteral("presets.json"));
}

std::vector<Settings> PresetShelf::all() const {
  std::vector<Settings> all(built_in_presets().begin(), built_in_presets().end());
  all.insert(all.end(), own_.begin(), own_.end());
  return all;
}

const Settings* PresetShelf::own(const std::string& name) const {
  const auto found =
      std::find_if(own_.begin(), own_.end(), [&](const Settings& one) { return one.name == name; });
  return found == own_.end() ? nullptr : &*found;
}

bool PresetShelf::isBuiltIn(const std::string& name) {
  const auto built_in = built_in_presets();
  return std::any_of(built_in.begin(), built_in.end(),
                     [&](const Settings& one) { return slug(one.name) == slug(name); });
}

bool PresetShelf::isFree(const std::string& name) {
  if (!name.empty() && !isBuiltIn(name)) return true;
  emit noted(tr("This is the name of a built-in preset. Choose another name."));
  return false;
}

bool PresetShelf::save(const Settings& preset) {
  if (!isFree(preset.name)) return false;
  const Settings* before = own(preset.name);
  change([] { return tr("Save Preset"); },
         {{before ? std::optional(*before) : std::nullopt, preset}});
  return true;
}

bool PresetShelf::rename(const QString& name, const QString& to) {
  const Settings* before = own(name.toStdString());
  if (!before || name == to || !isFree(to.toStdString())) return false;
  if (own(to.toStdString())) {
    emit noted(tr("There is a preset %1 already.").arg(to));
    return false;
  }
  Settings after = *before;
  after.name = to.toStdString();
  change([] { return tr("Rename Preset"); }, {{*before, after}});
  return true;
}

void PresetShelf::remove(const QString& name) {
  const Settings* before = own(name.toStdString());
  if (before) change([] { return tr("Remove Preset"); }, {{*before, std::nullopt}});
}

void PresetShelf::importFrom(const QString& path) {
  try {
    std::vector<Edit> edits;
    for (const Settings& preset : parse_presets(path.toStdString(), read_text(pathOf(path)))) {
      if (!isFree(preset.name)) continue;
      const Settings* before = own(preset.name);
      edits.push_back({before ? std::optional(*before) : std::nullopt, preset});
    }
    if (!edits.empty()) change([] { return tr("Import Presets"); }, edits);
  } catch (const Error& error) {
    emit noted(QString::fromStdString(error.what()));
  }
}

void PresetShelf::exportTo(const QString& path, const Settings& preset) {
  try {
    write_text(pathOf(path), presets_text({&preset, 1}));
    emit noted(tr("Wrote %1.").arg(QDir::toNativeSeparators(path)));
  } catch (const Error& error) {
    emit noted(QString::fromStdString(error.what()));
  }
}

void PresetShelf::change(const std::function<QString()>& name, const std::vector<Edit>& edits) {
  if (!history_) return apply(edits, false);
  const QPointer<PresetShelf> shelf(this);  // the history may outlive the shelf
  const auto applied = [shelf, edits](bool backwards) {
    return [shelf, edits, backwards] {
      if (shelf) shelf->apply(edits, backwards);
    };
  };
  history_()->push(new EditStep(name, applied(false), applied(true)));
}

/// Applies each edit to the preset of its name, unless another clip's history has changed that
/// preset meanwhile.
void PresetShelf::apply(const std::vector<Edit>& edits, bool backwards) {
  for (const Edit& edit : edits) {
    const std::optional<Settings>& from = backwards ? edit.after : edit.before;
    const std::optional<Settings>& to = backwards ? edit.before : edit.after;
    const std::string& name = from ? from->name : to->name;
    const auto place = std::find_if(own_.begin(), own_.end(),
                                    [&](const Settings& one) { return one.name == name; });
    const std::optional<Settings> now = place == own_.end() ? std::nullopt : std::optional(*place);
    const bool taken = to && to->name != name && own(to->name);
    if (now != from || taken) continue;
    if (place == own_.end()) {
      if (to) own_.push_back(*to);
    } else if (to) {
      *place = *to;
    } else {
      own_.erase(place);
    }
  }
  write();
  emit changed();
}

/// Renames an unreadable file, so that it is kept. False: that failed. Throws InputError.
bool PresetShelf::setAside() {
  if (!unreadable_) return true;
  QString kept = file_ + QStringLiteral(".unreadable");
  for (int i = 2; QFile::exists(kept); ++i)
    kept = QStringLiteral("%1.unreadable%2").arg(file_).arg(i);
  QFile file(file_);
  if (is_there(pathOf(file_)) && !file.rename(kept)) {
    emit noted(tr("Presets could not be kept: %1").arg(file.errorString()));
    return false;
  }
  unreadable_ = false;
  emit noted(tr("The presets could not be read; their file was renamed to %1.")
                 .arg(QDir::toNativeSeparators(kept)));
  return true;
}

void PresetShelf::write() {
  QDir().mkpath(QFileInfo(file_).absolutePath());
  try {
    if (!setAside()) return;
    write_text(pathOf(file_), own_.empty() ? std::string("[]\n") : presets_text(own_));
  } catch (const Error& error) {
    emit noted(tr("Presets could not be kept: %1").arg(QString::fromStdString(error.what())));
  }
}

}  // namespace mocapress
