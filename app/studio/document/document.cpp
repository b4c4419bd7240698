// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/document/document.h"

#include <QFileInfo>
#include <utility>

#include "app/jobs/result_cache.h"
#include "app/studio/document/named_settings.h"
#include "app/studio/document/settings_field.h"
#include "core/codec/encode/track_encoder.h"
#include "core/motion/forward_kinematics.h"
#include "core/motion/landmarks.h"
#include "core/motion/rig.h"

namespace mocapress {
namespace {

/// Options that would make the decoded clip again.
EncodeSettings optionsOf(const DecodedClip& decoded) {
  const CompressedClip& clip = decoded.compressed;
  EncodeSettings options;
  options.method = clip.provenance.method;
  options.coding = clip.coding;
  options.basis = clip.basis;
  options.weighting = clip.provenance.weighting;
  options.target = {Target::Kind::Ratio, decoded.ratio};
  options.seed = clip.provenance.seed;
  if (clip.correction) {
    options.correction = EncodeCorrection{.solver = clip.correction->solver};
    for (const Effector& effector : clip.correction->effectors)
      options.correction->joints.push_back(effector.joint);
  }
  return options;
}

/// Carries factors over to joints of the same names.
Importance carriedOver(const Importance& importance, const Skeleton* from, const Skeleton& to) {
  if (!from || std::ssize(importance.joints) != from->joint_count())
    return {.joints = {}, .contacts = importance.contacts};
  NamedImportance names = named(importance, *from);
  std::erase_if(names.factors, [&](const auto& factor) {
    return !is_body_part(factor.first) && to.find(factor.first) < 0;
  });
  return importance_for(names, to);
}

}  // namespace

Document::Document(QObject* parent) : QObject(parent) {
  tuning_.both.fill(usualSettings());
}

QString Document::title() const {
  if (!saved_path_.isEmpty()) return QFileInfo(saved_path_).fileName();
  return original_ ? QFileInfo(original_->path).fileName() : QString();
}

SourceFormat Document::source() const {
  if (original_) return original_->source;
  return decoded_ ? decoded_->source : SourceFormat();
}

bool Document::modified() const {
  const bool same_file = decoded_ == saved_ || (decoded_ && saved_ && !decoded_->file.empty() &&
                                                decoded_->file == saved_->file);
  return touched_ && original_ &&
         (!same_file ||
          (!original_->scalars.empty() && settings().track_error != saved_track_error_));
}

const CodedTracks& Document::codedTracks() const {
  if (coded_original_ != original_ || coded_error_ != settings().track_error) {
    coded_original_ = original_;
    coded_error_ = settings().track_error;
    coded_tracks_ = original_ ? encode_tracks(original_->scalars, coded_error_) : CodedTracks();
  }
  return coded_tracks_;
}

const Skeleton* Document::skeleton() const {
  if (original_) return &original_->motion().skeleton;
  return decoded_ ? &decoded_->compressed.skeleton : nullptr;
}

int Document::frames() const {
  if (original_) return original_->motion().clip.frames();
  return decoded_ ? decoded_->compressed.frames : 0;
}

double Document::sampleRate() const {
  if (original_) return original_->motion().clip.sample_rate_hz;
  return decoded_ ? decoded_->compressed.sample_rate_hz : Clip().sample_rate_hz;
}

int Document::currentJoint() const {
  return skeleton() ? skeleton()->find(current_joint_.toStdString()) : -1;
}

/// Importance for the skeleton of another clip. While the settings are those of the usual preset,
/// its factors are taken from the preset again: those for hands return even after a clip without
/// hands.
Importance Document::importanceIn(const Skeleton& next) const {
  const Settings& usual = usualPreset();
  if (isAsPreset(settings(), usual, skeleton() ? *skeleton() : Skeleton()))
    return importance_for(usual.importance, next);
  return carriedOver(options().importance, skeleton(), next);
}

void Document::setClip(OriginalPtr original, DecodedPtr decoded, const QString& saved_path,
                       const Characters& read) {
  for (auto& [rig, put] : characters_)
    if (const auto found = read.find(rig); found != read.end() && found->second.path == put.path)
      put = found->second;
  ClipSettings& now = tuning_.now();
  // Without any clip, factors of single joints are dropped, since they would have no skeleton.
  if (original || !decoded)
    now.encode.importance = importanceIn(original ? original->motion().skeleton : Skeleton());
  original_ = std::move(original);
  decoded_ = std::move(decoded);
  final_ = decoded_ != nullptr;
  unanswered_ = false;
  saved_path_ = saved_path;
  saved_ = decoded_;
  saved_track_error_ = settings().track_error;
  touched_ = false;
  if (decoded_) {
    now.encode = optionsOf(*decoded_);
    now.preset.clear();
  }
  if (!decoded_ && now.encode.correction)
    now.encode.correction->joints.clear();  // indices of another skeleton's joints
  for (ClipSettings& each : tuning_.both) {
    each.encode.contacts = contactsBy(each.contacts);
    each.encode.ranges.clear();  // frames of another clip
    each.encode.loop.reset();
  }
  leaveMissingSkin();
  findSkin();
  emit clipChanged();
  emit optionsChanged();
  emit decodedChanged();
  emit shownChanged();
  emit titleChanged();
}

void Document::announce() {
  emit clipChanged();
  emit skinChanged();
  emit optionsChanged();
  emit decodedChanged();
  emit shownChanged();
  emit curvesChanged();
  emit currentJointChanged();
  emit titleChanged();
}

/// Replaces a weighting by skin if the clip has no skin any more.
void Document::leaveMissingSkin() {
  if (!skeleton() || skeleton()->skin()) return;
  for (ClipSettings& each : tuning_.both)
    if (each.encode.weighting == Weighting::Skin) each.encode.weighting = Weighting::Surface;
}

void Document::setDressed(OriginalPtr original, DecodedPtr decoded) {
  original_ = std::move(original);
  if (saved_ == decoded_) saved_ = decoded;
  decoded_ = std::move(decoded);
  leaveMissingSkin();
  emit skinChanged();
  emit optionsChanged();
  emit decodedChanged();
  emit shownChanged();
}

void Document::setDecoded(DecodedPtr decoded, bool final) {
  decoded_ = std::move(decoded);
  final_ = final;
  unanswered_ = false;
  emit decodedChanged();
  emit shownChanged();
  emit titleChanged();
}

void Document::setUnanswered() {
  final_ = true;
  unanswered_ = true;
  emit decodedChanged();
  emit shownChanged();
  emit titleChanged();
}

void Document::setOptions(const EncodeSettings& options) {
  tuning_.now().encode = options;
  touched_ = true;
  emit optionsChanged();
}

void Document::setTuning(const Tuning& tuning) {
  const ClipSettings before = settings();
  tuning_ = tuning;
  if (firstDifference(before, settings()) == SettingsField::None) return;
  // Another viewing distance or other limits change only how the same file is judged.
  touched_ = touched_ || bytesKey(before.encode) != bytesKey(options()) ||
             before.track_error != settings().track_error;
  emit optionsChanged();
}

void Document::loadOptions(EncodeSettings options) {
  ClipSettings& now = tuning_.now();
  options.contacts = now.encode.contacts;
  options.ranges = now.encode.ranges;
  now.encode = std::move(options);
  now.preset.clear();
  emit optionsChanged();
}

void Document::loadSettings(const ClipSettings& settings) {
  tuning_.now() = settings;
  emit optionsChanged();
  emit shownChanged();
}

void Document::loadTuning(const Tuning& tuning) {
  tuning_ = tuning;
  emit optionsChanged();
  emit shownChanged();
}

void Document::beginSlots() {
  tuning_.both.fill(ClipSettings(settings()));
  tuning_.active = 0;
}

std::optional<std::vector<ContactSpan>> Document::contactsBy(
    const ContactSettings& settings) const {
  if (!original_ || settings == ContactSettings()) return {};
  const Motion& motion = original_->motion();
  return find_foot_contacts(motion.skeleton, original_->encoder->original_tracks(),
                            motion.clip.sample_rate_hz, settings);
}

std::vector<ContactSpan> Document::contacts() const {
  if (!original_) return {};
  return options().contacts ? *options().contacts : original_->encoder->contacts();
}

void Document::setUncorrected(bool uncorrected) {
  uncorrected_ = uncorrected;
  emit shownChanged();
}

Tracks Document::shownTracks() const {
  if (!decoded_) return nullptr;
  return uncorrected() ? decoded_->uncorrected_tracks : decoded_->tracks;
}

Poses Document::shownPoses() const {
  if (!decoded_) return {};
  return uncorrected() ? posesOf(decoded_->uncorrected) : posesOf(decoded_);
}

void Document::findSkin() {
  skin_ = ownSkin();
  const auto& [skeleton_of_it, skin] = character().character;
  if (!skin) return;
  try {
    Skin bound = bound_to(*skin, skeleton_of_it, *skeleton());
    bound.lengths.centre = start();
    skin_ = std::make_shared<const Skin>(std::move(bound));
  } catch (const Error&) {
    // The character has other joints: the clip keeps its own skin.
  }
}

QString Document::wornFile() const {
  const PutCharacter put = character();
  if (!put.path.isEmpty()) return put.character.skin ? put.path : QString();
  return original_ && original_->skin ? original_->path : QString();
}

/// The root's position in the first frame, projected onto the floor.
Eigen::Vector3d Document::start() const {
  const Clip& clip = original_ ? original_->motion().clip : decoded_->clip;
  Pose pose;
  compute_pose(*skeleton(), clip.channels.row(0), pose);
  return {pose.origin[0].x(), 0, pose.origin[0].z()};
}

void Document::setCharacters(const Characters& characters) {
  characters_ = characters;
  findSkin();
  emit skinChanged();
}

PutCharacter Document::character() const {
  return skeleton() ? characterOn(characters_, *skeleton()) : PutCharacter();
}

const Footskate* Document::shownFootskate() const {
  if (!decoded_) return nullptr;
  const auto& shown = uncorrected() ? decoded_->uncorrected_footskate : decoded_->footskate;
  return shown ? &*shown : nullptr;
}

void Document::setCurves(const CurveSelection& curves) {
  if (curves == curves_) return;
  curves_ = curves;
  emit curvesChanged();
}

void Document::setCurrentJoint(int joint) {
  const QString name =
      joint >= 0 ? QString::fromStdString(skeleton()->joint(joint).name) : QString();
  if (name == current_joint_) return;
  current_joint_ = name;
  emit currentJointChanged();
}

void Document::setSaved(const DecodedPtr& decoded, const QString& path) {
  saved_ = decoded;
  saved_path_ = path;
  saved_track_error_ = settings().track_error;
  touched_ = true;
  emit titleChanged();
}

std::vector<QString> Document::landmarkNames() const {
  std::vector<QString> names;
  if (!skeleton()) return names;
  const std::size_t shared = shared_namespace(*skeleton()).size();
  for (const Landmark& point : landmarks(*skeleton()))
    names.push_back(QString::fromStdString(point.name.substr(shared)));
  return names;
}

}  // namespace mocapress
