// SPDX-License-Identifier: MIT
#include "core/formats/gltf_draco.h"

#include <draco/compression/decode.h>
#include <draco/core/varint_decoding.h>

#include <iterator>

#include "core/base/error.h"

namespace mocapress {
namespace {

constexpr std::uint32_t kMostElements = 10'000'000;  // limit for vertices, and for triangles

[[noreturn]] void refuse() {
  throw Error("is not what KHR_draco_mesh_compression makes");
}

/// Checks the numbers of triangles and vertices in the header, since the library allocates for as
/// many as it states. After Draco's bitstream specification 2.2, which the extension requires.
void check_head(std::string_view bytes) {
  draco::DecoderBuffer buffer;
  buffer.Init(bytes.data(), bytes.size());
  struct Head {
    char mark[5];
    std::uint8_t major, minor, kind, method, flags[2];
  } head;
  static_assert(sizeof(Head) == 11);
  constexpr std::uint8_t kMesh = 1;
  constexpr std::uint8_t kEdgebreaker = 1;
  constexpr unsigned kHasMetadata = 0x80;  // in the second byte of the flags
  if (!buffer.Decode(&head) || std::string_view(head.mark, 5) != "DRACO" || head.major != 2 ||
      head.minor != 2 || head.kind != kMesh || (head.flags[1] & kHasMetadata) != 0)
    refuse();
  std::uint8_t traversal = 0;
  if (head.method == kEdgebreaker && !buffer.Decode(&traversal)) refuse();
  for (int i = 0; i < 2; ++i) {
    std::uint32_t count = 0;
    if (!draco::DecodeVarint(&count, &buffer)) refuse();
    if (count > kMostElements) throw Error("is too large to read");
  }
}

DracoMesh::Attribute values_of(const draco::PointAttribute& attribute, std::uint32_t vertices) {
  DracoMesh::Attribute read{static_cast<std::size_t>(attribute.num_components()), {}};
  const bool is_float = attribute.data_type() == draco::DT_FLOAT32;
  for (std::uint32_t v = 0; v < vertices; ++v) {
    const auto at = attribute.mapped_index(draco::PointIndex(v));
    const auto add = [&](auto&& components) {
      if (read.components > std::size(components) ||
          !attribute.ConvertValue(at, attribute.num_components(), components))
        refuse();
      read.values.insert(read.values.end(), components, components + read.components);
    };
    float numbers[4];
    std::int64_t integers[4];
    if (is_float)
      add(numbers);
    else
      add(integers);
  }
  return read;
}

}  // namespace

DracoMesh draco_unpacked(std::string_view bytes) {
  check_head(bytes);
  draco::DecoderBuffer buffer;
  buffer.Init(bytes.data(), bytes.size());
  draco::Decoder decoder;
  auto decoded = decoder.DecodeMeshFromBuffer(&buffer);
  if (!decoded.ok()) refuse();
  const draco::Mesh& mesh = *decoded.value();
  DracoMesh read{.vertices = mesh.num_points(), .corners = {}, .attributes = {}};
  for (draco::FaceIndex f(0); f < mesh.num_faces(); ++f)
    for (const auto& corner : mesh.face(f)) read.corners.push_back(corner.value());
  for (int a = 0; a < mesh.num_attributes(); ++a)
    read.attributes.emplace(mesh.attribute(a)->unique_id(),
                            values_of(*mesh.attribute(a), mesh.num_points()));
  return read;
}

}  // namespace mocapress
