// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/library/library_views.h"

#include <QDockWidget>
#include <QFileDialog>
#include <QGuiApplication>
#include <QMainWindow>
#include <QSettings>
#include <QTimer>
#include <algorithm>
#include <iterator>

#include "app/studio/document/clip_files.h"
#include "app/studio/document/named_settings.h"
#include "app/studio/document/preset_shelf.h"
#include "app/studio/document/session.h"
#include "app/studio/library/background_encoding.h"
#include "app/studio/library/library.h"
#include "widgets/models/library_tree.h"
#include "widgets/models/number_text.h"
#include "widgets/panels/encoding_bar.h"
#include "widgets/panels/library_panel.h"
#include "widgets/panels/review_bar.h"
#include "widgets/panels/slot_control.h"
#include "widgets/plots/library_plot.h"

namespace mocapress {
namespace {

const QString kArrangement = QStringLiteral("library/arrangement");

}  // namespace

LibraryViews::LibraryViews(Session* session, Library* library, LibraryPanel* panel,
                           SlotControl* settings, QWidget* window)
    : QObject(window),
      session_(session),
      library_(library),
      panel_(panel),
      slots_(settings),
      encoding_(new BackgroundEncoding(session, library, this)),
      window_(window) {
  connect(library, &Library::currentChanged, panel,
          [=, this] { panel_->setCurrent(library_->currentRow()); });
  connect(panel, &LibraryPanel::openRequested, library, &Library::openClip);
  connect(panel, &LibraryPanel::removeRequested, library, &Library::remove);
  connect(panel, &LibraryPanel::verdictChosen, library, &Library::setVerdict);
  connect(panel, &LibraryPanel::presetChosen, library, &Library::setPreset);
  connect(panel, &LibraryPanel::copySettingsRequested, library, [this](int row) {
    library_->copySettings(row);
    panel_->setCanPaste(true);
  });
  panel->setCanPaste(library->hasCopy());
  connect(panel, &LibraryPanel::pasteSettingsRequested, library, &Library::pasteSettings);
  connect(panel, &LibraryPanel::pasteImportanceRequested, library, &Library::pasteImportance);
  connect(panel, &LibraryPanel::putCharacterRequested, this, &LibraryViews::putCharacter);
  connect(panel, &LibraryPanel::takeCharacterOffRequested, library,
          [library](const std::vector<int>& rows) { library->putCharacter(rows, {}); });
  connect(library, &Library::compared, this, &LibraryViews::showComparison);
  connect(library, &Library::entered, panel, [panel] { panel->showComparison(false); });
  connect(panel, &LibraryPanel::findMissingRequested, this, &LibraryViews::findMissing);
  // Files change mostly while the user is in another program.
  connect(qApp, &QGuiApplication::applicationStateChanged, this,
          [library](Qt::ApplicationState state) {
            if (state == Qt::ApplicationActive) library->checkFiles();
          });
  // Files also change while this window is active: another program writes them on a second screen
  // or over a network.
  constexpr int kLookAgainMs = 3000;
  auto* const look_again = new QTimer(this);
  connect(look_again, &QTimer::timeout, library, &Library::lookAgain);
  look_again->start(kLookAgainMs);
  connect(panel->encoding(), &EncodingBar::activeChosen, encoding_, &BackgroundEncoding::setActive);
  connect(encoding_, &BackgroundEncoding::activeChanged, panel->encoding(),
          &EncodingBar::setActive);
  connect(encoding_, &BackgroundEncoding::failed, library, &Library::failed);
  encoding_->setInSight([panel] { return panel->rowsInSight(); });
  connect(panel->reviewed(), &ReviewBar::nextRequested, this, &LibraryViews::showNextToReview);
  connect(panel, &LibraryPanel::noteEdited, library, &Library::setNote);
  connect(panel, &LibraryPanel::addRequested, this, &LibraryViews::addClips);
  connect(panel, &LibraryPanel::addFolderRequested, this, &LibraryViews::addFolder);
  connect(settings, &SlotControl::switchRequested, session, &Session::switchSlot);
  connect(settings, &SlotControl::copyRequested, session, &Session::copyToOtherSlot);
  connect(session, &Session::slotsChanged, this, &LibraryViews::showSlots);
  showSlots();
  panel->arrange(QSettings().value(kArrangement).toByteArray());
  connect(panel, &LibraryPanel::arrangementChanged, this,
          [panel] { QSettings().setValue(kArrangement, panel->arrangement()); });
}

void LibraryViews::offer(const PresetShelf* presets) {
  const auto show = [this, presets] {
    std::vector<Settings> tunable;
    std::ranges::copy_if(presets->all(), std::back_inserter(tunable), isTunable);
    panel_->setPresets(tunable);
  };
  connect(presets, &PresetShelf::changed, this, show);
  show();
}

void LibraryViews::offer(LibraryPlot* plot) {
  connect(plot, &LibraryPlot::openRequested, library_, &Library::openClip);
  connect(library_, &Library::currentChanged, plot,
          [this, plot] { plot->setCurrent(library_->currentRow()); });
}

void LibraryViews::showSlots() {
  std::array<QString, 2> summaries;
  for (std::size_t slot = 0; slot < summaries.size(); ++slot)
    if (const auto figures = session_->slotFigures(static_cast<int>(slot)))
      summaries[slot] = tr("%1, %2").arg(ratioText(figures->ratio), lengthText(figures->eps_cm));
  slots_->setSlots(session_->document().tuning().active, summaries);
  slots_->setEnabled(session_->document().original() != nullptr);
}

/// Widens the panel, as far as the window has room, so that all columns of a comparison show.
void LibraryViews::showComparison() {
  panel_->showComparison(true);
  auto* const dock = qobject_cast<QDockWidget*>(panel_->parentWidget());
  auto* const window = qobject_cast<QMainWindow*>(window_);
  if (dock && window)
    window->resizeDocks({dock}, {std::max(dock->width(), panel_->wholeWidth())}, Qt::Horizontal);
}

void LibraryViews::showNextToReview() {
  const int next = panel_->nextToReview();
  if (next >= 0) return library_->openClip(next);
  const int row = library_->currentRow();
  const bool waits = row >= 0 && wantsReview(panel_->tree()->filter()->clips()->entry(row));
  emit library_->noted(waits ? tr("This is the last clip that waits for a verdict.")
                             : tr("No clip that is shown waits for a verdict."));
}

void LibraryViews::judge(Verdict verdict) {
  const int row = library_->currentRow();
  if (row < 0) return;
  const int next = panel_->nextToReview();  // the verdict may remove the clip from the list
  library_->setVerdict({row}, verdict);
  if (next >= 0)
    library_->openClip(next);
  else
    showNextToReview();
}

void LibraryViews::addClips() {
  library_->add(QFileDialog::getOpenFileNames(window_, tr("Add Clips"), library_->clipFolder(),
                                              tr("Motion (%1)").arg(motionPatterns())));
}

void LibraryViews::addFolder() {
  const QString folder =
      QFileDialog::getExistingDirectory(window_, tr("Add Folder"), library_->clipFolder());
  if (!folder.isEmpty()) library_->addFolder(folder);
}

void LibraryViews::putCharacter(const std::vector<int>& rows) {
  const QString file =
      QFileDialog::getOpenFileName(window_, tr("Put a Character On"), library_->clipFolder(),
                                   tr("Characters (*.fbx *.glb *.gltf *.vrm)"));
  if (!file.isEmpty()) library_->putCharacter(rows, file);
}

bool LibraryViews::encodes() const {
  return encoding_->active();
}

void LibraryViews::setEncodes(bool encodes) {
  encoding_->setActive(encodes);
}

void LibraryViews::compareWithBatch() {
  const QString file = QFileDialog::getOpenFileName(
      window_, tr("Compare Library with a Batch"), library_->clipFolder(),
      tr("Batches and projects (batch*.jsonl report*.json report*.html *.mocapress)"));
  if (!file.isEmpty()) library_->compareWith(file);
}

void LibraryViews::findMissing() {
  const QString folder =
      QFileDialog::getExistingDirectory(window_, tr("Find Missing Clips"), library_->clipFolder());
  if (!folder.isEmpty()) library_->findMissing(folder);
}

}  // namespace mocapress
