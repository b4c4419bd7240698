// SPDX-License-Identifier: MIT
// The common parts of every written glTF: buffers, data URIs and the two containers, after sections
// 2.8, 3.6 and 4 of the glTF 2.0 specification.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/formats/gltf_file.h"
#include "core/formats/gltf_writer.h"

namespace mocapress {

/// The media type of a buffer in a data URI.
inline constexpr const char* kBufferType = "application/octet-stream";

/// `bytes` as a URI: "data:image/png;base64,...".
std::string data_uri(std::string_view type, std::string_view bytes);

/// Collects the contents of one buffer.
class BufferWriter {
 public:
  /// `bytes` are the buffer's present contents.
  BufferWriter(Json& json, std::size_t buffer, std::string bytes)
      : json_(json), buffer_(buffer), bytes_(std::move(bytes)) {}

  /// Adds a bufferView and returns its index.
  std::size_t add_view(std::string_view bytes);

  /// Adds an accessor of floats, `components` for each element, and returns its index.
  std::size_t add(const char* type, std::size_t components, const std::vector<float>& values,
                  bool with_range = false);

  std::string release() { return std::move(bytes_); }

 private:
  Json& array(const char* key);

  Json& json_;
  std::size_t buffer_;
  std::string bytes_;
};

/// The bytes of a file. `data` is the buffer number `buffer`: a .gltf stores it as a data URI, a
/// .glb as its chunk, followed by `others`. Throws WriteError beyond the 4 GB limit of a .glb.
std::string in_container(Json json, GltfContainer container, std::size_t buffer, std::string data,
                         const std::vector<GlbChunk>& others = {});

}  // namespace mocapress
