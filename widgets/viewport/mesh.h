// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <Qt3DCore/QAttribute>
#include <Qt3DCore/QBuffer>
#include <Qt3DCore/QGeometry>
#include <Qt3DRender/QGeometryRenderer>
#include <cstdint>
#include <vector>

namespace mocapress {

/// Triangles whose vertices are a position (3 floats) and one float more.
struct Mesh {
  struct Vertex {
    float x, y, z;
    float along;  // what the capsule's shader takes; 0 elsewhere
  };
  std::vector<Vertex> vertices;
  std::vector<std::uint16_t> indices;
};

/// How finely a capsule is made.
struct CapsuleDetail {
  int segments = 12;  // around
  int rings = 4;      // a half, the pole included
};

/// A unit ball cut at the equator, the halves at `along` 0 (y <= 0) and 1: stretched by the shader.
Mesh capsuleMesh(const CapsuleDetail& detail = {});

/// A square from -1 to 1 on y = 0.
Mesh groundMesh();

/// One triangle that covers clip space.
Mesh backdropMesh();

/// What a buffer takes.
template <typename T>
QByteArray bytesOf(const std::vector<T>& values) {
  return {reinterpret_cast<const char*>(values.data()),
          static_cast<qsizetype>(values.size() * sizeof(T))};
}

/// Float attributes of a buffer of equal records.
Qt3DCore::QAttribute* addAttribute(Qt3DCore::QGeometry* geometry, Qt3DCore::QBuffer* buffer,
                                   const QString& name, uint floats, uint byte_offset,
                                   uint byte_stride);

/// The mesh with attributes `vertexPosition` and `along`.
Qt3DRender::QGeometryRenderer* makeRenderer(const Mesh& mesh, Qt3DCore::QNode* parent);

}  // namespace mocapress
