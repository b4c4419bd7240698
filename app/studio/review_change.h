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

/// A clip taken out of the library, that can be put back.
class ClipRemoval : public QUndoCommand {
 public:
  ClipRemoval(std::function<void()> take_out, std::function<void()> put_back);

  void undo() override { put_back_(); }
  void redo() override { take_out_(); }

 private:
  std::function<void()> take_out_, put_back_;
};

}  // namespace mocapress
