// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QObject>
#include <deque>
#include <functional>
#include <vector>

#include "app/jobs/job_runner.h"
#include "app/studio/document/document.h"
#include "app/studio/document/named_settings.h"

namespace mocapress {

class PinnedModel;
class PinnedPanel;
class Session;
class Viewport;

/// Results of the open clip that stay in view while other settings are tried. They go with the
/// clip, and are there again with it, made anew in the background.
class PinnedResults : public QObject {
  Q_OBJECT

 public:
  PinnedResults(Session* session, PinnedModel* model, PinnedPanel* panel, Viewport* viewport,
                QObject* parent = nullptr);

  /// There is a final result to the settings, measured, that is not pinned yet, and room for it.
  bool canPin() const;

  /// What was pinned of a clip before.
  using Memory = std::function<std::vector<Pin>(const QString& path)>;
  void setMemory(Memory memory) { memory_ = std::move(memory); }

  /// These are steps of the clip's history.
  void pinCurrent();
  void unpin(int row);
  void rename(int row, const QString& name);

  /// Its settings become the document's, which can be undone.
  void makeCurrent(int row);

 signals:
  void canPinChanged(bool can);

  /// By the user: all that is pinned of the clip now.
  void edited(const QString& path, const std::vector<Pin>& pins);

 private:
  struct Result {
    Pin pin;
    DecodedPtr decoded;
  };

  // Each pin of a clip has a colour of its own, however often it is made anew.
  void put(const Result& result, std::size_t row);
  void drop(const QColor& colour);
  void name(const QColor& colour, const QString& name);
  void recall();
  void makeNext();
  void noteEdit();
  std::vector<Pin> all() const;
  QString freeName(const QString& wanted) const;
  QColor freeColour() const;
  void setFinal(bool final);
  void show();
  void showWhetherToPin();

  Session* session_;
  PinnedModel* model_;
  PinnedPanel* panel_;
  Viewport* viewport_;
  Memory memory_;
  std::vector<Result> pins_;
  std::deque<Pin> unmade_;  // of those kept, not made anew yet
  JobRunner making_{Workers::LongRunning};
  bool final_ = false;  // the result is that of the document's options
};

}  // namespace mocapress
