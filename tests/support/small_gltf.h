// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "core/formats/gltf_file.h"

namespace mocapress::test {

/// A glTF assembled piece by piece. It starts with hips 1 m above the ground, a knee 0.5 m below
/// them and an ankle 0.4 m below that, all joints of a skin.
struct SmallGltf {
  Json json = Json::parse(R"({
    "asset": {"version": "2.0"},
    "scene": 0,
    "scenes": [{"nodes": [0]}],
    "nodes": [{"name": "hips", "translation": [0, 1, 0], "children": [1]},
              {"name": "knee", "translation": [0, -0.5, 0], "children": [2]},
              {"name": "ankle", "translation": [0, -0.4, 0]}],
    "skins": [{"joints": [0, 1, 2]}],
    "animations": [], "accessors": [], "bufferViews": [],
    "buffers": [{"byteLength": 0}]})");
  std::string data;

  /// Adds a bufferView and returns its index.
  template <typename T>
  std::size_t add_view(const std::vector<T>& values) {
    data.resize((data.size() + 3) / 4 * 4);
    const std::size_t size = values.size() * sizeof(T);
    json["bufferViews"].push_back(
        {{"buffer", 0}, {"byteOffset", data.size()}, {"byteLength", size}});
    data.append(reinterpret_cast<const char*>(values.data()), size);
    json["buffers"][0]["byteLength"] = data.size();
    return json["bufferViews"].size() - 1;
  }

  /// Adds an accessor and returns its index.
  template <typename T>
  std::size_t add(const std::string& type, const std::vector<T>& values, int component_type = 5126,
                  bool normalised = false) {
    const std::size_t components = type == "VEC4" ? 4 : type == "VEC3" ? 3 : type == "VEC2" ? 2 : 1;
    const std::size_t view = add_view(values);
    json["accessors"].push_back({{"bufferView", view},
                                 {"componentType", component_type},
                                 {"count", values.size() / components},
                                 {"type", type}});
    if (normalised) json["accessors"].back()["normalized"] = true;
    return json["accessors"].size() - 1;
  }

  /// Adds a channel to the last animation. `path` belongs to a node or, for "weights", to its mesh.
  void move(std::size_t node, const std::string& path, std::size_t input, std::size_t output,
            const std::string& interpolation = "LINEAR") {
    Json& animation = json["animations"].back();
    animation["samplers"].push_back(
        {{"input", input}, {"output", output}, {"interpolation", interpolation}});
    animation["channels"].push_back({{"sampler", animation["samplers"].size() - 1},
                                     {"target", {{"node", node}, {"path", path}}}});
  }

  void begin_animation(const std::string& name = "walk") {
    json["animations"].push_back(
        {{"name", name}, {"samplers", Json::array()}, {"channels", Json::array()}});
  }

  std::string glb() const {
    std::string text = json.dump();
    text.resize((text.size() + 3) / 4 * 4, ' ');
    std::string chunk = data;
    chunk.resize((chunk.size() + 3) / 4 * 4);
    std::string bytes;
    const auto word = [&](std::size_t value) {
      const auto bits = static_cast<std::uint32_t>(value);
      bytes.append(reinterpret_cast<const char*>(&bits), 4);
    };
    word(kGlbMagic);
    word(2);
    word(12 + 8 + text.size() + 8 + chunk.size());
    word(text.size());
    word(kGlbJsonChunk);
    bytes += text;
    word(chunk.size());
    word(kGlbDataChunk);
    return bytes + chunk;
  }
};

/// The knee bends by a right angle about x within a second, at 10 Hz.
inline SmallGltf bending_knee() {
  SmallGltf gltf;
  gltf.begin_animation();
  std::vector<float> times;
  std::vector<float> turns;
  for (int key = 0; key <= 10; ++key) {
    const double half = 0.5 * 1.5707963267948966 * key / 10;
    times.push_back(static_cast<float>(key) / 10);
    turns.insert(turns.end(),
                 {static_cast<float>(std::sin(half)), 0, 0, static_cast<float>(std::cos(half))});
  }
  const std::size_t input = gltf.add("SCALAR", times);
  gltf.move(1, "rotation", input, gltf.add("VEC4", turns));
  return gltf;
}

}  // namespace mocapress::test
