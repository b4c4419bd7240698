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

/// Triangles whose vertices have a position (3 floats) and one more float.
struct Mesh {
  struct Vertex {
    float x, y, z;
    float along;  // 0 or 1: the vertex's end of a capsule; 0 in other meshes
  };
  std::vector<Vertex> vertices;
  std::vector<std::uint16_t> indices;
};

/// Resolution of a capsule.
struct CapsuleDetail {
  int segments = 12;  // around the axis
  int rings = 4;      // from the equator to the pole, inclusive
};

/// A unit ball cut at the equator: one half has `along` 0 (y <= 0), the other 1. The shader pulls
/// the halves apart.
Mesh capsuleMesh(const CapsuleDetail& detail = {});

/// A square from -1 to 1 on y = 0.
Mesh groundMesh();

/// One triangle that covers clip space.
Mesh backdropMesh();

/// Copies values into a buffer's bytes.
template <typename T>
QByteArray bytesOf(const std::vector<T>& values) {
  return {reinterpret_cast<const char*>(values.data()),
          static_cast<qsizetype>(values.size() * sizeof(T))};
}

/// Adds a vertex attribute of `floats` floats, read from a buffer of equally large records.
Qt3DCore::QAttribute* addAttribute(Qt3DCore::QGeometry* geometry, Qt3DCore::QBuffer* buffer,
                                   const QString& name, uint floats, uint byte_offset,
                                   uint byte_stride);

/// Makes a renderer of the mesh with attributes `vertexPosition` and `along`.
Qt3DRender::QGeometryRenderer* makeRenderer(const Mesh& mesh, Qt3DCore::QNode* parent);

}  // namespace mocapress
