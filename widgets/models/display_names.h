// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <memory>
#include <optional>
#include <string_view>

#include "core/codec/encode/mend/correction_encoder.h"
#include "core/metrics/visibility.h"
#include "core/mocapress/settings.h"
#include "core/motion/body_part.h"

namespace mocapress {

/// A title from compression_methods() in the user's language; other texts stay as they are.
QString translatedMethod(const char* title);

/// The method's title from compression_methods() in the user's language, or the name itself for an
/// unknown method.
QString methodTitle(std::string_view name);

/// The title of a study's series: "Annealed wavelets + IK 16:1".
QString seriesTitle(std::string_view method, const std::optional<double>& ik_ratio);

/// The name shown for a preset: translated for built-in ones, as typed for the user's own.
QString displayName(const Settings& preset);

/// The purpose of a built-in preset; empty for any other.
QString purposeOf(const Settings& preset);

/// The preset's settings that nothing else shows, as "Importance: Feet × 4, contacts × 20. Effort:
/// Best." Empty if they are the usual ones.
QString detailsOf(const Settings& preset);

QString displayName(BodyPart part);
QString displayName(Effort effort);
QString displayName(Ends ends);

/// Formats importances as "Feet × 4, contacts × 20"; empty when all are equal.
QString importanceText(const NamedImportance& importance);

/// Names shown for settings that the file format stores.
QString displayName(Method method);
QString displayName(Coding coding);
QString displayName(Weighting weighting);
QString displayName(CorrectAt at);

/// Visibility of a clip's errors, shared by several views; null: unknown.
using SightPtr = std::shared_ptr<const SightTable>;

/// Returns "not visible", "borderline" or "visible" in the user's language.
QString displayName(Sight sight);

/// Returns a text such as "not visible from 15 m".
QString sightText(Sight sight, double distance_m);

/// Names a cue, such as "sliding foot".
QString displayName(Cue cue);

/// Explains the worst error, as in "borderline: velocity 5.2 cm/s, noticed from 3.1 cm/s".
QString sightText(const WorstSight& seen);

}  // namespace mocapress
