// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>
#include <Qt3DCore/QEntity>
#include <Qt3DExtras/Qt3DWindow>
#include <Qt3DRender/QRenderCapture>
#include <array>
#include <span>

#include "widgets/models/colours.h"
#include "widgets/viewport/figure.h"
#include "widgets/viewport/orbit_camera.h"
#include "widgets/viewport/overlay.h"
#include "widgets/viewport/ring.h"
#include "widgets/viewport/shader_material.h"
#include "widgets/viewport/skin_figure.h"
#include "widgets/viewport/view_arrangement.h"

namespace Qt3DRender {
class QSubtreeEnabler;
class QViewport;
}  // namespace Qt3DRender

namespace mocapress {

/// The distance (cm) between grid lines that suits a figure's size: 50 for a human, times powers of
/// ten for giants and dwarfs. Every second line is stronger.
float gridCell(float figure_size);

/// The grid on y = 0 with its axes, which fades with the distance from the camera's target.
class Ground : public Qt3DCore::QEntity {
 public:
  explicit Ground(QNode* parent);

  void setCell(float cell);
  void setPane(const Pane& pane);
  void lookFrom(const OrbitCamera& camera);
  void setColours(const SceneColours& colours);

 private:
  ShaderMaterial* material_;
  float cell_ = 50;  // cm
};

/// The kind of OpenGL that is available for drawing.
enum class OpenGl { None, Software, Hardware };
OpenGl findOpenGl();

/// The window that Qt3D renders into, with its entities. It renders only when something changes.
class Scene : public Qt3DExtras::Qt3DWindow {
  Q_OBJECT

 public:
  /// Requires findOpenGl() != OpenGl::None. A software renderer draws without multisampling, which
  /// is three times as fast.
  explicit Scene(OpenGl open_gl);

  // Call announce() after a change to one of these entities.
  /// The body is drawn first. The shell, which can be translucent, is drawn over it.
  Figure& body() { return *body_; }
  Figure& shell() { return *shell_; }
  SkinFigure& bodySkin() { return *body_skin_; }
  SkinFigure& shellSkin() { return *shell_skin_; }
  Figure& bodyShadow() { return *body_shadow_; }
  Figure& shellShadow() { return *shell_shadow_; }
  Figure& bodyPath() { return *body_path_; }
  Figure& shellPath() { return *shell_path_; }
  Ring& bodyRing() { return *body_ring_; }
  Ring& shellRing() { return *shell_ring_; }
  Figure& trails() { return *trails_; }
  Figure& discs() { return *discs_; }
  Figure& ghosts() { return *ghosts_; }  // poses before and after the current frame
  Figure& pinned(std::size_t index) { return *pinned_[index]; }
  SkinFigure& pinnedSkin(std::size_t index) { return *pinned_skins_[index]; }
  Overlay& overlay() { return *overlay_; }
  void setCell(float cell);  // Sets the grid's distance between lines, cm.

  /// Sets one camera, whose view is split into `panes` equal parts, or kQuarters cameras, each for
  /// a quarter of the window.
  void setCameras(std::span<const OrbitCamera> cameras, int panes);
  void setColours(const SceneColours& colours);

  /// Restarts the wait for drawn(), after a change.
  void announce();

  /// Delivers a picture with all earlier changes, or a null picture after five seconds without a
  /// frame.
  void capture();

 signals:
  void captured(const QImage& image);

  /// A picture with all announced changes has been rendered and shown.
  void drawn();

 private:
  void frameBegins();
  void capture(int frames);
  void makeFrameGraph(Qt3DCore::QEntity* backdrop);

  /// A part of the window with a camera of its own.
  struct View {
    Qt3DRender::QSubtreeEnabler* enabler = nullptr;
    Qt3DRender::QViewport* part = nullptr;
    Qt3DRender::QCamera* camera = nullptr;
  };

  Figure* body_;
  Figure* shell_;
  SkinFigure* body_skin_;
  SkinFigure* shell_skin_;
  Figure* body_shadow_;
  Figure* shell_shadow_;
  Figure* body_path_;
  Figure* shell_path_;
  Ring* body_ring_;
  Ring* shell_ring_;
  Figure* trails_;
  Figure* discs_;
  Figure* ghosts_;
  std::array<Figure*, kMostPinned> pinned_;
  std::array<SkinFigure*, kMostPinned> pinned_skins_;
  std::array<Ground*, kMostPanes> grounds_;  // one for each pane
  Overlay* overlay_;
  ShaderMaterial* backdrop_;
  std::array<View, kQuarters> views_;
  Qt3DRender::QRenderCapture* capture_;
  int frames_until_drawn_ = 0;
};

}  // namespace mocapress
