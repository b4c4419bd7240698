// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/document/settings_change.h"

#include <QCoreApplication>

#include "app/jobs/settings_key.h"
#include "app/studio/document/edit_step.h"

namespace mocapress {
namespace {

struct Texts {
  Q_DECLARE_TR_FUNCTIONS(mocapress::SettingsChange)
};

QString nameOf(SettingsField field) {
  switch (field) {
    case SettingsField::Preset:
      return Texts::tr("Preset");
    case SettingsField::Target:
      return Texts::tr("Target");
    case SettingsField::Method:
      return Texts::tr("Method");
    case SettingsField::Effort:
      return Texts::tr("Effort");
    case SettingsField::Importance:
      return Texts::tr("Importance");
    case SettingsField::Weighting:
      return Texts::tr("Weighting");
    case SettingsField::Ends:
      return Texts::tr("Ends");
    case SettingsField::Coding:
      return Texts::tr("Coding");
    case SettingsField::Correction:
      return Texts::tr("Held Feet");
    case SettingsField::Contacts:
      return Texts::tr("Contacts");
    case SettingsField::Slot:
      return Texts::tr("A or B");
    case SettingsField::None:
    case SettingsField::Other:
      break;
  }
  return Texts::tr("Settings");
}

/// Whether one is the other but for what `copy` takes over.
template <typename Copy>
bool differIn(const EncodeOptions& a, EncodeOptions b, const Copy& copy) {
  if (settingsKey(a) == settingsKey(b)) return false;
  copy(b);
  return settingsKey(a) == settingsKey(b);
}

}  // namespace

SettingsField firstDifference(const ClipSettings& a, const ClipSettings& b) {
  const EncodeOptions& one = a.encode;
  const EncodeOptions& other = b.encode;
  if (a.preset != b.preset) return SettingsField::Preset;
  if (!(a.contacts == b.contacts) || one.contacts != other.contacts) return SettingsField::Contacts;
  if (settingsKey(one) == settingsKey(other)) return SettingsField::None;
  const auto only = [&](auto member) {
    return differIn(one, other, [&](EncodeOptions& copy) { copy.*member = one.*member; });
  };
  if (only(&EncodeOptions::target)) return SettingsField::Target;
  if (one.method != other.method) return SettingsField::Method;
  if (only(&EncodeOptions::effort)) return SettingsField::Effort;
  if (only(&EncodeOptions::importance)) return SettingsField::Importance;
  if (only(&EncodeOptions::weighting)) return SettingsField::Weighting;
  if (only(&EncodeOptions::ends)) return SettingsField::Ends;
  if (only(&EncodeOptions::coding)) return SettingsField::Coding;
  if (only(&EncodeOptions::correction)) return SettingsField::Correction;
  return SettingsField::Other;
}

SettingsChange::SettingsChange(Tuning before, Tuning after, Apply apply)
    : before_(std::move(before)),
      after_(std::move(after)),
      field_(before_.active == after_.active ? firstDifference(before_.now(), after_.now())
                                             : SettingsField::Slot),
      apply_(std::move(apply)) {
  setText(nameOf(field_));
  made_.start();
}

bool SettingsChange::mergeWith(const QUndoCommand* newer) {
  const auto* change = static_cast<const SettingsChange*>(newer);
  // Edits of contacts are steps of their own however quickly they are made.
  const bool dragged = field_ == SettingsField::Target || field_ == SettingsField::Correction ||
                       field_ == SettingsField::Importance;
  if (!dragged || change->field_ != field_ || made_.elapsed() > kOneStepMs) return false;
  if (before_.now().encode.target.kind != change->after_.now().encode.target.kind) return false;
  after_ = change->after_;
  made_.restart();
  return true;
}

}  // namespace mocapress
