// SPDX-License-Identifier: GPL-3.0-or-later
// What the mouse does in the 3D view.
#include <QApplication>
#include <QMouseEvent>
#include <QWheelEvent>
#include <algorithm>
#include <utility>

#include "widgets/viewport/joint_picker.h"
#include "widgets/viewport/scene.h"
#include "widgets/viewport/viewport.h"

namespace mocapress {
namespace {

constexpr double kWheelStep = 120;    // Qt's angle delta of one notch
constexpr double kDividerReach = 10;  // pixels to either side at which it is taken

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
  drags_divider_ = event.button() == Qt::LeftButton && isOnDivider(event.position());
  is_click_ = event.button() == Qt::LeftButton && !drags_divider_;
}

bool Viewport::isOnDivider(const QPointF& position) const {
  if (!arrangement_.has_divider || arrangement_.panes > 1) return false;
  const double divider = (1 + static_cast<double>(arrangement_.dividerAt())) / 2 * scene_->width();
  return std::abs(position.x() - divider) <= kDividerReach;
}

void Viewport::drag(const QMouseEvent& event) {
  if (event.buttons() == Qt::NoButton) {
    scene_->setCursor(isOnDivider(event.position()) ? Qt::SplitHCursor : Qt::ArrowCursor);
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
  if (event.buttons() & Qt::LeftButton)
    camera_.orbit(step);
  else
    camera_.pan(step);
  showCamera();
}

void Viewport::release(const QMouseEvent& event) {
  drags_divider_ = false;
  if (!std::exchange(is_click_, false)) return;
  OrbitCamera camera = camera_;
  camera.moveBy(-offset());  // to where the figures are as recorded
  const double width = scene_->width();
  std::optional<PickedJoint> nearest;
  for (const auto& [tracks, placement] : {std::pair(compressed_, arrangement_.compressed),
                                          std::pair(original_, arrangement_.original)}) {
    const auto device_x = static_cast<float>(2 * event.position().x() / width - 1);
    if (!tracks || !placement.shown || !placement.pane.contains(device_x)) continue;
    const double pane_left = (width - width / arrangement_.panes) / 2 +
                             static_cast<double>(placement.pane.shift) * width / 2;
    const auto picked = pickJoint(camera, *tracks, frameOf(*tracks), shape_->jointCount(),
                                  event.position() - QPointF(pane_left, 0));
    if (picked && (!nearest || picked->distance < nearest->distance)) nearest = picked;
  }
  if (nearest) emit jointClicked(nearest->joint);
}

}  // namespace mocapress
