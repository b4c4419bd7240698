// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <memory>
#include <vector>

#include "app/jobs/clips.h"
#include "app/jobs/slope_finder.h"
#include "core/codec/format/byte_costs.h"
#include "widgets/panels/bytes_panel.h"

namespace mocapress {

class ByteCostModel;
class ByteStrip;
class Playback;
class Session;

/// Shows how the bytes of the open clip divide by joint and time, and what other settings would
/// bring. The bytes are divided in the background, once the clip's result is final.
class ByteView : public QObject {
  Q_OBJECT

 public:
  ByteView(Session* session, Playback* playback, ByteStrip* strip, ByteCostModel* model,
           BytesPanel* panel, QObject* parent = nullptr);

 private:
  void divide();
  void show(const std::shared_ptr<const ByteCosts>& costs);
  void forgetSlopes();
  void measure();
  void add(int change, const Slope& slope);
  void showState();
  bool measurable() const;

  Session* session_;
  ByteStrip* strip_;
  ByteCostModel* model_;
  BytesPanel* panel_;
  JobRunner dividing_{Workers::Idle};
  SlopeFinder finder_;
  DecodedPtr shown_;             // the clip whose bytes are shown or being divided
  SlopeTask task_;               // task that was started last
  std::vector<QString> titles_;  // of the changes in task_
  std::vector<Slope> slopes_;
  std::vector<SlopeRow> rows_;
};

}  // namespace mocapress
