// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QUndoStack>
#include <array>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "app/jobs/compressor.h"
#include "app/jobs/job_runner.h"
#include "app/jobs/open_clip.h"
#include "app/studio/document/document.h"
#include "app/studio/document/named_settings.h"
#include "core/mocapress/settings.h"
#include "core/report/review_page.h"
#include "core/study/row.h"

namespace mocapress {

/// Figures of the last result for settings A or B.
struct SlotFigures {
  double ratio = 0;
  double eps_cm = 0;
  Weighting weighting{};
};

/// Carries out what the user wants done with the document, by jobs. Uses no widgets.
class Session : public QObject {
  Q_OBJECT

 public:
  explicit Session(QObject* parent = nullptr);

  Document& document() { return document_; }
  const Document& document() const { return document_; }

  /// Opens a motion and compresses it with the document's options, or opens a .mcpr. A .mcpr is
  /// shown with its original if that is open or opened next. Without options the motion is read as
  /// it was before.
  void open(const QString& path, const QString& skeleton = {},
            const std::optional<ReadOptions>& reading = {});

  /// Emits the signals that tell of the open clip and of work on it, for views that were made after
  /// it.
  void announce();

  /// Closes the clip and abandons one that is being opened.
  void closeClip();

  /// Closes the clip and removes all characters.
  void close();

  /// True if this motion is open.
  bool isOpen(const QString& path) const;

  /// clipKey() of the open motion; empty: none is open.
  QString openKey() const;

  /// Reads the open motion again with other options and keeps its settings. Can be undone.
  void readAgain(const ReadOptions& reading);

  /// Opens another animation of the file, an index into OriginalClip::takes. Each is a clip of its
  /// own, with its settings and history.
  void chooseTake(int take);

  /// Opens the original of the shown .mcpr; refuses any other motion.
  void compareWith(const QString& path, const QString& skeleton = {});

  /// Opens a clip as it is compressed in a study: with the row's options, which the document takes
  /// over, or with a comparison method. The clip may be open already.
  void openRow(const StudyRow& row, const QString& skeleton = {});

  /// The functions below can be undone.
  void setOptions(const EncodeSettings& options);
  void setContactSettings(const ContactSettings& settings);
  void setContacts(const std::vector<ContactSpan>& contacts);
  void setRanges(const std::vector<ImportantRange>& ranges);
  void setLoop(const std::optional<Loop>& loop);
  void setTrackError(double track_error);
  void setImportance(const Importance& importance);

  /// Emits compressFailed() if the preset names a joint that the clip lacks.
  void choosePreset(const Settings& preset);

  /// Sets the settings as part of another object's step.
  void takeSettings(const ClipSettings& settings);

  /// Stores the name of the preset that the settings come from.
  void namePreset(const QString& name);

  /// History of the open clip. Each clip has its own, which is kept while other clips are open.
  QUndoStack* history() { return &past_->steps; }

  /// Forgets the histories of all clips when the project changes.
  void forgetHistories();

  /// Switches between the document's settings A and B.
  void switchSlot();
  void copyToOtherSlot();

  /// Figures of the last result for settings A (0) or B (1); unset: there is none.
  std::optional<SlotFigures> slotFigures(int slot) const;

  /// A function that returns the earlier settings of a clip by its clipKey(). Unset: the clip gets
  /// the usual settings, as in a batch, whatever the settings of the clip before.
  using Memory = std::function<std::optional<NamedSettings>(const QString& key)>;
  void setMemory(Memory memory) { memory_ = std::move(memory); }

  /// A function that returns the options that a file was read with before.
  using ReadingMemory = std::function<ReadOptions(const QString& path)>;
  void setReadingMemory(ReadingMemory memory) { reading_memory_ = std::move(memory); }

  void cancelAnnealing() { compressor_.stopEarly(); }

  /// Saves the shown clip.
  void save(const QString& path);

  /// Writes the decoded motion in the format of the extension of `path`, in the unit and axes of
  /// its source. With `onto`, writes a copy of that character's file with this motion in it.
  void exportMotion(const QString& path, const QString& onto = {});

  /// Writes a page that shows the clip and its original in a browser, with remarks.
  void exportReview(const QString& path, const ReviewRemarks& remarks);

  /// Puts the character of another file on this clip and all clips of its rig. Can be undone.
  void putCharacter(const QString& path);

  /// Removes the character from clips of the rig. Can be undone.
  void takeCharacterOff();

  /// Sets the characters of these rigs, as part of another object's step. Unset: the rig's clips
  /// keep their own.
  using CharacterChanges = std::map<std::string, std::optional<PutCharacter>>;
  void putCharacters(const CharacterChanges& by_rig);

  /// Sets the characters that a project has stored. A file is read when a clip first needs it.
  void recallCharacters(const CharacterFiles& files);

  /// True while a file is being read.
  bool isOpening() const { return opening_.busy(); }

  /// True while an answer, or a better one, is on its way.
  bool busy() const { return compressor_.busy() || wearing_.busy(); }
  bool refining() const { return compressor_.refining(); }

 signals:
  /// A file is being read; opened() or openFailed() follows, unless another file replaces it.
  void opening(const QString& path);
  void opened(const OpenRequest& request);
  void openFailed(const OpenRequest& request, const QString& message);
  void saved(const QString& path);
  void exported(const QString& path);
  void saveFailed(const QString& message);

  /// The character fits the clip and was set for the clip's rig.
  void characterPut(const QString& path);
  void characterFailed(const QString& message);

  /// The user changed the options; an answer or compressFailed() follows.
  void recompressing();

  /// `out_of_reach`: no settings of the method meet the target.
  void compressFailed(const QString& message, bool out_of_reach = false);

  void annealed(const std::vector<EncodeProgress>& states);
  void refiningChanged(bool refining);

  void slotsChanged();

  /// Another clip's history is current.
  void historyChanged();

  /// All requested work is done and in the document.
  void settled();

 private:
  /// A clip's undo history, and its settings when it was left.
  struct Past {
    QUndoStack steps;
    std::optional<Tuning> tuning;  // unset: never left
    int frames = 0;                // length of that clip
    int joints = 0;
    std::map<std::string, SlotFigures> figures;  // by settingsKey() of the settings
  };

  void readAs(const std::function<QString()>& step, const ReadOptions& reading);
  void readBy(const ReadOptions& reading, std::function<void()> then = {});

  /// Sets a rig's character; unset removes it.
  void setCharacter(const std::string& rig, const std::optional<PutCharacter>& character);
  void changeCharacter(const PutCharacter& character);

  /// Puts the document's character on the open clip and measures it on that; leaves other clips
  /// alone.
  void wear();

  /// `then` runs once the clip is open.
  void start(OpenRequest request, std::function<void()> then = {});
  void change(const ClipSettings& settings);
  void changeTuning(const Tuning& before, const Tuning& after);
  void apply(const Tuning& tuning);
  void show(const OpenedClip& opened, const OpenRequest& request);
  void leave();
  void takeUp(const QString& key, bool by_itself);
  void answer(const DecodedPtr& decoded, bool final);
  void chooseCurves();
  std::optional<NamedSettings> rememberedOf(const OpenedClip& opened,
                                            const OpenRequest& request) const;

  Document document_;
  std::map<QString, Past> pasts_;  // by clipKey(); "" for no clip
  Past* past_ = nullptr;           // entry of the open clip
  int shown_slot_ = 0;             // slot with the settings of the decoded clip
  Memory memory_;
  ReadingMemory reading_memory_;
  Compressor compressor_;
  JobRunner opening_;
  JobRunner saving_;
  JobRunner exporting_;
  JobRunner dressing_;
  JobRunner wearing_;
};

}  // namespace mocapress
