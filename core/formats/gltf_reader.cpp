// SPDX-License-Identifier: MIT
// After the glTF 2.0 specification, Khronos Group 2021 (ISO/IEC 12113:2022): sections 3.5 (nodes)
// and 3.11 (animations), appendix C (interpolation).
#include "core/formats/gltf_reader.h"

#include <Eigen/LU>
#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include "core/base/printable.h"
#include "core/base/utf8_path.h"
#include "core/formats/gltf_meshes.h"
#include "core/formats/gltf_target.h"
#include "core/formats/key_times.h"
#include "core/formats/take_choice.h"
#include "core/formats/text_writer.h"
#include "core/runtime/format/format_limits.h"

namespace mocapress {
namespace {

using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;

constexpr std::size_t kMostGltfNodes = 100'000;
constexpr double kFreePlacements = 1 << 21;  // limit for nodes times frames
constexpr double kPlacementsOfByte = 32;     // added to the limit for each byte of a larger file
constexpr double kShortest = 1e-12;          // a quaternion or axis below this has no direction

using Path = GltfPath;
using Target = GltfTarget;
enum class Interpolation { Step, Linear, CubicSpline };

/// A property of a node over time: a channel with its sampler. Morph weights take one curve each.
struct KeyCurve {
  std::size_t node = 0;  // its index in the file
  Path path = Path::Translation;
  std::size_t target = 0;  // for weights: the morph target
  std::string name;        // the morph target's name
  Interpolation interpolation = Interpolation::Linear;
  std::size_t input = 0;       // accessor of the times
  std::vector<double> times;   // s, ascending or equal
  std::vector<double> values;  // each key's value; cubic: in-tangent, value, out-tangent
};

/// Reads values of a curve at ascending times.
class KeyCurveReader {
 public:
  /// A time within `snap` seconds of a key gives that key's value.
  KeyCurveReader(const KeyCurve& curve, double snap)
      : curve_(curve), snap_(snap), width_(width_of(curve.path)) {}

  static std::size_t width_of(Path path) {
    return path == Path::Rotation ? 4 : path == Path::Weights ? 1 : 3;
  }

  double weight(double time) { return at(time)(0); }

  void apply(double time, LocalTransform& local) {
    const Eigen::Vector4d value = at(time);
    if (curve_.path == Path::Translation) local.translation = value.head<3>();
    if (curve_.path == Path::Scale) local.scale = value.head<3>();
    if (curve_.path == Path::Rotation) local.rotation = Quaterniond(value).normalized();
  }

 private:
  Eigen::Vector4d at(double time) {
    const std::vector<double>& times = curve_.times;
    while (key_ + 1 < times.size() && times[key_ + 1] <= time + snap_) ++key_;
    const double span = key_ + 1 < times.size() ? times[key_ + 1] - times[key_] : 0;
    const bool is_at_key = time <= times[key_] + snap_ || span <= 0;
    if (is_at_key || curve_.interpolation == Interpolation::Step) return value(key_);
    const double s = (time - times[key_]) / span;
    if (curve_.interpolation == Interpolation::CubicSpline) return spline(s, span);
    if (curve_.path != Path::Rotation) return (1 - s) * value(key_) + s * value(key_ + 1);
    const Quaterniond from(value(key_));
    const Quaterniond to(value(key_ + 1));
    return from.normalized().slerp(s, to.normalized()).coeffs();  // the shorter way
  }

  /// Hermite's spline, with tangents per second.
  Eigen::Vector4d spline(double s, double span) const {
    const double s2 = s * s;
    const double s3 = s2 * s;
    return (2 * s3 - 3 * s2 + 1) * value(key_) + span * (s3 - 2 * s2 + s) * element(3 * key_ + 2) +
           (3 * s2 - 2 * s3) * value(key_ + 1) + span * (s3 - s2) * element(3 * key_ + 3);
  }

  Eigen::Vector4d value(std::size_t key) const {
    return element(curve_.interpolation == Interpolation::CubicSpline ? 3 * key + 1 : key);
  }

  Eigen::Vector4d element(std::size_t index) const {
    Eigen::Vector4d element = Eigen::Vector4d::Zero();
    for (std::size_t i = 0; i < width_; ++i) element(i) = curve_.values[width_ * index + i];
    return element;
  }

  const KeyCurve& curve_;
  double snap_;
  std::size_t width_;
  std::size_t key_ = 0;  // last key not after the time
};

/// A matrix as translation, rotation and scale. Shear, which these cannot express, is left out.
LocalTransform decomposed(const std::vector<double>& column_major) {
  const Eigen::Matrix4d matrix = Eigen::Map<const Eigen::Matrix4d>(column_major.data());
  LocalTransform local;
  local.translation = matrix.topRightCorner<3, 1>();
  Matrix3d axes = matrix.topLeftCorner<3, 3>();
  local.scale = axes.colwise().norm().transpose();
  if (axes.determinant() < 0) local.scale.x() *= -1;
  if (local.scale.cwiseAbs().minCoeff() <= kShortest) return local;
  axes = axes * local.scale.cwiseInverse().asDiagonal();
  local.rotation = Quaterniond(axes).normalized();
  return local;
}

class TakeReader {
 public:
  TakeReader(GltfFile& file, const ReadOptions& options) : file_(file), options_(options) {}

  GltfTake read() {
    result_.take.cm_per_unit = kGltfCmPerUnit;
    find_tree();
    read_animation();
    add_nodes();
    sample();
    return std::move(result_);
  }

  GltfTake read_rest() {
    result_.take.cm_per_unit = kGltfCmPerUnit;
    find_tree();
    add_nodes();
    return std::move(result_);
  }

 private:
  void find_tree();
  std::vector<TakeName> take_names() const;
  void read_animation();
  bool changes() const;
  bool has_channel(const Json& animation, bool of_weights) const;
  void read_curves(Warnings& warnings);
  KeyCurve read_curve(const Json& sampler, const Target& target);
  void read_weights(const Json& sampler, const Target& target);
  std::vector<std::string> target_names(std::size_t node) const;
  LocalTransform rest_of(const Json& node) const;
  void add_nodes();
  void sample();
  void sample_weights(const SampleTimes& times);

  const Json& node(std::size_t number) const { return file_.list("nodes")[number]; }
  std::string name_of(std::size_t number) const {
    const std::string name = file_.text(node(number), "name");
    return name.empty() ? "node_" + std::to_string(number) : name;
  }

  GltfFile& file_;
  const ReadOptions& options_;
  GltfTake result_;
  std::vector<int> parents_;        // by a node's index in the file
  std::vector<std::size_t> order_;  // the same nodes, parents first
  std::vector<KeyCurve> curves_;
  std::vector<KeyCurve> weights_;
};

void TakeReader::find_tree() {
  const std::size_t count = file_.list("nodes").size();
  if (count > kMostGltfNodes)
    file_.fail("has more than " + std::to_string(kMostGltfNodes) + " nodes");
  parents_.assign(count, -1);
  std::vector<std::vector<std::size_t>> children(count);
  for (std::size_t n = 0; n < count; ++n) {
    children[n] = file_.indices(node(n), "children", "nodes");
    for (const std::size_t child : children[n]) {
      if (parents_[child] >= 0)
        file_.fail("has node " + std::to_string(child) + " below two nodes, or twice below one");
      parents_[child] = static_cast<int>(n);
    }
  }
  std::vector<std::size_t> waiting;
  for (std::size_t n = count; n-- > 0;)
    if (parents_[n] < 0) waiting.push_back(n);
  while (!waiting.empty()) {
    const std::size_t n = waiting.back();
    waiting.pop_back();
    order_.push_back(n);
    waiting.insert(waiting.end(), children[n].rbegin(), children[n].rend());
  }
  if (order_.size() < count) file_.fail("has a node that is below itself");
}

LocalTransform TakeReader::rest_of(const Json& node) const {
  if (const auto matrix = file_.numbers(node, "matrix", 16)) return decomposed(*matrix);
  LocalTransform local;
  if (const auto t = file_.numbers(node, "translation", 3)) local.translation = Vector3d(t->data());
  if (const auto s = file_.numbers(node, "scale", 3)) local.scale = Vector3d(s->data());
  if (const auto r = file_.numbers(node, "rotation", 4)) {
    local.rotation = Quaterniond(r->data());
    if (local.rotation.norm() <= kShortest) file_.fail("has a rotation of length 0");
    local.rotation.normalize();
  }
  return local;
}

/// True if an animation has a channel of morph weights, or for `of_weights` false, one of any other
/// kind.
bool TakeReader::has_channel(const Json& animation, bool of_weights) const {
  const Json& channels = file_.list(animation, "channels");
  return std::ranges::any_of(channels, [&](const Json& channel) {
    const auto target = gltf_target(file_, channel);
    return target && (target->path == Path::Weights) == of_weights;
  });
}

/// The names of all animations, and whether each counts as moving. Morph weights alone, as of a
/// face, count only if no animation moves nodes.
std::vector<TakeName> TakeReader::take_names() const {
  const Json& animations = file_.list("animations");
  std::vector<TakeName> takes;
  for (const Json& one : animations) {
    std::string name = file_.text(one, "name");
    if (name.empty()) name = "animation_" + std::to_string(takes.size() + 1);
    takes.push_back({std::move(name), has_channel(one, false)});
  }
  if (std::ranges::none_of(takes, [](const TakeName& take) { return take.moves; }))
    for (std::size_t a = 0; a < takes.size(); ++a)
      takes[a].moves = has_channel(animations[a], true);
  return takes;
}

/// Reads the animation that was asked for, or else the first whose values change. If none changes,
/// reads the first.
void TakeReader::read_animation() {
  const std::vector<TakeName> takes = take_names();
  Warnings warnings;
  const auto read = [&](const std::vector<TakeName>& among) {
    warnings.clear();
    result_.animation = choose_take(file_.name(), among, options_.take, warnings);
    read_curves(warnings);
  };
  read(takes);
  for (std::vector<TakeName> left = takes; !options_.take && !changes();) {
    left[result_.animation].moves = false;
    if (std::ranges::any_of(left, [](const TakeName& take) { return take.moves; })) {
      read(left);
      continue;
    }
    read(takes);
    break;
  }
  result_.takes = choices(takes, result_.animation);
  result_.take.name = takes[result_.animation].name;
  result_.warnings = std::move(warnings);
}

/// True if any curve changes its value.
bool TakeReader::changes() const {
  const auto differs = [](const KeyCurve& curve) {
    const std::size_t width = KeyCurveReader::width_of(curve.path);
    for (std::size_t i = width; i < curve.values.size(); ++i)
      if (curve.values[i] != curve.values[i % width]) return true;
    return false;
  };
  return std::ranges::any_of(curves_, differs) || std::ranges::any_of(weights_, differs);
}

KeyCurve TakeReader::read_curve(const Json& sampler, const Target& target) {
  KeyCurve curve{.node = target.node, .path = target.path};
  const std::string interpolation = file_.text(sampler, "interpolation");
  if (interpolation == "STEP")
    curve.interpolation = Interpolation::Step;
  else if (interpolation == "CUBICSPLINE")
    curve.interpolation = Interpolation::CubicSpline;
  else if (!interpolation.empty() && interpolation != "LINEAR")
    file_.fail("has an unknown interpolation, \"" + shortened(interpolation) + '"');
  curve.input = file_.required_index(sampler, "input", "accessors");
  curve.times = file_.values(curve.input, "SCALAR");
  const bool of_weights = target.path == Path::Weights;
  curve.values = file_.values(file_.required_index(sampler, "output", "accessors"),
                              target.path == Path::Rotation ? "VEC4"
                              : of_weights                  ? "SCALAR"
                                                            : "VEC3");
  const std::size_t keys = curve.times.size();
  const std::size_t width =
      of_weights ? target_names(target.node).size() : KeyCurveReader::width_of(target.path);
  const bool cubic = curve.interpolation == Interpolation::CubicSpline;
  if (keys == 0) file_.fail("has an animation without keys");
  if (curve.values.size() != width * keys * (cubic ? 3 : 1))
    file_.fail("has an animation with " + std::to_string(keys) + " key times, but " +
               std::to_string(curve.values.size() / std::max<std::size_t>(width, 1)) + " values");
  if (!std::ranges::is_sorted(curve.times)) file_.fail("has an animation whose key times go back");
  if (target.path == Path::Rotation)
    for (std::size_t key = 0; key < keys; ++key)
      if (Quaterniond(&curve.values[4 * (cubic ? 3 * key + 1 : key)]).norm() <= kShortest)
        file_.fail("has a rotation of length 0");
  return curve;
}

void TakeReader::read_curves(Warnings& warnings) {
  curves_.clear();
  weights_.clear();
  int others = 0;
  const Json& chosen = file_.list("animations")[result_.animation];
  const Json& samplers = file_.list(chosen, "samplers");
  for (const Json& channel : file_.list(chosen, "channels")) {
    const auto target = gltf_target(file_, channel);
    if (!target) {
      ++others;
      continue;
    }
    const std::size_t sampler = file_.size(channel, "sampler", samplers.size());
    if (sampler >= samplers.size()) file_.fail("has an animation channel without a sampler");
    if (target->path != Path::Weights) {
      curves_.push_back(read_curve(samplers[sampler], *target));
      continue;
    }
    try {
      read_weights(samplers[sampler], *target);
    } catch (const InputError& error) {  // bad weights are no reason to refuse the motion
      const std::string reason =
          std::string(error.what()).substr(printable(file_.name()).size() + 2);
      warnings.push_back({file_.name(), 0, "morph weights are not read: the file " + reason});
    }
  }
  if (others > 0)
    warnings.push_back({file_.name(), 0,
                        counted(others, "channel") + " of the animation left out, which " +
                            (others == 1 ? "moves" : "move") + " no node"});
  if (curves_.empty() && weights_.empty())
    file_.fail("moves neither nodes nor morph weights that can be read");
}

/// The names of the morph targets of a node's mesh.
std::vector<std::string> TakeReader::target_names(std::size_t number) const {
  const auto mesh = file_.index(node(number), "mesh", "meshes");
  if (!mesh) file_.fail("has morph weights of a node without a mesh");
  const Json& of = file_.list("meshes")[*mesh];
  const Json& primitives = file_.list(of, "primitives");
  const std::size_t count =
      primitives.empty() ? 0 : file_.list(primitives.front(), "targets").size();
  if (count > runtime::kMostTracks) file_.fail("has too many morph targets");
  std::vector<std::string> names;
  const Json extras = of.value("extras", Json());
  const Json given = extras.is_object() ? extras.value("targetNames", Json()) : Json();
  for (std::size_t t = 0; t < count; ++t)
    names.push_back(given.is_array() && t < given.size() && given[t].is_string()
                        ? given[t].get<std::string>()
                        : "target_" + std::to_string(t));
  return names;
}

/// Reads one curve for each morph target. At each key the file stores the values of all targets
/// side by side.
void TakeReader::read_weights(const Json& sampler, const Target& target) {
  if (std::ranges::any_of(weights_, [&](const KeyCurve& one) { return one.node == target.node; }))
    file_.fail("has an animation that moves the morph weights of a node twice");
  KeyCurve all = read_curve(sampler, target);
  const std::vector<std::string> names = target_names(target.node);
  const std::size_t targets = names.size();
  for (std::size_t t = 0; t < targets; ++t) {
    if (weights_.size() == runtime::kMostTracks) file_.fail("has too many morph weights");
    if (std::max(name_of(all.node).size(), names[t].size()) > runtime::kMostNameBytes)
      file_.fail("has a name of more than " + std::to_string(runtime::kMostNameBytes) + " bytes");
    KeyCurve one{.node = all.node,
                 .path = Path::Weights,
                 .target = t,
                 .name = names[t],
                 .interpolation = all.interpolation,
                 .input = all.input,
                 .times = all.times,
                 .values = {}};
    for (std::size_t at = t; at < all.values.size(); at += targets)
      one.values.push_back(all.values[at]);
    weights_.push_back(std::move(one));
  }
}

/// Adds all nodes except those that only hold meshes, cameras or lights.
void TakeReader::add_nodes() {
  const std::size_t count = parents_.size();
  std::vector<bool> is_joint(count);
  for (const Json& skin : file_.list("skins"))
    for (const std::size_t joint : file_.indices(skin, "joints", "nodes")) is_joint[joint] = true;
  if (curves_.empty() && file_.list("skins").empty())  // or nothing would be a joint
    for (const KeyCurve& weight : weights_) is_joint[weight.node] = true;
  std::vector<bool> is_wanted = is_joint;
  for (const KeyCurve& curve : curves_) is_wanted[curve.node] = true;
  std::vector<bool> draws(count);
  for (auto at = order_.rbegin(); at != order_.rend(); ++at) {
    const Json& one = node(*at);
    draws[*at] = draws[*at] || one.contains("mesh") || one.contains("camera") ||
                 one.value("extensions", Json()).contains("KHR_lights_punctual");
    is_wanted[*at] = is_wanted[*at] || !draws[*at];
    if (parents_[*at] < 0) continue;
    const auto parent = static_cast<std::size_t>(parents_[*at]);
    if (is_wanted[*at])
      is_wanted[parent] = true;
    else
      draws[parent] = true;
  }
  std::vector<int> index_of(count, -1);
  for (const std::size_t number : order_) {
    if (!is_wanted[number]) continue;
    index_of[number] = static_cast<int>(result_.take.nodes.size());
    const int parent = parents_[number];
    std::string name = name_of(number);
    result_.number_of_node.push_back(number);
    result_.take.nodes.push_back({.name = std::move(name),
                                  .parent = parent < 0 ? -1 : index_of[parent],
                                  .joint = is_joint[number],
                                  .rest = rest_of(node(number))});
  }
  for (KeyCurve& curve : curves_) curve.node = static_cast<std::size_t>(index_of[curve.node]);
}

void TakeReader::sample() {
  NodeTake& take = result_.take;
  std::vector<double> keys_s;
  std::set<std::size_t> inputs;
  std::set<std::size_t> moving;
  for (const KeyCurve& curve : curves_) {
    if (inputs.insert(curve.input).second)
      keys_s.insert(keys_s.end(), curve.times.begin(), curve.times.end());
    moving.insert(curve.node);
  }
  for (const KeyCurve& weight : weights_)
    if (inputs.insert(weight.input).second)
      keys_s.insert(keys_s.end(), weight.times.begin(), weight.times.end());
  keys_s = merged_times({}, std::move(keys_s));
  const SampleTimes times = sample_times(file_.name(), keys_s, std::nullopt,
                                         options_.sample_rate_hz, moving.size() + weights_.size());
  // Keys far apart could ask for any number of frames, so the limit grows with the file's own
  // bytes.
  const double placements =
      static_cast<double>(times.frames) * static_cast<double>(take.nodes.size());
  const auto bytes = static_cast<double>(file_.bytes_read());
  if (placements > kFreePlacements + kPlacementsOfByte * bytes)
    file_.fail("asks for " + std::to_string(times.frames) + " frames of " +
               std::to_string(take.nodes.size()) + " nodes, too many for a file of so few bytes");
  if (!times.warning.empty()) result_.warnings.push_back({file_.name(), 0, times.warning});
  result_.first_s = times.first_s;
  take.frames = times.frames;
  take.sample_rate_hz = times.rate_hz;
  std::map<std::size_t, std::vector<KeyCurveReader>> of_node;
  for (const KeyCurve& curve : curves_) of_node[curve.node].emplace_back(curve, times.near_s);
  for (auto& [index, readers] : of_node) {
    AnimatedNode& node = take.nodes[index];
    node.frames.reserve(times.frames);
    for (int f = 0; f < times.frames; ++f) {
      LocalTransform local = node.rest;
      for (KeyCurveReader& reader : readers) reader.apply(times.at(f), local);
      node.frames.push_back(local);
    }
  }
  sample_weights(times);
}

void TakeReader::sample_weights(const SampleTimes& times) {
  for (const KeyCurve& weight : weights_) {
    KeyCurveReader reader(weight, times.near_s);
    ScalarTrack track{.kind = TrackKind::MorphWeight,
                      .node = name_of(weight.node),
                      .name = weight.name,
                      .steps = weight.interpolation == Interpolation::Step,
                      .values = {}};
    for (int f = 0; f < times.frames; ++f)
      track.values.push_back(static_cast<float>(reader.weight(times.at(f))));
    result_.take.tracks.push_back(std::move(track));
    result_.weights.push_back({weight.node, weight.target});
  }
}

}  // namespace

GltfTake read_gltf_take(GltfFile& file, const ReadOptions& options) {
  return TakeReader(file, options).read();
}

MotionFile read_gltf(const std::string& name, std::string_view bytes, const ReadOptions& options) {
  GltfFile file(utf8_path(name), bytes);
  GltfTake read = read_gltf_take(file, options);
  try {
    read.take.meshes = gltf_meshes(file, read, read.warnings);
  } catch (const InputError& error) {  // a bad mesh is no reason to refuse the motion
    const std::string reason = std::string(error.what()).substr(printable(file.name()).size() + 2);
    read.warnings.push_back({name, 0, "its character is not read: " + reason});
  }
  MotionFile motion = motion_of(name, read.take, options, SourceFormat::Kind::Gltf);
  motion.warnings.insert(motion.warnings.begin(), read.warnings.begin(), read.warnings.end());
  motion.takes = std::move(read.takes);
  return motion;
}

Character read_gltf_character(const std::string& name, std::string_view bytes) {
  GltfFile file(utf8_path(name), bytes);
  const ReadOptions as_it_says;
  GltfTake rest = TakeReader(file, as_it_says).read_rest();
  Warnings left_out;
  rest.take.meshes = gltf_meshes(file, rest, left_out);
  if (rest.take.meshes.empty() && !left_out.empty())
    throw InputError(name, 0, 0, left_out.back().message);
  return character_of(name, rest.take);
}

}  // namespace mocapress
