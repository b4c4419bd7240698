// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QString>
#include <QUndoCommand>
#include <functional>

#include "widgets/models/library_entry.h"

namespace mocapress {

/// What a reviewer says about a clip.
struct Review {
  Verdict verdict = Verdict::None;
  QString note;

  bool operator==(const Review&) const = default;
};

/// A review that can be taken back. A note typed without a pause is one step.
class ReviewChange : public QUndoCommand {
 public:
  using Apply = std::function<void(const Review&)>;

  ReviewChange(Review before, Review after, Apply apply);

  int id() const override { return 1000; }  // settings have the small ones
  bool mergeWith(const QUndoCommand* newer) override;
  void undo() override { apply_(before_); }
  void redo() override { apply_(after_); }

 private:
  Review before_, after_;
  Apply apply_;
  QElapsedTimer made_;
};

}  // namespace mocapress
