// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace mocapress {

/// The digits of base64 (RFC 4648), in the order of their values.
inline constexpr std::string_view kBase64Digits =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

/// Encodes bytes as base64 (RFC 4648), with padding.
std::string base64_of(std::string_view bytes);

/// Decodes base64. Skips all characters that are not digits, such as padding.
std::string bytes_of_base64(std::string_view text);

}  // namespace mocapress
