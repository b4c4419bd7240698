// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/timeline/sight_strip.h"

#include <QPainter>
#include <algorithm>
#include <utility>

#include "widgets/models/colours.h"

namespace mocapress {

SightStrip::SightStrip(QWidget* parent) : JointStrip(tr("Seen"), 17, parent) {
  setAccessibleName(tr("Visible errors"));
  setAccessibleDescription(
      tr("Times at which errors are visible. The heat map shows them by joint."));
}

void SightStrip::setSight(SightPtr sight, std::vector<QString> names, int frames) {
  sight_ = sight && sight->windows() > 0 ? std::move(sight) : nullptr;
  worst_ = sight_ ? sight_->times_noticed.rowwise().maxCoeff() : Eigen::VectorXf();
  setClip(std::move(names), frames);
}

/// Draws a column for each pixel, for the worst of the pixel's time windows.
void SightStrip::paintColumns(QPainter& painter, const QRectF& area, const TimeAxis& time) const {
  for (double x = area.left(); x < area.right(); ++x) {
    const int first = sight_->window_of(time.frameAt(x));
    const int last = sight_->window_of(time.frameAt(x + 1));
    const float most = worst_.segment(first, std::max(last - first, 1)).maxCoeff();
    const Sight sight = sight_of(static_cast<double>(most));
    if (sight == Sight::NotVisible) continue;
    const double height = area.height() / (sight == Sight::Visible ? 1 : 2);
    painter.fillRect(QRectF(x, area.bottom() - height, 1, height), sightColour(sight));
  }
}

QString SightStrip::meaning() const {
  return tr("Times at which errors are visible (full column) or borderline (half a column).");
}

QString SightStrip::describe(int frame) const {
  const WorstSight seen = sight_->at(frame);
  return tr("%1, frame %L2").arg(nameOf(seen.joint)).arg(seen.frame + 1) + QLatin1Char('\n') +
         sightText(seen);
}

}  // namespace mocapress
