// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace mocapress {

/// RFC 4648, with padding.
std::string base64_of(std::string_view bytes);

}  // namespace mocapress
