// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/viewport/viewport.h"

#include <QApplication>
#include <QLabel>
#include <QMouseEvent>
#include <QSurfaceFormat>
#include <QVBoxLayout>
#include <QWheelEvent>
#include <algorithm>

#include "widgets/viewport/joint_picker.h"
#include "widgets/viewport/scene.h"
#include "widgets/viewport/slide_marks.h"

namespace mocapress {
namespace {

constexpr float kRadiusPerSize = 0.56f;  // of the ball in sight, per size of the figure
constexpr float kTrailPerSize = 0.006f;  // radius of a trail, per size of the figure
constexpr double kWheelStep = 120;       // Qt's angle delta of one notch

bool isEmpty(const Viewport::Tracks& tracks) {
  return !tracks || tracks->size() == 0;
}

}  // namespace

void prepareViewport() {
  // Qt's rhi renderer captures upside down and crashes where there is no OpenGL.
  if (!qEnvironmentVariableIsSet("QT3D_RENDERER")) qputenv("QT3D_RENDERER", "opengl");
  QSurfaceFormat format;
  format.setVersion(4, 3);
  format.setProfile(QSurfaceFormat::CoreProfile);
  format.setDepthBufferSize(24);
  QSurfaceFormat::setDefaultFormat(format);
}

Viewport::Viewport(QWidget* parent) : QWidget(parent) {
  setMinimumSize(160, 120);
  camera_.lookAt({0, 90, 0}, 100);
  showSceneOrNotice();
}

Viewport::~Viewport() = default;

void Viewport::showSceneOrNotice() {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins({});
  const OpenGl open_gl = findOpenGl();
  if (open_gl == OpenGl::None) {
    auto* notice = new QLabel(tr("The 3D view needs OpenGL 3.2, which is not available here."));
    notice->setAlignment(Qt::AlignCenter);
    notice->setWordWrap(true);
    layout->addWidget(notice);
    return;
  }
  scene_ = new Scene(open_gl);
  scene_->setColours(sceneColours(palette()));
  scene_->installEventFilter(this);
  connect(scene_, &Scene::captured, this, &Viewport::captured);
  connect(scene_, &Scene::drawn, this, &Viewport::drawn);
  layout->addWidget(QWidget::createWindowContainer(scene_, this));
  showCamera();
}

void Viewport::setSkeleton(const Skeleton& skeleton) {
  shape_.emplace(skeleton);
  original_.reset();
  compressed_.reset();
  setSlides({});
  selected_joint_ = -1;
  camera_is_framed_ = false;
  if (scene_) scene_->ground().setCell(gridCell(shape_->size()));
  showFigures();
}

void Viewport::setOriginal(Tracks tracks) {
  original_ = isEmpty(tracks) ? nullptr : std::move(tracks);
  showFigures();
}

void Viewport::setCompressed(Tracks tracks) {
  compressed_ = isEmpty(tracks) ? nullptr : std::move(tracks);
  showFigures();
}

void Viewport::setSlides(std::vector<SlideFinding> slides) {
  slides_ = std::move(slides);
  showTrails();
  showFigures();
}

void Viewport::setFrame(int frame) {
  frame_ = frame;
  showFigures();
}

void Viewport::setSelectedJoint(int joint) {
  selected_joint_ = joint;
  showFigures();
}

void Viewport::setFollow(bool follow) {
  follow_ = follow;
  const Eigen::MatrixXd* tracks = leadingTracks();
  if (!follow || !tracks) return;
  camera_.moveBy(FigureShape::centre(*tracks, frameOf(*tracks)) - camera_.target());
  showCamera();
}

void Viewport::resetCamera() {
  if (const Eigen::MatrixXd* tracks = leadingTracks())
    camera_.lookAt(FigureShape::centre(*tracks, frameOf(*tracks)), kRadiusPerSize * shape_->size());
  showCamera();
}

void Viewport::capture() {
  if (scene_) return scene_->capture();
  // Later, as with a scene: the caller may not have connected yet.
  QMetaObject::invokeMethod(
      this, [this] { emit captured({}); }, Qt::QueuedConnection);
}

void Viewport::showFigures() {
  if (const Eigen::MatrixXd* tracks = leadingTracks()) {
    const QVector3D root = landmarkAt(*tracks, frameOf(*tracks), 0);
    if (!std::exchange(camera_is_framed_, true)) {
      resetCamera();
    } else if (follow_) {
      camera_.moveBy(root - root_);
      showCamera();
    }
    root_ = root;
  }
  if (!scene_) return;
  const auto show = [&](Figure& figure, const Tracks& tracks, std::vector<float> alerts) {
    if (!tracks) return figure.hide();
    figure.show(*shape_, *tracks, frameOf(*tracks), {selected_joint_, std::move(alerts)});
  };
  show(scene_->original(), original_, {});
  show(scene_->compressed(), compressed_,
       shape_ ? slideAlerts(slides_, shape_->jointCount(), frame_) : std::vector<float>());
  scene_->announce();
}

void Viewport::showTrails() {
  if (!scene_) return;
  const bool shown = shape_ && compressed_ && !slides_.empty();
  scene_->trails().show(shown ? slideTrails(slides_, *compressed_, kTrailPerSize * shape_->size())
                              : std::vector<Capsule>());
}

void Viewport::showCamera() {
  if (!scene_) return;
  scene_->setCamera(camera_);
  scene_->announce();
}

const Eigen::MatrixXd* Viewport::leadingTracks() const {
  return original_ ? original_.get() : compressed_.get();
}

int Viewport::frameOf(const Eigen::MatrixXd& tracks) const {
  return std::clamp(frame_, 0, static_cast<int>(tracks.rows()) - 1);
}

bool Viewport::eventFilter(QObject* watched, QEvent* event) {
  if (watched != scene_) return QWidget::eventFilter(watched, event);
  switch (event->type()) {
    case QEvent::MouseButtonPress:
      pressed_at_ = dragged_to_ = static_cast<QMouseEvent*>(event)->position();
      is_click_ = static_cast<QMouseEvent*>(event)->button() == Qt::LeftButton;
      break;
    case QEvent::MouseMove:
      drag(*static_cast<QMouseEvent*>(event));
      break;
    case QEvent::MouseButtonRelease:
      release(*static_cast<QMouseEvent*>(event));
      break;
    case QEvent::Wheel:
      camera_.zoom(
          static_cast<float>(static_cast<QWheelEvent*>(event)->angleDelta().y() / kWheelStep));
      showCamera();
      break;
    case QEvent::Resize:
      camera_.setViewSize(scene_->size());
      showCamera();
      break;
    default:
      break;
  }
  return QWidget::eventFilter(watched, event);
}

void Viewport::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange && scene_) {
    scene_->setColours(sceneColours(palette()));
    scene_->announce();
  }
  QWidget::changeEvent(event);
}

void Viewport::drag(const QMouseEvent& event) {
  if (event.buttons() == Qt::NoButton) return;
  const QPointF away = event.position() - pressed_at_;
  if (is_click_ && away.manhattanLength() < QApplication::startDragDistance()) return;
  is_click_ = false;
  const QPointF step = event.position() - dragged_to_;
  dragged_to_ = event.position();
  if (event.buttons() & Qt::LeftButton)
    camera_.orbit(step);
  else
    camera_.pan(step);
  showCamera();
}

void Viewport::release(const QMouseEvent& event) {
  if (!std::exchange(is_click_, false)) return;
  std::optional<PickedJoint> nearest;
  for (const Tracks& tracks : {compressed_, original_}) {
    if (!tracks) continue;
    const auto picked =
        pickJoint(camera_, *tracks, frameOf(*tracks), shape_->jointCount(), event.position());
    if (picked && (!nearest || picked->distance < nearest->distance)) nearest = picked;
  }
  if (nearest) emit jointClicked(nearest->joint);
}

}  // namespace mocapress
