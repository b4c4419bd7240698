// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/viewport/ring.h"

#include <QVector4D>
#include <Qt3DRender/QDepthTest>

#include "widgets/viewport/mesh.h"

namespace mocapress {

Ring::Ring(QNode* parent) : QEntity(parent) {
  std::vector<Qt3DRender::QRenderState*> states = translucent();
  auto* over_all = new Qt3DRender::QDepthTest;
  over_all->setDepthFunction(Qt3DRender::QDepthTest::Always);
  states.push_back(over_all);
  material_ = new ShaderMaterial("ring", {{"shade", states}}, this);
  setPane({});
  addComponent(makeRenderer(groundMesh(), this));
  addComponent(material_);
  hide();
}

void Ring::show(const QVector3D& centre, float radius) {
  material_->set("place", QVector4D(centre, radius));
  setEnabled(true);
}

void Ring::hide() {
  setEnabled(false);
}

void Ring::setPane(const Pane& pane) {
  material_->set("pane", QVector3D(pane.shift, pane.from, pane.to));
}

}  // namespace mocapress
