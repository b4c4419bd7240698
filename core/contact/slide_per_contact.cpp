// SPDX-License-Identifier: MIT
#include "core/contact/slide_per_contact.h"

namespace mocapress {

std::optional<SlidePerContact> slide_per_contact(const Footskate& footskate, std::size_t contacts) {
  if (contacts == 0) return std::nullopt;
  return SlidePerContact{
      .mean_cm = footskate.total_cm / static_cast<double>(contacts),
      .worst_cm = footskate.findings.empty() ? 0 : footskate.findings.front().slid_cm};
}

}  // namespace mocapress
