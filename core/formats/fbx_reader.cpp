// SPDX-License-Identifier: MIT
// assimp reads all transforms of a node as one, if told not to keep pivots, but then drops what it
// needs to animate the pivots of some nodes: their channels are named after helper nodes that are
// not there. Such a file is read again with its helpers.
#include <assimp/config.h>
#include <assimp/defs.h>
#include <assimp/scene.h>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <map>
#include <memory>
#include <numbers>
#include <stdexcept>
#include <unordered_map>
#include <unordered_set>

#include "core/base/memory_limit.h"
#include "core/formats/fbx_meshes.h"
#include "core/formats/fbx_reader.h"
#include "core/formats/fbx_structure.h"
#include "core/formats/key_times.h"
#include "core/formats/node_motion.h"
#include "core/formats/take_choice.h"
#include "core/runtime/format/format_limits.h"

namespace mocapress {
namespace {

constexpr std::size_t kMostBytes = std::size_t{512} << 20;
constexpr std::string_view kHelper = "_$AssimpFbx$_";
constexpr double kMetadataSaysDefault = 1;  // frames per second, where the file states none

Eigen::Vector3d vector_of(const aiVector3D& v) {
  return {v.x, v.y, v.z};
}

Eigen::Quaterniond quaternion_of(const aiQuaternion& q) {
  return {q.w, q.x, q.y, q.z};
}

bool is_helper_name(std::string_view name) {
  return name.find(kHelper) != name.npos;
}

LocalTransform local_of(const aiMatrix4x4& parent_from_node) {
  aiVector3D scale;
  aiVector3D translation;
  aiQuaternion rotation;
  parent_from_node.Decompose(scale, rotation, translation);
  return {vector_of(translation), quaternion_of(rotation), vector_of(scale)};
}

template <typename Number>
std::optional<Number> metadata(const aiScene& scene, const char* key) {
  Number value{};
  if (scene.mMetaData == nullptr || !scene.mMetaData->Get(key, value)) return std::nullopt;
  return value;
}

/// The value of a key and the one after it at a time, in ticks; `key` goes on from call to call.
template <typename Key, typename Between>
auto sampled(const Key* keys, unsigned count, unsigned& key, double ticks, const Between& between) {
  while (key + 1 < count && keys[key + 1].mTime <= ticks) ++key;
  const double begin = keys[key].mTime;
  if (key + 1 == count || ticks <= begin) return between(keys[key].mValue, keys[key].mValue, 0.0);
  const double share = (ticks - begin) / (keys[key + 1].mTime - begin);
  return between(keys[key].mValue, keys[key + 1].mValue, share);
}

Eigen::Vector3d straight(const aiVector3D& a, const aiVector3D& b, double share) {
  return (1 - share) * vector_of(a) + share * vector_of(b);
}

Eigen::Quaterniond shortest_way(const aiQuaternion& a, const aiQuaternion& b, double share) {
  return quaternion_of(a).normalized().slerp(share, quaternion_of(b).normalized());
}

/// Assimp repeats the file from where it fails.
std::string shortened(const std::string& reason) {
  constexpr std::size_t kLongest = 120;
  return reason.substr(0, std::min(reason.find_first_of("\r\n"), kLongest));
}

class FbxReader {
 public:
  FbxReader(const std::string& file, std::string_view bytes, const ReadOptions& options)
      : file_(file), bytes_(bytes), options_(options) {}

  MotionFile read();
  Character read_character();

 private:
  void check_bytes() const;
  void load(bool with_helpers);
  const aiAnimation& chosen_take();
  void map_channels(const aiAnimation& animation);
  void read_nodes();
  void mark_joints(const std::vector<const aiNode*>& sources);
  void still_helpers();
  void settle_axes();
  void sample(const aiAnimation& animation);
  void sample_weights(const aiAnimation& animation, const SampleTimes& times);
  const aiMesh* mesh_of(const aiMeshMorphAnim& weights) const;
  void sample_node(const aiNodeAnim& channel, const SampleTimes& times, double ticks_per_second,
                   AnimatedNode& node) const;

  [[noreturn]] void refuse(const std::string& what) const { throw InputError(file_, 0, 0, what); }
  void warn(std::string message) { warnings_.push_back({file_, 0, std::move(message)}); }

  const std::string& file_;
  std::string_view bytes_;
  const ReadOptions& options_;
  std::unique_ptr<Assimp::Importer> importer_;
  const aiScene* scene_ = nullptr;
  std::unordered_map<std::string, const aiNodeAnim*> channels_;  // of the take, by node
  NodeTake take_;
  Takes takes_;
  Warnings warnings_;
};

void FbxReader::check_bytes() const {
  if (bytes_.size() > kMostBytes) refuse("has more than 512 MiB");
  check_fbx_structure(file_, bytes_);
}

Character FbxReader::read_character() {
  check_bytes();
  load(false);
  read_nodes();
  settle_axes();
  return character_of(file_, take_);
}

MotionFile FbxReader::read() {
  check_bytes();
  load(false);
  const aiAnimation* animation = &chosen_take();
  map_channels(*animation);
  if (std::any_of(channels_.begin(), channels_.end(),
                  [](const auto& channel) { return is_helper_name(channel.first); })) {
    load(true);
    warnings_.clear();
    animation = &chosen_take();
    map_channels(*animation);
  }
  read_nodes();
  settle_axes();
  sample(*animation);
  MotionFile result = motion_of(file_, take_, options_, SourceFormat::Kind::Fbx);
  result.warnings.insert(result.warnings.begin(), warnings_.begin(), warnings_.end());
  result.takes = std::move(takes_);
  return result;
}

void FbxReader::load(bool with_helpers) {
  importer_ = std::make_unique<Assimp::Importer>();
  importer_->SetPropertyBool(AI_CONFIG_IMPORT_FBX_PRESERVE_PIVOTS, with_helpers);
  importer_->SetPropertyBool(AI_CONFIG_IMPORT_FBX_READ_MATERIALS, true);
  importer_->SetPropertyBool(AI_CONFIG_IMPORT_FBX_READ_TEXTURES, true);
  importer_->SetPropertyBool(AI_CONFIG_IMPORT_REMOVE_EMPTY_BONES, false);
  scene_ = importer_->ReadFileFromMemory(bytes_.data(), bytes_.size(), 0, "fbx");
  if (scene_ != nullptr && scene_->mRootNode != nullptr) return;
  const std::string error = importer_->GetErrorString();
  refuse("cannot be read as FBX: " + shortened(error));
}

const aiAnimation& FbxReader::chosen_take() {
  std::vector<TakeName> takes;
  for (unsigned a = 0; a < scene_->mNumAnimations; ++a)
    takes.push_back(
        {scene_->mAnimations[a]->mName.C_Str(), scene_->mAnimations[a]->mNumChannels > 0});
  const std::size_t chosen = choose_take(file_, takes, options_.take, warnings_);
  takes_ = choices(takes, chosen);
  if (!options_.take && !takes[chosen].moves) refuse("holds no keys");
  const aiAnimation& animation = *scene_->mAnimations[chosen];
  const std::vector<std::string> layered = layered_fbx_takes(bytes_);
  if (std::find(layered.begin(), layered.end(), animation.mName.C_Str()) != layered.end())
    refuse("its take " + std::string(animation.mName.C_Str()) +
           " moves the same node in several animation layers: bake them into one");
  return animation;
}

void FbxReader::map_channels(const aiAnimation& animation) {
  channels_.clear();
  for (unsigned c = 0; c < animation.mNumChannels; ++c) {
    const aiNodeAnim* channel = animation.mChannels[c];
    if (channel->mNumPositionKeys + channel->mNumRotationKeys + channel->mNumScalingKeys > 0)
      channels_.emplace(channel->mNodeName.C_Str(), channel);
  }
}

/// All nodes but leaves that only draw, light or look.
void FbxReader::read_nodes() {
  std::unordered_set<std::string> onlookers;
  for (unsigned i = 0; i < scene_->mNumCameras; ++i)
    onlookers.insert(scene_->mCameras[i]->mName.C_Str());
  for (unsigned i = 0; i < scene_->mNumLights; ++i)
    onlookers.insert(scene_->mLights[i]->mName.C_Str());
  const auto is_empty_leaf = [&](const aiNode& node) {
    const std::string name = node.mName.C_Str();
    const bool only_draws = node.mNumMeshes > 0 && !channels_.contains(name);
    return node.mNumChildren == 0 && (only_draws || onlookers.contains(name));
  };
  std::vector<const aiNode*> sources = {scene_->mRootNode};
  take_.nodes.push_back({.name = scene_->mRootNode->mName.C_Str(),
                         .rest = local_of(scene_->mRootNode->mTransformation)});
  for (std::size_t i = 0; i < sources.size(); ++i)  // both grow
    for (unsigned c = 0; c < sources[i]->mNumChildren; ++c) {
      const aiNode& child = *sources[i]->mChildren[c];
      if (is_empty_leaf(child)) continue;
      sources.push_back(&child);
      take_.nodes.push_back({.name = child.mName.C_Str(),
                             .parent = static_cast<int>(i),
                             .rest = local_of(child.mTransformation)});
    }
  mark_joints(sources);
  still_helpers();
  std::unordered_map<const aiNode*, int> index_of;
  for (std::size_t i = 0; i < sources.size(); ++i)
    index_of.emplace(sources[i], static_cast<int>(i));
  take_.meshes = fbx_meshes(*scene_, take_.nodes, index_of, {file_, warnings_});
}

/// The bones of skins and what carries them; without skins, whatever is not Null, mesh, camera or
/// light. So clips of one figure have the same joints, whichever of them move.
void FbxReader::mark_joints(const std::vector<const aiNode*>& sources) {
  std::unordered_set<std::string> bones;
  for (unsigned m = 0; m < scene_->mNumMeshes; ++m)
    for (unsigned b = 0; b < scene_->mMeshes[m]->mNumBones; ++b)
      bones.insert(scene_->mMeshes[m]->mBones[b]->mName.C_Str());
  const auto may_be_joint = [&](const aiNode& node) {
    bool is_null = true;  // of helpers and of the scene, which say nothing
    if (node.mMetaData != nullptr) node.mMetaData->Get("IsNull", is_null);
    return !is_null && node.mNumMeshes == 0;
  };
  std::vector<bool> carries(sources.size(), bones.empty());
  for (std::size_t i = sources.size(); i-- > 0;) {
    AnimatedNode& node = take_.nodes[i];
    const bool is_bone = bones.contains(node.name);
    node.joint = is_bone || (carries[i] && may_be_joint(*sources[i]));
    if ((is_bone || carries[i]) && node.parent >= 0)
      carries[static_cast<std::size_t>(node.parent)] = true;
  }
}

/// A channel of a node holds what its helpers do as well.
void FbxReader::still_helpers() {
  for (AnimatedNode& node : take_.nodes)
    if (const std::size_t helper = node.name.find(kHelper);
        helper != node.name.npos && channels_.contains(node.name.substr(0, helper)))
      node.rest = {};
}

void FbxReader::settle_axes() {
  const auto unit = metadata<float>(*scene_, "UnitScaleFactor");
  if (unit && *unit >= 1e-6F && *unit <= 1e6F) take_.cm_per_unit = *unit;
  switch (metadata<std::int32_t>(*scene_, "UpAxis").value_or(1)) {
    case 0:  // X, which only a turn of everything can say
      take_.nodes.front().rest.rotation =
          Eigen::AngleAxisd(std::numbers::pi / 2, Eigen::Vector3d::UnitZ()) *
          take_.nodes.front().rest.rotation;
      break;
    case 2:
      take_.up = UpAxis::Z;
      break;
    default:
      break;
  }
}

void FbxReader::sample(const aiAnimation& animation) {
  const double stated_hz = animation.mTicksPerSecond;
  if (!(stated_hz >= 1e-3 && stated_hz <= 1e6)) refuse("has an impossible frame rate");
  std::vector<std::pair<AnimatedNode*, const aiNodeAnim*>> moving;
  std::vector<double> keys_s;
  for (AnimatedNode& node : take_.nodes) {
    const auto channel = channels_.extract(node.name);  // of nodes of one name the first
    if (channel.empty()) continue;
    moving.emplace_back(&node, channel.mapped());
    const auto add_times = [&](const auto* keys, unsigned count) {
      std::vector<double> times;
      for (unsigned k = 0; k < count; ++k) times.push_back(keys[k].mTime / stated_hz);
      if (!std::all_of(times.begin(), times.end(), [](double t) { return std::isfinite(t); }))
        refuse("has keys at impossible times");
      keys_s = merged_times(keys_s, std::move(times));
    };
    add_times(channel.mapped()->mPositionKeys, channel.mapped()->mNumPositionKeys);
    add_times(channel.mapped()->mRotationKeys, channel.mapped()->mNumRotationKeys);
    add_times(channel.mapped()->mScalingKeys, channel.mapped()->mNumScalingKeys);
  }
  for (unsigned m = 0; m < animation.mNumMorphMeshChannels; ++m) {
    std::vector<double> of_weights;
    const aiMeshMorphAnim& weights = *animation.mMorphMeshChannels[m];
    for (unsigned k = 0; k < weights.mNumKeys; ++k)
      if (const double time = weights.mKeys[k].mTime / stated_hz; std::isfinite(time))
        of_weights.push_back(time);
    keys_s = merged_times(keys_s, std::move(of_weights));
  }
  if (keys_s.empty()) refuse("its take " + std::string(animation.mName.C_Str()) + " moves no node");
  std::size_t morphs = 0;
  for (unsigned m = 0; m < animation.mNumMorphMeshChannels; ++m)
    if (const aiMesh* const mesh = mesh_of(*animation.mMorphMeshChannels[m]))
      morphs += mesh->mNumAnimMeshes;
  const SampleTimes times = sample_times(
      file_, keys_s, stated_hz > kMetadataSaysDefault ? std::optional(stated_hz) : std::nullopt,
      options_.sample_rate_hz, moving.size() + morphs);
  if (!times.warning.empty()) warn(times.warning);
  take_.name = animation.mName.C_Str();
  take_.frames = times.frames;
  take_.sample_rate_hz = times.rate_hz;
  for (const auto& [node, channel] : moving) sample_node(*channel, times, stated_hz, *node);
  sample_weights(animation, times);
}

/// The channel is named after the node and the number of its mesh: "Face*0".
const aiMesh* FbxReader::mesh_of(const aiMeshMorphAnim& weights) const {
  const std::string name = weights.mName.C_Str();
  const std::size_t star = name.rfind('*');
  const aiNode* const node = scene_->mRootNode->FindNode(name.substr(0, star).c_str());
  const unsigned long number = star == name.npos ? 0 : std::strtoul(&name[star + 1], nullptr, 10);
  if (node == nullptr || number >= node->mNumMeshes) return nullptr;
  return scene_->mMeshes[node->mMeshes[number]];
}

/// Morph weights. A key has those that were keyed at its time. Curves of other properties are not
/// to be had from assimp.
void FbxReader::sample_weights(const aiAnimation& animation, const SampleTimes& times) {
  for (unsigned m = 0; m < animation.mNumMorphMeshChannels; ++m) {
    const aiMeshMorphAnim& channel = *animation.mMorphMeshChannels[m];
    const aiMesh* const mesh = mesh_of(channel);
    if (mesh == nullptr) continue;
    const std::string name = channel.mName.C_Str();
    std::map<unsigned, std::vector<aiVectorKey>> keys;  // of each weight, in x
    for (unsigned k = 0; k < channel.mNumKeys; ++k)
      for (unsigned w = 0; w < channel.mKeys[k].mNumValuesAndWeights; ++w)
        keys[channel.mKeys[k].mValues[w]].emplace_back(
            channel.mKeys[k].mTime,
            aiVector3D(static_cast<ai_real>(channel.mKeys[k].mWeights[w]), 0, 0));
    for (const auto& [target, of_target] : keys) {
      if (target >= mesh->mNumAnimMeshes) continue;
      ScalarTrack track{.kind = TrackKind::MorphWeight,
                        .node = name.substr(0, name.rfind('*')),
                        .name = mesh->mAnimMeshes[target]->mName.C_Str(),
                        .values = {}};
      unsigned key = 0;
      for (int t = 0; t < times.frames; ++t) {
        const double ticks = times.at(t) * animation.mTicksPerSecond;
        track.values.push_back(static_cast<float>(
            sampled(of_target.data(), static_cast<unsigned>(of_target.size()), key, ticks, straight)
                .x()));
      }
      const auto is_weight = [](float v) { return std::abs(v) <= 1e9F; };
      if (!std::all_of(track.values.begin(), track.values.end(), is_weight))
        refuse("has a morph weight that is not finite, or beyond 1e9");
      if (std::max(track.node.size(), track.name.size()) > runtime::kMostNameBytes ||
          take_.tracks.size() == runtime::kMostTracks)
        refuse("has too many morph weights, or names too long for them");
      take_.tracks.push_back(std::move(track));
    }
  }
}

void FbxReader::sample_node(const aiNodeAnim& channel, const SampleTimes& times,
                            double ticks_per_second, AnimatedNode& node) const {
  node.frames.assign(static_cast<std::size_t>(times.frames), node.rest);
  unsigned position = 0;
  unsigned rotation = 0;
  unsigned scale = 0;
  for (int t = 0; t < times.frames; ++t) {
    const double ticks = times.at(t) * ticks_per_second;
    LocalTransform& local = node.frames[static_cast<std::size_t>(t)];
    if (channel.mNumPositionKeys > 0)
      local.translation =
          sampled(channel.mPositionKeys, channel.mNumPositionKeys, position, ticks, straight);
    if (channel.mNumRotationKeys > 0)
      local.rotation =
          sampled(channel.mRotationKeys, channel.mNumRotationKeys, rotation, ticks, shortest_way);
    if (channel.mNumScalingKeys > 0)
      local.scale = sampled(channel.mScalingKeys, channel.mNumScalingKeys, scale, ticks, straight);
  }
}

/// What assimp throws, and want of memory, are said as what is wrong with the file.
template <typename Read>
auto told_in_one_sentence(const std::string& file, const Read& read) {
  try {
    return read();
  } catch (const Error&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw_out_of_memory(file);
  } catch (const std::exception& error) {  // of assimp, of memory
    throw InputError(file, 0, 0, "cannot be read as FBX: " + shortened(error.what()));
  }
}

}  // namespace

MotionFile read_fbx(const std::string& file, std::string_view bytes, const ReadOptions& options) {
  return told_in_one_sentence(file, [&] { return FbxReader(file, bytes, options).read(); });
}

Character read_fbx_character(const std::string& file, std::string_view bytes) {
  const ReadOptions as_it_says;
  return told_in_one_sentence(file,
                              [&] { return FbxReader(file, bytes, as_it_says).read_character(); });
}

}  // namespace mocapress

// Debian builds assimp with its assertions, some of which broken files fail. The program would end:
// this stands in for the function that they call. Assimp passes exceptions on.
namespace Assimp {
ASSIMP_API void aiAssertViolation(const char* expression, const char*, int);
void aiAssertViolation(const char* expression, const char*, int) {
  throw std::runtime_error(std::string("assimp expects ") + expression);
}
}  // namespace Assimp
