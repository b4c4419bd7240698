// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/viewport/mesh.h"

#include <cmath>
#include <numbers>

namespace mocapress {

Mesh capsuleMesh(const CapsuleDetail& detail) {
  const int segments = detail.segments;
  const int rings = detail.rings;
  constexpr float kQuarter = std::numbers::pi_v<float> / 2;
  Mesh mesh;
  for (int ring = 0; ring < 2 * rings; ++ring) {
    const bool end = ring >= rings;
    const int step = end ? ring - rings : ring - rings + 1;  // rings from the equator, signed
    const float latitude = kQuarter * static_cast<float>(step) / static_cast<float>(rings - 1);
    for (int segment = 0; segment < segments; ++segment) {
      const float longitude =
          4 * kQuarter * static_cast<float>(segment) / static_cast<float>(segments);
      mesh.vertices.push_back({std::cos(latitude) * std::cos(longitude), std::sin(latitude),
                               std::cos(latitude) * std::sin(longitude), end ? 1.0f : 0.0f});
    }
  }
  for (int ring = 0; ring + 1 < 2 * rings; ++ring)
    for (int segment = 0; segment < segments; ++segment) {
      const auto at = [&](int up, int around) {
        return static_cast<std::uint16_t>((ring + up) * segments + (segment + around) % segments);
      };
      mesh.indices.insert(mesh.indices.end(),
                          {at(0, 0), at(1, 0), at(1, 1), at(0, 0), at(1, 1), at(0, 1)});
    }
  return mesh;
}

Mesh groundMesh() {
  return {{{-1, 0, -1, 0}, {-1, 0, 1, 0}, {1, 0, 1, 0}, {1, 0, -1, 0}}, {0, 1, 2, 0, 2, 3}};
}

Mesh backdropMesh() {
  return {{{-1, -1, 0, 0}, {3, -1, 0, 0}, {-1, 3, 0, 0}}, {0, 1, 2}};
}

Qt3DCore::QAttribute* addAttribute(Qt3DCore::QGeometry* geometry, Qt3DCore::QBuffer* buffer,
                                   const QString& name, uint floats, uint byte_offset,
                                   uint byte_stride) {
  auto* attribute = new Qt3DCore::QAttribute(geometry);
  attribute->setName(name);
  attribute->setAttributeType(Qt3DCore::QAttribute::VertexAttribute);
  attribute->setVertexBaseType(Qt3DCore::QAttribute::Float);
  attribute->setVertexSize(floats);
  attribute->setByteOffset(byte_offset);
  attribute->setByteStride(byte_stride);
  attribute->setBuffer(buffer);
  geometry->addAttribute(attribute);
  return attribute;
}

Qt3DRender::QGeometryRenderer* makeRenderer(const Mesh& mesh, Qt3DCore::QNode* parent) {
  auto* renderer = new Qt3DRender::QGeometryRenderer(parent);
  auto* geometry = new Qt3DCore::QGeometry(renderer);

  auto* vertices = new Qt3DCore::QBuffer(geometry);
  vertices->setData(bytesOf(mesh.vertices));
  const auto count = static_cast<uint>(mesh.vertices.size());
  const QString position = Qt3DCore::QAttribute::defaultPositionAttributeName();
  addAttribute(geometry, vertices, position, 3, 0, sizeof(Mesh::Vertex))->setCount(count);
  addAttribute(geometry, vertices, "along", 1, offsetof(Mesh::Vertex, along), sizeof(Mesh::Vertex))
      ->setCount(count);

  auto* indices = new Qt3DCore::QBuffer(geometry);
  indices->setData(bytesOf(mesh.indices));
  auto* index = new Qt3DCore::QAttribute(geometry);
  index->setAttributeType(Qt3DCore::QAttribute::IndexAttribute);
  index->setVertexBaseType(Qt3DCore::QAttribute::UnsignedShort);
  index->setCount(static_cast<uint>(mesh.indices.size()));
  index->setBuffer(indices);
  geometry->addAttribute(index);

  renderer->setGeometry(geometry);
  return renderer;
}

}  // namespace mocapress
