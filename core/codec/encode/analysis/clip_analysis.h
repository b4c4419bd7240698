// SPDX-License-Identifier: MIT
#pragma once

#include <tbb/task_arena.h>

#include <map>
#include <memory>
#include <mutex>
#include <utility>

#include "core/codec/encode/closed_loop/closed_loop.h"
#include "core/feet/contact_spans.h"
#include "core/metrics/jitter.h"
#include "core/motion/loop.h"
#include "core/motion/rotation_form.h"
#include "core/select/error_model.h"
#include "core/select/ranking.h"

namespace mocapress {

/// A clip in one basis: its coefficients and their order.
struct BasisAnalysis {
  RankedCoefficients ranked;
  StandardOrder standard;
  std::vector<double> scales;  // factors that make channels comparable

  BasisAnalysis(const Motion& motion, Basis basis);

  /// The factors `comparable`, one for each column, make the signals comparable.
  BasisAnalysis(const Clip& columns, const std::vector<double>& comparable, Basis basis);
};

/// Data about a motion that every encode needs and no option changes. Each part is computed when it
/// is first asked for. Const and safe to use from several threads at a time.
class ClipAnalysis {
 public:
  explicit ClipAnalysis(Motion motion) : motion_(std::move(motion)) {}

  /// Analyses the motion of `same` in other rotation forms, and takes from `same` all that does not
  /// depend on these, such as tracks and contacts. `same` must outlive this object.
  ClipAnalysis(Motion motion, const ClipAnalysis& same)
      : motion_(std::move(motion)), same_(&same) {}

  const Motion& motion() const { return motion_; }

  /// The forms from choose_forms(), and the analysis of the motion in these forms, which is this
  /// object if the motion has them already.
  const RotationForms& chosen_forms() const;
  const ClipAnalysis& in_chosen_forms() const;

  const Eigen::MatrixXd& original_tracks() const;       // landmark_tracks()
  const Eigen::MatrixXd& original_body() const;         // body_tracks()
  const Coefficients& coefficients(Basis basis) const;  // for the closed loop
  const BasisAnalysis& in(Basis basis) const;
  const ErrorModel& model(Weighting weighting) const;
  const ClosedLoop& closed_loop(Basis basis, Weighting weighting) const;

  const Jitter& original_jitter() const;  // jitter_of()

  Loop loop() const;  // find_loop()

  /// The contacts of the feet, found on the original; empty if there are no feet.
  const std::vector<ContactSpan>& contacts() const;

 private:
  template <typename Key, typename Value>
  class OnDemand {
   public:
    template <typename Build>
    const Value& get(Key key, const Build& build) const {
      const std::lock_guard lock(mutex_);
      auto& slot = values_[key];
      // Isolated, because a thread that waits inside build() must not take up a task that needs
      // this lock.
      if (!slot) tbb::this_task_arena::isolate([&] { slot = build(); });
      return *slot;
    }

   private:
    mutable std::mutex mutex_;
    mutable std::map<Key, std::unique_ptr<const Value>> values_;
  };

  struct Only {  // key for data that exists once
    bool operator<(Only) const { return false; }
  };

  /// Returns whether the clip is so long that it is cut into segments. Its tracks must then never
  /// be in memory all at once.
  bool is_long() const;

  Motion motion_;
  const ClipAnalysis* same_ = nullptr;
  OnDemand<Only, RotationForms> forms_;
  OnDemand<Only, ClipAnalysis> in_chosen_forms_;
  OnDemand<Only, Eigen::MatrixXd> original_tracks_;
  OnDemand<Only, Eigen::MatrixXd> original_body_;
  OnDemand<Only, std::vector<ContactSpan>> contacts_;
  OnDemand<Only, Jitter> original_jitter_;
  OnDemand<Only, Loop> loop_;
  OnDemand<Basis, Coefficients> coefficients_;
  OnDemand<Basis, BasisAnalysis> bases_;
  OnDemand<Weighting, ErrorModel> models_;
  OnDemand<std::pair<Basis, Weighting>, ClosedLoop> closed_loops_;
};

}  // namespace mocapress
