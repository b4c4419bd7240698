// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QSet>
#include <QStringList>
#include <QUndoStack>
#include <functional>
#include <map>
#include <optional>

#include "app/jobs/clip_sources.h"
#include "app/jobs/job_runner.h"
#include "app/studio/document/named_settings.h"
#include "app/studio/library/folder_search.h"
#include "app/studio/library/kept_project.h"
#include "app/studio/library/outline_reader.h"
#include "core/report/notes_file.h"
#include "core/report/review_page.h"
#include "widgets/models/library_model.h"

namespace mocapress {

class LibraryModel;
class Session;
struct BatchStep;
struct OpenRequest;

/// The open project: its clips with settings, results and verdicts. Entering a project opens its
/// current clip. library.cpp has the list and the open clip; library_files.cpp,
/// library_settings.cpp, library_outcomes.cpp, library_reviews.cpp, library_notes.cpp and
/// library_comparison.cpp have what their names say.
class Library : public KeptProject {
  Q_OBJECT

 public:
  Library(Session* session, LibraryModel* model, QObject* parent = nullptr);

  /// Shows all rows again, in the current language, and emits the signals that tell of the list.
  void announce();

  /// History of the list and its reviews; changes to a clip are in its document's history.
  QUndoStack* history() { return &history_; }

  /// Adds clips that are not in the list yet. Adding, removing, verdicts and notes are steps of
  /// history().
  void add(const QStringList& paths);

  /// Adds all clips below a folder, found in the background.
  void addFolder(const QString& path);
  void remove(const QList<int>& rows);
  void openClip(int row);
  void setNote(int row, const QString& note);

  /// The notes on frames of a row's clip, in the order of frames; none for row -1.
  std::vector<FrameNote> frameNotes(int row) const;

  /// Replaces the note with this index; -1 adds one, and a note without a text is removed. Reviewer
  /// and time are set to the current ones.
  void setFrameNote(int row, int index, const FrameNote& note);

  /// Writes the notes on frames to files beside the clips; see notes_file.h.
  void writeNotes();

  /// Reads these files and adds the notes that the library lacks, in one step.
  void readNotes();

  /// Sets a verdict for all these rows in one step. It applies to the files and settings of the
  /// outcome in the row, else to the clip's current ones. A clip without its file gets no verdict,
  /// and failed() says so.
  void setVerdict(const std::vector<int>& rows, Verdict verdict);
  void setPreset(const std::vector<int>& rows, const Settings& preset);

  /// Judges all clips by the user's own limits of visibility; each clip's settings keep them.
  void takeOwnLimits();

  /// Copies the settings of a clip for pasteSettings(), until another clip's are copied.
  void copySettings(int row);
  bool hasCopy() const { return copied_.has_value(); }

  /// Applies the copied settings to clips, in one step. Each clip keeps its own edited contacts,
  /// ranges and loop.
  void pasteSettings(const std::vector<int>& rows);
  void pasteImportance(const std::vector<int>& rows);

  /// Sets the character of the clips' rigs, in one step; an empty path removes it. Clips that were
  /// not read yet are left out.
  void putCharacter(const std::vector<int>& rows, const QString& file);

  /// Checks whether the files of the clips are there and unchanged. Clips whose files have changed
  /// are read again.
  void checkFiles();

  /// Calls checkFiles() unless a check is running.
  void lookAgain();

  /// Searches a folder for missing clips, and uses the files found instead, in one step.
  void findMissing(const QString& folder);

  /// Compares the clips with those of an earlier batch, given by any file in its folder, or of an
  /// earlier project; see LibraryEntry::since. Clips are matched by path and take, or else by file
  /// name if only one clip has it.
  void compareWith(const QString& path);

  /// Takes over the outcome of a batch that compressed a clip of that file by these settings,
  /// unless the clip in the library has other settings of its own.
  void noteExported(const QString& path, const Settings& settings, const ReadOptions& reading,
                    const BatchStep& step);

  /// Clips that have settings and no outcome for their present files and settings: at most `most`,
  /// those of the rows `first` in their order, then the shortest. Leaves out the open clip, which
  /// the session compresses, and clips that failed.
  std::vector<TunedClip> unencoded(std::size_t most, const std::vector<int>& first = {}) const;

  /// Takes over the result, or the failure, of a clip that was compressed in the background.
  void noteEncoded(const TunedClip& clip, const BatchStep& step);

  /// The pinned results of a clip.
  std::vector<Pin> pinsOf(const QString& key);
  void setPins(const QString& key, const std::vector<Pin>& pins);

  /// True if figures show their skin.
  bool showsSkin() const { return project_.shows_skin; }
  void setShowsSkin(bool shows);

  /// Sets the queue of this project's batch.
  void setBatch(const RememberedBatch& batch);

  int currentRow() const;

  /// The folder of the open clip, or of the first: file dialogs start there. Empty: no clips.
  QString clipFolder() const;

  /// Clips with their own settings, for a batch; no rows: all clips.
  std::vector<TunedClip> tuned(const std::vector<int>& rows) const;

  /// Verdicts and notes of all clips.
  ClipReviews reviews() const;

  /// Verdict and notes on a clip, as texts for a report.
  ReviewRemarks remarksOn(const QString& key) const;

 signals:
  void currentChanged();

  /// New clips were added, starting at this row.
  void added(int row);

  /// Emitted once the clips have an earlier batch to compare with.
  void compared();

  /// A check of the files has ended.
  void looked();

 private:
  using Reviews = std::map<QString, ClipReview>;  // by ProjectClip::key()
  using SettingsByKey = std::map<QString, std::optional<NamedSettings>>;

  void change(const std::vector<int>& rows, const std::function<QString()>& name,
              const std::function<void(NamedSettings&)>& change);
  void apply(const Reviews& reviews);
  void apply(const SettingsByKey& settings);
  void move(const std::map<QString, ClipSource>& to);
  ClipReview reviewNow(const ProjectClip& clip, Verdict verdict) const;

  /// Hashes of the clip's files and settings that a review applies to.
  struct Reviewed {
    std::string source, settings;
  };
  Reviewed reviewedOf(const ProjectClip& clip) const;
  using NotesByFile = std::map<QString, NotesByTake>;

  /// Reviews of clips before and after they get notes that they lack.
  struct MoreNotes {
    Reviews before, after;
    int added = 0;
  };
  MoreNotes withNotes(const NotesByFile& found) const;
  void noteBeside(const NotesByFile& files);
  void readNotesOfNew(const QString& path);
  void readNewNotes();
  static std::string userName();
  static std::string timeNow();
  void openIfChanged();
  void noteFiles(const std::vector<QString>& keys, const std::vector<ClipSource>& sources,
                 const std::vector<SourceNow>& now);
  void noteOpenFailed(const OpenRequest& request, const QString& message);

  /// Makes a clip's row; facts from its file are kept from the previous row.
  static LibraryEntry entryOf(const ProjectClip& clip, const LibraryEntry& read);
  std::vector<LibraryEntry> entries() const;
  using ClipsByRow = std::map<int, ProjectClip>;

  using EarlierClips = QHash<QString, ClipFigures>;  // by key
  void compare(const QString& name);
  bool findEarlier();

  template <typename IsOut>
  ClipsByRow takeOut(const IsOut& is_out);
  void putBack(const ClipsByRow& clips);
  void noteOpened(const QString& path, const QString& skeleton);
  void noteSettings();
  void noteCharacters();
  void noteOutcome();
  void setOutcome(ProjectClip& clip, const Outcome& outcome);
  void recallOutcome(ProjectClip& clip);
  static TunedClip tunedClip(const Project& project, const ProjectClip& clip);
  void show(const ProjectClip& clip);
  void showRows(const std::vector<int>& rows);
  void showAsRead(const ProjectClip& clip, const OriginalClip& original);
  void noteOutline(const QString& key, const ClipOutline& outline, const QString& trouble);
  void noteTakes(const QString& path, const Takes& takes);
  void addTakes(int row, const Takes& takes);
  void leave();
  void enter();
  ProjectClip* openNow();
  bool isAsNow(const NamedSettings& settings) const;
  NamedSettings settingsNow() const;

  Session* session_;
  LibraryModel* model_;
  QUndoStack history_;
  OutlineReader outlines_{&project_};
  FolderSearch folder_search_;
  std::map<std::pair<std::string, std::string>, Outcome>
      known_;  // by hashes of source and settings
  JobRunner checking_{Workers::LongRunning};
  bool check_again_ = false;  // files may have changed since the running check began
  std::string tried_;         // hash of the changed file that was opened last, or failed to open
  JobRunner finding_{Workers::LongRunning};
  JobRunner reading_character_;
  JobRunner comparing_{Workers::LongRunning};
  JobRunner carrying_notes_{Workers::LongRunning};
  JobRunner reading_new_notes_{Workers::LongRunning};
  std::vector<QString> new_;  // files whose notes will be read next
  std::optional<NamedSettings> copied_;
  EarlierClips earlier_;  // clips of the batch to compare with; empty: none
};

}  // namespace mocapress
