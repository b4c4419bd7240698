// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <array>

#include "app/jobs/clips.h"
#include "widgets/models/curve_selection.h"

namespace mocapress {

/// By what a clip is compressed, and by what its contacts are found. NamedSettings are the same by
/// the names of joints, as a project keeps them.
struct ClipSettings {
  EncodeSettings encode;
  ContactSettings contacts;
  QString preset;                         // they come of, with changes or without; empty: of none
  double track_error = kUsualTrackError;  // no value of a scalar track is further off
};

/// Two settings of a clip to choose from.
struct Tuning {
  std::array<ClipSettings, 2> both;  // A and B
  int active = 0;

  const ClipSettings& now() const { return both[static_cast<std::size_t>(active)]; }
  ClipSettings& now() { return both[static_cast<std::size_t>(active)]; }
  const ClipSettings& other() const { return both[static_cast<std::size_t>(1 - active)]; }
};

/// What is open: values and their changes, no work and no widgets. Curves, current joint and
/// options outlive the clip.
class Document : public QObject {
  Q_OBJECT

 public:
  explicit Document(QObject* parent = nullptr);

  /// Either may be null: a .mcpr without its original, or a motion not compressed yet.
  const OriginalPtr& original() const { return original_; }
  const DecodedPtr& decoded() const { return decoded_; }

  /// No better answer to these options is on its way, nor a first one.
  bool final() const { return final_; }

  /// There is none: what is shown was made by other settings, or is a draft.
  bool unanswered() const { return unanswered_; }

  /// The .mcpr that was opened or saved last; empty: none.
  const QString& savedPath() const { return saved_path_; }

  /// The .mcpr that saving writes; wants a decoded().
  std::vector<std::byte> file() const {
    return savedFile(*decoded_, original_.get(), codedTracks());
  }

  /// Those of the original, by the bound of the settings.
  const CodedTracks& codedTracks() const;

  /// How the file that the clip was read from puts motion into numbers.
  SourceFormat source() const;

  /// The file name for the window title.
  QString title() const;

  /// The file that saving writes: what was saved, or will be beside the original.
  QString fileTitle() const;

  /// The user changed or saved something, and what is shown now is not in the file.
  bool modified() const;

  /// Null: nothing is open.
  const Skeleton* skeleton() const;
  std::vector<QString> landmarkNames() const;
  int frames() const;
  double sampleRate() const;  // Hz

  /// Two settings to compare, A and B; what follows is of the active one. Kept nowhere else.
  const Tuning& tuning() const { return tuning_; }
  const ClipSettings& settings() const { return tuning_.now(); }
  const EncodeSettings& options() const { return settings().encode; }
  /// By which contacts are found on the original.
  const ContactSettings& contactSettings() const { return settings().contacts; }

  /// On the original; none without it.
  std::vector<ContactSpan> contacts() const;

  /// Those found by other settings, as EncodeSettings takes them.
  std::optional<std::vector<ContactSpan>> contactsBy(const ContactSettings& settings) const;

  /// The user looks at the motion without its IK correction, to compare.
  bool uncorrected() const { return uncorrected_ && decoded_ && decoded_->uncorrected_tracks; }

  /// What is to be seen of the compressed clip: with its correction or without. Null: nothing.
  Tracks shownTracks() const;
  Poses shownPoses() const;
  const Footskate* shownFootskate() const;

  /// What the figures look like: the character that was put on them where it fits their joints,
  /// else that of the clip. Null: nobody knows.
  const std::shared_ptr<const Skin>& skin() const { return skin_; }

  const CurveSelection& curves() const { return curves_; }
  int currentJoint() const;  // -1: none, or not in this skeleton

  /// Another clip, or the same with its other half, and what was read of characters for it.
  void setClip(OriginalPtr original, DecodedPtr decoded, const QString& saved_path,
               const Characters& read = {});

  void setDecoded(DecodedPtr decoded, bool final);

  /// The clip that is open, with another character on it. It was decoded and measured on that.
  void setDressed(OriginalPtr original, DecodedPtr decoded);

  /// To these options no answer will come.
  void setUnanswered();

  /// By the user.
  void setOptions(const EncodeSettings& options);
  void setTuning(const Tuning& tuning);

  /// From elsewhere: nothing of the user's that would be lost.
  void loadOptions(EncodeSettings options);
  void loadSettings(const ClipSettings& settings);
  void loadTuning(const Tuning& tuning);

  /// Both slots begin with the settings that stand.
  void beginSlots();

  void setUncorrected(bool uncorrected);

  /// Each is on all clips of its rig, now and to come.
  void setCharacters(const Characters& characters);
  const Characters& characters() const { return characters_; }

  /// The character put on the clip that is open.
  PutCharacter character() const;

  void setCurves(const CurveSelection& curves);
  void setCurrentJoint(int joint);

  /// `decoded` is in the file `path` now.
  void setSaved(const DecodedPtr& decoded, const QString& path);

 signals:
  void clipChanged();
  void decodedChanged();

  /// Among them that it is to be seen with or without its correction.
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
  mutable CodedTracks coded_tracks_;  // of coded_original_, by coded_error_
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
