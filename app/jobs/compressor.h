// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QTimer>
#include <memory>
#include <vector>

#include "app/jobs/clips.h"
#include "app/jobs/job_runner.h"
#include "app/jobs/result_cache.h"

namespace mocapress {

/// Turns settings into answers, the newest settings only. The quick answer (a closed loop's draft,
/// or the standard selection where annealing is asked for) comes at once and is refined then. That
/// of a draft whose size is estimated comes again with its bytes, before it is refined. New
/// settings abandon a running refinement at once, but let a quick answer finish: while a slider is
/// dragged pictures keep coming. Settings answered before are answered at once.
class Compressor : public QObject {
  Q_OBJECT

 public:
  explicit Compressor(QObject* parent = nullptr);

  /// Whose clip to compress. Abandons everything; null: nothing to compress.
  void setEncoder(std::shared_ptr<const Encoder> encoder);

  void request(const EncodeSettings& options);

  /// Ends the refinement: the best so far is kept where it beats the quick answer.
  void stopEarly();

  void abandon();

  bool busy() const;
  bool refining() const { return refine_.busy(); }

 signals:
  /// An answer to the newest request, or to the one before while a quick answer is on its way.
  /// `final`: no better one will follow.
  void answered(const DecodedPtr& decoded, bool final);

  /// What the refinement reached since the last report.
  void progressed(const std::vector<EncodeProgress>& states);

  void refiningChanged(bool refining);

  /// `out_of_reach`: no settings of the method meet the target.
  void failed(const QString& message, bool out_of_reach);

 private:
  void answerFinally(const DecodedPtr& decoded);
  bool refines() const {
    return wanted_.method == Method::Annealed || wanted_.method == Method::ClosedLoop;
  }
  void startQuick();
  void quickDone(const DecodedPtr& decoded);
  void startCoding();
  void startRefining();
  void refined(const DecodedPtr& decoded);
  void fail(const QString& message);

  JobRunner quick_;
  JobRunner code_;  // the quick answer's bytes
  JobRunner refine_;
  QTimer refine_later_;  // so that a drag does not start them only to abandon them
  std::shared_ptr<const Encoder> encoder_;
  EncodeSettings wanted_;
  bool newer_wanted_ = false;   // than what the quick job answers
  bool out_of_reach_ = false;   // what the newest job found
  bool coded_will_do_ = false;  // no refinement is wanted any more
  DecodedPtr quick_answer_;     // null: there is none to these settings
  ResultCache results_;         // of the encoder's clip
};

}  // namespace mocapress
