// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <Qt3DCore/QBuffer>
#include <Qt3DCore/QEntity>
#include <Qt3DRender/QGeometryRenderer>

#include "widgets/viewport/figure_shape.h"
#include "widgets/viewport/shader_material.h"
#include "widgets/viewport/view_arrangement.h"

namespace mocapress {

/// One figure in the scene: a capsule mesh, drawn once an instance. A new pose replaces one buffer.
class Figure : public Qt3DCore::QEntity {
 public:
  /// A trail is a ghost of many capsules, each made of less.
  enum class Look { Solid, Ghost, Trail };

  Figure(Look look, QNode* parent);

  /// Shows these alone.
  void show(std::span<const Capsule> capsules);
  void hide();

  /// A figure made as a ghost may stand solid, and be one again.
  void setGhost(bool ghost);

  /// Counts as this much (cm) further from the eye than it is: what is nearer covers it.
  void setBehind(float behind);

  /// 1: as thick as the bones are.
  void setThickness(float thickness);

  void setPane(const Pane& pane);

  /// Draws everything that far (cm) from where it is.
  void setOffset(const QVector3D& offset);

  /// 1: round; less: pressed flat onto the ground.
  void setFlatness(float flatness);

  void setColours(const QColor& figure, const QColor& alert);

 private:
  Qt3DRender::QGeometryRenderer* mesh_;
  Qt3DCore::QBuffer* capsules_;
  ShaderMaterial* material_;
};

}  // namespace mocapress
