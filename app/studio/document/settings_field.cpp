// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/document/settings_field.h"

#include <QCoreApplication>

#include "app/jobs/result_cache.h"

namespace mocapress {
namespace {

struct FieldTexts {
  Q_DECLARE_TR_FUNCTIONS(mocapress::SettingsField)
};

/// True if `a` and `b` differ, but become equal when `copy` transfers its fields.
template <typename Copy>
bool differIn(const EncodeSettings& a, EncodeSettings b, const Copy& copy) {
  if (settingsKey(a) == settingsKey(b)) return false;
  copy(b);
  return settingsKey(a) == settingsKey(b);
}

}  // namespace

QString nameOf(SettingsField field) {
  switch (field) {
    case SettingsField::Preset:
      return FieldTexts::tr("Preset");
    case SettingsField::Target:
      return FieldTexts::tr("Target");
    case SettingsField::Method:
      return FieldTexts::tr("Method");
    case SettingsField::Effort:
      return FieldTexts::tr("Effort");
    case SettingsField::Importance:
      return FieldTexts::tr("Importance");
    case SettingsField::Ranges:
      return FieldTexts::tr("Care in a Range");
    case SettingsField::Loop:
      return FieldTexts::tr("Loop");
    case SettingsField::Weighting:
      return FieldTexts::tr("Weighting");
    case SettingsField::Distance:
      return FieldTexts::tr("Viewing Distance");
    case SettingsField::Limits:
      return FieldTexts::tr("Limits of Visibility");
    case SettingsField::Ends:
      return FieldTexts::tr("Ends");
    case SettingsField::Coding:
      return FieldTexts::tr("Coding");
    case SettingsField::Correction:
      return FieldTexts::tr("Held Feet");
    case SettingsField::TrackError:
      return FieldTexts::tr("Tracks");
    case SettingsField::Contacts:
      return FieldTexts::tr("Contacts");
    case SettingsField::Slot:
      return FieldTexts::tr("A or B");
    case SettingsField::None:
    case SettingsField::Other:
      break;
  }
  return FieldTexts::tr("Settings");
}

SettingsField firstDifference(const ClipSettings& a, const ClipSettings& b) {
  const EncodeSettings& one = a.encode;
  const EncodeSettings& other = b.encode;
  if (a.preset != b.preset) return SettingsField::Preset;
  if (!(a.contacts == b.contacts) || one.contacts != other.contacts) return SettingsField::Contacts;
  if (settingsKey(one) == settingsKey(other))
    return a.track_error != b.track_error ? SettingsField::TrackError : SettingsField::None;
  const auto only = [&](auto member) {
    return differIn(one, other, [&](EncodeSettings& copy) { copy.*member = one.*member; });
  };
  if (only(&EncodeSettings::target)) return SettingsField::Target;
  if (one.method != other.method) return SettingsField::Method;
  if (only(&EncodeSettings::effort)) return SettingsField::Effort;
  if (only(&EncodeSettings::importance)) return SettingsField::Importance;
  if (only(&EncodeSettings::ranges)) return SettingsField::Ranges;
  if (only(&EncodeSettings::loop)) return SettingsField::Loop;
  if (only(&EncodeSettings::weighting)) return SettingsField::Weighting;
  if (only(&EncodeSettings::limits))
    return one.limits.of_cues == other.limits.of_cues ? SettingsField::Distance
                                                      : SettingsField::Limits;
  if (only(&EncodeSettings::ends)) return SettingsField::Ends;
  if (only(&EncodeSettings::coding)) return SettingsField::Coding;
  if (only(&EncodeSettings::correction)) return SettingsField::Correction;
  return SettingsField::Other;
}

QString dragOf(const ClipSettings& before, const ClipSettings& after) {
  const SettingsField field = firstDifference(before, after);
  const bool is_a_number = field == SettingsField::Target || field == SettingsField::Correction ||
                           field == SettingsField::Importance ||
                           field == SettingsField::TrackError || field == SettingsField::Distance;
  const Target::Kind kind = before.encode.target.kind;
  if (!is_a_number || after.encode.target.kind != kind) return {};
  return QStringLiteral("%1 %2").arg(static_cast<int>(field)).arg(static_cast<int>(kind));
}

}  // namespace mocapress
