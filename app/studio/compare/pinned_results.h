// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QObject>
#include <QPointer>
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

/// Results of the open clip that stay in view while other settings are tried. When the clip is
/// closed they disappear; when it is opened again they are encoded again in the background.
class PinnedResults : public QObject {
  Q_OBJECT

 public:
  PinnedResults(Session* session, PinnedModel* model, QObject* parent = nullptr);

  /// Shows the pins in the views of a window, instead of those of the window before.
  void showIn(PinnedPanel* panel, Viewport* viewport);

  /// True if the current result is final, measured and not pinned yet, and there is room for it.
  bool canPin() const;

  /// Returns the pins that a clip had before.
  using Memory = std::function<std::vector<Pin>(const QString& path)>;
  void setMemory(Memory memory) { memory_ = std::move(memory); }

  /// Pinning, unpinning and renaming are steps of the clip's history.
  void pinCurrent();

  /// Pins what an engine would make of the clip with as many bytes as the current result: key
  /// frames for each track by itself.
  void pinEngine();
  void unpin(int row);
  void rename(int row, const QString& name);

  /// Copies the pin's settings to the document, as a step that can be undone.
  void makeCurrent(int row);

 signals:
  void canPinChanged(bool can);
  void failed(const QString& message);

  /// The user changed the pins; `pins` are all pins that the clip has now.
  void edited(const QString& path, const std::vector<Pin>& pins);

 private:
  struct Result {
    Pin pin;
    DecodedPtr decoded;
  };

  // The colour identifies a pin, which keeps it however often it is encoded again.
  void put(const Result& result, std::size_t row);
  void drop(const QColor& colour);
  void name(const QColor& colour, const QString& name);
  void recall();
  void makeNext();
  void noteEdit();
  bool hasRoom() const;
  std::vector<Pin> all() const;
  QString freeName(const QString& wanted) const;
  QColor freeColour() const;
  void setFinal(bool final);
  void show();
  void showWhetherToPin();

  Session* session_;
  PinnedModel* model_;
  QPointer<PinnedPanel> panel_;
  QPointer<Viewport> viewport_;
  Memory memory_;
  OriginalPtr clip_;  // the clip whose results are pinned
  std::vector<Result> pins_;
  std::deque<Pin> unmade_;  // pins still to be encoded
  JobRunner making_{Workers::LongRunning};
  JobRunner engine_{Workers::LongRunning};
  bool final_ = false;  // the result was made with the document's options
};

}  // namespace mocapress
