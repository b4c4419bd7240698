// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/viewport/figure.h"

#include "widgets/viewport/mesh.h"

namespace mocapress {
namespace {

constexpr CapsuleDetail kTrailDetail{8, 3};

Mesh meshOf(Figure::Look look) {
  if (look == Figure::Look::Shadow) return groundMesh();
  return capsuleMesh(look == Figure::Look::Trail ? kTrailDetail : CapsuleDetail());
}

ShaderMaterial* materialOf(Figure::Look look, Qt3DCore::QNode* parent) {
  if (look == Figure::Look::Shadow)
    return new ShaderMaterial("shadow", {{"shade", translucent()}}, parent);
  return new ShaderMaterial("figure", look == Figure::Look::Solid ? solidPasses() : ghostPasses(),
                            parent);
}

}  // namespace

Figure::Figure(Look look, QNode* parent) : QEntity(parent) {
  mesh_ = makeRenderer(meshOf(look), this);
  Qt3DCore::QGeometry* geometry = mesh_->geometry();
  capsules_ = new Qt3DCore::QBuffer(geometry);
  capsules_->setUsage(Qt3DCore::QBuffer::DynamicDraw);
  const auto perInstance = [&](const char* name, uint floats, uint byte_offset) {
    addAttribute(geometry, capsules_, name, floats, byte_offset, sizeof(Capsule))->setDivisor(1);
  };
  perInstance("start", 4, offsetof(Capsule, start));
  perInstance("end", 4, offsetof(Capsule, end));
  perInstance("alert", 1, offsetof(Capsule, alert));
  perInstance("startTint", 4, offsetof(Capsule, start_tint));
  perInstance("endTint", 4, offsetof(Capsule, end_tint));

  material_ = materialOf(look, this);
  setGhost(look != Look::Solid);
  setBehind(0);
  setThickness(1);
  setPane({});
  setOffset({});
  setFlatness(1);
  addComponent(mesh_);
  addComponent(material_);
  hide();
}

void Figure::show(std::span<const Capsule> capsules) {
  capsules_->setData(QByteArray(reinterpret_cast<const char*>(capsules.data()),
                                static_cast<qsizetype>(capsules.size_bytes())));
  mesh_->setInstanceCount(static_cast<int>(capsules.size()));
  setEnabled(!capsules.empty());
}

void Figure::hide() {
  setEnabled(false);
}

void Figure::setGhost(bool ghost) {
  material_->set("opacity", ghost ? kGhostOpacity : 1.0f);
}

void Figure::setBehind(float behind) {
  material_->set("behind", behind);
}

void Figure::setThickness(float thickness) {
  material_->set("thickness", thickness);
}

void Figure::setPane(const Pane& pane) {
  material_->set("pane", QVector3D(pane.shift, pane.from, pane.to));
}

void Figure::setOffset(const QVector3D& offset) {
  material_->set("offset", offset);
}

void Figure::setFlatness(float flatness) {
  material_->set("flatness", flatness);
}

void Figure::setColours(const QColor& figure, const QColor& alert) {
  material_->setColour("colour", figure);
  material_->setColour("alertColour", alert);
}

}  // namespace mocapress
