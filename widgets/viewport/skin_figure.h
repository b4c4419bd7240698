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

/// What is marked on a figure, as a colour for each joint and how much of it covers the skin there.
std::vector<QVector4D> jointCovers(const FigureMarks& marks, int joints, const QColor& alert);

/// A character in the scene: its mesh, which the graphics card bends. A new pose replaces one small
/// buffer, that of its bones.
class SkinFigure : public Qt3DCore::QEntity {
 public:
  SkinFigure(bool may_be_ghost, QNode* parent);

  void setSkin(std::shared_ptr<const Skin> skin);

  /// `covers`: of each joint; empty: none.
  void show(const Pose& pose, const std::vector<QVector4D>& covers);
  void hide();

  void setGhost(bool ghost);

  /// As Figure's.
  void setBehind(float behind);
  void setPane(const Pane& pane);

  /// Draws everything that far (cm) from where it is.
  void setOffset(const QVector3D& offset);

  /// Invalid: the colours of the skin itself.
  void setColour(const QColor& colour);

 private:
  void upload();

  std::shared_ptr<const Skin> skin_;
  bool is_uploaded_ = false;  // which waits until it is shown: of pinned results few are
  Qt3DCore::QBuffer* vertices_;
  Qt3DCore::QBuffer* triangles_;
  Qt3DCore::QBuffer* bones_;
  std::vector<Qt3DCore::QAttribute*> of_vertices_;
  Qt3DCore::QAttribute* corners_;
  ShaderMaterial* material_;
  Qt3DRender::QTexture2D* pictures_;
};

}  // namespace mocapress
