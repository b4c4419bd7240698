// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>
#include <Qt3DExtras/Qt3DWindow>
#include <Qt3DRender/QRenderCapture>

#include "widgets/viewport/figure.h"
#include "widgets/viewport/ground.h"
#include "widgets/viewport/orbit_camera.h"
#include "widgets/viewport/scene_colours.h"

namespace mocapress {

/// What can draw a 3D window here.
enum class OpenGl { None, Software, Hardware };
OpenGl findOpenGl();

/// The window Qt3D renders into, and what stands in it. Renders when something changes only.
class Scene : public Qt3DExtras::Qt3DWindow {
  Q_OBJECT

 public:
  /// Requires findOpenGl() != OpenGl::None. Software draws without multisampling: three times as
  /// fast.
  explicit Scene(OpenGl open_gl);

  // After changing one of these, announce() it.
  Figure& original() { return *original_; }
  Figure& compressed() { return *compressed_; }
  Figure& trails() { return *trails_; }
  Ground& ground() { return *ground_; }
  void setCamera(const OrbitCamera& camera);
  void setColours(const SceneColours& colours);

  /// Starts the wait for drawn() anew.
  void announce();

  /// Delivers the next picture rendered, a null one after five seconds without.
  void capture();

 signals:
  void captured(const QImage& image);

  /// A picture with everything announced has been rendered and shown.
  void drawn();

 private:
  void frameBegins();

  Figure* original_;
  Figure* compressed_;
  Figure* trails_;
  Ground* ground_;
  ShaderMaterial* backdrop_;
  Qt3DRender::QRenderCapture* capture_;
  int frames_until_drawn_ = 0;
  bool capture_is_warm_ = false;
};

}  // namespace mocapress
