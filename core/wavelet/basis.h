// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string_view>

namespace mocapress {

/// The interpolating wavelet bases, by the neighbours that predict an odd sample. The values are
/// part of the file format.
enum class Basis : std::uint8_t {
  Haar = 0,    // the even sample before it
  Linear = 1,  // 2 neighbours
  Cubic = 2,   // 4 neighbours: the paper's
};

/// "haar", "linear", "cubic".
std::string_view name(Basis basis);

}  // namespace mocapress
