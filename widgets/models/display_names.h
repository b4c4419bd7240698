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

/// The title that compression_methods() give a method, in the user's language; the name itself
/// where there is no method of that name.
QString methodTitle(std::string_view name);

/// The same of a series of a study: "Annealed wavelets + IK 16:1".
QString seriesTitle(std::string_view method, const std::optional<double>& ik_ratio);

/// What people read: the built-in ones in their language, their own as they called them.
QString displayName(const Settings& preset);

/// What a built-in preset is for; empty for any other.
QString purposeOf(const Settings& preset);

/// "Feet × 4, contacts × 20; effort: best": what of a preset is not seen elsewhere; may be empty.
QString detailsOf(const Settings& preset);

QString displayName(BodyPart part);
QString displayName(Effort effort);
QString displayName(Ends ends);

/// "Feet × 4, contacts × 20"; empty where all are alike.
QString importanceText(const NamedImportance& importance);

/// What people read for the values of the file format.
QString displayName(Method method);
QString displayName(Coding coding);
QString displayName(Weighting weighting);
QString displayName(CorrectAt at);

/// What is seen of a clip, as views share it; null: unknown.
using SightPtr = std::shared_ptr<const SightTable>;

/// "not visible", "borderline", "visible".
QString displayName(Sight sight);

/// "sliding foot".
QString displayName(Cue cue);

/// "borderline: velocity 5.2 cm/s, noticed from 3.1 cm/s".
QString sightText(const WorstSight& seen);

}  // namespace mocapress
