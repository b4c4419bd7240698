// SPDX-License-Identifier: MIT
// After the glTF 2.0 specification, section 3.11, and its extension KHR_animation_pointer.
#include "core/formats/gltf_target.h"

#include <charconv>
#include <string_view>

namespace mocapress {
namespace {

std::optional<GltfPath> path_named(std::string_view name) {
  if (name == "translation") return GltfPath::Translation;
  if (name == "rotation") return GltfPath::Rotation;
  if (name == "scale") return GltfPath::Scale;
  if (name == "weights") return GltfPath::Weights;
  return std::nullopt;
}

/// The target of a pointer such as "/nodes/1/rotation".
std::optional<GltfTarget> pointed_at(const GltfFile& file, std::string_view pointer) {
  constexpr std::string_view kNodes = "/nodes/";
  if (!pointer.starts_with(kNodes)) return std::nullopt;
  pointer.remove_prefix(kNodes.size());
  std::size_t node = 0;
  const auto [end, error] = std::from_chars(pointer.data(), pointer.data() + pointer.size(), node);
  pointer.remove_prefix(static_cast<std::size_t>(end - pointer.data()));
  if (error != std::errc() || !pointer.starts_with('/')) return std::nullopt;
  const auto path = path_named(pointer.substr(1));
  if (!path) return std::nullopt;
  if (node >= file.list("nodes").size())
    file.fail("has an animation of node " + std::to_string(node) + ", which it has not");
  return GltfTarget{node, *path};
}

}  // namespace

std::optional<GltfTarget> gltf_target(const GltfFile& file, const Json& channel) {
  const auto target = channel.find("target");
  if (target == channel.end() || !target->is_object())
    file.fail("has an animation channel without a target");
  if (const Json* pointer = file.extension(*target, "KHR_animation_pointer"))
    return pointed_at(file, file.text(*pointer, "pointer"));
  const auto path = path_named(file.text(*target, "path"));
  const auto node = file.index(*target, "node", "nodes");
  return path && node ? std::optional(GltfTarget{*node, *path}) : std::nullopt;
}

}  // namespace mocapress
