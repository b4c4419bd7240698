// SPDX-License-Identifier: GPL-3.0-or-later
// The mouse in the 3D view: drags, clicks and the wheel.
#include <QApplication>
#include <QMouseEvent>
#include <QWheelEvent>
#include <algorithm>
#include <limits>
#include <utility>

#include "widgets/viewport/scene.h"
#include "widgets/viewport/viewport.h"

namespace mocapress {
namespace {

constexpr double kWheelStep = 120;  // Qt's angle delta of one notch
constexpr double kClickReach = 12;  // logical pixels between a joint and a click that selects it

}  // namespace

bool Viewport::eventFilter(QObject* watched, QEvent* event) {
  if (watched != scene_) return QWidget::eventFilter(watched, event);
  switch (event->type()) {
    case QEvent::MouseButtonPress:
      press(*static_cast<QMouseEvent*>(event));
      break;
    case QEvent::MouseMove:
      drag(*static_cast<QMouseEvent*>(event));
      break;
    case QEvent::MouseButtonRelease:
      release(*static_cast<QMouseEvent*>(event));
      break;
    case QEvent::Wheel:
      camera_is_as_framed_ = false;
      camera_.zoom(
          static_cast<float>(static_cast<QWheelEvent*>(event)->angleDelta().y() / kWheelStep));
      showCamera();
      break;
    case QEvent::Resize:
      sizeCamera();
      showOverlay();
      break;
    default:
      break;
  }
  return QWidget::eventFilter(watched, event);
}

void Viewport::press(const QMouseEvent& event) {
  pressed_at_ = dragged_to_ = event.position();
  pressed_quarter_ = picture().quarterAt(event.position());
  drags_divider_ = event.button() == Qt::LeftButton && picture().isOnDivider(event.position());
  is_click_ =
      (event.button() == Qt::LeftButton && !drags_divider_) || event.button() == Qt::RightButton;
}

void Viewport::drag(const QMouseEvent& event) {
  if (event.buttons() == Qt::NoButton) {
    scene_->setCursor(picture().isOnDivider(event.position()) ? Qt::SplitHCursor : Qt::ArrowCursor);
    return;
  }
  if (drags_divider_) {
    options_.divider = std::clamp(event.position().x() / scene_->width(), 0.0, 1.0);
    arrangeFigures();
    emit dividerMoved(options_.divider);
    return;
  }
  const QPointF away = event.position() - pressed_at_;
  if (is_click_ && away.manhattanLength() < QApplication::startDragDistance()) return;
  is_click_ = false;
  const QPointF step = event.position() - dragged_to_;
  dragged_to_ = event.position();
  camera_is_as_framed_ = false;
  if ((event.buttons() & Qt::LeftButton) && pressed_quarter_ == 0) {
    camera_.orbit(step);
  } else {
    const std::vector<OrbitCamera> seen =
        picture().cameras();  // fewer, if only the press saw a quartered view
    OrbitCamera dragged =
        seen[std::min(static_cast<std::size_t>(pressed_quarter_), seen.size() - 1)];
    dragged.pan(step);
    camera_.moveBy(dragged.target() - camera_.target());
  }
  showCamera();
}

void Viewport::release(const QMouseEvent& event) {
  drags_divider_ = false;
  if (!std::exchange(is_click_, false)) return;
  if (event.button() == Qt::RightButton) {
    emit menuRequested(event.globalPosition().toPoint());
    return;
  }
  const std::optional<PictureSpace::Pointed> on = pointedAt(event.position(), kClickReach);
  if (!(event.modifiers() & Qt::ControlModifier)) {
    if (on) emit jointClicked(on->joint);
    return;
  }
  if (on) return emit placePointed(on->joint, on->place);
  // No joint is near: the place is at the depth of the nearest joint.
  if (const auto body = pointedAt(event.position(), std::numeric_limits<double>::max()))
    emit placePointed(-1, body->camera.beside(body->place, body->in_pane));
}

/// The conversion between the present picture and the clip's world; for immediate use.
PictureSpace Viewport::picture() const {
  return {arrangement_, QSizeF(scene_->size()), camera_, offset()};
}

std::optional<PictureSpace::Pointed> Viewport::pointedAt(const QPointF& position,
                                                         double reach) const {
  std::vector<PictureSpace::Drawn> figures;
  for (const auto& [tracks, placement] : {std::pair(compressed_, arrangement_.compressed),
                                          std::pair(original_, arrangement_.original)})
    if (tracks && placement.shown) figures.push_back({*tracks, frameOf(*tracks), placement.pane});
  if (figures.empty()) return {};
  return picture().pointedAt(figures, shape_->jointCount(), position, reach);
}

}  // namespace mocapress
