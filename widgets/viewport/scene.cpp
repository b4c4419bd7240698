// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/viewport/scene.h"

#include <QGuiApplication>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QSurfaceFormat>
#include <QTimer>
#include <QVector2D>
#include <Qt3DCore/QEntity>
#include <Qt3DLogic/QFrameAction>
#include <Qt3DRender/QCamera>
#include <Qt3DRender/QCameraSelector>
#include <Qt3DRender/QClearBuffers>
#include <Qt3DRender/QFilterKey>
#include <Qt3DRender/QLayer>
#include <Qt3DRender/QLayerFilter>
#include <Qt3DRender/QNoDepthMask>
#include <Qt3DRender/QNoDraw>
#include <Qt3DRender/QRenderCaptureReply>
#include <Qt3DRender/QRenderPassFilter>
#include <Qt3DRender/QRenderSettings>
#include <Qt3DRender/QRenderSurfaceSelector>
#include <Qt3DRender/QSubtreeEnabler>
#include <Qt3DRender/QViewport>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "widgets/viewport/mesh.h"

namespace mocapress {

float gridCell(float figure_size) {
  const float human = 180;  // cm
  return 50 * std::pow(10.0f, std::round(std::log10(figure_size / human)));
}

Ground::Ground(QNode* parent) : QEntity(parent) {
  material_ = new ShaderMaterial("ground", {{"shade", translucent()}}, this);
  addComponent(makeRenderer(groundMesh(), this));
  addComponent(material_);
  setCell(cell_);
  setPane({});
}

void Ground::setPane(const Pane& pane) {
  material_->set("pane", QVector3D(pane.shift, pane.from, pane.to));
}

void Ground::setCell(float cell) {
  cell_ = cell;
  material_->set("cell", cell);
}

void Ground::lookFrom(const OrbitCamera& camera) {
  material_->set("centre", QVector2D(camera.target().x(), camera.target().z()));
  material_->set("reach", std::clamp(2.5f * camera.distance(), 8 * cell_, 200 * cell_));
}

void Ground::setColours(const SceneColours& colours) {
  material_->setColour("lineColour", colours.grid);
  material_->setColour("xAxisColour", colours.x_axis);
  material_->setColour("zAxisColour", colours.z_axis);
}

namespace {

constexpr std::chrono::seconds kCaptureTimeout{5};

// A change is rendered by the first frame that begins after the change. Another frame may already
// be running, hence 2.
constexpr int kFramesUntilDrawn = 2;

constexpr float kDiscFlatness = 0.05f;

constexpr float kTrailThickness = 0.8f;

/// Draws some entities with one pass of their materials.
struct Step {
  Qt3DRender::QLayer* layer;
  QString pass;
};

template <typename Entities>
Step stepOf(const Entities& entities, const char* pass) {
  auto* layer = new Qt3DRender::QLayer(*std::begin(entities));
  for (Qt3DCore::QEntity* entity : entities) entity->addComponent(layer);
  return {layer, QString::fromLatin1(pass)};
}

Step stepOf(std::initializer_list<Qt3DCore::QEntity*> entities, const char* pass) {
  return stepOf<std::initializer_list<Qt3DCore::QEntity*>>(entities, pass);
}

/// Adds a leaf to the frame graph that draws a step.
void addStep(Qt3DRender::QFrameGraphNode* parent, const Step& step) {
  auto* only_layer = new Qt3DRender::QLayerFilter(parent);
  only_layer->addLayer(step.layer);
  auto* only_pass = new Qt3DRender::QRenderPassFilter(only_layer);
  auto* key = new Qt3DRender::QFilterKey(only_pass);
  key->setName(kPassKey);
  key->setValue(step.pass);
  only_pass->addMatch(key);
}

/// Adds a node to the frame graph. Everything below the node is drawn into a part of the window, as
/// the camera sees it.
Qt3DRender::QCameraSelector* addView(Qt3DRender::QFrameGraphNode* parent,
                                     Qt3DRender::QCamera* camera,
                                     Qt3DRender::QViewport** part = nullptr) {
  auto* viewport = new Qt3DRender::QViewport(parent);
  if (part) *part = viewport;
  auto* selector = new Qt3DRender::QCameraSelector(viewport);
  selector->setCamera(camera);
  return selector;
}

bool isSoftware(const QByteArray& renderer) {
  return renderer.contains("llvmpipe") || renderer.contains("softpipe") ||
         renderer.contains("SwiftShader");
}

}  // namespace

OpenGl findOpenGl() {
  const QString platform = QGuiApplication::platformName();
  if (platform == "offscreen" || platform == "minimal") return OpenGl::None;
  QOffscreenSurface surface;
  surface.create();
  QOpenGLContext context;
  if (!context.create() || !context.makeCurrent(&surface)) return OpenGl::None;
  if (context.format().version() < std::pair(3, 2)) return OpenGl::None;
  const GLubyte* renderer = context.functions()->glGetString(GL_RENDERER);
  return isSoftware(reinterpret_cast<const char*>(renderer)) ? OpenGl::Software : OpenGl::Hardware;
}

Scene::Scene(OpenGl open_gl) {
  QSurfaceFormat surface_format = format();
  surface_format.setSamples(open_gl == OpenGl::Software ? 0 : 4);
  setFormat(surface_format);
  QSurfaceFormat::setDefaultFormat(surface_format);  // Qt3D's context uses the default format

  auto* root = new Qt3DCore::QEntity;
  auto* backdrop = new Qt3DCore::QEntity(root);
  backdrop_ = new ShaderMaterial("backdrop", {{"shade", {new Qt3DRender::QNoDepthMask}}}, backdrop);
  backdrop->addComponent(makeRenderer(backdropMesh(), backdrop));
  backdrop->addComponent(backdrop_);
  for (Ground*& ground : grounds_) ground = new Ground(root);
  body_ = new Figure(Figure::Look::Solid, root);
  shell_ = new Figure(Figure::Look::Ghost, root);
  body_skin_ = new SkinFigure(false, root);
  shell_skin_ = new SkinFigure(true, root);
  body_shadow_ = new Figure(Figure::Look::Shadow, root);
  shell_shadow_ = new Figure(Figure::Look::Shadow, root);
  body_path_ = new Figure(Figure::Look::Solid, root);
  shell_path_ = new Figure(Figure::Look::Solid, root);
  trails_ = new Figure(Figure::Look::Solid, root);
  discs_ = new Figure(Figure::Look::Solid, root);
  discs_->setFlatness(kDiscFlatness);
  ghosts_ = new Figure(Figure::Look::Trail, root);
  ghosts_->setThickness(kTrailThickness);
  for (Figure*& figure : pinned_) figure = new Figure(Figure::Look::Ghost, root);
  for (SkinFigure*& skin : pinned_skins_) skin = new SkinFigure(true, root);
  body_ring_ = new Ring(root);
  shell_ring_ = new Ring(root);
  overlay_ = new Overlay(root);
  auto* frame_action = new Qt3DLogic::QFrameAction(root);
  root->addComponent(frame_action);
  connect(frame_action, &Qt3DLogic::QFrameAction::triggered, this, &Scene::frameBegins);

  makeFrameGraph(backdrop);
  renderSettings()->setRenderPolicy(Qt3DRender::QRenderSettings::OnDemand);
  setRootEntity(root);
}

void Scene::makeFrameGraph(Qt3DCore::QEntity* backdrop) {
  auto* surface = new Qt3DRender::QRenderSurfaceSelector;
  surface->setSurface(this);
  auto* clear = new Qt3DRender::QClearBuffers(addView(surface, camera()));
  clear->setBuffers(Qt3DRender::QClearBuffers::ColorDepthBuffer);
  new Qt3DRender::QNoDraw(clear);
  // The frame graph draws in this order, so that translucent things are drawn over solid ones.
  std::vector<Step> steps = {
      stepOf({backdrop}, "shade"),
      stepOf({body_, body_skin_, body_path_, shell_path_, trails_, discs_}, "shade"),
      stepOf({body_shadow_, shell_shadow_}, "shade"), stepOf(grounds_, "shade")};
  // Only the nearest of overlapping pinned figures is visible: a blend of two colours would match
  // neither.
  std::vector<Qt3DCore::QEntity*> pinned(pinned_.begin(), pinned_.end());
  pinned.insert(pinned.end(), pinned_skins_.begin(), pinned_skins_.end());
  for (const char* pass : {"depth", "shade"}) steps.push_back(stepOf(pinned, pass));
  for (Qt3DCore::QEntity* translucent :
       std::initializer_list<Qt3DCore::QEntity*>{ghosts_, shell_, shell_skin_})
    for (const char* pass : {"depth", "shade"}) steps.push_back(stepOf({translucent}, pass));
  steps.push_back(stepOf({body_ring_, shell_ring_}, "shade"));
  for (View& view : views_) {
    view.camera =
        &view == &views_.front() ? camera() : new Qt3DRender::QCamera(camera()->parentNode());
    view.enabler = new Qt3DRender::QSubtreeEnabler(surface);
    Qt3DRender::QCameraSelector* selector = addView(view.enabler, view.camera, &view.part);
    for (const Step& step : steps) addStep(selector, step);
  }
  Qt3DRender::QCameraSelector* whole = addView(surface, camera());
  for (const auto& labels : overlay_->labels()) addStep(whole, stepOf(labels, "shade"));
  capture_ = new Qt3DRender::QRenderCapture(new Qt3DRender::QNoDraw(whole));

  setActiveFrameGraph(surface);
}

void Scene::setCameras(std::span<const OrbitCamera> cameras, int panes) {
  const bool quartered = cameras.size() > 1;
  for (std::size_t i = 0; i < views_.size(); ++i) {
    const View& view = views_[i];
    view.enabler->setEnabled(i < cameras.size());
    if (i >= cameras.size()) continue;
    const OrbitCamera& orbit = cameras[i];
    if (quartered)
      view.part->setNormalizedRect({i % 2 == 0 ? 0 : 0.5, i < 2 ? 0 : 0.5, 0.5, 0.5});
    else
      view.part->setNormalizedRect({0, 0, 1, 1});
    view.camera->lens()->setPerspectiveProjection(OrbitCamera::kFieldOfView,
                                                  static_cast<float>(panes) * orbit.aspectRatio(),
                                                  orbit.nearPlane(), orbit.farPlane());
    view.camera->setUpVector({0, 1, 0});
    view.camera->setPosition(orbit.eye());
    view.camera->setViewCenter(orbit.target());
  }
  for (int i = 0; i < kMostPanes; ++i) {
    Ground* ground = grounds_[static_cast<std::size_t>(i)];
    ground->setEnabled(i < panes);
    ground->setPane(paneOf(i, panes));
    ground->lookFrom(cameras.front());
  }
}

void Scene::setCell(float cell) {
  for (Ground* ground : grounds_) ground->setCell(cell);
}

void Scene::setColours(const SceneColours& colours) {
  trails_->setColours(colours.trail, colours.alert);
  discs_->setColours(colours.trail, colours.alert);
  for (Ground* ground : grounds_) ground->setColours(colours);
  overlay_->setColours(colours);
  backdrop_->setColour("centreColour", colours.backdrop_centre);
  backdrop_->setColour("edgeColour", colours.backdrop_edge);
}

void Scene::announce() {
  frames_until_drawn_ = kFramesUntilDrawn;
}

void Scene::frameBegins() {
  if (frames_until_drawn_ == 0 || !isExposed()) return;
  if (--frames_until_drawn_ == 0) emit drawn();
}

// Captures twice: changes are uploaded during the first frame and visible in the second. The first
// captured picture may be blank, too.
void Scene::capture() {
  capture(2);
}

void Scene::capture(int frames) {
  Qt3DRender::QRenderCaptureReply* reply = capture_->requestCapture();
  auto* timeout = new QTimer(reply);
  connect(timeout, &QTimer::timeout, this, [this, reply, timeout] {
    timeout->stop();
    reply->disconnect(this);
    connect(reply, &Qt3DRender::QRenderCaptureReply::completed, reply, &QObject::deleteLater);
    emit captured({});
  });
  connect(reply, &Qt3DRender::QRenderCaptureReply::completed, this, [this, reply, frames] {
    const QImage image = reply->image().convertToFormat(QImage::Format_RGB32);
    reply->deleteLater();
    if (frames > 1) return capture(frames - 1);
    emit captured(image);
  });
  timeout->start(kCaptureTimeout);
}

}  // namespace mocapress
