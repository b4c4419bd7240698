// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Qt3DCore/QEntity>

#include "widgets/viewport/orbit_camera.h"
#include "widgets/viewport/scene_colours.h"
#include "widgets/viewport/shader_material.h"
#include "widgets/viewport/view_arrangement.h"

namespace mocapress {

/// The distance (cm) between grid lines for a figure of that size: 50 for a human, a power of ten
/// more or less for giants and dwarfs. Every second line is stronger.
float gridCell(float figure_size);

/// The grid on y = 0 with its axes, fading with the distance from what the camera looks at.
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

}  // namespace mocapress
