// SPDX-License-Identifier: MIT
#include "core/formats/gltf_meshopt.h"

#include <meshoptimizer.h>

#include "core/base/error.h"

namespace mocapress {
namespace {

constexpr std::size_t kMostPerByte = 64;  // most bytes that one packed byte can become

/// Checks the library's preconditions.
bool is_possible(const MeshoptPacking& packing, std::size_t packed_bytes) {
  const std::size_t stride = packing.stride;
  const bool is_attributes = packing.mode == "ATTRIBUTES";
  const bool has_filter = !packing.filter.empty() && packing.filter != "NONE";
  if (is_attributes ? stride == 0 || stride % 4 != 0 || stride > 256 : stride != 2 && stride != 4)
    return false;
  if (packing.mode == "TRIANGLES" && packing.count % 3 != 0) return false;
  if (has_filter && !is_attributes) return false;
  if (packing.filter == "OCTAHEDRAL" && stride != 4 && stride != 8) return false;
  if (packing.filter == "QUATERNION" && stride != 8) return false;
  return packing.count <= kMostPerByte * packed_bytes / stride;
}

}  // namespace

std::string meshopt_unpacked(const MeshoptPacking& packing, std::string_view bytes) {
  const auto refuse = [] { throw Error("is not what EXT_meshopt_compression makes"); };
  if (!is_possible(packing, bytes.size())) refuse();
  const auto [count, stride, mode, filter] = packing;
  std::string data(count * stride, '\0');
  const auto* const packed = reinterpret_cast<const unsigned char*>(bytes.data());
  int failure = -1;
  if (mode == "ATTRIBUTES")
    failure = meshopt_decodeVertexBuffer(data.data(), count, stride, packed, bytes.size());
  else if (mode == "TRIANGLES")
    failure = meshopt_decodeIndexBuffer(data.data(), count, stride, packed, bytes.size());
  else if (mode == "INDICES")
    failure = meshopt_decodeIndexSequence(data.data(), count, stride, packed, bytes.size());
  if (failure != 0) refuse();
  if (filter == "OCTAHEDRAL")
    meshopt_decodeFilterOct(data.data(), count, stride);
  else if (filter == "QUATERNION")
    meshopt_decodeFilterQuat(data.data(), count, stride);
  else if (filter == "EXPONENTIAL")
    meshopt_decodeFilterExp(data.data(), count, stride);
  else if (!filter.empty() && filter != "NONE")
    refuse();
  return data;
}

}  // namespace mocapress
