// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QUndoStack>
#include <vector>

#include "app/jobs/compressor.h"
#include "app/jobs/job_runner.h"
#include "app/jobs/open_clip.h"
#include "app/studio/document.h"
#include "core/study/row.h"

namespace mocapress {

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

  /// Whether this is the motion that is open.
  bool isOpen(const QString& path) const;

  /// Opens the original of the .mcpr shown, and refuses another.
  void compareWith(const QString& path, const QString& skeleton = {});

  /// Opens a clip as it is compressed in a study: by its options, which then stand, or by a
  /// comparison method. Its clip may be open already.
  void openRow(const StudyRow& row, const QString& skeleton = {});

  /// Each of these can be undone.
  void setOptions(const EncodeOptions& options);
  void setContactSettings(const ContactSettings& settings);
  void setContacts(const std::vector<ContactSpan>& contacts);

  /// Of the clip that is open.
  QUndoStack* history() { return &history_; }
  void cancelAnnealing() { compressor_.stopEarly(); }

  /// Saves what is shown now.
  void save(const QString& path);

  bool refining() const { return compressor_.refining(); }

 signals:
  void opened(const OpenRequest& request);
  void openFailed(const OpenRequest& request, const QString& message);
  void saved(const QString& path);
  void saveFailed(const QString& message);

  /// The user changed the options; an answer to them follows, or compressFailed().
  void recompressing();
  void compressFailed(const QString& message);

  void annealed(const std::vector<EncodeProgress>& states);
  void refiningChanged(bool refining);

  /// All that was asked for is done and in the document.
  void settled();

 private:
  void start(const OpenRequest& request);
  void change(const ClipSettings& settings);
  void apply(const ClipSettings& settings);
  void show(const OpenedClip& opened, const OpenRequest& request);
  void answer(const DecodedPtr& decoded, bool final);
  void chooseCurves();

  Document document_;
  QUndoStack history_;
  Compressor compressor_;
  JobRunner opening_;
  JobRunner saving_;
};

}  // namespace mocapress
