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

namespace mocapress {

/// A chunk of a .glb.
struct GlbChunk {
  std::uint32_t type;
  std::string bytes;
};

inline constexpr std::uint32_t kGlbMagic = 0x46546C67;      // "glTF"
inline constexpr std::uint32_t kGlbJsonChunk = 0x4E4F534A;  // "JSON"
inline constexpr std::uint32_t kGlbDataChunk = 0x004E4942;  // "BIN\0"

/// The extension EXT_meshopt_compression, and the name under which Khronos took it over.
inline constexpr const char* kMeshoptExtensions[] = {"EXT_meshopt_compression",
                                                     "KHR_meshopt_compression"};

/// A glTF 2.0 file taken apart: its JSON, and on demand the bytes that it refers to. Every index,
/// size and number that is asked for is checked. What is wrong is an InputError, from all of these.
class GltfFile {
 public:
  /// A .glb or a .gltf, whichever the bytes are. The folder of `file` is where its buffers may be.
  GltfFile(std::filesystem::path file, std::string_view bytes);

  std::string name() const { return path_.string(); }
  const Json& json() const { return json_; }

  /// Of the file itself and of the buffers that were asked for so far.
  std::size_t bytes_read() const { return bytes_read_; }

  /// The chunks of a .glb that follow its JSON. A .gltf has none.
  const std::vector<GlbChunk>& chunks() const { return chunks_; }

  [[noreturn]] void fail(const std::string& message) const;

  /// "nodes", "skins", ...: the file's objects of that kind; none where it has none.
  const Json& list(const char* kind) const;

  /// The objects in a list of `object`, as list() has it.
  const Json& list(const Json& object, const char* key) const;

  /// The member that counts from 0 into list(kind).
  std::optional<std::size_t> index(const Json& object, const char* key, const char* kind) const;
  std::size_t required_index(const Json& object, const char* key, const char* kind) const;

  /// All indices of an array.
  std::vector<std::size_t> indices(const Json& object, const char* key, const char* kind) const;

  /// A whole number from 0; `otherwise` where there is none.
  std::size_t size(const Json& object, const char* key, std::size_t otherwise) const;

  /// An extension of an object; null where it has none of that name.
  const Json* extension(const Json& object, const char* name) const;

  /// A text; empty where there is none.
  std::string text(const Json& object, const char* key) const;

  /// So many numbers, each finite and at most 1e9.
  std::optional<std::vector<double>> numbers(const Json& object, const char* key,
                                             std::size_t count) const;

  /// The bytes of a buffer, as many as it states.
  const std::string& buffer(std::size_t index);

  /// What a `uri` stands for: a data URI, or a file in this one's folder or below.
  std::string resource(const std::string& uri) const;

  /// Whether a buffer only says how large packed bufferViews are: it has no bytes of its own.
  bool is_placeholder(std::size_t buffer) const;

  /// The bytes of a bufferView, one after another.
  std::string bytes_of_view(std::size_t index);

  /// Counts numbers that are read towards the most that a file may hold.
  void spend(std::size_t numbers);

  /// How many numbers an element of such an accessor has.
  static std::size_t components_of(std::string_view type);

  /// Numbers of an accessor that come from elsewhere, normalised where it states so.
  std::vector<double> as_stated(std::size_t accessor, std::vector<double> values) const;

  /// An accessor's elements one after another, as numbers: normalised ones from -1 or 0 to 1,
  /// sparse ones filled in. `type` is what it has to be: "SCALAR", "VEC2", "VEC3",
  /// "VEC4", "MAT4".
  std::vector<double> values(std::size_t accessor, std::string_view type);

 private:
  struct View;  // of numbers among a buffer's bytes

  void read_glb(std::string_view bytes);
  /// The bytes that accessors see: a packed bufferView's are unpacked, once.
  std::string_view view_bytes(std::size_t index);
  const Json* packing(const Json& buffer_view) const;
  std::string_view part(std::size_t view, const Json& stated);
  View view(const Json& object, std::size_t count, std::size_t components, bool normalised);
  bool is_normalised(const Json& accessor) const;
  const Json* member(const Json& object, const char* key) const;

  std::filesystem::path path_;
  Json json_;
  std::vector<GlbChunk> chunks_;
  std::map<std::size_t, std::string> buffers_;   // those that were asked for
  std::map<std::size_t, std::string> unpacked_;  // bufferViews, likewise
  std::size_t bytes_read_;
  std::size_t values_read_ = 0;
  std::size_t zeros_read_ = 0;
  std::size_t unpacked_bytes_ = 0;
};

/// Whether a URI holds its bytes itself.
bool is_data_uri(std::string_view uri);

}  // namespace mocapress
