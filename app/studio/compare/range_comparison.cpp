// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/compare/range_comparison.h"

#include <QAction>

#include "widgets/plots/error_graph.h"
#include "widgets/timeline/playback.h"
#include "widgets/timeline/timeline.h"

namespace mocapress {

RangeComparison::RangeComparison(Playback* playback, Timeline* timeline, ErrorGraph* graph,
                                 QAction* toggle, const Switches& switches, QObject* parent)
    : QObject(parent),
      playback_(playback),
      timeline_(timeline),
      graph_(graph),
      toggle_(toggle),
      switches_(switches) {
  toggle->setCheckable(true);
  toggle->setEnabled(false);
  connect(toggle, &QAction::toggled, this, [this](bool on) { on ? start() : end(); });
  connect(playback, &Playback::rangeChanged, this, [this] {
    if (toggle_->isChecked() && playback_->range()) showRange();
    if (!playback_->range()) toggle_->setChecked(false);
    toggle_->setEnabled(playback_->range().has_value());
  });
}

void RangeComparison::start() {
  was_overlay_ = switches_.overlay->isChecked();
  did_loop_ = switches_.loop->isChecked();
  was_quartered_ = switches_.quarters->isChecked();
  switches_.quarters->setChecked(false);
  if (was_overlay_) switches_.side_by_side->trigger();
  switches_.loop->setChecked(true);
  showRange();
  playback_->seek(playback_->range()->first);
  playback_->play();
}

void RangeComparison::end() {
  // Keeps the way of viewing if the user has changed it meanwhile.
  if (was_overlay_ && switches_.side_by_side->isChecked()) switches_.overlay->trigger();
  if (was_quartered_) switches_.quarters->setChecked(true);
  switches_.loop->setChecked(did_loop_);
  timeline_->showAll();
  graph_->setRange({});
}

void RangeComparison::showRange() {
  timeline_->showRange(*playback_->range());
  graph_->setRange(playback_->range());
}

}  // namespace mocapress
