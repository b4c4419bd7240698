// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>
#include <QRectF>
#include <QSizeF>
#include <Qt3DCore/QEntity>

#include "widgets/viewport/shader_material.h"

namespace mocapress {

class PaintedImage;

/// A small picture over the scene: widgets cannot be laid over a 3D window.
class SceneLabel : public Qt3DCore::QEntity {
 public:
  explicit SceneLabel(QNode* parent);

  /// Shows the picture in a rectangle of a view, both in logical pixels.
  void show(const QImage& picture, const QRectF& place, const QSizeF& view);
  void hide();

 private:
  PaintedImage* image_;
  ShaderMaterial* material_;
};

}  // namespace mocapress
