// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/viewport/skin_figure.h"

#include <Qt3DCore/QGeometry>
#include <Qt3DRender/QGeometryRenderer>
#include <algorithm>
#include <utility>

#include "widgets/viewport/mesh.h"
#include "widgets/viewport/skin_pictures.h"

namespace mocapress {
namespace {

/// A vertex in the layout of the shader. Indices are floats, since the shader's integers are slow
/// and its attributes few.
struct SkinVertex {
  std::array<float, 3> position;
  std::array<float, 3> normal;
  std::array<float, 3> colour;
  std::array<float, 4> bones;
  std::array<float, 4> weights;
  std::array<float, 3> place;  // texture coordinates and the picture's index; -1: no picture
};
static_assert(sizeof(SkinVertex) == 20 * sizeof(float));

/// One bone's entry in the uniform block `Bones`: four vectors.
struct BoneRows {
  std::array<float, 12> world_from_bind;  // in row-major order
  std::array<float, 4> cover;
};
static_assert(sizeof(BoneRows) == 64);

std::array<float, 3> floatsOf(const Eigen::Vector3f& vector) {
  return {vector.x(), vector.y(), vector.z()};
}

std::vector<SkinVertex> verticesOf(const Skin& skin) {
  std::vector<SkinVertex> vertices;
  vertices.reserve(skin.vertices.size());
  for (const Skin::Vertex& vertex : skin.vertices) {
    const auto& bones = vertex.carried_by.bones;
    vertices.push_back(
        {floatsOf(vertex.in_bind),
         floatsOf(vertex.normal),
         floatsOf(vertex.colour),
         {static_cast<float>(bones[0]), static_cast<float>(bones[1]), static_cast<float>(bones[2]),
          static_cast<float>(bones[3])},
         vertex.carried_by.weights,
         {vertex.in_picture.x(), vertex.in_picture.y(), static_cast<float>(vertex.picture)}});
  }
  return vertices;
}

}  // namespace

std::vector<QVector4D> jointCovers(const FigureMarks& marks, int joints, const QColor& alert) {
  std::vector<QVector4D> covers;
  for (int joint = 0; joint < joints; ++joint) {
    const auto j = static_cast<std::size_t>(joint);
    QVector4D cover;
    if (j < marks.alerts.size()) {
      cover = tintOf(alert);
      cover.setW(marks.alerts[j]);
    }
    if (j < marks.tints.size() && marks.tints[j].w() > 0) cover = marks.tints[j];
    covers.push_back(cover);
  }
  return covers;
}

SkinFigure::SkinFigure(bool may_be_ghost, QNode* parent) : QEntity(parent) {
  auto* mesh = new Qt3DRender::QGeometryRenderer(this);
  auto* geometry = new Qt3DCore::QGeometry(mesh);
  vertices_ = new Qt3DCore::QBuffer(geometry);
  triangles_ = new Qt3DCore::QBuffer(geometry);
  const auto perVertex = [&](const QString& name, uint floats, uint byte_offset) {
    of_vertices_.push_back(
        addAttribute(geometry, vertices_, name, floats, byte_offset, sizeof(SkinVertex)));
  };
  perVertex(Qt3DCore::QAttribute::defaultPositionAttributeName(), 3, 0);
  perVertex(Qt3DCore::QAttribute::defaultNormalAttributeName(), 3, offsetof(SkinVertex, normal));
  perVertex("vertexColour", 3, offsetof(SkinVertex, colour));
  perVertex("bones", 4, offsetof(SkinVertex, bones));
  perVertex("weights", 4, offsetof(SkinVertex, weights));
  perVertex("place", 3, offsetof(SkinVertex, place));
  corners_ = new Qt3DCore::QAttribute(geometry);
  corners_->setAttributeType(Qt3DCore::QAttribute::IndexAttribute);
  corners_->setVertexBaseType(Qt3DCore::QAttribute::UnsignedInt);
  corners_->setBuffer(triangles_);
  geometry->addAttribute(corners_);
  mesh->setGeometry(geometry);

  material_ = new ShaderMaterial("skin", "figure", may_be_ghost ? ghostPasses() : solidPasses(),
                                 this, "PICTURED");
  pictures_ = makePictureTexture(this);
  material_->set("pictures", QVariant::fromValue(pictures_));
  bones_ = new Qt3DCore::QBuffer(this);
  bones_->setUsage(Qt3DCore::QBuffer::DynamicDraw);
  bones_->setData(bytesOf(std::vector<BoneRows>(Skin::kMostBones)));
  material_->set("Bones", QVariant::fromValue(bones_));
  material_->set("pictureCount", 1.0f);
  setGhost(may_be_ghost);
  setBehind(0);
  setPane({});
  setOffset({});
  setColour({});
  addComponent(mesh);
  addComponent(material_);
  hide();
}

void SkinFigure::setSkin(std::shared_ptr<const Skin> skin) {
  skin_ = std::move(skin);
  is_uploaded_ = false;
  hide();
}

void SkinFigure::upload() {
  showPictures(pictures_, skin_);
  material_->set("pictureCount",
                 static_cast<float>(std::max<std::size_t>(1, skin_->pictures.size())));
  vertices_->setData(bytesOf(verticesOf(*skin_)));
  triangles_->setData(bytesOf(skin_->triangles));
  for (Qt3DCore::QAttribute* attribute : of_vertices_)
    attribute->setCount(static_cast<uint>(skin_->vertices.size()));
  corners_->setCount(static_cast<uint>(3 * skin_->triangles.size()));
}

void SkinFigure::show(const Pose& pose, const std::vector<QVector4D>& covers) {
  if (!std::exchange(is_uploaded_, true)) upload();
  const std::vector<Eigen::Affine3d> transforms = world_from_bind(*skin_, pose);
  std::vector<BoneRows> rows(Skin::kMostBones);
  for (std::size_t b = 0; b < transforms.size(); ++b) {
    using RowByRow = Eigen::Matrix<float, 3, 4, Eigen::RowMajor>;
    Eigen::Map<RowByRow>(rows[b].world_from_bind.data()) =
        transforms[b].matrix().topRows<3>().cast<float>();
    const auto joint = static_cast<std::size_t>(skin_->bones[b].joint);
    if (joint < covers.size())
      rows[b].cover = {covers[joint].x(), covers[joint].y(), covers[joint].z(), covers[joint].w()};
  }
  bones_->setData(bytesOf(rows));
  setEnabled(true);
}

void SkinFigure::hide() {
  setEnabled(false);
}

void SkinFigure::setGhost(bool ghost) {
  material_->set("opacity", ghost ? kGhostOpacity : 1.0f);
}

void SkinFigure::setBehind(float behind) {
  material_->set("behind", behind);
}

void SkinFigure::setPane(const Pane& pane) {
  material_->set("pane", QVector3D(pane.shift, pane.from, pane.to));
}

void SkinFigure::setOffset(const QVector3D& offset) {
  material_->set("offset", offset);
}

void SkinFigure::setColour(const QColor& colour) {
  material_->set("colour", colour.isValid() ? tintOf(colour) : QVector4D());
}

}  // namespace mocapress
