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
  /// A trail is a ghost of many capsules, each with fewer triangles. A shadow lies on the ground, y
  /// = 0, with one soft spot for each capsule: dark and sharp if the capsule is near the ground,
  /// faint and wide if it is high.
  enum class Look { Solid, Ghost, Trail, Shadow };

  Figure(Look look, QNode* parent);

  /// Replaces the capsules that are shown.
  void show(std::span<const Capsule> capsules);
  void hide();

  /// Shows a figure that was made as a ghost as a solid figure, or as a ghost again.
  void setGhost(bool ghost);

  /// Moves the figure's depth this far (cm) away from the eye, so that nearer figures cover it.
  void setBehind(float behind);

  /// Scales the thickness; 1: the thickness of the capsules.
  void setThickness(float thickness);

  void setPane(const Pane& pane);

  /// Moves the drawn figure by this offset (cm).
  void setOffset(const QVector3D& offset);

  /// Scales the capsules' height, to flatten them onto the ground; 1: round.
  void setFlatness(float flatness);

  void setColours(const QColor& figure, const QColor& alert);

 private:
  Qt3DRender::QGeometryRenderer* mesh_;
  Qt3DCore::QBuffer* capsules_;
  ShaderMaterial* material_;
};

}  // namespace mocapress
