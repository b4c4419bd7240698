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
#include "core/study/row.h"

namespace mocapress {

/// The figures of an answer to one of a clip's two settings.
struct SlotFigures {
  double ratio = 0;
  double eps_cm = 0;
};

/// What the user wants of the document, done by jobs. No widgets.
class Session : public QObject {
  Q_OBJECT

 public:
  explicit Session(QObject* parent = nullptr);

  Document& document() { return document_; }
  const Document& document() const { return document_; }

  /// A motion is compressed with the options of the document at once. A .mcpr is shown; with its
  /// original, where that is open or is opened next.
  void open(const QString& path, const QString& skeleton = {});

  /// Nothing is open any more, nor on its way.
  void closeClip();

  /// And no character is on anything.
  void close();

  /// Whether this is the motion that is open.
  bool isOpen(const QString& path) const;

  /// Reads the motion that is open again, by other options. Its settings stand. Can be undone.
  void readAgain(const ReadOptions& reading);

  /// Likewise: another animation of its file, by its place among OriginalClip::takes.
  void chooseTake(int take);

  /// Opens the original of the .mcpr shown, and refuses another.
  void compareWith(const QString& path, const QString& skeleton = {});

  /// Opens a clip as it is compressed in a study: by its options, which then stand, or by a
  /// comparison method. Its clip may be open already.
  void openRow(const StudyRow& row, const QString& skeleton = {});

  /// Each of these can be undone.
  void setOptions(const EncodeSettings& options);
  void setContactSettings(const ContactSettings& settings);
  void setContacts(const std::vector<ContactSpan>& contacts);
  void setTrackError(double track_error);
  void setImportance(const Importance& importance);

  /// compressFailed() where it names a joint that the clip lacks.
  void choosePreset(const Settings& preset);

  /// The same, as a step of somebody else.
  void takeSettings(const ClipSettings& settings);

  /// The settings are those of a preset of that name from now on.
  void namePreset(const QString& name);

  /// Of the clip that is open. Each clip has one of its own, there again when it is opened again.
  QUndoStack* history() { return &past_->steps; }

  /// Of all clips, which are another project's.
  void forgetHistories();

  /// Between the two settings of the document, A and B.
  void switchSlot();
  void copyToOtherSlot();

  /// The figures of a slot's last answer; unset: not known.
  std::optional<SlotFigures> slotFigures(int slot) const;

  /// By what a clip was compressed before; what is unset is compressed as the last one was.
  using Memory = std::function<std::optional<NamedSettings>(const QString& path)>;
  void setMemory(Memory memory) { memory_ = std::move(memory); }

  /// By which options a clip was read before.
  using ReadingMemory = std::function<ReadOptions(const QString& path)>;
  void setReadingMemory(ReadingMemory memory) { reading_memory_ = std::move(memory); }

  void cancelAnnealing() { compressor_.stopEarly(); }

  /// Saves what is shown now.
  void save(const QString& path);

  /// Writes the motion as it comes out of the compressed clip, by the extension of `path`, in the
  /// unit and axes of its source.
  void exportMotion(const QString& path);

  /// Writes a page that shows the clip and its original in a browser, with remarks about it.
  void exportReview(const QString& path, const std::vector<std::string>& remarks);

  /// Puts what another file's figure looks like on the joints of this clip, and on all clips of its
  /// rig. Can be undone.
  void putCharacter(const QString& path);

  /// These clips look as their files say. Can be undone.
  void takeCharacterOff();

  /// Has them again as a project has them. They are read once a clip needs them.
  void recallCharacters(const CharacterFiles& files);

  /// An answer is on its way, or a better one.
  bool busy() const { return compressor_.busy() || wearing_.busy(); }
  bool refining() const { return compressor_.refining(); }

 signals:
  /// The file is being read; opened() or openFailed() follows, unless another takes its place.
  void opening(const QString& path);
  void opened(const OpenRequest& request);
  void openFailed(const OpenRequest& request, const QString& message);
  void saved(const QString& path);
  void exported(const QString& path);
  void saveFailed(const QString& message);

  /// The character is on the clip now, or why not.
  void characterPut(const QString& path);
  void characterFailed(const QString& message);

  /// The user changed the options; an answer to them follows, or compressFailed().
  void recompressing();

  /// `out_of_reach`: the method cannot meet the target with any settings.
  void compressFailed(const QString& message, bool out_of_reach = false);

  void annealed(const std::vector<EncodeProgress>& states);
  void refiningChanged(bool refining);

  void slotsChanged();

  /// It is another clip's.
  void historyChanged();

  /// All that was asked for is done and in the document.
  void settled();

 private:
  /// What was done to a clip, and where that led when it was left.
  struct Past {
    QUndoStack steps;
    std::optional<Tuning> tuning;  // unset: it was never left
    int frames = 0;                // of the clip they were done to
    int joints = 0;
    std::map<std::string, SlotFigures> figures;  // by settingsKey() of what came to them
  };

  void readAs(const QString& step, const ReadOptions& reading);
  void readBy(const ReadOptions& reading, std::function<void()> then = {});

  /// Unset: the rig has none of its own.
  void setCharacter(const std::string& rig, const std::optional<PutCharacter>& character);
  void changeCharacter(const PutCharacter& character);

  /// Measures on the document's character what is open; sees to it that nothing else is.
  void wear();

  /// `then`: once it is open.
  void start(OpenRequest request, std::function<void()> then = {});
  void change(const ClipSettings& settings);
  void changeTuning(const Tuning& before, const Tuning& after);
  void apply(const Tuning& tuning);
  void show(const OpenedClip& opened, const OpenRequest& request);
  void leave();
  void takeUp(const QString& path, bool by_itself);
  void answer(const DecodedPtr& decoded, bool final);
  void chooseCurves();
  std::optional<NamedSettings> rememberedOf(const OpenedClip& opened,
                                            const OpenRequest& request) const;

  Document document_;
  std::map<QString, Past> pasts_;  // by path; of no clip: ""
  Past* past_ = nullptr;           // of the clip that is open
  int shown_slot_ = 0;             // whose settings made what is decoded
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
