// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>

#include "core/contact/footskate.h"

namespace mocapress {

/// Footskate a contact. A total grows with the clip; these compare clips of any length.
struct SlidePerContact {
  double mean_cm = 0;   // over all contacts; one that slid no further than the original counts 0
  double worst_cm = 0;  // of the contact that slid furthest

  bool operator==(const SlidePerContact&) const = default;
};

/// Of footskate measured over so many contacts; unset without any.
std::optional<SlidePerContact> slide_per_contact(const Footskate& footskate, std::size_t contacts);

}  // namespace mocapress
