// SPDX-License-Identifier: MIT
// After the glTF 2.0 specification, Khronos Group 2021 (ISO/IEC 12113:2022): sections 2.8 (URIs),
// 3.6 (buffers and accessors) and 4 (GLB).
#include "core/formats/gltf_file.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <iterator>
#include <limits>

#include "core/base/base64.h"
#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/memory_limit.h"
#include "core/base/path_kind.h"
#include "core/base/printable.h"
#include "core/base/utf8_path.h"
#include "core/formats/gltf_meshopt.h"

namespace mocapress {
namespace {

namespace fs = std::filesystem;

constexpr JsonLimits kLimits = {.depth = 64, .values = 20'000'000};
constexpr std::size_t kMostZeros = 10'000'000;  // limit for accessors without bytes, together
constexpr std::size_t kBytesOfNumber = 16;      // bytes for a number that is read and copied once
constexpr double kLargestNumber = 1e9;
constexpr const char* kTooMuch = "holds too many numbers to read";
constexpr const char* kNotANumber = " holds a number that is not finite or beyond 1e9";

/// Reads a little-endian number at any address.
template <typename T>
T read_at(const char* place) {
  T value;
  std::memcpy(&value, place, sizeof(T));
  return value;
}

/// The value of a hexadecimal digit, or -1.
int hex_digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

/// The text with "%20" and the like decoded.
std::string percent_decoded(std::string_view uri) {
  std::string text;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    const bool escaped = uri[i] == '%' && i + 2 < uri.size() && hex_digit(uri[i + 1]) >= 0 &&
                         hex_digit(uri[i + 2]) >= 0;
    text +=
        escaped ? static_cast<char>(16 * hex_digit(uri[i + 1]) + hex_digit(uri[i + 2])) : uri[i];
    if (escaped) i += 2;
  }
  return text;
}

/// True if a URI begins with "http:", "file:", "C:" or the like.
bool has_scheme(std::string_view uri) {
  return uri.substr(0, uri.find('/')).find(':') != std::string_view::npos;
}

bool leaves_its_folder(const fs::path& path) {
  return path.has_root_path() || std::ranges::find(path, "..") != path.end();
}

std::size_t component_bytes(std::size_t type) {
  switch (type) {
    case 5120:
    case 5121:
      return 1;
    case 5122:
    case 5123:
      return 2;
    case 5125:
    case 5126:
      return 4;
    default:
      return 0;
  }
}

/// A normalised integer as a share of its type's largest value (section 3.11). A float is returned
/// unchanged.
double share(double value, std::size_t type) {
  const auto of = [value](double one) { return std::max(value / one, -1.0); };
  switch (type) {
    case 5120:
      return of(std::numeric_limits<std::int8_t>::max());
    case 5121:
      return of(std::numeric_limits<std::uint8_t>::max());
    case 5122:
      return of(std::numeric_limits<std::int16_t>::max());
    case 5123:
      return of(std::numeric_limits<std::uint16_t>::max());
    case 5125:
      return of(std::numeric_limits<std::uint32_t>::max());
    default:
      return value;
  }
}

/// Reads a number of a component type (section 3.6.2.2).
double component(const char* place, std::size_t type) {
  switch (type) {
    case 5120:
      return read_at<std::int8_t>(place);
    case 5121:
      return read_at<std::uint8_t>(place);
    case 5122:
      return read_at<std::int16_t>(place);
    case 5123:
      return read_at<std::uint16_t>(place);
    case 5125:
      return read_at<std::uint32_t>(place);
    default:
      return static_cast<double>(read_at<float>(place));
  }
}

const Json& no_objects() {
  static const Json kNone = Json::array();
  return kNone;
}

std::string quoted_key(const char* key) {
  return std::string("\"") + key + '"';
}

}  // namespace

/// `count` times `components` numbers of one type, every `stride` bytes.
struct GltfFile::View {
  const char* begin = nullptr;  // null: no bytes, all numbers are zero
  std::size_t stride = 0;
  std::size_t count = 0;
  std::size_t components = 0;
  std::size_t component_type = 0;
  bool normalised = false;

  double operator()(std::size_t element, std::size_t i) const {
    if (begin == nullptr) return 0;
    const double value =
        component(begin + element * stride + i * component_bytes(component_type), component_type);
    return normalised ? share(value, component_type) : value;
  }
};

bool is_data_uri(std::string_view uri) {
  return uri.starts_with("data:");
}

GltfFile::GltfFile(fs::path file, std::string_view bytes)
    : path_(std::move(file)), bytes_read_(bytes.size()) {
  if (bytes.size() >= 4 && read_at<std::uint32_t>(bytes.data()) == kGlbMagic)
    read_glb(bytes);
  else
    json_ = parse_json(name(), bytes, kLimits);
  if (!json_.is_object()) fail("is no glTF: its JSON is not an object");
  const Json* asset = member(json_, "asset");
  const std::string version = asset && asset->is_object() ? text(*asset, "version") : "";
  if (!version.starts_with("2."))
    fail("is no glTF 2.0: " +
         (version.empty() ? "it states no version" : "its version is " + shortened(version)));
  // Checks all lists once, here, since they are often looked up.
  for (const char* kind : {"accessors", "animations", "buffers", "bufferViews", "images",
                           "materials", "meshes", "nodes", "skins", "textures"})
    list(json_, kind);
}

void GltfFile::fail(const std::string& message) const {
  throw InputError(utf8(path_), 0, 0, message);
}

void GltfFile::read_glb(std::string_view bytes) {
  constexpr std::size_t kHead = 12;
  constexpr std::size_t kChunkHead = 8;
  const auto word = [&](std::size_t at) { return read_at<std::uint32_t>(bytes.data() + at); };
  if (bytes.size() < kHead || word(8) > bytes.size()) fail("ends before the length it states");
  if (word(4) != 2) fail("is version " + std::to_string(word(4)) + " of .glb, not 2");
  const std::size_t length = word(8);
  bool has_json = false;
  for (std::size_t at = kHead; at < length;) {
    if (length - at < kChunkHead || word(at) > length - at - kChunkHead)
      fail("has a chunk that reaches beyond its end");
    const std::string_view chunk = bytes.substr(at + kChunkHead, word(at));
    if (has_json)
      chunks_.push_back({word(at + 4), std::string(chunk)});
    else if (word(at + 4) == kGlbJsonChunk)
      json_ = parse_json(name(), chunk, kLimits);
    else
      fail("does not begin with JSON");
    has_json = true;
    at += kChunkHead + chunk.size();
  }
  if (!has_json) fail("holds no JSON");
}

const Json* GltfFile::member(const Json& object, const char* key) const {
  const auto found = object.find(key);
  return found == object.end() ? nullptr : &*found;
}

const Json* GltfFile::extension(const Json& object, const char* name) const {
  const Json* const extensions = member(object, "extensions");
  if (extensions == nullptr || !extensions->is_object()) return nullptr;
  const Json* const found = member(*extensions, name);
  return found != nullptr && found->is_object() ? found : nullptr;
}

const Json& GltfFile::list(const char* kind) const {
  const Json* found = member(json_, kind);
  return found == nullptr ? no_objects() : *found;
}

const Json& GltfFile::list(const Json& object, const char* key) const {
  const Json* found = member(object, key);
  if (found == nullptr) return no_objects();
  if (!found->is_array() ||
      !std::ranges::all_of(*found, [](const Json& one) { return one.is_object(); }))
    fail(quoted_key(key) + " is not a list of objects");
  return *found;
}

std::size_t GltfFile::size(const Json& object, const char* key, std::size_t otherwise) const {
  const Json* found = member(object, key);
  if (found == nullptr) return otherwise;
  if (found->is_number_unsigned()) return found->get<std::size_t>();
  // Some programs write whole numbers as 3.0.
  const double value = found->is_number() ? found->get<double>() : -1;
  if (!(value >= 0 && value <= 9e15) || value != std::floor(value))
    fail(quoted_key(key) + " is not a whole number from 0");
  return static_cast<std::size_t>(value);
}

std::optional<std::size_t> GltfFile::index(const Json& object, const char* key,
                                           const char* kind) const {
  if (member(object, key) == nullptr) return std::nullopt;
  const std::size_t value = size(object, key, 0);
  if (value >= list(kind).size())
    fail(quoted_key(key) + " names number " + std::to_string(value) + " of only " +
         std::to_string(list(kind).size()) + ' ' + kind);
  return value;
}

std::size_t GltfFile::required_index(const Json& object, const char* key, const char* kind) const {
  const auto found = index(object, key, kind);
  if (!found) fail("lacks a " + quoted_key(key) + " that should name one of its " + kind);
  return *found;
}

std::vector<std::size_t> GltfFile::indices(const Json& object, const char* key,
                                           const char* kind) const {
  const Json* found = member(object, key);
  if (found == nullptr) return {};
  if (!found->is_array()) fail(quoted_key(key) + " is not a list");
  const std::size_t count = list(kind).size();
  std::vector<std::size_t> indices;
  for (const Json& one : *found) {
    if (!one.is_number_unsigned() || one.get<std::size_t>() >= count)
      fail(quoted_key(key) + " names what is none of its " + std::to_string(count) + ' ' + kind);
    indices.push_back(one.get<std::size_t>());
  }
  return indices;
}

std::string GltfFile::text(const Json& object, const char* key) const {
  const Json* found = member(object, key);
  if (found == nullptr) return "";
  if (!found->is_string()) fail(quoted_key(key) + " is not a text");
  return found->get<std::string>();
}

std::optional<std::vector<double>> GltfFile::numbers(const Json& object, const char* key,
                                                     std::size_t count) const {
  const Json* found = member(object, key);
  if (found == nullptr) return std::nullopt;
  const bool fits = found->is_array() && found->size() == count &&
                    std::ranges::all_of(*found, [](const Json& one) {
                      return one.is_number() && std::abs(one.get<double>()) <= kLargestNumber;
                    });
  if (!fits) fail(quoted_key(key) + " is not " + std::to_string(count) + " numbers up to 1e9");
  return found->get<std::vector<double>>();
}

std::string GltfFile::resource(const std::string& uri) const {
  if (is_data_uri(uri)) {
    constexpr std::string_view kMark = ";base64,";
    const std::size_t mark = uri.find(kMark);
    if (mark == std::string::npos || mark > uri.find(',')) fail("has a data URI without base64");
    std::string_view digits = std::string_view(uri).substr(mark + kMark.size());
    while (digits.ends_with('=')) digits.remove_suffix(1);
    if (digits.find_first_not_of(kBase64Digits) != digits.npos)
      fail("has a data URI that is not base64");
    return bytes_of_base64(digits);
  }
  const std::string shown = "\"" + uri.substr(0, 120) + '"';
  const fs::path relative = utf8_path(percent_decoded(uri));
  if (has_scheme(uri) || leaves_its_folder(relative) ||
      relative.native().find('\0') != std::string::npos)
    fail("refers to " + shown + ", but only files in its own folder are read");
  const fs::path folder = path_.has_parent_path() ? path_.parent_path() : fs::path(".");
  const auto place = real_path(folder / relative);
  if (!place) fail("refers to " + shown + ", which is not there");
  // Resolved links may lead out of the folder, on Windows even to another drive.
  const fs::path below = place->lexically_relative(real_path(folder).value_or(fs::path()));
  if (below.empty() || leaves_its_folder(below) || path_kind(*place) != PathKind::File)
    fail("refers to " + shown + ", but only files in its own folder are read");
  return read_text(*place);
}

const std::string& GltfFile::buffer(std::size_t index) {
  if (const auto known = buffers_.find(index); known != buffers_.end()) return known->second;
  const Json& stated = list("buffers")[index];
  const std::string which = "buffer " + std::to_string(index);
  const std::size_t bytes = size(stated, "byteLength", 0);
  std::string data;
  if (stated.contains("uri"))
    data = resource(text(stated, "uri"));
  else if (index == 0 && !chunks_.empty() && chunks_.front().type == kGlbDataChunk)
    data = chunks_.front().bytes;
  else
    fail(which + " has neither a uri nor a chunk of a .glb");
  if (stated.contains("uri")) bytes_read_ += data.size();
  if (data.size() < bytes)
    fail(which + " has " + std::to_string(data.size()) + " of the " + std::to_string(bytes) +
         " bytes it states");
  data.resize(bytes);
  return buffers_.emplace(index, std::move(data)).first->second;
}

bool GltfFile::is_placeholder(std::size_t buffer) const {
  const Json& stated = list("buffers")[buffer];
  return !stated.contains("uri") && std::ranges::any_of(kMeshoptExtensions, [&](const char* name) {
    return extension(stated, name) != nullptr;
  });
}

/// The bytes of bufferView number `view`. `stated` says where they are: the bufferView itself, or
/// the extension that packs it.
std::string_view GltfFile::part(std::size_t view, const Json& stated) {
  const std::string& bytes = buffer(required_index(stated, "buffer", "buffers"));
  const std::size_t begin = size(stated, "byteOffset", 0);
  const std::size_t length = size(stated, "byteLength", 0);
  if (begin > bytes.size() || length > bytes.size() - begin)
    fail("bufferView " + std::to_string(view) + " reaches beyond its buffer");
  return std::string_view(bytes).substr(begin, length);
}

/// The extension that packs a bufferView; null: it is not packed.
const Json* GltfFile::packing(const Json& buffer_view) const {
  for (const char* name : kMeshoptExtensions)
    if (const Json* found = extension(buffer_view, name)) return found;
  return nullptr;
}

std::string_view GltfFile::view_bytes(std::size_t index) {
  const Json& stated = list("bufferViews")[index];
  const Json* const packed = packing(stated);
  if (packed == nullptr) return part(index, stated);
  if (const auto known = unpacked_.find(index); known != unpacked_.end()) return known->second;
  const MeshoptPacking how{.count = size(*packed, "count", 0),
                           .stride = size(*packed, "byteStride", 0),
                           .mode = text(*packed, "mode"),
                           .filter = text(*packed, "filter")};
  const std::size_t most = static_cast<std::size_t>(memory_limit()) - unpacked_bytes_;
  if (how.count > most / std::max<std::size_t>(how.stride, 1)) fail(kTooMuch);
  const std::string_view bytes = part(index, *packed);
  try {
    std::string unpacked = meshopt_unpacked(how, bytes);
    unpacked_bytes_ += unpacked.size();
    return unpacked_.emplace(index, std::move(unpacked)).first->second;
  } catch (const Error& error) {
    fail("bufferView " + std::to_string(index) + ' ' + error.what());
  }
}

std::string GltfFile::bytes_of_view(std::size_t index) {
  return std::string(view_bytes(index));
}

GltfFile::View GltfFile::view(const Json& object, std::size_t count, std::size_t components,
                              bool normalised) {
  View view{.count = count,
            .components = components,
            .component_type = size(object, "componentType", 0),
            .normalised = normalised};
  const std::size_t width = component_bytes(view.component_type);
  if (width == 0) fail("has an accessor of an unknown componentType");
  const auto index_of_view = index(object, "bufferView", "bufferViews");
  if (!index_of_view) return view;
  const std::string which = "bufferView " + std::to_string(*index_of_view);
  const std::string_view bytes = view_bytes(*index_of_view);
  const std::size_t element = components * width;
  const std::size_t begin = size(object, "byteOffset", 0);
  const Json& stated = list("bufferViews")[*index_of_view];
  const Json* const packed = packing(stated);
  view.stride = size(packed ? *packed : stated, "byteStride", element);
  if (view.stride < element) fail(which + " has a byteStride that is too small");
  if (count > 0 && (begin > bytes.size() || element > bytes.size() - begin ||
                    count - 1 > (bytes.size() - begin - element) / view.stride))
    fail("has an accessor that reaches beyond " + which);
  view.begin = bytes.data() + begin;
  return view;
}

void GltfFile::spend(std::size_t numbers) {
  values_read_ += numbers;
  require_memory(name(), kBytesOfNumber * values_read_);
}

std::size_t GltfFile::components_of(std::string_view type) {
  if (type == "MAT4") return 16;
  return type == "VEC4" ? 4 : type == "VEC3" ? 3 : type == "VEC2" ? 2 : 1;
}

bool GltfFile::is_normalised(const Json& accessor) const {
  const Json* const flag = member(accessor, "normalized");
  return flag != nullptr && flag->is_boolean() && flag->get<bool>();
}

std::vector<double> GltfFile::as_stated(std::size_t accessor, std::vector<double> values) const {
  const Json& stated = list("accessors")[accessor];
  const bool normalised = is_normalised(stated);
  const std::size_t type = size(stated, "componentType", 0);
  for (double& value : values) {
    if (normalised) value = share(value, type);
    if (!(std::abs(value) <= kLargestNumber))
      fail("accessor " + std::to_string(accessor) + kNotANumber);
  }
  return values;
}

std::vector<double> GltfFile::values(std::size_t accessor, std::string_view type) {
  const std::string which = "accessor " + std::to_string(accessor);
  const Json& stated = list("accessors")[accessor];
  if (text(stated, "type") != type) fail(which + " is not " + std::string(type));
  const std::size_t components = components_of(type);
  const std::size_t count = size(stated, "count", 0);
  // Accessors without bytes are all zeros and take no room in a file, so their total count is
  // limited.
  if (!stated.contains("bufferView")) zeros_read_ += std::min(count, kMostZeros + 1) * components;
  if (zeros_read_ > kMostZeros) fail("states more zeros that have no bytes than are read");
  if (count > std::numeric_limits<std::uint32_t>::max()) fail(kTooMuch);
  spend(count * components);
  const bool normalised = is_normalised(stated);
  const View dense = view(stated, count, components, normalised);
  std::vector<double> values(count * components);
  for (std::size_t e = 0; e < count; ++e)
    for (std::size_t i = 0; i < components; ++i) values[e * components + i] = dense(e, i);

  if (const Json* sparse = member(stated, "sparse"); sparse && sparse->is_object()) {
    const std::size_t changed = size(*sparse, "count", 0);
    const Json* places = member(*sparse, "indices");
    const Json* changes = member(*sparse, "values");
    if (changed > count || !places || !places->is_object() || !changes || !changes->is_object())
      fail(which + " has sparse values without sense");
    const View at = view(*places, changed, 1, false);
    Json same_type = *changes;
    same_type["componentType"] = dense.component_type;
    const View to = view(same_type, changed, components, normalised);
    for (std::size_t s = 0; s < changed; ++s) {
      const double e = at(s, 0);
      if (!(e >= 0 && e < static_cast<double>(count)))
        fail(which + " has a sparse value for an element that it has not");
      for (std::size_t i = 0; i < components; ++i)
        values[static_cast<std::size_t>(e) * components + i] = to(s, i);
    }
  }
  if (!std::ranges::all_of(values, [](double value) { return std::abs(value) <= kLargestNumber; }))
    fail(which + kNotANumber);
  return values;
}

}  // namespace mocapress
