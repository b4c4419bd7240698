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

/// What a body keeps of the sky's light from the ground, y = 0: dark and sharp where it stands,
/// faint and wide below what is high. Each capsule of it is one soft spot.
class Shadow : public Qt3DCore::QEntity {
 public:
  explicit Shadow(QNode* parent);

  void show(std::span<const Capsule> capsules);
  void hide();
  void setPane(const Pane& pane);

  /// Draws everything that far (cm) from where it is.
  void setOffset(const QVector3D& offset);

 private:
  Qt3DRender::QGeometryRenderer* mesh_;
  Qt3DCore::QBuffer* capsules_;
  ShaderMaterial* material_;
};

}  // namespace mocapress
