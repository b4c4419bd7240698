// SPDX-License-Identifier: MIT
// Puts a motion into an existing glTF file, in place of an animation.
#include <algorithm>
#include <map>
#include <string>
#include <unordered_map>
#include <unordered_set>

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/path_kind.h"
#include "core/formats/gltf_animation.h"
#include "core/formats/gltf_reader.h"
#include "core/formats/gltf_target.h"
#include "core/formats/gltf_writer.h"

namespace mocapress {
namespace {

namespace fs = std::filesystem;

/// Morph weights of the nodes all of whose weights have a track in `tracks`. Tracks of the same
/// name are used in order, each once.
std::vector<WeightsTrack> weights_of(const GltfTake& take, const ScalarTracks& tracks) {
  std::unordered_set<const ScalarTrack*> taken;
  std::map<std::size_t, WeightsTrack> of_node;
  for (std::size_t w = 0; w < take.weights.size(); ++w) {
    const ScalarTrack& wanted = take.take.tracks[w];
    const auto found = std::ranges::find_if(tracks, [&](const ScalarTrack& track) {
      return track.kind == wanted.kind && track.node == wanted.node && track.name == wanted.name &&
             !taken.contains(&track);
    });
    WeightsTrack& weights = of_node[take.weights[w].node];
    weights.node = take.weights[w].node;
    weights.of_target.push_back(found == tracks.end() ? nullptr : &*found);
    if (found != tracks.end()) taken.insert(&*found);
  }
  std::vector<WeightsTrack> all;
  for (auto& [node, weights] : of_node)
    if (std::ranges::find(weights.of_target, nullptr) == weights.of_target.end())
      all.push_back(std::move(weights));
  return all;
}

/// Removes the channels that move the nodes of `tracks` and `weights`, and the samplers that only
/// these channels used.
void remove_channels(const GltfFile& file, const std::vector<NodeTrack>& tracks,
                     const std::vector<WeightsTrack>& weights, Json& animation) {
  std::unordered_set<std::size_t> nodes;
  for (const NodeTrack& track : tracks) nodes.insert(track.node);
  std::unordered_set<std::size_t> morphed;
  for (const WeightsTrack& track : weights) morphed.insert(track.node);
  Json channels = file.list(animation, "channels");
  Json samplers = file.list(animation, "samplers");
  animation["channels"] = Json::array();
  animation["samplers"] = Json::array();
  std::unordered_map<std::size_t, std::size_t> new_index;
  for (Json channel : channels) {
    const auto target = gltf_target(file, channel);
    const bool of_weights = target && target->path == GltfPath::Weights;
    if (target && (of_weights ? morphed : nodes).contains(target->node)) continue;
    const std::size_t sampler = file.size(channel, "sampler", samplers.size());
    if (sampler >= samplers.size()) file.fail("has an animation channel without a sampler");
    const auto [at, is_new] = new_index.emplace(sampler, animation["samplers"].size());
    if (is_new) animation["samplers"].push_back(samplers[sampler]);
    channel["sampler"] = at->second;
    animation["channels"].push_back(std::move(channel));
  }
}

/// The media type of an image, by its first bytes. Empty unless it is a PNG or JPEG, as glTF has
/// them, or a KTX2 or WebP, as its extensions have them.
std::string image_type(std::string_view bytes) {
  if (bytes.starts_with("\x89PNG")) return "image/png";
  if (bytes.starts_with("\xFF\xD8\xFF")) return "image/jpeg";
  if (bytes.starts_with("\xABKTX 20")) return "image/ktx2";
  if (bytes.substr(0, 12).ends_with("WEBP")) return "image/webp";
  return "";
}

/// Joins all buffers into the first, for the chunk of a .glb, and returns its bytes. In the list of
/// buffers, placeholders of packed bufferViews follow it.
std::string joined_buffers(GltfFile& file, Json& json) {
  std::string bytes;
  std::vector<std::size_t> begins;
  std::vector<std::size_t> new_index;
  Json buffers = Json::array({Json::object()});
  for (std::size_t b = 0; b < file.list("buffers").size(); ++b) {
    const Json& stated = file.list("buffers")[b];
    bytes.resize((bytes.size() + 3) / 4 * 4);
    const bool is_placeholder = file.is_placeholder(b);
    begins.push_back(is_placeholder ? 0 : bytes.size());
    new_index.push_back(is_placeholder ? buffers.size() : 0);
    if (is_placeholder) {
      buffers.push_back(stated);
      continue;
    }
    bytes += file.buffer(b);
    if (buffers.front().empty()) buffers.front() = stated;
  }
  buffers.front().erase("uri");
  const auto move = [&](Json& part) {
    const std::size_t buffer = file.required_index(part, "buffer", "buffers");
    if (begins[buffer] > 0) part["byteOffset"] = file.size(part, "byteOffset", 0) + begins[buffer];
    part["buffer"] = new_index[buffer];
  };
  if (json.contains("bufferViews"))
    for (Json& view : json["bufferViews"]) {
      move(view);
      for (const char* name : kMeshoptExtensions)
        if (file.extension(view, name) != nullptr) move(view["extensions"][name]);
    }
  json["buffers"] = std::move(buffers);
  return bytes;
}

/// Makes a data URI of a .glb's chunk for a .gltf, and if `with_files`, of buffers in files of
/// their own.
void embed_buffers(GltfFile& file, Json& json, bool with_files) {
  for (std::size_t b = 0; b < file.list("buffers").size(); ++b) {
    if (file.is_placeholder(b)) continue;
    const std::string uri = file.text(file.list("buffers")[b], "uri");
    if (uri.empty() || (with_files && !is_data_uri(uri)))
      json["buffers"][b]["uri"] = data_uri(kBufferType, file.buffer(b));
  }
}

/// Embeds images. Those of data URIs go into the chunk of a .glb. If `with_files`, those in files
/// of their own go into that chunk, or become data URIs of a .gltf. Images that are missing or
/// remote stay references.
void embed_images(const GltfFile& file, Json& json, bool with_files, BufferWriter* chunk) {
  if (!json.contains("images")) return;
  Json images = json["images"];  // a copy, since add_view() changes `json`
  for (Json& image : images) {
    const std::string uri = file.text(image, "uri");
    if (uri.empty() || (is_data_uri(uri) ? chunk == nullptr : !with_files)) continue;
    try {
      const std::string bytes = file.resource(uri);
      const std::string type = image_type(bytes);
      if (type.empty()) continue;
      if (chunk != nullptr) {
        image.erase("uri");
        image["mimeType"] = type;
        image["bufferView"] = chunk->add_view(bytes);
      } else {
        image["uri"] = data_uri(type, bytes);
      }
    } catch (const InputError&) {
      continue;
    }
  }
  json["images"] = std::move(images);
}

bool same_folder(const fs::path& a, const fs::path& b) {
  return is_same_file(a.empty() ? "." : a, b.empty() ? "." : b);
}

}  // namespace

std::string gltf_bytes_onto(const fs::path& onto, const Motion& motion, GltfContainer container,
                            const fs::path& folder, const SourceFormat& source,
                            const WriteOptions& options, const ScalarTracks& scalars) {
  GltfFile file(onto, read_text(onto));
  const SourceFormat format = gltf_format(source, options);
  const ReadOptions reading{
      .cm_per_unit = format.cm_per_unit, .up = format.up, .take = options.take};
  const GltfTake take = read_gltf_take(file, reading);
  std::vector<NodeTrack> tracks = tracks_following(file.name(), take.take, motion,
                                                   without_namespace(gltf_names(motion.skeleton)),
                                                   reading, JointScales(scalars, motion.skeleton));
  for (NodeTrack& track : tracks) track.node = take.number_of_node[track.node];
  const std::vector<WeightsTrack> weights = weights_of(take, scalars);

  Json json = file.json();
  for (const NodeTrack& track : tracks) {
    Json& node = json["nodes"][track.node];
    // An animated node must not have a matrix.
    if (node.erase("matrix") > 0) set_transform(node, track.rest);
  }
  // A .glb has one buffer, its chunk; a .gltf gets a new buffer for the animation.
  const bool is_glb = container == GltfContainer::Glb;
  const bool moves_away = !same_folder(onto.parent_path(), folder);
  std::string data;
  if (is_glb)
    data = joined_buffers(file, json);
  else
    embed_buffers(file, json, moves_away);
  const std::size_t buffer = is_glb ? 0 : file.list("buffers").size();
  BufferWriter writer(json, buffer, std::move(data));
  embed_images(file, json, moves_away, is_glb ? &writer : nullptr);
  Json animation = json["animations"][take.animation];
  remove_channels(file, tracks, weights, animation);
  AnimationWriter animator(writer, animation, take.first_s, motion.clip.frames(),
                           options.sample_rate_hz.value_or(motion.clip.sample_rate_hz));
  for (const NodeTrack& track : tracks) animator.add(track, false);
  for (const WeightsTrack& track : weights) animator.add(track);
  if (animation["channels"].empty() && !tracks.empty()) animator.add(tracks.front(), true);
  json["animations"][take.animation] = std::move(animation);
  std::vector<GlbChunk> others = file.chunks();
  if (!others.empty() && others.front().type == kGlbDataChunk) others.erase(others.begin());
  return in_container(std::move(json), container, buffer, writer.release(), others);
}

}  // namespace mocapress
