// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/compare/range_actions.h"

#include <QAction>
#include <QLocale>
#include <QMenu>
#include <algorithm>

#include "app/studio/document/session.h"
#include "widgets/models/care_edit.h"
#include "widgets/models/contact_edit.h"
#include "widgets/timeline/playback.h"

namespace mocapress {

RangeActions::RangeActions(Session* session, Playback* playback, QObject* parent)
    : QObject(parent),
      session_(session),
      playback_(playback),
      care_(new QMenu(tr("More &Care in the Range"))),
      contacts_(new QMenu(tr("C&ontacts in the Range"))),
      loop_(new QMenu(tr("The Clip as a Loo&p"))) {
  // Menus are filled when they open. An empty menu would not open, so each begins with one entry.
  for (QMenu* menu : {care_, contacts_, loop_}) menu->addSeparator();
  connect(care_, &QMenu::aboutToShow, this, &RangeActions::fillCare);
  connect(contacts_, &QMenu::aboutToShow, this, &RangeActions::fillContacts);
  connect(loop_, &QMenu::aboutToShow, this, &RangeActions::fillLoop);
  connect(playback, &Playback::rangeChanged, this, &RangeActions::update);
  connect(&session->document(), &Document::clipChanged, this, &RangeActions::update);
  update();
}

RangeActions::~RangeActions() {
  for (QMenu* menu : {care_, contacts_, loop_}) delete menu;
}

QList<QAction*> RangeActions::actions() const {
  return {care_->menuAction(), contacts_->menuAction(), loop_->menuAction()};
}

void RangeActions::update() {
  const bool is_clip = session_->document().original() != nullptr;
  for (QMenu* menu : {care_, contacts_}) {
    menu->setEnabled(is_clip && playback_->range());
    menu->menuAction()->setToolTip(
        menu->isEnabled() ? QString()
        : is_clip         ? tr("First choose a range: drag along the ruler of the timeline")
                          : tr("First open a clip"));
  }
  loop_->setEnabled(is_clip);
}

void RangeActions::fillCare() {
  care_->clear();
  const auto range = playback_->range();
  if (!range) return;
  const int first = range->first, last = range->second;
  const std::vector<ImportantRange> ranges = session_->document().options().ranges;
  const double now = careOver(ranges, first, last);
  for (const double factor : {1.0, 2.0, 3.0, 5.0, 10.0}) {
    const QString text =
        factor == 1 ? tr("As &elsewhere") : tr("%1 times stricter").arg(QLocale().toString(factor));
    QAction* const action = care_->addAction(
        text, this, [=, this] { session_->setRanges(withCareOver(ranges, first, last, factor)); });
    action->setCheckable(true);
    action->setChecked(factor == now);
  }
  if (is_error(session_->document().options().target)) return;
  care_->addSeparator();
  care_->addAction(tr("The target is a size: the other frames get worse"))->setEnabled(false);
}

void RangeActions::fillContacts() {
  contacts_->clear();
  const auto range = playback_->range();
  if (!range) return;
  const int first = range->first, last = range->second;
  const Document& document = session_->document();
  const std::vector<ContactSpan> contacts = document.contacts();
  const std::vector<QString> names = document.landmarkNames();
  std::vector<int> feet;  // feet with a contact at any time, edited or found
  for (const auto* spans : {&contacts, &document.original()->encoder->contacts()})
    for (const ContactSpan& span : *spans) feet.push_back(span.landmark);
  std::sort(feet.begin(), feet.end());
  feet.erase(std::unique(feet.begin(), feet.end()), feet.end());
  for (const int foot : feet) {
    const QString& name = names[static_cast<std::size_t>(foot)];
    contacts_->addAction(tr("%1 stands").arg(name), this, [=, this] {
      session_->setContacts(withContactOver(contacts, foot, first, last));
    });
    contacts_->addAction(tr("%1 is in the air").arg(name), this, [=, this] {
      session_->setContacts(withoutContactOver(contacts, foot, first, last));
    });
  }
  if (feet.empty()) contacts_->addAction(tr("No foot stands in this clip"))->setEnabled(false);
}

void RangeActions::fillLoop() {
  loop_->clear();
  const std::pair<QString, std::optional<Loop>> choices[] = {
      {tr("&Automatic"), std::nullopt},
      {tr("&Not a loop"), Loop::None},
      {tr("The last frame &repeats the first"), Loop::Repeats},
      {tr("The first frame follo&ws the last"), Loop::Follows}};
  for (const auto& [text, loop] : choices) {
    QAction* const action =
        loop_->addAction(text, this, [this, loop = loop] { session_->setLoop(loop); });
    action->setCheckable(true);
    action->setChecked(session_->document().options().loop == loop);
  }
}

}  // namespace mocapress
