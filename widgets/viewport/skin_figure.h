// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QVector4D>
#include <Qt3DCore/QAttribute>
#include <Qt3DCore/QBuffer>
#include <Qt3DCore/QEntity>
#include <Qt3DRender/QTexture>
#include <memory>
#include <vector>

#include "core/motion/skin.h"
#include "widgets/viewport/figure_shape.h"
#include "widgets/viewport/shader_material.h"
#include "widgets/viewport/view_arrangement.h"

namespace mocapress {

/// Turns a figure's marks into a colour for each joint. Its alpha is the colour's opacity on the
/// skin.
std::vector<QVector4D> jointCovers(const FigureMarks& marks, int joints, const QColor& alert);

/// A character's mesh in the scene, skinned on the graphics card. A new pose replaces only the
/// small buffer of bones.
class SkinFigure : public Qt3DCore::QEntity {
 public:
  SkinFigure(bool may_be_ghost, QNode* parent);

  void setSkin(std::shared_ptr<const Skin> skin);

  /// Shows a pose. `covers` has a colour for each joint, see jointCovers(); empty: none.
  void show(const Pose& pose, const std::vector<QVector4D>& covers);
  void hide();

  void setGhost(bool ghost);

  /// See Figure::setBehind().
  void setBehind(float behind);
  void setPane(const Pane& pane);

  /// Moves the drawn figure by this offset (cm).
  void setOffset(const QVector3D& offset);

  /// Colours the skin; an invalid colour keeps the skin's own.
  void setColour(const QColor& colour);

 private:
  void upload();

  std::shared_ptr<const Skin> skin_;
  bool is_uploaded_ = false;  // done when first shown: most pinned results never are
  Qt3DCore::QBuffer* vertices_;
  Qt3DCore::QBuffer* triangles_;
  Qt3DCore::QBuffer* bones_;
  std::vector<Qt3DCore::QAttribute*> of_vertices_;
  Qt3DCore::QAttribute* corners_;
  ShaderMaterial* material_;
  Qt3DRender::QTexture2D* pictures_;
};

}  // namespace mocapress
