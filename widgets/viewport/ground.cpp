// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/viewport/ground.h"

#include <QVector2D>
#include <algorithm>
#include <cmath>

#include "widgets/viewport/mesh.h"

namespace mocapress {

float gridCell(float figure_size) {
  const float human = 180;  // cm
  return 50 * std::pow(10.0f, std::round(std::log10(figure_size / human)));
}

Ground::Ground(QNode* parent) : QEntity(parent) {
  material_ = new ShaderMaterial("ground", {{"shade", translucent()}}, this);
  addComponent(makeRenderer(groundMesh(), this));
  addComponent(material_);
  setCell(cell_);
  setPane({});
}

void Ground::setPane(const Pane& pane) {
  material_->set("pane", QVector3D(pane.shift, pane.from, pane.to));
}

void Ground::setCell(float cell) {
  cell_ = cell;
  material_->set("cell", cell);
}

void Ground::lookFrom(const OrbitCamera& camera) {
  material_->set("centre", QVector2D(camera.target().x(), camera.target().z()));
  material_->set("reach", std::clamp(2.5f * camera.distance(), 8 * cell_, 200 * cell_));
}

void Ground::setColours(const SceneColours& colours) {
  material_->setColour("lineColour", colours.grid);
  material_->setColour("xAxisColour", colours.x_axis);
  material_->setColour("zAxisColour", colours.z_axis);
}

}  // namespace mocapress
