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

/// One figure in the scene, drawn as instances of one mesh. A new pose replaces one buffer.
class Figure : public Qt3DCore::QEntity {
 public:
  /// A trail is a ghost of many capsules, each with fewer triangles. A shadow lies on the ground,
  /// y = 0: one soft spot a capsule, dark and sharp under what stands, faint and wide under what is
  /// high.
  enum class Look { Solid, Ghost, Trail, Shadow };

  Figure(Look look, QNode* parent);

  /// Shows these capsules and no others.
  void show(std::span<const Capsule> capsules);
  void hide();

  /// Switches a figure made as a ghost to solid and back.
  void setGhost(bool ghost);

  /// Moves the figure's depth this far (cm) from the eye, so that nearer ones cover it.
  void setBehind(float behind);

  /// Scales the thickness; 1: as thick as the bones are.
  void setThickness(float thickness);

  void setPane(const Pane& pane);

  /// Moves everything drawn by this offset (cm).
  void setOffset(const QVector3D& offset);

  /// Flattens the capsules onto the ground; 1: round.
  void setFlatness(float flatness);

  void setColours(const QColor& figure, const QColor& alert);

 private:
  Qt3DRender::QGeometryRenderer* mesh_;
  Qt3DCore::QBuffer* capsules_;
  ShaderMaterial* material_;
};

}  // namespace mocapress
