// SPDX-License-Identifier: MIT
#include "core/formats/fbx/fbx_scene.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "core/base/printable.h"
#include "core/formats/fbx/fbx_meshes.h"
#include "core/formats/key_times.h"
#include "core/formats/take_choice.h"
#include "core/formats/text_cursor.h"
#include "core/formats/text_writer.h"
#include "core/formats/value_repair.h"
#include "core/runtime/format/format_limits.h"

namespace mocapress {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

constexpr std::size_t kMostFbxNodes = 1 << 16;
constexpr int kDeepestFbxNode = 1000;
constexpr double kMostFbxPlacements = 1e8;  // node placements over all frames
constexpr double kNearFrame = 0.1;  // in frames: a key this near to a frame was meant to be on it

bool is_joint_kind(std::string_view kind) {
  return kind == "LimbNode" || kind == "Limb" || kind == "Root";
}

bool is_onlooker(std::string_view kind) {
  return kind == "Camera" || kind == "CameraSwitcher" || kind == "Light";
}

double power(double base, double exponent) {
  return std::copysign(std::pow(std::abs(base), exponent), base);
}

class FbxTakeReader {
 public:
  FbxTakeReader(FbxFile& file, const ReadOptions& options, FbxCurves curves)
      : file_(file),
        objects_(file.objects),
        options_(options),
        curves_(curves),
        ticks_per_second_(file.ticks_per_second()) {}

  FbxTake read();
  FbxTake read_rest();

 private:
  void choose_take(FbxAnimation& animation);
  void find_nodes();
  void mark_joints();
  void settle_axes();
  std::optional<double> stated_rate() const;
  std::vector<double> key_times(bool of_nodes, std::size_t fewest) const;
  void clip_to_span(std::vector<double>& keys_s, std::optional<double> rate) const;
  void snap_to_frames(std::vector<double>& keys_s, std::optional<double> rate) const;
  void sample();
  void sample_node(std::size_t node, const std::vector<FbxMovement*>& movements);
  void apply(const FbxMovement& movement, double ticks, Vector3d& part) const;
  void sample_tracks();
  bool sample_track(const FbxLayered& movements, std::size_t axis, ScalarTrack track, double scale);
  std::optional<std::size_t> mesh_of_shape(std::size_t channel) const;
  double ticks_at(int frame) const { return times_.at(frame) * ticks_per_second_; }
  void warn(std::string message) {
    result_.warnings.push_back({file_.records.file(), 0, std::move(message)});
  }
  [[noreturn]] void refuse(const std::string& what) const { file_.records.fail(what); }

  FbxFile& file_;
  const FbxObjects& objects_;
  const ReadOptions& options_;
  FbxCurves curves_;
  double ticks_per_second_;
  FbxTake result_;
  std::optional<FbxTakeInfo> chosen_;
  std::vector<FbxMovement> movements_;
  SampleTimes times_;
};

FbxTake FbxTakeReader::read() {
  FbxAnimation animation(file_.records, objects_, ticks_per_second_);
  choose_take(animation);
  find_nodes();
  settle_axes();
  sample();
  result_.movements = std::move(movements_);
  return std::move(result_);
}

FbxTake FbxTakeReader::read_rest() {
  find_nodes();
  settle_axes();
  return std::move(result_);
}

void FbxTakeReader::choose_take(FbxAnimation& animation) {
  std::vector<TakeName> takes;
  for (std::size_t t = 0; t < animation.takes().size(); ++t)
    takes.push_back({animation.takes()[t].name, animation.moves(t, true)});
  // Skips takes of weights alone, such as faces, if any take moves nodes.
  if (std::ranges::none_of(takes, [](const TakeName& take) { return take.moves; }))
    for (std::size_t t = 0; t < takes.size(); ++t) takes[t].moves = animation.moves(t, false);
  const auto moves = [](const TakeName& take) { return take.moves; };
  const auto first_moving = std::ranges::find_if(takes, moves);
  const bool stands = first_moving != takes.begin() && first_moving != takes.end();
  const std::size_t chosen =
      mocapress::choose_take(file_.records.file(), takes, options_.take, result_.warnings);
  if (stands && !options_.take)
    warn("the first take, " + shortened(takes.front().name) + ", stands still");
  result_.index = chosen;
  result_.takes = choices(takes, chosen);
  result_.take.name = takes[chosen].name;
  chosen_ = animation.takes()[chosen];
  movements_ = animation.movements(chosen);
  if (std::ranges::none_of(movements_,
                           [](const FbxMovement& movement) { return movement.has_keys(); })) {
    if (takes.size() == 1 || !options_.take) refuse("holds no keys");
    refuse("its take " + shortened(takes[chosen].name) + " moves no node");
  }
  int dropped = 0;
  for (const FbxMovement& movement : movements_)
    for (const auto& curve : movement.curves) dropped += curve ? curve->dropped() : 0;
  if (dropped > 0) warn(counted(dropped, "key") + kKeysLeftOut);
}

/// Finds all nodes, parents first, except leaves that only hold a mesh, a light or a camera.
void FbxTakeReader::find_nodes() {
  const std::size_t count = objects_.all().size();
  std::vector<int> parent(count, -1);
  std::size_t models = 0;
  std::vector<std::vector<std::size_t>> children(count);
  for (std::size_t o = 1; o < count; ++o) {
    if (!objects_.is(o, "Model")) continue;
    if (++models > kMostFbxNodes)
      refuse("has more than " + std::to_string(kMostFbxNodes) + " nodes");
    std::size_t above = FbxObjects::kScene;
    for (const FbxLink& link : objects_.parents(o))
      if (link.property.empty() && objects_.is(link.object, "Model")) {
        above = link.object;  // among several parents the first
        break;
      }
    parent[o] = static_cast<int>(above);
  }
  // Keeps children in the order of the file's connections, as other programs do.
  for (std::size_t o = 0; o < count; ++o)
    for (const FbxLink& link : objects_.children(o))
      if (link.property.empty() && parent[link.object] == static_cast<int>(o))
        children[o].push_back(link.object);
  for (std::size_t o = 1; o < count; ++o)
    if (parent[o] == 0) {
      const auto& links = objects_.parents(o);
      if (std::ranges::none_of(links, [](const FbxLink& link) {
            return link.property.empty() && link.object == FbxObjects::kScene;
          }))
        children[0].push_back(o);
    }
  std::vector<bool> moves(count);
  for (const FbxMovement& movement : movements_) {
    moves[movement.object] = true;
    if (const auto mesh = mesh_of_shape(movement.object)) moves[*mesh] = true;
  }
  const auto is_left_out = [&](std::size_t o) {
    const std::string& kind = objects_[o].kind;
    return children[o].empty() && (is_onlooker(kind) || (kind == "Mesh" && !moves[o]));
  };
  result_.node_of_object.assign(count, -1);
  struct Visit {
    std::size_t object;
    int parent;
    int depth;
  };
  std::vector<Visit> open = {{FbxObjects::kScene, -1, 0}};
  std::size_t visited = 0;
  int spheric = 0;
  int by_quaternion = 0;
  while (!open.empty()) {
    const Visit visit = open.back();
    open.pop_back();
    ++visited;
    if (visit.depth > kDeepestFbxNode)
      refuse("its nodes hang deeper than " + std::to_string(kDeepestFbxNode));
    if (visit.object != FbxObjects::kScene && is_left_out(visit.object)) continue;
    const auto node = static_cast<int>(result_.take.nodes.size());
    result_.node_of_object[visit.object] = node;
    const FbxProperties properties = objects_.properties(visit.object);
    const FbxTransform transform =
        visit.object == FbxObjects::kScene ? FbxTransform() : FbxTransform(properties);
    spheric += transform.is_spheric;
    by_quaternion += properties.number("QuaternionInterpolate", 0) != 0;
    result_.object_of_node.push_back(visit.object);
    result_.transforms.push_back(transform);
    result_.take.nodes.push_back(
        {.name = objects_[visit.object].name, .parent = visit.parent, .rest = transform.local()});
    for (auto child = children[visit.object].rbegin(); child != children[visit.object].rend();
         ++child)
      open.push_back({*child, node, visit.depth + 1});
  }
  if (visited < models + 1) refuse("its nodes hang in a circle");
  if (const int repeated = objects_.repeated_connections(); repeated > 0)
    warn(counted(repeated, "connection") + " stated again: each counts once");
  if (spheric > 0)
    warn(counted(spheric, "node") + " with spheric XYZ angles, which are read as XYZ angles");
  if (by_quaternion > 0 && !movements_.empty())
    warn(counted(by_quaternion, "node") +
         " with quaternions between keys, which are read as angles");
  mark_joints();
}

/// Marks as joints the bones of skins and those of their ancestors that are limb nodes; without a
/// skin, all limb nodes. All clips of a figure then have the same joints, whatever moves in each.
void FbxTakeReader::mark_joints() {
  auto& nodes = result_.take.nodes;
  std::vector<bool> is_bone(nodes.size());
  bool any = false;
  for (std::size_t o = 0; o < objects_.all().size(); ++o) {
    if (objects_[o].kind != "Cluster") continue;
    for (const FbxLink& link : objects_.children(o))
      if (const int node = result_.node_of_object[link.object]; node > 0)
        is_bone[node] = any = true;
  }
  // If nothing moves a node and there is no skin, nodes with moving weights or properties are
  // joints, too.
  const auto moves_node = [&](const FbxMovement& movement) {
    return FbxTransform().part(movement.property) != nullptr && movement.moves();
  };
  if (!any && std::ranges::none_of(movements_, moves_node))
    for (const FbxMovement& movement : movements_)
      for (const auto object : {std::optional(movement.object), mesh_of_shape(movement.object)})
        if (const int node = object ? result_.node_of_object[*object] : -1; node > 0)
          nodes[node].joint = true;
  std::vector<bool> carries(nodes.size(), !any);
  for (std::size_t i = nodes.size(); i-- > 0;) {
    const std::string& kind = objects_[result_.object_of_node[i]].kind;
    nodes[i].joint |= is_bone[i] || (i > 0 && carries[i] && is_joint_kind(kind));
    if ((is_bone[i] || (any && carries[i])) && nodes[i].parent >= 0)
      carries[nodes[i].parent] = true;
  }
}

void FbxTakeReader::settle_axes() {
  const FbxProperties& settings = objects_.settings();
  const double unit = settings.number("UnitScaleFactor", 1);
  if (unit >= 1e-6 && unit <= 1e6) result_.take.cm_per_unit = unit;
  const int up = static_cast<int>(settings.number("UpAxis", 1));
  const bool is_down = settings.number("UpAxisSign", 1) < 0;
  // UpAxis has only Y and Z, so X and negative directions become a turn of the whole scene.
  const auto turn = [&](double angle, const Vector3d& axis) {
    AnimatedNode& scene = result_.take.nodes.front();
    scene.rest.rotation = Eigen::AngleAxisd(angle, axis) * scene.rest.rotation;
  };
  using std::numbers::pi;
  if (up == 2) result_.take.up = UpAxis::Z;
  if (up == 0)
    turn(is_down ? -pi / 2 : pi / 2, Vector3d::UnitZ());
  else if (is_down)
    turn(pi, Vector3d::UnitX());
}

std::optional<double> FbxTakeReader::stated_rate() const {
  const FbxProperties& settings = objects_.settings();
  if (!settings.has("TimeMode")) {  // version 6, in Version5/Settings/FrameRate
    const FbxRecord* const old = file_.records.find(file_.records.top(), "Version5");
    const FbxRecord* const of = old != nullptr ? file_.records.find(*old, "Settings") : nullptr;
    if (of == nullptr) return std::nullopt;
    const std::string rate = file_.records.text(*of, "FrameRate");
    const double number = parse_number(rate).value_or(0);
    return number >= 1 && number <= 1000 ? std::optional(number) : std::nullopt;
  }
  const double mode = settings.number("TimeMode", kFbxDefaultMode);
  const double custom = settings.number("CustomFrameRate", -1);
  const bool is_custom = mode == kFbxCustomMode;
  if (is_custom) return custom >= 1e-3 && custom <= 1e6 ? std::optional(custom) : std::nullopt;
  if (!(mode > kFbxDefaultMode && mode < static_cast<double>(std::size(kFbxRates))))
    return std::nullopt;
  return kFbxRates[static_cast<std::size_t>(mode)];
}

/// Key times of the curves that move nodes, or with `of_nodes` false, of all other curves. Curves
/// with fewer than `fewest` keys are left out.
std::vector<double> FbxTakeReader::key_times(bool of_nodes, std::size_t fewest) const {
  // Uses each list of key times once, since many curves have equal ones.
  const auto is_earlier = [](const auto* a, const auto* b) {
    return std::lexicographical_compare(
        a->begin(), a->end(), b->begin(), b->end(),
        [](const FbxCurve::Key& x, const FbxCurve::Key& y) { return x.ticks < y.ticks; });
  };
  std::set<const std::vector<FbxCurve::Key>*, decltype(is_earlier)> known(is_earlier);
  std::vector<double> all;
  for (const FbxMovement& movement : movements_) {
    const bool is_of_node = result_.node_of_object[movement.object] > 0 &&
                            FbxTransform().part(movement.property) != nullptr;
    if (is_of_node != of_nodes) continue;
    for (const auto& curve : movement.curves) {
      if (!curve || curve->keys().size() < fewest) continue;
      if (!known.insert(&curve->keys()).second) continue;
      std::vector<double> times;
      for (const FbxCurve::Key& key : curve->keys()) {
        times.push_back(static_cast<double>(key.ticks) / ticks_per_second_);
        if (std::abs(times.back()) > kMostFbxSeconds) refuse("has keys at impossible times");
      }
      all = merged_times(all, std::move(times));
    }
  }
  return all;
}

/// Limits the times to the take's span, or extends them to it if curves go on beyond their keys.
void FbxTakeReader::clip_to_span(std::vector<double>& keys_s, std::optional<double> rate) const {
  if (!chosen_->span) return;
  const double first = static_cast<double>(chosen_->span->first) / ticks_per_second_;
  const double last = static_cast<double>(chosen_->span->second) / ticks_per_second_;
  if (!(std::abs(first) <= kMostFbxSeconds && std::abs(last) <= kMostFbxSeconds)) return;
  const bool goes_on = std::ranges::any_of(movements_, [](const FbxMovement& movement) {
    return std::ranges::any_of(movement.curves,
                               [](const auto& curve) { return curve && curve->goes_beyond(); });
  });
  double begin = goes_on ? first : std::max(first, keys_s.front());
  double end = goes_on ? last : std::min(last, keys_s.back());
  if (rate) {  // cuts at whole frames within the span: keys may have been made at another rate
    const double origin = keys_s.front();
    begin = origin + std::ceil((begin - origin) * *rate - kNearFrame) / *rate;
    if (end != keys_s.back())
      end = origin + std::floor((end - origin) * *rate + kNearFrame) / *rate;
  }
  if (!(end > begin)) return;
  std::erase_if(keys_s, [&](double key) { return key < begin || key > end; });
  keys_s = merged_times(keys_s, {begin, end});
}

/// Moves every key to its nearest frame, as files round times; does nothing if a key is not near
/// one.
void FbxTakeReader::snap_to_frames(std::vector<double>& keys_s, std::optional<double> rate) const {
  if (!rate) return;
  std::vector<double> snapped;
  for (const double key : keys_s) {
    const double frame = (key - keys_s.front()) * *rate;
    if (std::abs(frame - std::round(frame)) > kNearFrame) return;
    snapped.push_back(keys_s.front() + std::round(frame) / *rate);
  }
  keys_s = merged_times({}, std::move(snapped));
}

void FbxTakeReader::sample() {
  NodeTake& take = result_.take;
  std::map<std::size_t, std::vector<FbxMovement*>> of_node;
  std::size_t others = 0;
  for (FbxMovement& movement : movements_) {
    const int node = result_.node_of_object[movement.object];
    if (node <= 0 || FbxTransform().part(movement.property) == nullptr) {
      ++others;
      continue;
    }
    const auto n = static_cast<std::size_t>(node);
    const Vector3d& rest = *result_.transforms[n].part(movement.property);
    for (Eigen::Index axis = 0; axis < 3; ++axis)
      if (!std::isfinite(movement.still(axis))) movement.still(axis) = rest(axis);
    of_node[n].push_back(&movement);
  }
  // Prefers curves of two keys or more: a single key holds its value at any time.
  std::vector<double> keys_s;
  for (const std::size_t fewest : {2, 1})
    for (const bool of_nodes : {true, false})
      if (keys_s.empty()) keys_s = key_times(of_nodes, fewest);
  if (keys_s.empty()) refuse("its take " + shortened(take.name) + " moves no node");
  const std::optional<double> rate = stated_rate();
  clip_to_span(keys_s, rate);
  snap_to_frames(keys_s, rate);
  times_ = sample_times(file_.records.file(), keys_s, rate, options_.sample_rate_hz,
                        of_node.size() + std::min<std::size_t>(others, runtime::kMostTracks));
  if (static_cast<double>(times_.frames) * static_cast<double>(take.nodes.size()) >
      kMostFbxPlacements)
    refuse("has too many nodes for so many frames");
  if (!times_.warning.empty()) warn(times_.warning);
  result_.first_s = times_.first_s;
  take.frames = times_.frames;
  take.sample_rate_hz = times_.rate_hz;
  for (const auto& [node, movements] : of_node) sample_node(node, movements);
  sample_tracks();
}

void FbxTakeReader::sample_node(std::size_t node, const std::vector<FbxMovement*>& movements) {
  AnimatedNode& of = result_.take.nodes[node];
  const FbxTransform& rest = result_.transforms[node];
  FbxTransform transform = rest;
  std::vector<Vector3d*> parts;  // the part of the transform that each movement moves
  for (const FbxMovement* const movement : movements)
    parts.push_back(transform.part(movement->property));
  const bool is_turned_by_curves = std::ranges::any_of(parts, [&](const Vector3d* part) {
    return part == &transform.pre_rotation || part == &transform.post_rotation;
  });
  const FbxTransform::Turns turns = rest.turns();
  of.frames.reserve(times_.frames);
  for (int t = 0; t < times_.frames; ++t) {
    transform = rest;
    for (std::size_t m = 0; m < parts.size(); ++m) apply(*movements[m], ticks_at(t), *parts[m]);
    of.frames.push_back(is_turned_by_curves ? transform.local() : transform.local(turns));
  }
  if (curves_ == FbxCurves::Release)
    for (FbxMovement* const movement : movements) movement->curves = {};
}

/// The first layer replaces the value at rest; later layers combine with it by their blend modes.
void FbxTakeReader::apply(const FbxMovement& movement, double ticks, Vector3d& part) const {
  const Vector3d value = movement.at(ticks);
  const FbxLayer& layer = chosen_->layers[movement.layer];
  if (movement.layer == 0 || layer.blend == FbxLayer::Blend::Replace) {
    part = value;
    return;
  }
  const double weight = layer.weight_at(ticks);
  const bool adds = layer.blend == FbxLayer::Blend::Add;
  if (movement.property == "Lcl Rotation" && !layer.turns_by_angle) {
    // Angles of both layers are combined in order XYZ, whatever the node's order, as Maya does.
    const Quaterniond below = fbx_rotation(part);
    const Quaterniond own = fbx_rotation(value);
    part = fbx_angles(
        adds ? below * Quaterniond::Identity().slerp(weight, own) : below.slerp(weight, own), 0);
  } else if (movement.property == "Lcl Scaling" && !layer.scales_by_sum) {
    for (Eigen::Index axis = 0; axis < 3; ++axis)
      part(axis) = (adds ? part(axis) : power(part(axis), 1 - weight)) * power(value(axis), weight);
  } else {
    part = layer.over(part, value, weight);
  }
}

/// The node with the mesh of a blend shape channel.
std::optional<std::size_t> FbxTakeReader::mesh_of_shape(std::size_t channel) const {
  std::size_t at = channel;
  for (const char* const type : {"Deformer", "Geometry", "Model"}) {
    const auto& parents = objects_.parents(at);
    const auto above = std::ranges::find_if(
        parents, [&](const FbxLink& link) { return objects_.is(link.object, type); });
    if (above == parents.end()) return std::nullopt;
    at = above->object;
  }
  return at;
}

bool FbxTakeReader::sample_track(const FbxLayered& movements, std::size_t axis, ScalarTrack track,
                                 double scale) {
  auto& tracks = result_.take.tracks;
  if (tracks.size() == runtime::kMostTracks ||
      std::max(track.node.size(), track.name.size()) > runtime::kMostNameBytes)
    return false;
  const FbxMovement& first = *movements.front();
  track.steps = std::ranges::all_of(movements, [&](const FbxMovement* movement) {
    const auto& curve = movement->curves[axis];
    const auto& weight = chosen_->layers[movement->layer].weight_curve;
    return (!curve || curve->steps()) && (!weight || movement->layer == 0 || weight->steps());
  });
  const FbxProperties properties = objects_.properties(first.object);
  const double number = properties.number(first.property, 0);
  const double rest =
      properties.vector(first.property, {number, 0, 0})(static_cast<Eigen::Index>(axis));
  for (int t = 0; t < times_.frames; ++t) {
    const auto value =
        static_cast<float>(scale * chosen_->value_at(movements, axis, rest, ticks_at(t)));
    if (!(std::abs(value) <= 1e9F)) return false;
    track.values.push_back(value);
  }
  tracks.push_back(std::move(track));
  result_.track_places.push_back({first.object, first.property, axis, scale});
  return true;
}

/// Samples weights of blend shapes, and custom properties and visibility of nodes that change.
void FbxTakeReader::sample_tracks() {
  constexpr double kFullShape = 0.01;
  constexpr const char* kAxes[] = {"", ".Y", ".Z"};
  int left_out = 0;
  std::map<std::pair<std::size_t, std::string>, FbxLayered> of_property;
  std::vector<const FbxLayered*> in_order;
  for (const FbxMovement& movement : movements_) {
    const auto [of, is_new] = of_property.try_emplace({movement.object, movement.property});
    add_layered(of->second, movement);
    if (is_new) in_order.push_back(&of->second);
  }
  for (const FbxLayered* const movements : in_order) {
    const FbxMovement& first = *movements->front();
    const FbxObject& object = objects_[first.object];
    if (object.type == "Model" && FbxTransform().part(first.property) != nullptr) continue;
    const bool is_channel = object.kind == "BlendShapeChannel" && first.property == "DeformPercent";
    if (!is_channel && object.type != "Model") continue;
    const bool is_shape =
        is_channel || (object.record != nullptr &&
                       fbx_shape_named(file_.records, *object.record, first.property));
    if (!is_shape && first.property != "Visibility" &&
        !objects_.properties(first.object).is_custom(first.property))
      continue;
    const auto mesh = is_channel ? mesh_of_shape(first.object) : std::optional(first.object);
    for (std::size_t axis = 0; axis < (is_channel ? 1 : 3); ++axis) {
      const bool changes = std::ranges::any_of(*movements, [&](const FbxMovement* movement) {
        const auto& curve = movement->curves[axis];
        const auto& weight = chosen_->layers[movement->layer].weight_curve;
        return curve && (is_shape || curve->moves() || (weight && weight->moves()));
      });
      if (!changes) continue;
      left_out += !sample_track(*movements, axis,
                                {.kind = is_shape ? TrackKind::MorphWeight : TrackKind::Property,
                                 .node = mesh ? objects_[*mesh].name : std::string(),
                                 .name = (is_channel ? object.name : first.property) + kAxes[axis],
                                 .values = {}},
                                is_shape ? kFullShape : 1);
    }
  }
  if (left_out > 0)
    warn(counted(left_out, "curve") +
         " of weights or properties left out: too many, too long a name, or beyond 1e9");
}

}  // namespace

double FbxFile::ticks_per_second() const {
  // Files from 2019 on may count 141,120,000 ticks a second; their TCDefinition is then not 127.
  constexpr double kNewTicks = 141'120'000;
  constexpr std::int64_t kUsual = 127;
  constexpr std::int64_t kHeadWithDefinition = 1004;
  const FbxRecord* const head = records.find(records.top(), "FBXHeaderExtension");
  if (head == nullptr) return kFbxTicks;
  const auto number = [&](const FbxRecord* in, const char* name) -> std::optional<std::int64_t> {
    const FbxRecord* const record = in != nullptr ? records.find(*in, name) : nullptr;
    const auto value = record != nullptr ? records.value(*record, 0) : std::nullopt;
    return value ? std::optional(value->whole()) : std::nullopt;
  };
  const auto definition = number(records.find(*head, "OtherFlags"), "TCDefinition");
  const bool is_stated = number(head, "FBXHeaderVersion").value_or(0) >= kHeadWithDefinition;
  return is_stated && definition && *definition != kUsual ? kNewTicks : kFbxTicks;
}

FbxTake read_fbx_take(FbxFile& file, const ReadOptions& options, FbxCurves curves) {
  FbxTake take = FbxTakeReader(file, options, curves).read();
  try {
    take.take.meshes = fbx_meshes(file, take, take.warnings);
  } catch (const InputError& error) {  // a bad mesh is no reason to refuse the motion
    const std::string reason =
        std::string(error.what()).substr(printable(file.records.file()).size() + 2);
    take.warnings.push_back({file.records.file(), 0, "its character is not read: " + reason});
  }
  return take;
}

FbxTake read_fbx_rest(FbxFile& file) {
  const ReadOptions as_it_says;
  FbxTake take = FbxTakeReader(file, as_it_says, FbxCurves::Release).read_rest();
  take.take.meshes = fbx_meshes(file, take, take.warnings);
  return take;
}

}  // namespace mocapress
