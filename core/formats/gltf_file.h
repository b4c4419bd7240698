// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/json_text.h"
#include "core/base/utf8_path.h"

namespace mocapress {

/// A chunk of a .glb.
struct GlbChunk {
  std::uint32_t type;
  std::string bytes;
};

inline constexpr std::uint32_t kGlbMagic = 0x46546C67;      // "glTF"
inline constexpr std::uint32_t kGlbJsonChunk = 0x4E4F534A;  // "JSON"
inline constexpr std::uint32_t kGlbDataChunk = 0x004E4942;  // "BIN\0"

/// The extension EXT_meshopt_compression, and its later name as a Khronos extension.
inline constexpr const char* kMeshoptExtensions[] = {"EXT_meshopt_compression",
                                                     "KHR_meshopt_compression"};

/// A parsed glTF 2.0 file: its JSON, and on demand the bytes it refers to. Every index, size and
/// number that is returned was checked. All members throw InputError for anything wrong.
class GltfFile {
 public:
  /// Takes a .glb or a .gltf, told apart by their bytes. Buffers may lie in the folder of `file`.
  GltfFile(std::filesystem::path file, std::string_view bytes);

  std::string name() const { return utf8(path_); }
  const Json& json() const { return json_; }

  /// Size of the file and of the buffers loaded so far.
  std::size_t bytes_read() const { return bytes_read_; }

  /// The chunks of a .glb after its JSON; none in a .gltf.
  const std::vector<GlbChunk>& chunks() const { return chunks_; }

  [[noreturn]] void fail(const std::string& message) const;

  /// The file's objects of a kind ("nodes", "skins", ...); an empty list if it has none.
  const Json& list(const char* kind) const;

  /// A list that is a member of `object`; an empty list if the member is absent.
  const Json& list(const Json& object, const char* key) const;

  /// A member that is an index into list(kind).
  std::optional<std::size_t> index(const Json& object, const char* key, const char* kind) const;
  std::size_t required_index(const Json& object, const char* key, const char* kind) const;

  /// A member that is an array of indices into list(kind).
  std::vector<std::size_t> indices(const Json& object, const char* key, const char* kind) const;

  /// A member that is a whole number from 0 on; `otherwise` if it is absent.
  std::size_t size(const Json& object, const char* key, std::size_t otherwise) const;

  /// An extension of an object by name; null if absent.
  const Json* extension(const Json& object, const char* name) const;

  /// A member that is a text; empty if absent.
  std::string text(const Json& object, const char* key) const;

  /// A member that is an array of `count` numbers, each finite and at most 1e9.
  std::optional<std::vector<double>> numbers(const Json& object, const char* key,
                                             std::size_t count) const;

  /// The bytes of a buffer, as many as it states.
  const std::string& buffer(std::size_t index);

  /// The bytes behind a `uri`: a data URI, or a file in this file's folder or below.
  std::string resource(const std::string& uri) const;

  /// True if a buffer has no bytes and only states the unpacked size of bufferViews.
  bool is_placeholder(std::size_t buffer) const;

  /// The bytes of a bufferView, without gaps.
  std::string bytes_of_view(std::size_t index);

  /// Counts `numbers` towards the limit on numbers that are read from a file.
  void spend(std::size_t numbers);

  /// The number of components in an element of type "SCALAR", "VEC3", ...
  static std::size_t components_of(std::string_view type);

  /// The values of an accessor that were decoded elsewhere, normalised if the accessor says so.
  std::vector<double> as_stated(std::size_t accessor, std::vector<double> values) const;

  /// All elements of an accessor as numbers: normalised ones from -1 or 0 to 1, sparse ones filled
  /// in. `type` is the required type: "SCALAR", "VEC2", "VEC3", "VEC4", "MAT4".
  std::vector<double> values(std::size_t accessor, std::string_view type);

 private:
  struct View;  // numbers among a buffer's bytes

  void read_glb(std::string_view bytes);
  /// The bytes of a bufferView as accessors see them: a packed one is unpacked, once.
  std::string_view view_bytes(std::size_t index);
  const Json* packing(const Json& buffer_view) const;
  std::string_view part(std::size_t view, const Json& stated);
  View view(const Json& object, std::size_t count, std::size_t components, bool normalised);
  bool is_normalised(const Json& accessor) const;
  const Json* member(const Json& object, const char* key) const;

  std::filesystem::path path_;
  Json json_;
  std::vector<GlbChunk> chunks_;
  std::map<std::size_t, std::string> buffers_;   // loaded ones
  std::map<std::size_t, std::string> unpacked_;  // unpacked bufferViews
  std::size_t bytes_read_;
  std::size_t values_read_ = 0;
  std::size_t zeros_read_ = 0;
  std::size_t unpacked_bytes_ = 0;
};

/// True if a URI contains its bytes.
bool is_data_uri(std::string_view uri);

}  // namespace mocapress
