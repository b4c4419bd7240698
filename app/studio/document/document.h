// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <array>

#include "app/jobs/clips.h"
#include "widgets/models/curve_selection.h"

namespace mocapress {

/// Settings of a clip: its compression and the detection of its contacts.
struct ClipSettings {
  EncodeSettings encode;
  ContactSettings contacts;
  QString preset;                         // preset they came from; empty: none
  double track_error = kUsualTrackError;  // largest error of a scalar track's value
};

/// The two settings of a clip, and the active one.
struct Tuning {
  std::array<ClipSettings, 2> both;  // A and B
  int active = 0;

  const ClipSettings& now() const { return both[static_cast<std::size_t>(active)]; }
  ClipSettings& now() { return both[static_cast<std::size_t>(active)]; }
  const ClipSettings& other() const { return both[static_cast<std::size_t>(1 - active)]; }
};

/// The open clip with its settings: values and change signals, without jobs or widgets. Curves,
/// current joint and options survive a change of clip.
class Document : public QObject {
  Q_OBJECT

 public:
  explicit Document(QObject* parent = nullptr);

  /// Either may be null: a .mcpr without its original, or a motion that is not compressed yet.
  const OriginalPtr& original() const { return original_; }
  const DecodedPtr& decoded() const { return decoded_; }

  /// True when neither a first nor a better answer is on its way.
  bool final() const { return final_; }

  /// True when the options got no answer: the shown clip has other settings or is a draft.
  bool unanswered() const { return unanswered_; }

  /// The last .mcpr opened or saved; empty: none.
  const QString& savedPath() const { return saved_path_; }

  /// The .mcpr that saving writes; requires decoded().
  std::vector<std::byte> file() const {
    return savedFile(*decoded_, original_.get(), codedTracks());
  }

  /// The original's tracks, coded within the settings' error.
  const CodedTracks& codedTracks() const;

  /// Units and axes of the file that the clip was read from.
  SourceFormat source() const;

  /// The name of the file that was opened or last saved, for the window title.
  QString title() const;

  /// True when the user changed something and the shown clip is in no file.
  bool modified() const;

  /// Null: no clip is open.
  const Skeleton* skeleton() const;

  /// The landmarks' names as lists show them: without a namespace that all joints share.
  std::vector<QString> landmarkNames() const;
  int frames() const;
  double sampleRate() const;  // Hz

  /// Both settings, A and B; the functions below concern the active one. No file keeps the pair.
  const Tuning& tuning() const { return tuning_; }
  const ClipSettings& settings() const { return tuning_.now(); }
  const EncodeSettings& options() const { return settings().encode; }

  /// Contacts of the original; empty without an original.
  std::vector<ContactSpan> contacts() const;

  /// Contacts found with these thresholds, for EncodeSettings::contacts; unset for the default
  /// thresholds.
  std::optional<std::vector<ContactSpan>> contactsBy(const ContactSettings& settings) const;

  /// True when the user looks at the motion without its IK correction.
  bool uncorrected() const { return uncorrected_ && decoded_ && decoded_->uncorrected_tracks; }

  /// Positions of the compressed clip, with or without its correction. Null: nothing to show.
  Tracks shownTracks() const;
  Poses shownPoses() const;
  const Footskate* shownFootskate() const;

  /// The skin of the figures: of the character if it fits the joints, else of the clip. Null: none.
  const std::shared_ptr<const Skin>& skin() const { return skin_; }

  /// The file that skin() comes from: that of the character or of the clip. Empty: no skin.
  QString wornFile() const;

  const CurveSelection& curves() const { return curves_; }
  int currentJoint() const;  // -1: none, or not in this skeleton

  /// Sets a new clip, or the missing half of the open one. `read`: characters read for it.
  void setClip(OriginalPtr original, DecodedPtr decoded, const QString& saved_path,
               const Characters& read = {});

  void setDecoded(DecodedPtr decoded, bool final);

  /// Replaces the open clip by itself with another character, decoded and measured on it.
  void setDressed(OriginalPtr original, DecodedPtr decoded);

  /// Records that the current options gave no result; the clip that is shown stays.
  void setUnanswered();

  /// Sets options chosen by the user.
  void setOptions(const EncodeSettings& options);
  void setTuning(const Tuning& tuning);

  /// Sets options from elsewhere, which do not count as the user's unsaved work.
  void loadOptions(EncodeSettings options);
  void loadSettings(const ClipSettings& settings);
  void loadTuning(const Tuning& tuning);

  /// Gives both slots, A and B, the active settings, and makes A active.
  void beginSlots();

  void setUncorrected(bool uncorrected);

  /// Sets the characters; each is shown on all present and future clips of its rig.
  void setCharacters(const Characters& characters);
  const Characters& characters() const { return characters_; }

  /// The character on the open clip.
  PutCharacter character() const;

  void setCurves(const CurveSelection& curves);
  void setCurrentJoint(int joint);

  /// Emits all signals, for views that were made after the clip was opened.
  void announce();

  /// Notes that `decoded` has been saved to `path`.
  void setSaved(const DecodedPtr& decoded, const QString& path);

 signals:
  void clipChanged();
  void decodedChanged();

  /// The shown motion changed, also by switching its correction on or off.
  void shownChanged();
  void skinChanged();
  void optionsChanged();
  void curvesChanged();
  void currentJointChanged();
  void titleChanged();

 private:
  std::shared_ptr<const Skin> ownSkin() const { return original_ ? original_->skin : nullptr; }
  void findSkin();
  Eigen::Vector3d start() const;
  void leaveMissingSkin();

  Importance importanceIn(const Skeleton& next) const;

  OriginalPtr original_;
  DecodedPtr decoded_;
  bool final_ = true;
  bool unanswered_ = false;
  QString saved_path_;
  DecodedPtr saved_;
  double saved_track_error_ = kUsualTrackError;
  mutable CodedTracks coded_tracks_;  // made from coded_original_ within coded_error_
  mutable OriginalPtr coded_original_;
  mutable double coded_error_ = 0;
  bool touched_ = false;
  Characters characters_;
  std::shared_ptr<const Skin> skin_;
  Tuning tuning_;
  bool uncorrected_ = false;
  CurveSelection curves_;
  QString current_joint_;
};

}  // namespace mocapress
