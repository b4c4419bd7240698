// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Qt3DCore/QBuffer>
#include <Qt3DCore/QEntity>
#include <Qt3DRender/QGeometryRenderer>
#include <span>

#include "widgets/viewport/figure_shape.h"
#include "widgets/viewport/shader_material.h"
#include "widgets/viewport/view_arrangement.h"

namespace mocapress {

/// Soft shadow of a body on the ground, y = 0: dark and sharp under what stands, faint and wide
/// under what is high. Each capsule casts one soft spot.
class Shadow : public Qt3DCore::QEntity {
 public:
  explicit Shadow(QNode* parent);

  void show(std::span<const Capsule> capsules);
  void hide();
  void setPane(const Pane& pane);

  /// Moves everything drawn by this offset (cm).
  void setOffset(const QVector3D& offset);

 private:
  Qt3DRender::QGeometryRenderer* mesh_;
  Qt3DCore::QBuffer* capsules_;
  ShaderMaterial* material_;
};

}  // namespace mocapress
