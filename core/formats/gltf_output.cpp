// SPDX-License-Identifier: MIT
#include "core/formats/gltf_output.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <limits>

#include "core/base/base64.h"
#include "core/base/error.h"

namespace mocapress {
namespace {

constexpr int kFloat = 5126;  // componentType

}  // namespace

std::string data_uri(std::string_view type, std::string_view bytes) {
  return "data:" + std::string(type) + ";base64," + base64_of(bytes);
}

std::size_t BufferWriter::add_view(std::string_view bytes) {
  bytes_.resize((bytes_.size() + 3) / 4 * 4);
  Json& views = array("bufferViews");
  views.push_back(
      {{"buffer", buffer_}, {"byteOffset", bytes_.size()}, {"byteLength", bytes.size()}});
  bytes_.append(bytes);
  return views.size() - 1;
}

std::size_t BufferWriter::add(const char* type, std::size_t components,
                              const std::vector<float>& values, bool with_range) {
  const std::size_t view =
      add_view({reinterpret_cast<const char*>(values.data()), values.size() * sizeof(float)});
  Json accessor = {{"bufferView", view},
                   {"componentType", kFloat},
                   {"count", values.size() / components},
                   {"type", type}};
  if (with_range) {
    const auto [least, most] = std::minmax_element(values.begin(), values.end());
    accessor["min"] = Json::array({*least});
    accessor["max"] = Json::array({*most});
  }
  Json& accessors = array("accessors");
  accessors.push_back(std::move(accessor));
  return accessors.size() - 1;
}

Json& BufferWriter::array(const char* key) {
  Json& list = json_[key];
  if (!list.is_array()) list = Json::array();
  return list;
}

std::string in_container(Json json, GltfContainer container, std::size_t buffer, std::string data,
                         const std::vector<GlbChunk>& others) {
  json["buffers"][buffer]["byteLength"] = data.size();
  if (container == GltfContainer::Gltf)
    json["buffers"][buffer]["uri"] = data_uri(kBufferType, data);
  // In names, bytes that are not UTF-8 become the replacement character.
  std::string text = dumped(json, container == GltfContainer::Gltf ? 1 : -1);
  if (container == GltfContainer::Gltf) return text + '\n';

  std::string file;
  const auto append_word = [&](std::size_t word) {
    const auto value = static_cast<std::uint32_t>(word);
    file.append(reinterpret_cast<const char*>(&value), sizeof(value));
  };
  const auto append_chunk = [&](std::uint32_t type, std::string bytes, char padding) {
    bytes.resize((bytes.size() + 3) / 4 * 4, padding);
    append_word(bytes.size());
    append_word(type);
    file += bytes;
  };
  for (const std::uint32_t word : {kGlbMagic, 2U, 0U}) append_word(word);
  append_chunk(kGlbJsonChunk, std::move(text), ' ');
  append_chunk(kGlbDataChunk, std::move(data), '\0');
  for (const GlbChunk& chunk : others) append_chunk(chunk.type, chunk.bytes, '\0');
  if (file.size() > std::numeric_limits<std::uint32_t>::max())
    throw WriteError("the motion is too large for a .glb: 4 GB are the most");
  const auto size = static_cast<std::uint32_t>(file.size());
  std::memcpy(file.data() + 8, &size, sizeof(size));
  return file;
}

}  // namespace mocapress
