// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/library/review_change.h"

#include <QCoreApplication>

namespace mocapress {
namespace {

constexpr int kOneStep = 1500;  // ms between keys that are one note

struct Texts {
  Q_DECLARE_TR_FUNCTIONS(mocapress::ReviewChange)
};

}  // namespace

ReviewChange::ReviewChange(Review before, Review after, Apply apply)
    : before_(std::move(before)), after_(std::move(after)), apply_(std::move(apply)) {
  setText(before_.verdict == after_.verdict ? Texts::tr("Note") : Texts::tr("Verdict"));
  made_.start();
}

bool ReviewChange::mergeWith(const QUndoCommand* newer) {
  const auto* change = static_cast<const ReviewChange*>(newer);
  const bool typed =
      before_.verdict == after_.verdict && change->before_.verdict == change->after_.verdict;
  if (!typed || made_.elapsed() > kOneStep) return false;
  after_ = change->after_;
  made_.restart();
  return true;
}

}  // namespace mocapress
