// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QTimer>
#include <memory>
#include <string>
#include <vector>

#include "app/jobs/clips.h"
#include "app/jobs/job_runner.h"
#include "app/jobs/result_cache.h"

namespace mocapress {

/// Compresses the clip by the newest settings. A quick answer (a closed loop's draft, or standard
/// selection instead of annealing) comes at once and is refined afterwards. A draft whose size is
/// estimated is coded before the refinement. New settings abandon a running refinement at once, but
/// let a quick answer finish, so that pictures keep coming during a drag. Settings that were
/// answered before are answered from the cache, judged by the current limits of visibility.
class Compressor : public QObject {
  Q_OBJECT

 public:
  explicit Compressor(QObject* parent = nullptr);

  /// Sets the clip to compress and abandons all work. Null: nothing to compress, and all results
  /// are forgotten. `content` is the key of the results: encoders may share it only if they give
  /// equal results. Empty: shared with no other encoder.
  void setEncoder(std::shared_ptr<const Encoder> encoder, const std::string& content = {});

  void request(const EncodeSettings& options);

  /// Ends the refinement and keeps its best result if that beats the quick answer.
  void stopEarly();

  void abandon();

  bool busy() const;
  bool refining() const { return refine_.busy(); }

 signals:
  /// An answer to the newest request, or to an earlier one whose quick answer was under way.
  /// `final`: no better answer will follow.
  void answered(const DecodedPtr& decoded, bool final);

  /// Progress of the refinement since the last report.
  void progressed(const std::vector<EncodeProgress>& states);

  void refiningChanged(bool refining);

  /// `out_of_reach`: no settings of the method meet the target.
  void failed(const QString& message, bool out_of_reach);

 private:
  std::string resultKey() const;
  void answerFinally(const DecodedPtr& decoded);
  bool refines() const {
    return wanted_.method == Method::Annealed || wanted_.method == Method::ClosedLoop;
  }
  void startQuick();
  void quickDone(const DecodedPtr& decoded);
  void startCoding();
  void startJudging(const DecodedPtr& known);
  void startRefining();
  void refined(const DecodedPtr& decoded);
  void fail(const QString& message);

  JobRunner quick_;
  JobRunner code_;  // codes the quick answer's bytes, or judges a known answer anew
  JobRunner refine_;
  QTimer refine_later_;  // delays refinements, so that a drag does not start and abandon them
  std::shared_ptr<const Encoder> encoder_;
  EncodeSettings wanted_;
  bool newer_wanted_ = false;   // newer settings wait for the quick job
  bool out_of_reach_ = false;   // the newest job found the target out of reach
  bool coded_will_do_ = false;  // coded bytes are the final answer: no refinement is wanted
  DecodedPtr quick_answer_;     // null: these settings have none
  std::string content_;         // see setEncoder()
  int unlike_others_ = 0;       // number of encoders without content so far
  ResultCache results_;         // results of this encoder and earlier ones
};

}  // namespace mocapress
