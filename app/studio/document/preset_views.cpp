// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/document/preset_views.h"

#include <QCoreApplication>
#include <QFileDialog>
#include <QInputDialog>
#include <algorithm>

#include "app/studio/document/named_settings.h"
#include "app/studio/document/preset_shelf.h"
#include "app/studio/document/session.h"
#include "widgets/panels/preset_chooser.h"

namespace mocapress {
namespace {

struct PresetTexts {
  Q_DECLARE_TR_FUNCTIONS(mocapress::PresetViews)
};

/// Asks for a text; empty if the user cancelled.
QString askForText(const QString& title, const QString& text, QWidget* window) {
  bool accepted = false;
  const QString name = QInputDialog::getText(window, title, PresetTexts::tr("Name"),
                                             QLineEdit::Normal, text, &accepted);
  return accepted ? name.trimmed() : QString();
}

}  // namespace

void connectShelf(PresetChooser* chooser, PresetShelf* shelf, QWidget* window) {
  QObject::connect(chooser, &PresetChooser::removeRequested, shelf, &PresetShelf::remove);
  QObject::connect(chooser, &PresetChooser::renameRequested, shelf,
                   [shelf, window](const QString& name) {
                     const QString to = askForText(PresetTexts::tr("Rename Preset"), name, window);
                     if (!to.isEmpty()) shelf->rename(name, to);
                   });
  QObject::connect(chooser, &PresetChooser::importRequested, shelf, [shelf, window] {
    const QString path = QFileDialog::getOpenFileName(window, PresetTexts::tr("Import Presets"), {},
                                                      PresetTexts::tr("Presets (*.json)"));
    if (!path.isEmpty()) shelf->importFrom(path);
  });
  QObject::connect(
      chooser, &PresetChooser::exportRequested, shelf, [shelf, window](const Settings& preset) {
        const QString word = QString::fromStdString(slug(preset.name));
        const QString name = word.isEmpty() ? QStringLiteral("preset") : word;
        QString path = QFileDialog::getSaveFileName(window, PresetTexts::tr("Export Preset"),
                                                    name + QStringLiteral(".json"),
                                                    PresetTexts::tr("Presets (*.json)"));
        if (path.isEmpty()) return;
        if (QFileInfo(path).suffix().isEmpty()) path += QStringLiteral(".json");
        Settings named = preset;
        if (named.name.empty()) named.name = QFileInfo(path).completeBaseName().toStdString();
        shelf->exportTo(path, named);
      });
}

Settings askForName(const Settings& preset, QWidget* window) {
  Settings named = preset;
  const std::string offered = PresetShelf::isBuiltIn(preset.name) ? std::string() : preset.name;
  named.name =
      askForText(PresetTexts::tr("Save as Preset"), QString::fromStdString(offered), window)
          .toStdString();
  return named;
}

PresetViews::PresetViews(Session* session, PresetShelf* shelf, PresetChooser* chooser,
                         QWidget* window)
    : QObject(window), session_(session), shelf_(shelf), chooser_(chooser) {
  connect(shelf, &PresetShelf::changed, this, &PresetViews::showPresets);
  connect(&session->document(), &Document::optionsChanged, this, &PresetViews::showSettings);
  connect(&session->document(), &Document::clipChanged, this, &PresetViews::showSettings);
  connect(chooser, &PresetChooser::chosen, session, &Session::choosePreset);
  connect(chooser, &PresetChooser::saveRequested, this, [this, window](const Settings& preset) {
    const Settings named = askForName(preset, window);
    if (!named.name.empty()) save(named);
  });
  connectShelf(chooser, shelf, window);
  showPresets();
}

void PresetViews::save(const Settings& preset) {
  if (!shelf_->isFree(preset.name)) return;  // checked before a step is pushed
  QUndoStack* history = session_->history();
  history->beginMacro(tr("Save Preset"));
  if (shelf_->save(preset)) session_->namePreset(QString::fromStdString(preset.name));
  history->endMacro();
}

/// Offers the presets that the studio can edit clips with; the others serve comparisons in a batch.
void PresetViews::showPresets() {
  std::vector<Settings> presets = shelf_->all();
  std::erase_if(presets, [](const Settings& preset) { return !isTunable(preset); });
  chooser_->setPresets(presets);
  showSettings();
}

void PresetViews::showSettings() {
  const Document& document = session_->document();
  const ClipSettings settings = document.settings();
  const Skeleton none;
  const Skeleton& skeleton = document.skeleton() ? *document.skeleton() : none;
  const std::vector<Settings> presets = shelf_->all();
  // Two presets may have the same settings: then the name decides.
  const auto is_it = [&](const Settings& one, bool by_name) {
    return (!by_name || settings.preset.toStdString() == one.name) &&
           isAsPreset(settings, one, skeleton);
  };
  for (const bool by_name : {true, false})
    for (const Settings& one : presets)
      if (is_it(one, by_name)) return chooser_->setPreset(one);
  chooser_->setPreset(presetOf(settings, skeleton));
}

}  // namespace mocapress
