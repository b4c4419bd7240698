// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/window/notices.h"

#include <QFileInfo>
#include <chrono>
#include <utility>

#include "app/studio/compare/view_pictures.h"
#include "app/studio/document/clip_files.h"
#include "app/studio/document/preset_shelf.h"
#include "app/studio/document/session.h"
#include "app/studio/library/library.h"
#include "widgets/panels/message_bar.h"

namespace mocapress {
namespace {

constexpr std::chrono::milliseconds kSlowOpening{400};  // delay before the message

}  // namespace

Notices::Notices(Session* session, Library* library, MessageBar* bar, QObject* parent)
    : QObject(parent), session_(session), library_(library), bar_(bar) {
  slow_opening_.setSingleShot(true);
  slow_opening_.setInterval(kSlowOpening);
  connect(&slow_opening_, &QTimer::timeout, this, &Notices::showSlowOpening);
  tellOfSession();
  tellOfLibrary();
}

void Notices::say(const QString& note) {
  bar_->showNote(note);
}

void Notices::keep(const QString& note) {
  say(note);
  if (library_->currentRow() >= 0) kept_ = note;
}

void Notices::showSlowOpening() {
  bar_->showWork(tr("Opening %1…").arg(QFileInfo(opening_).fileName()));
}

void Notices::tellOfSession() {
  connect(session_, &Session::opening, this, [this](const QString& path) {
    opening_ = path;
    is_opening_ = true;
    slow_opening_.start();
  });
  connect(session_, &Session::opened, this, [this] {
    slow_opening_.stop();
    is_opening_ = false;
    bar_->hide();
    if (!kept_.isEmpty()) say(std::exchange(kept_, {}));
    if (!kept_error_.isEmpty()) bar_->showError(std::exchange(kept_error_, {}));
  });
  connect(session_, &Session::openFailed, this, [this] {
    slow_opening_.stop();
    is_opening_ = false;
    kept_.clear();
    kept_error_.clear();
  });
  connect(session_, &Session::compressFailed, bar_,
          [this](const QString& message, bool out_of_reach) {
            if (!out_of_reach) bar_->showError(message);  // else the panel's target shows it
          });
  connect(session_, &Session::characterPut, bar_, &MessageBar::hide);
  connect(session_, &Session::characterFailed, this, [this](const QString& message) {
    bar_->showError(message);
    if (is_opening_) kept_error_ = message;
  });
  connect(session_, &Session::saveFailed, bar_,
          [this](const QString& message) { bar_->showError(message); });
}

void Notices::tellOfLibrary() {
  connect(library_, &Library::failed, bar_,
          [this](const QString& message) { bar_->showError(message); });
  connect(library_, &Library::noted, this, &Notices::keep);
  connect(library_, &Library::recovered, this, [this](int clips) {
    keep(tr("The last session ended unexpectedly. Its project was restored: %Ln clip(s).", nullptr,
            clips));
  });
}

void Notices::tellOf(ClipFiles* files, QAction* choose_skeleton) {
  connect(files, &ClipFiles::openFailed, bar_,
          [this, choose_skeleton](const QString& message, bool wants_skeleton) {
            bar_->showError(message, wants_skeleton ? choose_skeleton : nullptr);
          });
  connect(files, &ClipFiles::saved, this,
          [this](const QString& name) { say(tr("Saved %1.").arg(name)); });
  connect(files, &ClipFiles::exported, this,
          [this](const QString& name) { say(tr("Exported %1.").arg(name)); });
}

void Notices::tellOf(PresetShelf* presets) {
  connect(presets, &PresetShelf::noted, this, &Notices::say);
}

void Notices::tellOf(ViewPictures* pictures) {
  connect(pictures, &ViewPictures::noted, this, &Notices::say);
  connect(pictures, &ViewPictures::failed, bar_,
          [this](const QString& message) { bar_->showError(message); });
}

}  // namespace mocapress
