// SPDX-License-Identifier: GPL-3.0-or-later
// What the user does to the queue of a BatchSession, each a step that can be undone.
#include <algorithm>
#include <numeric>
#include <set>

#include "app/studio/batch/batch_session.h"
#include "app/studio/document/edit_step.h"

namespace mocapress {

void BatchSession::setSettings(const BatchSettings& settings) {
  if (settings == settings_ || running()) return;
  BatchSettings renamed = settings_;
  renamed.names = settings.names;
  const QString kind = renamed == settings ? QStringLiteral("names") : QString();  // as typed
  history_.push(new EditStep(
      tr("Output"), [this, settings] { apply(settings); },
      [this, before = settings_] { apply(before); }, kind));
}

void BatchSession::setCommon(const Preset& preset) {
  if (running() || preset == queue_.common()) return;
  history_.push(new EditStep(
      tr("Settings"), [this, preset] { queue_.setCommon(preset); },
      [this, before = queue_.common()] { queue_.setCommon(before); }, QStringLiteral("common")));
}

void BatchSession::setOwn(const std::vector<int>& rows, const std::optional<Preset>& preset) {
  std::map<int, std::optional<Preset>> before;
  QString kind = QStringLiteral("own");
  bool locks = false;
  for (const int row : rows) {
    const std::optional<Preset>& own = queue_.clips()[static_cast<std::size_t>(row)].own;
    if (own == preset) continue;
    before[row] = own;
    kind += QStringLiteral(" %1").arg(row);
    locks = locks || own.has_value() != preset.has_value();
  }
  if (running() || before.empty()) return;
  std::map<int, std::optional<Preset>> after = before;
  for (auto& [row, own] : after) own = preset;
  history_.push(new EditStep(
      tr("Settings"), [this, after] { queue_.setOwn(after); },
      [this, before] { queue_.setOwn(before); }, locks ? QString() : kind));
}

void BatchSession::remove(const std::vector<int>& rows) {
  if (running() || rows.empty()) return;
  std::map<int, QueuedClip> clips;
  for (const int row : rows) clips[row] = queue_.clips()[static_cast<std::size_t>(row)];
  history_.push(new EditStep(
      tr("Remove Clips"), [this, rows] { queue_.remove(rows); },
      [this, clips] { queue_.insert(clips); }));
}

void BatchSession::setLeftOut(const std::vector<int>& rows, bool left_out) {
  std::vector<int> others;
  for (const int row : rows)
    if (queue_.clips()[static_cast<std::size_t>(row)].left_out != left_out) others.push_back(row);
  if (running() || others.empty()) return;
  history_.push(new EditStep(
      left_out ? tr("Leave Out Clips") : tr("Export Clips Too"),
      [this, others, left_out] { queue_.setLeftOut(others, left_out); },
      [this, others, left_out] { queue_.setLeftOut(others, !left_out); }));
}

/// Those that are not there yet, at the end.
void BatchSession::add(const std::vector<QueuedClip>& clips) {
  std::set<std::string> there;
  for (const QueuedClip& clip : queue_.clips()) there.insert(clip.source.path);
  std::vector<QueuedClip> fresh;
  for (const QueuedClip& clip : clips)
    if (there.insert(clip.source.path).second) fresh.push_back(reviewed(clip));
  if (fresh.empty()) return;
  std::vector<int> rows(fresh.size());
  std::iota(rows.begin(), rows.end(), queue_.rowCount());
  history_.push(new EditStep(
      tr("Add Clips"), [this, fresh] { queue_.add(fresh); },
      [this, rows] { queue_.remove(rows); }));
}

void BatchSession::undo() {
  if (!running()) history_.undo();
}

void BatchSession::redo() {
  if (!running()) history_.redo();
}

/// Those that are there already get the settings.
void BatchSession::take(const std::vector<QueuedClip>& clips) {
  const bool new_settings = std::any_of(clips.begin(), clips.end(), [this](const auto& clip) {
    const auto& queued = queue_.clips();
    return std::any_of(queued.begin(), queued.end(), [&](const QueuedClip& one) {
      return one.source.path == clip.source.path &&
             (one.own != clip.own || one.reading != clip.reading);
    });
  });
  if (!new_settings) return add(clips);
  history_.beginMacro(tr("Add Clips"));
  add(clips);
  for (const QueuedClip& clip : clips) {
    const auto& queued = queue_.clips();
    const auto at = std::find_if(queued.begin(), queued.end(), [&](const QueuedClip& one) {
      return one.source.path == clip.source.path;
    });
    if (at == queued.end()) continue;
    const auto row = static_cast<int>(at - queued.begin());
    if (at->reading != clip.reading)
      history_.push(new EditStep(
          tr("Settings"), [this, row, after = clip.reading] { queue_.setReading(row, after); },
          [this, row, before = at->reading] { queue_.setReading(row, before); }));
    if (at->own != clip.own) setOwn({row}, clip.own);
  }
  history_.endMacro();
}

}  // namespace mocapress
