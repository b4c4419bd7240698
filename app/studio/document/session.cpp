// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/document/session.h"

#include <QFileInfo>
#include <algorithm>
#include <numeric>

#include "app/jobs/clips.h"
#include "app/jobs/result_cache.h"
#include "app/studio/document/edit_step.h"
#include "app/studio/document/named_settings.h"
#include "app/studio/document/settings_field.h"
#include "core/base/error.h"
#include "core/batch/row.h"
#include "core/codec/decode/track_decoding.h"
#include "core/formats/motion_file.h"
#include "core/motion/landmarks.h"
#include "core/motion/rig.h"
#include "core/motion/surface_points.h"
#include "widgets/models/library_model.h"
#include "widgets/models/report_texts.h"

namespace mocapress {
namespace {

constexpr std::size_t kFirstCurves = 3;

/// Indices of columns by descending mean.
std::vector<int> worstFirst(const Eigen::MatrixXf& distances) {
  const Eigen::RowVectorXf mean = distances.colwise().mean();
  std::vector<int> order(static_cast<std::size_t>(mean.size()));
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return mean[a] > mean[b]; });
  return order;
}

SlotFigures figuresOf(const DecodedClip& decoded) {
  const Weighting weighting = decoded.compressed.provenance.weighting;
  return {decoded.ratio, decoded.distortion->eps(weighting), weighting};
}

QString keyOf(const OriginalClip& clip) {
  return clipKey(clip.path, clip.reading.take);
}

QString absolute(const QString& path) {
  return QFileInfo(path).absoluteFilePath();
}

}  // namespace

Session::Session(QObject* parent) : QObject(parent) {
  past_ = &pasts_[QString()];
  connect(&compressor_, &Compressor::answered, this, &Session::answer);
  connect(&compressor_, &Compressor::progressed, this, &Session::annealed);
  connect(&compressor_, &Compressor::refiningChanged, this, &Session::refiningChanged);
  connect(&compressor_, &Compressor::failed, this,
          [this](const QString& message, bool out_of_reach) {
            document_.setUnanswered();
            emit compressFailed(message, out_of_reach);
          });
}

void Session::open(const QString& path, const QString& skeleton,
                   const std::optional<ReadOptions>& reading) {
  // A .mcpr that is shown without its original accepts one.
  const bool waits = document_.decoded() && !document_.original();
  start({.path = absolute(path),
         .skeleton = skeleton,
         .original = document_.original(),
         .decoded = waits ? document_.decoded() : nullptr,
         .reading = reading});
}

void Session::closeClip() {
  opening_.abandon();
  leave();
  compressor_.setEncoder(nullptr);
  document_.setClip(nullptr, nullptr, {});
  wearing_.abandon();
  takeUp({}, false);
  emit slotsChanged();
}

void Session::close() {
  dressing_.abandon();
  closeClip();
  document_.setCharacters({});
}

bool Session::isOpen(const QString& path) const {
  return document_.original() && document_.original()->path == absolute(path);
}

QString Session::openKey() const {
  return document_.original() ? keyOf(*document_.original()) : QString();
}

void Session::compareWith(const QString& path, const QString& skeleton) {
  start({absolute(path), skeleton, nullptr, document_.decoded(), true});
}

void Session::openRow(const StudyRow& row, const QString& skeleton) {
  OpenRequest request = requestOf(row);
  request.skeleton = skeleton;
  request.original = document_.original();
  if (!isOpen(request.path) || !request.comparison.empty()) return start(request);
  opening_.abandon();
  const Tuning before = document_.tuning();
  EncodeSettings wanted = *request.options;
  wanted.contacts = before.now().encode.contacts;
  wanted.ranges = before.now().encode.ranges;
  wanted.limits = before.now().encode.limits;
  if (settingsKey(wanted) == settingsKey(before.now().encode))
    return apply(before);  // nothing to undo
  document_.loadOptions(wanted);
  changeTuning(before, document_.tuning());
}

void Session::readAgain(const ReadOptions& reading) {
  readAs([] { return tr("Import Options"); }, reading);
}

void Session::chooseTake(int take) {
  const OriginalPtr& original = document_.original();
  if (!original || take == static_cast<int>(original->takes.read)) return;
  ReadOptions reading = original->reading;
  reading.take = original->takes.keys.at(static_cast<std::size_t>(take));
  open(original->path, original->skeleton, reading);
}

void Session::readAs(const std::function<QString()>& step, const ReadOptions& reading) {
  const OriginalPtr& original = document_.original();
  if (!original || original->reading == reading) return;
  // A step is pushed only after reading succeeds, since the file may be gone.
  readBy(reading, [this, step, reading, before = original->reading] {
    history()->push(new EditStep(
        step, [this, reading] { readBy(reading); }, [this, before] { readBy(before); }));
  });
}

void Session::readBy(const ReadOptions& reading, std::function<void()> then) {
  const OriginalPtr& original = document_.original();
  if (!original || (original->reading == reading && !opening_.busy())) return;
  start({.path = original->path,
         .skeleton = original->skeleton,
         .original = original,
         .reading = reading},
        std::move(then));
}

void Session::start(OpenRequest request, std::function<void()> then) {
  if (!request.reading && reading_memory_) request.reading = reading_memory_(request.path);
  request.characters = document_.characters();
  request.limits = document_.options().limits;
  if (request.options) request.options->limits = request.limits;
  emit opening(request.path);
  opening_.start([request](const Job& job) { return openClip(request, job); },
                 [this, request, then = std::move(then)](const OpenedClip& opened) {
                   show(opened, request);
                   if (then) then();
                 },
                 [this, request](const QString& message) {
                   emit openFailed(request, message);
                   if (document_.original()) compressor_.request(document_.options());
                 });
}

namespace {

/// A key that is equal only for clips whose compression gives equal results. Empty: unknown, as for
/// a clip with a character from another file.
std::string contentOf(const OriginalClip& clip) {
  if (clip.stamp.hash.empty() || !clip.character.isEmpty() || clip.reading.character) return {};
  return clip.stamp.hash + ' ' + settings_hash({}, clip.reading);
}

}  // namespace

void Session::show(const OpenedClip& opened, const OpenRequest& request) {
  const bool together = opened.original && opened.decoded;
  const QString saved_path = isCompressedFile(request.path) ? request.path
                             : together                     ? document_.savedPath()
                                                            : QString();
  // If the open file was read again with other options, earlier steps can still be undone.
  const bool again = opened.original && opened.original != document_.original() &&
                     keyOf(*opened.original) == openKey();
  leave();
  if (opened.original)
    compressor_.setEncoder(opened.original->encoder, contentOf(*opened.original));
  else
    compressor_.setEncoder(nullptr);
  if (request.options) document_.loadOptions(*request.options);
  // Asked before setClip(): after it, the document's settings count as those of the new clip.
  const std::optional<NamedSettings> remembered = rememberedOf(opened, request);
  const Characters before = document_.characters();
  document_.setClip(opened.original, opened.decoded, saved_path, opened.characters);
  if (remembered) document_.loadSettings(settingsFor(*remembered, opened.original->motion()));
  if (again && past_->joints == document_.skeleton()->joint_count()) {
    past_->figures.clear();
    emit historyChanged();
  } else {
    takeUp(opened.original ? keyOf(*opened.original) : request.path,
           !opened.decoded && !request.options);
  }
  shown_slot_ = document_.tuning().active;
  chooseCurves();
  emit slotsChanged();
  emit this->opened(request);
  if (opened.decoded)
    emit settled();
  else
    compressor_.request(document_.options());
  wear();
  for (const auto& [rig, put] : document_.characters())
    if (const auto known = before.find(rig);
        known != before.end() && known->second.trouble != put.trouble)
      emit characterFailed(put.trouble);
}

/// Keeps the clip's history and settings for when it is opened again.
void Session::leave() {
  if (!document_.original()) return;
  const Motion& motion = document_.original()->motion();
  past_->tuning = document_.tuning();
  past_->frames = motion.clip.frames();
  past_->joints = motion.skeleton.joint_count();
}

/// Restores the settings that the clip had when it was open before. `by_itself`: the clip was
/// opened without a compressed form and without options. Settings changed elsewhere meanwhile win.
void Session::takeUp(const QString& key, bool by_itself) {
  past_ = &pasts_[key];
  emit historyChanged();
  const bool same = by_itself && past_->tuning && document_.original() &&
                    past_->frames == document_.frames() &&
                    past_->joints == document_.skeleton()->joint_count() &&
                    (!memory_ || firstDifference(past_->tuning->now(), document_.settings()) ==
                                     SettingsField::None);
  if (same) return document_.loadTuning(*past_->tuning);
  past_->steps.clear();
  past_->figures.clear();
  document_.beginSlots();
}

void Session::forgetHistories() {
  for (auto& [path, past] : pasts_) {
    past.steps.clear();
    past.tuning.reset();
  }
}

std::optional<NamedSettings> Session::rememberedOf(const OpenedClip& opened,
                                                   const OpenRequest& request) const {
  if (!memory_ || !opened.original || opened.decoded || request.options) return {};
  const std::optional<NamedSettings> kept = memory_(keyOf(*opened.original));
  // Settings that were chosen while nothing was open become those of the first clip.
  return kept || !document_.original() ? kept : NamedSettings{usualPreset(), {}};
}

void Session::setOptions(const EncodeSettings& options) {
  ClipSettings settings = document_.settings();
  settings.encode = options;
  change(settings);
}

void Session::setImportance(const Importance& importance) {
  ClipSettings settings = document_.settings();
  settings.encode.importance = importance;
  change(settings);
}

void Session::setRanges(const std::vector<ImportantRange>& ranges) {
  ClipSettings settings = document_.settings();
  settings.encode.ranges = ranges;
  change(settings);
}

void Session::setLoop(const std::optional<Loop>& loop) {
  ClipSettings settings = document_.settings();
  settings.encode.loop = loop;
  change(settings);
}

void Session::setTrackError(double track_error) {
  ClipSettings settings = document_.settings();
  settings.track_error = track_error;
  change(settings);
}

void Session::choosePreset(const Settings& preset) {
  if (!document_.skeleton()) return;
  try {
    change(withPreset(document_.settings(), preset, *document_.skeleton()));
  } catch (const Error& error) {
    emit compressFailed(QString::fromStdString(error.what()));
    emit document_.optionsChanged();  // shows the current options again
  }
}

void Session::takeSettings(const ClipSettings& settings) {
  Tuning tuning = document_.tuning();
  tuning.now() = settings;
  apply(tuning);
}

void Session::namePreset(const QString& name) {
  ClipSettings settings = document_.settings();
  settings.preset = name;
  change(settings);
}

void Session::setContactSettings(const ContactSettings& settings) {
  ClipSettings changed = document_.settings();
  changed.encode.contacts = document_.contactsBy(settings);
  changed.contacts = settings;
  change(changed);
}

void Session::setContacts(const std::vector<ContactSpan>& contacts) {
  ClipSettings settings = document_.settings();
  settings.encode.contacts = contacts;
  change(settings);
}

void Session::change(const ClipSettings& settings) {
  // A change without effect is no step of the history.
  if (firstDifference(document_.settings(), settings) == SettingsField::None) return;
  Tuning tuning = document_.tuning();
  tuning.now() = settings;
  changeTuning(document_.tuning(), tuning);
}

void Session::changeTuning(const Tuning& before, const Tuning& after) {
  const bool same_slot = before.active == after.active;
  const SettingsField field =
      same_slot ? firstDifference(before.now(), after.now()) : SettingsField::Slot;
  history()->push(new EditStep([field] { return nameOf(field); }, [this, after] { apply(after); },
                               [this, before] { apply(before); },
                               same_slot ? dragOf(before.now(), after.now()) : QString()));
}

void Session::switchSlot() {
  Tuning tuning = document_.tuning();
  tuning.active = 1 - tuning.active;
  changeTuning(document_.tuning(), tuning);
}

void Session::copyToOtherSlot() {
  Tuning tuning = document_.tuning();
  if (firstDifference(tuning.other(), tuning.now()) == SettingsField::None) return;
  tuning.both.fill(document_.settings());
  changeTuning(document_.tuning(), tuning);
}

void Session::announce() {
  document_.announce();
  emit slotsChanged();
  if (document_.decoded() && document_.final() && !busy()) emit settled();
  if (compressor_.busy()) emit recompressing();
  if (refining()) emit refiningChanged(true);
}

void Session::apply(const Tuning& tuning) {
  document_.setTuning(tuning);
  emit slotsChanged();
  if (!document_.original()) return;
  emit recompressing();
  // Waits while a take is being read, since the contacts may belong to that take, and while a
  // character is being put on, since the skin may belong to that character.
  if (!opening_.busy() && !wearing_.busy()) compressor_.request(document_.options());
}

void Session::answer(const DecodedPtr& decoded, bool final) {
  document_.setDecoded(decoded, final);
  shown_slot_ = document_.tuning().active;
  if (final && decoded->distortion)
    past_->figures[settingsKey(document_.options())] = figuresOf(*decoded);
  chooseCurves();
  emit slotsChanged();
  if (final) emit settled();
}

std::optional<SlotFigures> Session::slotFigures(int slot) const {
  const Tuning& tuning = document_.tuning();
  const DecodedPtr& decoded = document_.decoded();
  if (slot == tuning.active && slot == shown_slot_ && decoded && decoded->distortion)
    return figuresOf(*decoded);
  const auto found =
      past_->figures.find(settingsKey(tuning.both[static_cast<std::size_t>(slot)].encode));
  return found == past_->figures.end() ? std::nullopt : std::optional(found->second);
}

/// Chooses the worst joints if none of the chosen ones exist: a graph without a curve explains
/// nothing.
void Session::chooseCurves() {
  const DecodedPtr& decoded = document_.decoded();
  if (!decoded || !decoded->distortion) return;
  const std::vector<Landmark> points = landmarks(*document_.skeleton());
  CurveSelection curves = document_.curves();
  const auto chosen = [&](const Landmark& point) {
    return curves.contains(QString::fromStdString(point.name));
  };
  if (std::any_of(points.begin(), points.end(), chosen)) return;
  const std::vector<int> worst = worstFirst(decoded->distortion->distances);
  for (std::size_t i = 0; i < std::min(kFirstCurves, worst.size()); ++i)
    curves.add(QString::fromStdString(points[static_cast<std::size_t>(worst[i])].name));
  document_.setCurves(curves);
}

void Session::save(const QString& path) {
  const DecodedPtr decoded = document_.decoded();
  if (!decoded) return;
  saving_.start(
      [decoded, original = document_.original(), tracks = document_.codedTracks(),
       path](const Job&) {
        saveClip(path, *decoded, original.get(), tracks);
        return path;
      },
      [this, decoded](const QString& saved_path) {
        document_.setSaved(decoded, saved_path);
        emit saved(saved_path);
      },
      [this](const QString& message) { emit saveFailed(message); });
}

void Session::exportMotion(const QString& path, const QString& onto) {
  const DecodedPtr decoded = document_.decoded();
  if (!decoded) return;
  // Writing onto the clip's own file replaces the take that the clip was read from.
  WriteOptions writing;
  if (const OriginalPtr& original = document_.original(); original && original->path == onto)
    writing = original->reading;
  exporting_.start(
      [=, file = document_.file(), source = document_.source()](const Job&) {
        const Motion motion{decoded->compressed.skeleton, decoded->clip};
        if (onto.isEmpty())
          write_motion(path.toStdU16String(), motion, {}, source, {}, tracks_of(file));
        else
          write_motion_onto(path.toStdU16String(), motion, onto.toStdU16String(), source, writing,
                            tracks_of(file));
        return path;
      },
      [this](const QString& written) { emit exported(written); },
      [this](const QString& message) { emit saveFailed(message); });
}

void Session::exportReview(const QString& path, const ReviewRemarks& remarks) {
  const DecodedPtr decoded = document_.decoded();
  const OriginalPtr original = document_.original();
  if (!decoded || !original) return;
  exporting_.start(
      [=, tracks = document_.codedTracks(), limits = document_.options().limits,
       language = reportLanguage()](const Job&) {
        saveReviewPage(path, *decoded, *original, tracks, limits, remarks, language);
        return path;
      },
      [this](const QString& written) { emit exported(written); },
      [this](const QString& message) { emit saveFailed(message); });
}

void Session::putCharacter(const QString& path) {
  dressing_.start(
      [path = absolute(path)](const Job&) {
        return PutCharacter{read_character(path.toStdU16String()), path, {}};
      },
      [this](const PutCharacter& put) {
        if (!document_.skeleton()) return;  // the clip was closed meanwhile
        try {
          bound_to(*put.character.skin, put.character.skeleton, *document_.skeleton());
        } catch (const Error& error) {
          return emit characterFailed(QStringLiteral("%1: %2").arg(
              QFileInfo(put.path).fileName(), QString::fromUtf8(error.what())));
        }
        changeCharacter(put);
        emit characterPut(put.path);
      },
      [this](const QString& message) { emit characterFailed(message); });
}

void Session::takeCharacterOff() {
  if (!document_.character().path.isEmpty()) changeCharacter({});
}

void Session::changeCharacter(const PutCharacter& character) {
  const std::string rig = rig_of(*document_.skeleton());
  std::optional<PutCharacter> before;
  if (const auto found = document_.characters().find(rig); found != document_.characters().end())
    before = found->second;
  // Does nothing if the character has changed meanwhile, by a step in the history of another clip
  // of the rig.
  const auto change = [this, rig](const std::optional<PutCharacter>& from,
                                  const std::optional<PutCharacter>& to) {
    const auto now = document_.characters().find(rig);
    const QString path = now == document_.characters().end() ? QString() : now->second.path;
    const bool stands = path == (from ? from->path : QString());
    if (stands) setCharacter(rig, to);
    return stands;
  };
  // Undo also restores the settings: taking a mesh away changes those that are weighted by it.
  history()->push(new EditStep([] { return tr("Character"); }, [=] { change(before, character); },
                               [=, this, tuning = document_.tuning()] {
                                 if (change(character, before)) apply(tuning);
                               }));
}

void Session::recallCharacters(const CharacterFiles& files) {
  Characters characters;
  for (const auto& [rig, file] : files) characters[rig].path = file;
  document_.setCharacters(characters);
}

void Session::putCharacters(const CharacterChanges& by_rig) {
  Characters characters = document_.characters();
  for (const auto& [rig, character] : by_rig) {
    if (character)
      characters[rig] = *character;
    else
      characters.erase(rig);
  }
  document_.setCharacters(characters);
  wear();
}

void Session::setCharacter(const std::string& rig, const std::optional<PutCharacter>& character) {
  putCharacters({{rig, character}});
}

void Session::wear() {
  wearing_.abandon();
  const OriginalPtr original = document_.original();
  const PutCharacter character = document_.character();
  // A clip that is being opened gets its character from openClip() or once it is open.
  if (!original || opening_.busy() || original->wears(character)) return;
  struct Worn {
    OriginalPtr original;
    DecodedPtr decoded;
  };
  const DecodedPtr decoded = document_.decoded();
  wearing_.start(
      [original, decoded, character](const Job&) {
        Worn worn{dressed(*original, character), nullptr};
        if (decoded) worn.decoded = measuredAgain(*decoded, *worn.original);
        return worn;
      },
      [this, original, decoded, key = settingsKey(document_.options())](const Worn& worn) {
        // A character changes only the errors on the skin, unless the clip was compressed by these
        // errors or the mesh counts as the surface at some joint.
        const bool is_surface_kept = far_meshes(original->motion().skeleton).empty() &&
                                     far_meshes(worn.original->motion().skeleton).empty();
        const bool stands = decoded && document_.final() && document_.decoded() == decoded &&
                            document_.options().weighting != Weighting::Skin && is_surface_kept &&
                            settingsKey(document_.options()) == key;
        compressor_.setEncoder(worn.original->encoder);
        std::erase_if(past_->figures, [is_surface_kept](const auto& of_settings) {
          return of_settings.second.weighting == Weighting::Skin || !is_surface_kept;
        });
        document_.setDressed(worn.original, stands ? worn.decoded : document_.decoded());
        emit slotsChanged();
        stands ? emit settled() : compressor_.request(document_.options());
      },
      [this](const QString& message) { emit characterFailed(message); });
}

}  // namespace mocapress
