// SPDX-License-Identifier: MIT
#include "core/formats/fbx/fbx_writer.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <map>
#include <set>
#include <string_view>
#include <unordered_set>
#include <utility>

#include "core/base/error.h"
#include "core/formats/fbx/fbx_curve_output.h"
#include "core/formats/fbx/fbx_curves.h"
#include "core/formats/fbx/fbx_scene.h"
#include "core/formats/fbx/fbx_transform.h"
#include "core/formats/node_tracks.h"
#include "core/formats/text_writer.h"

namespace mocapress {
namespace {

using Eigen::Vector3d;
using Track3 = std::array<std::vector<float>, 3>;

constexpr std::int64_t kNoObject = 0;  // parent of the scene's topmost nodes
constexpr std::int64_t kDocument = 1;
constexpr std::int64_t kPose = 2;
constexpr std::int64_t kFirstId = 1000;

constexpr float kPercentOfWhole = 100;

/// The FBX number of a joint's rotation order, or of XYZ for joints without three different axes.
int order_of(const Joint& joint) {
  std::vector<int> axes;
  for (const ChannelKind kind : joint.channels)
    if (is_rotation(kind)) axes.insert(axes.begin(), axis_of(kind));
  for (int order = 0; order + 1 < kFbxOrders; ++order)
    if (std::equal(axes.begin(), axes.end(), fbx_axes(order), fbx_axes(order) + 3)) return order;
  return 0;
}

std::int32_t time_mode(double rate_hz) {
  for (std::size_t mode = kFbxDefaultMode + 1; mode < std::size(kFbxRates); ++mode)
    if (kFbxRates[mode] == rate_hz) return static_cast<std::int32_t>(mode);
  return kFbxCustomMode;
}

std::vector<std::int64_t> ticks_of(const Clip& clip) {
  std::vector<std::int64_t> ticks;
  for (int t = 0; t < clip.frames(); ++t)
    ticks.push_back(std::llround(t * kFbxTicks / clip.sample_rate_hz));
  return ticks;
}

void append(const Vector3d& value, Track3& track) {
  for (std::size_t a = 0; a < 3; ++a) track[a].push_back(static_cast<float>(value(a)));
}

bool moves(const Track3& track) {
  return std::ranges::any_of(track, [](const std::vector<float>& values) {
    return std::ranges::any_of(values, [&](float value) { return value != values.front(); });
  });
}

class FbxDocument {
 public:
  /// Starts a document with the joints of `motion`, whose transforms at rest are in `rest`.
  FbxDocument(const Motion& motion, const std::vector<NodeTrack>& rest, const SourceFormat& format)
      : skeleton_(motion.skeleton),
        format_(format),
        rate_hz_(motion.clip.sample_rate_hz),
        out_({}, objects_.records, connections_.records, kFirstId) {
    add_joints(rest);
  }

  void add_take(const std::string& name, const Clip& clip, const std::vector<NodeTrack>& tracks,
                const ScalarTracks& scalars) {
    std::vector<std::int64_t> ticks = ticks_of(clip);
    begin_take(name, ticks.empty() ? 0 : ticks.back());
    out_.set_key_ticks(std::move(ticks));
    for (const NodeTrack& track : tracks) add_movement(track);
    for (const ScalarTrack& track : scalars)
      if (!is_scale(track.kind)) add_track(track);
  }

  std::string bytes(int version);

 private:
  /// A written node: its id, for connections, its property record and its transform at rest.
  struct Node {
    std::int64_t id = 0;
    FbxOutRecord* properties = nullptr;
    LocalTransform rest;
  };
  struct MorphedMesh {
    std::int64_t shapes = 0;  // id of the deformer that holds the shapes
    // Channels by the name of their shape, and by the number of shapes of that name before it in
    // the take.
    std::map<std::pair<std::string, int>, std::int64_t> channels;
    std::map<std::string, int> of_name;  // shapes of each name so far in the take that is added
  };

  Node add_node(const std::string& name, std::string_view kind, std::int64_t parent);
  Node add_limb(const std::string& name, std::int64_t parent, const LocalTransform& rest,
                const Vector3d& angles, int order, const NodePlacement& bound);
  void add_joints(const std::vector<NodeTrack>& tracks);
  void begin_take(const std::string& name, std::int64_t end);
  void add_movement(const NodeTrack& track);
  void add_track(const ScalarTrack& track);
  void add_weights(const ScalarTrack& track);
  std::int64_t channel_of(const ScalarTrack& track);
  Node node_of(const ScalarTrack& track);
  FbxOutRecord head(int version) const;
  FbxOutRecord settings() const;
  FbxOutRecord definitions() const;

  const Skeleton& skeleton_;
  const SourceFormat& format_;
  double rate_hz_;
  std::int64_t layer_ = 0;      // the layer of the take that is added
  std::int64_t last_tick_ = 0;  // latest tick of any take
  FbxOutRecord objects_{.name = "Objects"};
  FbxOutRecord connections_{.name = "Connections"};
  FbxOutRecord pose_{.name = "Objects"};  // record for the bind pose
  FbxCurveOutput out_;
  std::vector<Node> joints_;
  std::map<std::string, Node> nodes_;                          // by name
  std::map<std::string, MorphedMesh> morphed_meshes_;          // by name
  std::set<std::pair<std::int64_t, std::string>> properties_;  // node id, property name
  int bound_ = 0;
};

FbxDocument::Node FbxDocument::add_node(const std::string& name, std::string_view kind,
                                        std::int64_t parent) {
  Node node{.id = out_.new_id()};
  FbxOutRecord& model = out_.object("Model", node.id, fbx_full_name(name, "Model"), kind);
  model.field("Version", std::int32_t{232});
  node.properties = &model.record("Properties70");
  out_.connect(node.id, parent);
  return node;
}

FbxDocument::Node FbxDocument::add_limb(const std::string& name, std::int64_t parent,
                                        const LocalTransform& rest, const Vector3d& angles,
                                        int order, const NodePlacement& bound) {
  Node node = add_node(name, "LimbNode", parent);
  node.rest = rest;
  const auto vector = [&](std::string_view of, const Vector3d& value) {
    node.properties->property(of, of, "", "A").value(value.x()).value(value.y()).value(value.z());
  };
  node.properties->property("RotationActive", "bool", "", "").value(std::int32_t{1});
  node.properties->property("RotationOrder", "enum", "", "").value(std::int32_t{order});
  node.properties->property("InheritType", "enum", "", "").value(std::int32_t{1});
  vector("Lcl Translation", rest.translation);
  vector("Lcl Rotation", angles);
  vector("Lcl Scaling", rest.scale);
  const std::int64_t attribute = out_.new_id();
  out_.object("NodeAttribute", attribute, fbx_full_name(name, "NodeAttribute"), "LimbNode")
      .field("TypeFlags", std::string_view("Skeleton"));
  out_.connect(attribute, node.id);
  Eigen::Matrix4d world = Eigen::Matrix4d::Identity();
  world.topLeftCorner<3, 3>() = bound.world_from_node / format_.cm_per_unit;
  world.topRightCorner<3, 1>() = bound.origin / format_.cm_per_unit;
  FbxOutRecord& pose = pose_.records.front().record("PoseNode");
  pose.field("Node", node.id);
  pose.record("Matrix").array(std::vector<double>(world.data(), world.data() + world.size()));
  ++bound_;
  return node;
}

void FbxDocument::add_joints(const std::vector<NodeTrack>& tracks) {
  FbxOutRecord& pose = pose_.record("Pose");
  pose.value(kPose).value(fbx_full_name("BindPose", "Pose")).value(std::string_view("BindPose"));
  pose.field("Type", std::string_view("BindPose"));
  pose.field("Version", std::int32_t{100});
  const std::vector<std::string> names = fbx_names(skeleton_);
  std::unordered_set<std::string> taken(names.begin(), names.end());
  const std::vector<NodePlacement> placements =
      rest_placements(skeleton_, tracks, format_.cm_per_unit);
  for (std::size_t j = 0; j < names.size(); ++j) {
    const Joint& joint = skeleton_.joint(static_cast<int>(j));
    const LocalTransform& rest = tracks[j].rest;
    const int order = order_of(joint);
    joints_.push_back(add_limb(names[j], joint.parent < 0 ? kNoObject : joints_[joint.parent].id,
                               rest, fbx_angles(rest.rotation, order), order, placements[j]));
    nodes_.emplace(joint.name, joints_.back());
    if (!joint.end_site) continue;
    const LocalTransform end{.translation = end_in_node(placements[j], *joint.end_site)};
    add_limb(unique_word(names[j] + "_end", taken), joints_.back().id, end, Vector3d::Zero(), 0,
             below(placements[j], end));
  }
}

void FbxDocument::begin_take(const std::string& name, std::int64_t end) {
  const std::int64_t id = out_.new_id();
  layer_ = out_.new_id();
  last_tick_ = std::max(last_tick_, end);
  for (auto& [name_of_mesh, mesh] : morphed_meshes_) mesh.of_name.clear();
  FbxOutRecord& stack = out_.object("AnimationStack", id, fbx_full_name(name, "AnimStack"), "");
  FbxOutRecord& all = stack.record("Properties70");
  for (const std::string_view stop : {"LocalStop", "ReferenceStop"})
    all.property(stop, "KTime", "Time", "").value(end);
  out_.object("AnimationLayer", layer_, fbx_full_name("BaseLayer", "AnimLayer"), "").is_list = true;
  out_.connect(layer_, id);
}

void FbxDocument::add_movement(const NodeTrack& track) {
  if (track.rotation.empty()) return;
  const int order = order_of(skeleton_.joint(static_cast<int>(track.node)));
  Track3 places;
  Track3 turns;
  Track3 scales;
  Vector3d angles = Vector3d::Zero();
  for (std::size_t t = 0; t < track.rotation.size(); ++t) {
    angles = fbx_angles(track.rotation[t], order, angles);
    append(track.translation[t], places);
    append(angles, turns);
  }
  if (track.scales.empty() && !joints_[track.node].rest.scale.isOnes())
    scales.fill(std::vector<float>(track.rotation.size(), 1.0F));
  for (const Vector3d& scale : track.scales) append(scale, scales);
  const std::int64_t model = joints_[track.node].id;
  // A constant translation is written if it differs from that at rest, as it may in another take.
  const Vector3d& rest = joints_[track.node].rest.translation;
  const bool is_at_rest = (track.translation.front() - rest).norm() <= 1e-9 * (1 + rest.norm());
  if (skeleton_.joint(static_cast<int>(track.node)).parent < 0 || !is_at_rest || moves(places))
    out_.add(layer_, model, "Lcl Translation", places);
  out_.add(layer_, model, "Lcl Rotation", turns);
  if (!scales[0].empty()) out_.add(layer_, model, "Lcl Scaling", scales);
}

/// The node that a track belongs to. Adds a node outside the skeleton if needed, which only holds
/// tracks.
FbxDocument::Node FbxDocument::node_of(const ScalarTrack& track) {
  if (track.node.empty() && !joints_.empty()) return joints_.front();
  const auto known = nodes_.find(track.node);
  if (known != nodes_.end()) return known->second;
  return nodes_[track.node] = add_node(track.node, "Null", kNoObject);
}

void FbxDocument::add_track(const ScalarTrack& track) {
  if (track.values.empty()) return;
  if (track.kind == TrackKind::MorphWeight) return add_weights(track);
  const Node node = node_of(track);
  const auto first = static_cast<double>(track.values.front());
  const bool is_new = properties_.emplace(node.id, track.name).second;
  if (is_new && track.name == "Visibility")
    node.properties->property(track.name, "Visibility", "", "A").value(first);
  else if (is_new)
    node.properties->property(track.name, "Number", "", "A+U").value(first);
  out_.add(layer_, node.id, track.name, track.values, track.steps);
}

/// The blend shape channel of a track, added when first asked for. All takes share it.
std::int64_t FbxDocument::channel_of(const ScalarTrack& track) {
  MorphedMesh& mesh = morphed_meshes_[track.node];
  if (mesh.shapes == 0) {
    const Node model = add_node(track.node, "Mesh", kNoObject);
    const std::int64_t geometry = out_.new_id();
    FbxOutRecord& empty =
        out_.object("Geometry", geometry, fbx_full_name(track.node, "Geometry"), "Mesh");
    empty.field("GeometryVersion", std::int32_t{124});
    empty.record("Vertices").array(std::vector<double>());
    empty.record("PolygonVertexIndex").array(std::vector<std::int32_t>());
    mesh.shapes = out_.new_id();
    out_.object("Deformer", mesh.shapes, fbx_full_name(track.node, "Deformer"), "BlendShape")
        .field("Version", std::int32_t{100});
    out_.connect(geometry, model.id);
    out_.connect(mesh.shapes, geometry);
  }
  const std::pair<std::string, int> key = {track.name, mesh.of_name[track.name]++};
  const auto [known, is_new] = mesh.channels.emplace(key, 0);
  if (!is_new) return known->second;
  const std::int64_t channel = known->second = out_.new_id();
  FbxOutRecord& of = out_.object("Deformer", channel, fbx_full_name(track.name, "SubDeformer"),
                                 "BlendShapeChannel");
  of.field("Version", std::int32_t{100});
  of.field("DeformPercent", static_cast<double>(kPercentOfWhole * track.values.front()));
  of.record("FullWeights").array(std::vector<double>{kPercentOfWhole});
  const std::int64_t shape = out_.new_id();
  FbxOutRecord& same =
      out_.object("Geometry", shape, fbx_full_name(track.name, "Geometry"), "Shape");
  same.field("Version", std::int32_t{100});
  same.record("Indexes").array(std::vector<std::int32_t>());
  same.record("Vertices").array(std::vector<double>());
  same.record("Normals").array(std::vector<double>());
  out_.connect(channel, mesh.shapes);
  out_.connect(shape, channel);
  return channel;
}

void FbxDocument::add_weights(const ScalarTrack& track) {
  std::vector<float> percent = track.values;
  for (float& value : percent) value *= kPercentOfWhole;
  out_.add(layer_, channel_of(track), "DeformPercent", percent, track.steps);
}

FbxOutRecord FbxDocument::head(int version) const {
  FbxOutRecord head{.name = "FBXHeaderExtension"};
  head.field("FBXHeaderVersion", std::int32_t{1003});
  head.field("FBXVersion", std::int32_t{version});
  head.field("EncryptionType", std::int32_t{0});
  head.field("Creator", std::string_view("Mocapress"));
  return head;
}

FbxOutRecord FbxDocument::settings() const {
  FbxOutRecord settings{.name = "GlobalSettings"};
  settings.field("Version", std::int32_t{1000});
  FbxOutRecord& all = settings.record("Properties70");
  const bool is_z = format_.up == UpAxis::Z;
  const auto axis = [&](std::string_view name, std::int32_t value) {
    all.property(name, "int", "Integer", "").value(value);
  };
  axis("UpAxis", is_z ? 2 : 1);
  axis("UpAxisSign", 1);
  axis("FrontAxis", is_z ? 1 : 2);
  axis("FrontAxisSign", is_z ? -1 : 1);
  axis("CoordAxis", 0);
  axis("CoordAxisSign", 1);
  all.property("UnitScaleFactor", "double", "Number", "").value(format_.cm_per_unit);
  all.property("TimeMode", "enum", "", "").value(time_mode(rate_hz_));
  all.property("CustomFrameRate", "double", "Number", "").value(rate_hz_);
  all.property("TimeSpanStart", "KTime", "Time", "").value(std::int64_t{0});
  all.property("TimeSpanStop", "KTime", "Time", "").value(last_tick_);
  return settings;
}

FbxOutRecord FbxDocument::definitions() const {
  FbxOutRecord definitions{.name = "Definitions"};
  definitions.field("Version", std::int32_t{100});
  std::map<std::string, std::int32_t> counts = {{"GlobalSettings", 1}};
  for (const FbxOutRecord& object : objects_.records) ++counts[object.name];
  std::int32_t all = 0;
  for (const auto& [type, count] : counts) all += count;
  definitions.field("Count", all);
  for (const auto& [type, count] : counts)
    definitions.record("ObjectType").value(type).field("Count", count);
  return definitions;
}

std::string FbxDocument::bytes(int version) {
  pose_.records.front().field("NbPoseNodes", static_cast<std::int32_t>(bound_));
  // The id at the end of the file must match this date and id; some programs check that.
  constexpr std::string_view kFileId(
      "\x28\xb3\x2a\xeb\xb6\x24\xcc\xc2\xbf\xc8\xb0\x2a\xa9\x2b\xfc\xf1", 16);
  objects_.records.splice(objects_.records.end(), pose_.records);
  FbxOutRecord top;
  top.records.push_back(head(version));
  top.record("FileId").raw(kFileId);
  top.field("CreationTime", std::string_view("1970-01-01 10:00:00:000"));
  top.field("Creator", std::string_view("Mocapress"));
  top.records.push_back(settings());
  FbxOutRecord& documents = top.record("Documents");
  documents.field("Count", std::int32_t{1});
  FbxOutRecord& document = documents.record("Document");
  document.value(kDocument).value(std::string_view()).value(std::string_view("Scene"));
  document.field("RootNode", kNoObject);
  top.record("References");
  top.records.push_back(definitions());
  top.records.push_back(std::move(objects_));
  top.records.push_back(std::move(connections_));
  top.record("Takes");
  return fbx_file_bytes(version, top.records);
}

}  // namespace

SourceFormat fbx_format(const SourceFormat& source, const WriteOptions& options) {
  SourceFormat format{SourceFormat::Kind::Fbx, 1, source.up};
  if (source.kind == SourceFormat::Kind::Fbx) format = source;
  format.cm_per_unit = options.cm_per_unit.value_or(format.cm_per_unit);
  format.up = options.up.value_or(format.up);
  return format;
}

std::vector<std::string> fbx_names(const Skeleton& skeleton) {
  std::vector<std::string> names;
  std::unordered_set<std::string> taken;
  for (const Joint& joint : skeleton.joints())
    names.push_back(unique_word(joint.name.empty() ? "joint" : joint.name, taken));
  return names;
}

std::string fbx_bytes(const std::vector<FbxClip>& clips, const SourceFormat& source,
                      const WriteOptions& options) {
  const int version = options.fbx_version.value_or(kUsualFbxVersion);
  if (version != 7400 && version != 7700)
    throw Error("an FBX is written as version 7.4 or 7.7 only");
  const SourceFormat format = fbx_format(source, options);
  const Motion first = exported_motion(clips.front().motion, format, options);
  // The first root rests at the origin: Blender computes the direction of a bone of length zero in
  // floats, which are not exact enough far from the origin.
  Pose rest = resting_pose(first, source);
  const Vector3d root = rest.origin.empty() ? Vector3d(Vector3d::Zero()) : rest.origin.front();
  for (Vector3d& origin : rest.origin) origin -= root;
  const auto tracks = [&](const Motion& motion, const ScalarTracks& scalars) {
    return tracks_of(motion, rest, format.cm_per_unit, JointScales(scalars, motion.skeleton));
  };
  std::vector<NodeTrack> nodes = tracks(first, clips.front().tracks);
  FbxDocument document(first, nodes, format);
  document.add_take(clips.front().take, first.clip, nodes, clips.front().tracks);
  for (std::size_t c = 1; c < clips.size(); ++c) {
    const Motion motion = exported_motion(clips[c].motion, format, options);
    document.add_take(clips[c].take, motion.clip, tracks(motion, clips[c].tracks), clips[c].tracks);
  }
  return document.bytes(version);
}

std::string fbx_bytes(const Motion& motion, const SourceFormat& source, const WriteOptions& options,
                      const ScalarTracks& tracks) {
  return fbx_bytes({{"Take 001", motion, tracks}}, source, options);
}

}  // namespace mocapress
