// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <optional>
#include <string_view>

namespace mocapress {

/// The title that compression_methods() give a method, in the user's language; the name itself
/// where there is no method of that name.
QString methodTitle(std::string_view name);

/// The same of a series of a study: "Annealed wavelets + IK 16:1".
QString seriesTitle(std::string_view method, const std::optional<double>& ik_ratio);

}  // namespace mocapress
