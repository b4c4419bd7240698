// SPDX-License-Identifier: MIT
// Replaces a take of an existing FBX file by a motion.
#include "core/formats/fbx/fbx_onto.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <optional>
#include <set>
#include <unordered_map>
#include <unordered_set>

#include "core/base/error.h"
#include "core/formats/fbx/fbx_animation.h"
#include "core/formats/fbx/fbx_curve_output.h"
#include "core/formats/fbx/fbx_output.h"
#include "core/formats/fbx/fbx_scene.h"
#include "core/formats/fbx/fbx_writer.h"
#include "core/formats/node_tracks.h"
#include "core/formats/take_choice.h"

namespace mocapress {
namespace {

using Eigen::Vector3d;
using Curves = std::array<std::vector<float>, 3>;

// A curve that differs from the motion by less than these stays as it is, since files hold floats.
constexpr double kSameNumber = 1e-5;  // share of 1 + |number|
constexpr double kSameAngle = 1e-4;   // degrees

constexpr const char* kPlace = "Lcl Translation";
constexpr const char* kTurn = "Lcl Rotation";
constexpr const char* kScale = "Lcl Scaling";

/// The number of an object in the file's connections.
std::int64_t id_of(const FbxRecords& records, const FbxObject& object) {
  const auto id = object.record != nullptr ? records.value(*object.record, 0) : std::nullopt;
  return id ? id->whole() : 0;
}

/// Reads the take that a motion replaces. If no take has a key, reads the nodes at rest; the motion
/// then begins at the beginning of the take that the options name, or else of the first.
FbxTake read_target(FbxFile& file, const ReadOptions& options) {
  const double second = file.ticks_per_second();
  FbxAnimation animation(file.records, file.objects, second);
  for (std::size_t take = 0; take < animation.takes().size(); ++take)
    if (animation.has_keys(take)) return read_fbx_take(file, options, FbxCurves::Keep);
  FbxTake rest = read_fbx_rest(file);
  std::vector<TakeName> takes;
  for (const FbxTakeInfo& take : animation.takes()) takes.push_back({take.name});
  if (options.take)
    rest.index = choose_take(file.records.file(), takes, options.take, rest.warnings);
  if (takes.empty()) return rest;
  rest.movements = animation.movements(rest.index);
  if (!animation.takes()[rest.index].span) return rest;
  const double begin = static_cast<double>(animation.takes()[rest.index].span->first) / second;
  if (std::abs(begin) <= kMostFbxSeconds) rest.first_s = begin;
  return rest;
}

/// A take of a file whose curves are replaced.
class EditedTake {
 public:
  EditedTake(FbxFile& file, const FbxTake& read, const Clip& clip, double rate_hz)
      : file_(file),
        read_(read),
        ticks_per_second_(file.ticks_per_second()),
        first_(read.first_s * ticks_per_second_),
        objects_(list("Objects")),
        connections_(list("Connections")),
        out_(ticks_of(clip, rate_hz), edits_.added[objects_], edits_.added[connections_],
             free_id()) {
    FbxAnimation animation(file.records, file.objects, ticks_per_second_);
    if (animation.takes().empty()) {
      add_take();
    } else {
      take_ = animation.takes()[read.index];
      if (take_.layers.empty() || take_.layers.front().is_silent)
        file.records.fail("its take " + take_.name +
                          " has no first layer that is heard: a motion cannot be written there");
      layer_ = id(take_.layers.front().object);
    }
    keeps_rate_ = rate_hz == read.take.sample_rate_hz;
    for (const FbxRecord* c = file.records.first_child(*connections_); c != nullptr;
         c = file.records.next(*c))
      if (const auto child = file.records.value(*c, 1)) by_child_[child->whole()].push_back(c);
  }

  void move(const NodeTrack& track);
  void move(const ScalarTracks& tracks);
  std::string bytes();

 private:
  using Property = std::pair<std::size_t, std::string>;  // an object and one of its properties
  struct GivenTrack {
    const ScalarTrack* track;
    std::size_t axis;
    double scale;
    bool stays;
  };
  using GivenTracks = std::vector<GivenTrack>;  // for one property

  const FbxRecord* list(const char* name) const {
    const FbxRecord* const found = file_.records.find(file_.records.top(), name);
    if (found == nullptr) file_.records.fail(std::string("has no ") + name);
    return found;
  }
  std::vector<std::int64_t> ticks_of(const Clip& clip, double rate_hz);
  std::int64_t free_id() const;
  void add_take();
  std::int64_t id(std::size_t object) const { return id_of(file_.records, file_.objects[object]); }
  double ticks_at(std::size_t frame) const { return static_cast<double>(ticks_[frame]); }
  bool moves_so(const NodeTrack& track) const;
  const FbxMovement* movement_of(std::size_t object, std::string_view property);
  bool is_alone(std::size_t curve_node) const;
  void disconnect(std::size_t curve_node, std::size_t object, std::string_view property);
  void set(std::size_t object, std::string_view property, const FbxMovement* movement,
           const Vector3d& rest, const Curves& curves, double same);
  void set_axis(std::size_t curve_node, std::size_t axis, const std::vector<float>& values,
                bool steps);
  void set_keys(const FbxRecord& curve, const std::vector<float>& values, bool steps);
  void move(const Property& property, const GivenTracks& given);
  bool is_layered(std::size_t object, std::string_view property) const;
  void sample(const Property& property, Curves& curves, std::array<bool, 3>& steps) const;
  void lengthen();

  FbxFile& file_;
  const FbxTake& read_;
  double ticks_per_second_;
  double first_;
  FbxEdits edits_;
  const FbxRecord* objects_;
  const FbxRecord* connections_;
  std::vector<std::int64_t> ticks_;
  FbxCurveOutput out_;
  FbxTakeInfo take_;
  std::int64_t layer_ = 0;  // the take's first layer
  bool keeps_rate_ = true;
  std::unordered_map<std::int64_t, std::vector<const FbxRecord*>> by_child_;  // by child
};

std::vector<std::int64_t> EditedTake::ticks_of(const Clip& clip, double rate_hz) {
  for (int t = 0; t < clip.frames(); ++t)
    ticks_.push_back(std::llround(first_ + t * ticks_per_second_ / rate_hz));
  return ticks_;
}

/// The first number above all objects' numbers.
std::int64_t EditedTake::free_id() const {
  std::int64_t largest = 0;
  constexpr std::int64_t kMost = std::int64_t{1} << 62;
  for (const FbxObject& object : file_.objects.all())
    largest = std::max(largest, id_of(file_.records, object));
  if (largest > kMost) file_.records.fail("numbers its objects too high to add any");
  return largest + 1;
}

/// Adds a take to a file without one.
void EditedTake::add_take() {
  const std::int64_t stack = out_.new_id();
  layer_ = out_.new_id();
  FbxOutRecord& all =
      out_.object("AnimationStack", stack, fbx_full_name("Take 001", "AnimStack"), "")
          .record("Properties70");
  for (const std::string_view stop : {"LocalStop", "ReferenceStop"})
    all.property(stop, "KTime", "Time", "").value(ticks_.empty() ? std::int64_t{0} : ticks_.back());
  out_.object("AnimationLayer", layer_, fbx_full_name("BaseLayer", "AnimLayer"), "").is_list = true;
  out_.connect(layer_, stack);
}

/// The first layer's movement of a property; null if it has none that may be changed. Disconnects
/// the property from other layers, and from curves that it shares with other properties.
const FbxMovement* EditedTake::movement_of(std::size_t object, std::string_view property) {
  const FbxMovement* first = nullptr;
  for (const FbxMovement& movement : read_.movements) {
    if (movement.object != object || movement.property != property) continue;
    if (first == nullptr && movement.layer == 0)
      first = &movement;
    else
      disconnect(movement.curve_node, object, property);
  }
  if (first == nullptr || is_alone(first->curve_node)) return first;
  disconnect(first->curve_node, object, property);
  return nullptr;
}

/// True if a curve node belongs to one layer and one property, and its curves belong to it alone.
bool EditedTake::is_alone(std::size_t curve_node) const {
  const auto& of = file_.objects.parents(curve_node);
  const auto& curves = file_.objects.children(curve_node);
  return of.size() == 2 && std::ranges::all_of(curves, [&](const FbxLink& link) {
           return file_.objects.parents(link.object).size() == 1;
         });
}

void EditedTake::disconnect(std::size_t curve_node, std::size_t object, std::string_view property) {
  FbxRecords& records = file_.records;
  const auto& parents = file_.objects.parents(curve_node);
  if (std::ranges::count_if(parents, [&](const FbxLink& link) {
        return file_.objects.is(link.object, "AnimationLayer");
      }) > 1)
    records.fail("has curves that several takes share: a motion cannot be written onto one");
  for (const FbxRecord* const c : by_child_[id(curve_node)]) {
    const std::vector<FbxValue> values = records.values(*c);
    if (values.size() > 3 && values[2].whole() == id(object) && values[3].text == property)
      edits_.dropped.insert(c);
  }
}

void EditedTake::set_keys(const FbxRecord& curve, const std::vector<float>& values, bool steps) {
  for (FbxOutRecord& keys : out_.keys(values, steps)) {
    if (const FbxRecord* const old = file_.records.find(curve, keys.name))
      edits_.replaced[old] = std::move(keys);
    else
      edits_.added[&curve].push_back(std::move(keys));
  }
}

void EditedTake::set_axis(std::size_t curve_node, std::size_t axis,
                          const std::vector<float>& values, bool steps) {
  bool is_there = false;
  for (const FbxLink& link : file_.objects.children(curve_node)) {
    if (!file_.objects.is(link.object, "AnimationCurve") || fbx_axis(link.property) != axis)
      continue;
    set_keys(*file_.objects[link.object].record, values, steps);
    is_there = true;
  }
  if (!is_there) out_.add_curve(id(curve_node), kFbxCurveAxes[axis], values, steps);
}

/// Writes the curves of a property, except on axes whose values in the file differ by at most
/// `same`. `rest` is the property's value without a curve.
void EditedTake::set(std::size_t object, std::string_view property, const FbxMovement* movement,
                     const Vector3d& rest, const Curves& curves, double same) {
  const auto stays = [&](std::size_t axis) {
    // At another rate, keys that stayed would mix with the new ones, and a reader would find
    // neither rate.
    if (!keeps_rate_ && movement != nullptr && movement->curves[axis] &&
        movement->curves[axis]->keys().size() > 1)
      return false;
    const auto a = static_cast<Eigen::Index>(axis);
    for (std::size_t t = 0; t < ticks_.size(); ++t) {
      double was = rest(a);
      if (movement != nullptr && movement->curves[axis])
        was = movement->curves[axis]->at(ticks_at(t));
      else if (movement != nullptr && std::isfinite(movement->still(a)))
        was = movement->still(a);
      const double scale = property == kTurn ? 1 : 1 + std::abs(was);
      if (std::abs(static_cast<double>(curves[axis][t]) - was) > same * scale) return false;
    }
    return true;
  };
  if (movement == nullptr) {
    if (!stays(0) || !stays(1) || !stays(2)) out_.add(layer_, id(object), property, curves);
    return;
  }
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (!stays(axis)) set_axis(movement->curve_node, axis, curves[axis], false);
}

/// True if the take in the file, with all its layers, already moves the node as `track` does.
bool EditedTake::moves_so(const NodeTrack& track) const {
  const AnimatedNode& node = read_.take.nodes[track.node];
  if (!keeps_rate_ || static_cast<int>(ticks_.size()) != read_.take.frames) return false;
  for (std::size_t t = 0; t < ticks_.size(); ++t) {
    const LocalTransform& was = node.frames.empty() ? node.rest : node.frames[t];
    const Vector3d scale =
        track.scales.empty() ? track.scale.value_or(track.rest.scale) : track.scales[t];
    const double turn = track.rotation[t].normalized().angularDistance(was.rotation.normalized());
    const auto is_same = [](const Vector3d& a, const Vector3d& b) {
      return (a - b).norm() <= kSameNumber * (1 + b.norm());
    };
    if (!is_same(track.translation[t], was.translation) || !is_same(scale, was.scale) ||
        turn * 180 / std::numbers::pi > kSameAngle)
      return false;
  }
  return true;
}

void EditedTake::move(const NodeTrack& track) {
  if (moves_so(track)) return;
  const std::size_t object = read_.object_of_node[track.node];
  FbxTransform transform = read_.transforms[track.node];
  // Disconnects curves of pivots and the like: translation, rotation and scaling take over their
  // effect.
  for (const FbxMovement& movement : read_.movements)
    if (movement.object == object && movement.property != kPlace && movement.property != kTurn &&
        movement.property != kScale && transform.part(movement.property) != nullptr)
      disconnect(movement.curve_node, object, movement.property);
  const FbxMovement* const place = movement_of(object, kPlace);
  const FbxMovement* const turn = movement_of(object, kTurn);
  const FbxMovement* const scale = movement_of(object, kScale);
  const FbxTransform rest = transform;
  if (turn != nullptr) {
    const Vector3d first = turn->at(first_);
    for (Eigen::Index a = 0; a < 3; ++a)
      if (std::isfinite(first(a))) transform.rotation(a) = first(a);
  }
  Curves places;
  Curves turns;
  Curves scales;
  LocalTransform local = track.rest;
  if (track.scale) local.scale = *track.scale;
  const auto append = [](const Vector3d& value, Curves& curves) {
    for (std::size_t a = 0; a < 3; ++a) curves[a].push_back(static_cast<float>(value(a)));
  };
  for (std::size_t t = 0; t < ticks_.size(); ++t) {
    local.translation = track.translation[t];
    local.rotation = track.rotation[t];
    if (!track.scales.empty()) local.scale = track.scales[t];
    transform.set_local(local);
    append(transform.translation, places);
    append(transform.rotation, turns);
    append(transform.scaling, scales);
  }
  set(object, kPlace, place, rest.translation, places, kSameNumber);
  set(object, kTurn, turn, rest.rotation, turns, kSameAngle);
  set(object, kScale, scale, rest.scaling, scales, kSameNumber);
}

/// Tracks of the same name are used in order, each once.
void EditedTake::move(const ScalarTracks& tracks) {
  std::map<Property, GivenTracks> given;
  std::set<Property> changed;
  std::unordered_set<const ScalarTrack*> taken;
  for (std::size_t w = 0; w < read_.track_places.size(); ++w) {
    const ScalarTrack& wanted = read_.take.tracks[w];
    const FbxTake::TrackPlace& place = read_.track_places[w];
    const auto found = std::ranges::find_if(tracks, [&](const ScalarTrack& track) {
      return track.kind == wanted.kind && track.node == wanted.node && track.name == wanted.name &&
             !taken.contains(&track);
    });
    if (found == tracks.end()) continue;
    taken.insert(&*found);
    const Property property = {place.object, place.property};
    const bool stays = keeps_rate_ && found->values == wanted.values;
    given[property].push_back({&*found, place.axis, place.scale, stays});
    if (!stays) changed.insert(property);
  }
  for (const Property& property : changed) move(property, given.at(property));
}

/// Sets the curves of a property. If several layers move the property, or others share its curves,
/// all its axes get curves in the first layer that belong to it alone.
void EditedTake::move(const Property& property, const GivenTracks& given) {
  const auto& [object, name] = property;
  const FbxMovement* const movement = movement_of(object, name);
  const bool is_whole = movement == nullptr || is_layered(object, name);
  Curves curves;
  std::array<bool, 3> steps = {};
  if (is_whole) sample(property, curves, steps);
  for (const auto& [track, axis, scale, stays] : given) {
    if (stays && !is_whole) continue;
    curves[axis].clear();
    for (const float value : track->values)
      curves[axis].push_back(static_cast<float>(static_cast<double>(value) / scale));
    curves[axis].resize(ticks_.size(), curves[axis].back());
    steps[axis] = track->steps;
  }
  if (movement != nullptr) {
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (!curves[axis].empty()) set_axis(movement->curve_node, axis, curves[axis], steps[axis]);
  } else if (curves[1].empty() && curves[2].empty()) {
    out_.add(layer_, id(object), name, curves[0], steps[0]);
  } else {
    out_.add(layer_, id(object), name, curves, steps);
  }
}

bool EditedTake::is_layered(std::size_t object, std::string_view property) const {
  return std::ranges::count_if(read_.movements, [&](const auto& movement) {
           return movement.object == object && movement.property == property;
         }) > 1;
}

/// The values of a property in the file, of one axis or three, at the times of the new keys.
void EditedTake::sample(const Property& property, Curves& curves,
                        std::array<bool, 3>& steps) const {
  const auto& [object, name] = property;
  FbxLayered movements;
  for (const FbxMovement& movement : read_.movements)
    if (movement.object == object && movement.property == name) add_layered(movements, movement);
  const FbxProperties properties = file_.objects.properties(object);
  const Vector3d none = Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
  const bool is_vector = properties.vector(name, none).allFinite() ||
                         std::ranges::any_of(movements, [](const FbxMovement* movement) {
                           return movement->curves[1] || movement->curves[2];
                         });
  const Vector3d rest = properties.vector(name, {properties.number(name, 0), 0, 0});
  for (std::size_t axis = 0; axis < (is_vector ? 3 : 1); ++axis)
    for (std::size_t t = 0; t < ticks_.size(); ++t)
      curves[axis].push_back(
          static_cast<float>(take_.value_at(movements, axis, rest(axis), ticks_at(t))));
  for (std::size_t w = 0; w < read_.track_places.size(); ++w)
    if (read_.track_places[w].object == object && read_.track_places[w].property == name)
      steps[read_.track_places[w].axis] = read_.take.tracks[w].steps;
}

/// Moves the take's stated end if the motion is longer.
void EditedTake::lengthen() {
  if (ticks_.empty() || !take_.span) return;
  FbxRecords& records = file_.records;
  const FbxRecord* const all = records.find(*file_.objects[take_.object].record, "Properties70");
  if (all == nullptr) return;
  for (const FbxRecord* p = records.first_child(*all); p != nullptr; p = records.next(*p)) {
    const std::vector<FbxValue> values = records.values(*p);
    if (values.size() != 5 || (values[0].text != "LocalStop" && values[0].text != "ReferenceStop"))
      continue;
    if (values[4].kind != FbxValue::Kind::Integer || values[4].whole() >= ticks_.back()) continue;
    FbxOutRecord later{.name = "P"};
    for (std::size_t v = 0; v < 4; ++v) later.value(values[v].text);
    later.value(ticks_.back());
    edits_.replaced[p] = std::move(later);
  }
}

std::string EditedTake::bytes() {
  lengthen();
  return fbx_edited_bytes(file_.records, edits_);
}

}  // namespace

std::string fbx_bytes_onto(const std::string& name, std::string_view bytes, const Motion& motion,
                           const WriteOptions& options, const ScalarTracks& tracks) {
  FbxFile file(name, bytes);
  if (!file.records.is_binary() || file.records.is_big_endian() || file.records.version() < 7000)
    file.records.fail(
        "is ASCII, big-endian or older than 7.0: a motion is put only onto other binary FBX files");
  const ReadOptions reading{
      .cm_per_unit = options.cm_per_unit, .up = options.up, .take = options.take};
  const FbxTake read = read_target(file, reading);
  EditedTake take(file, read, motion.clip,
                  options.sample_rate_hz.value_or(motion.clip.sample_rate_hz));
  for (const NodeTrack& track :
       tracks_following(name, read.take, motion, without_namespace(fbx_names(motion.skeleton)),
                        reading, JointScales(tracks, motion.skeleton)))
    take.move(track);
  take.move(tracks);
  return take.bytes();
}

}  // namespace mocapress
