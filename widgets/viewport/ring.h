// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QVector3D>
#include <Qt3DCore/QEntity>

#include "widgets/viewport/shader_material.h"
#include "widgets/viewport/view_arrangement.h"

namespace mocapress {

/// A white ring that faces the eye and is drawn over everything. It marks a joint without changing
/// the joint's colours.
class Ring : public Qt3DCore::QEntity {
 public:
  explicit Ring(QNode* parent);

  /// Shows the ring at a world position, in cm. Its size on the screen has a minimum, so that it is
  /// visible from afar.
  void show(const QVector3D& centre, float radius);
  void hide();

  void setPane(const Pane& pane);

 private:
  ShaderMaterial* material_;
};

}  // namespace mocapress
