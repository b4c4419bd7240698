// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/viewport/shadow.h"

#include "widgets/viewport/mesh.h"

namespace mocapress {

Shadow::Shadow(QNode* parent) : QEntity(parent) {
  mesh_ = makeRenderer(groundMesh(), this);
  Qt3DCore::QGeometry* geometry = mesh_->geometry();
  capsules_ = new Qt3DCore::QBuffer(geometry);
  capsules_->setUsage(Qt3DCore::QBuffer::DynamicDraw);
  addAttribute(geometry, capsules_, "start", 4, offsetof(Capsule, start), sizeof(Capsule))
      ->setDivisor(1);
  addAttribute(geometry, capsules_, "end", 4, offsetof(Capsule, end), sizeof(Capsule))
      ->setDivisor(1);
  material_ = new ShaderMaterial("shadow", {{"shade", translucent()}}, this);
  setPane({});
  setOffset({});
  addComponent(mesh_);
  addComponent(material_);
  hide();
}

void Shadow::show(std::span<const Capsule> capsules) {
  capsules_->setData(QByteArray(reinterpret_cast<const char*>(capsules.data()),
                                static_cast<qsizetype>(capsules.size_bytes())));
  mesh_->setInstanceCount(static_cast<int>(capsules.size()));
  setEnabled(!capsules.empty());
}

void Shadow::hide() {
  setEnabled(false);
}

void Shadow::setPane(const Pane& pane) {
  material_->set("pane", QVector3D(pane.shift, pane.from, pane.to));
}

void Shadow::setOffset(const QVector3D& offset) {
  material_->set("offset", offset);
}

}  // namespace mocapress
