// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QVector3D>
#include <Qt3DCore/QEntity>

#include "widgets/viewport/shader_material.h"
#include "widgets/viewport/view_arrangement.h"

namespace mocapress {

/// A white ring that faces the eye, over all that is drawn: it marks a joint and leaves the colours
/// of the joint as they are.
class Ring : public Qt3DCore::QEntity {
 public:
  explicit Ring(QNode* parent);

  /// In the world, cm. From afar it stays as large as is seen well.
  void show(const QVector3D& centre, float radius);
  void hide();

  void setPane(const Pane& pane);

 private:
  ShaderMaterial* material_;
};

}  // namespace mocapress
