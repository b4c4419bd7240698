// SPDX-License-Identifier: MIT
#include "core/wavelet/basis.h"

namespace mocapress {

std::string_view name(Basis basis) {
  switch (basis) {
    case Basis::Haar:
      return "haar";
    case Basis::Linear:
      return "linear";
    case Basis::Cubic:
      return "cubic";
  }
  return "unknown";
}

}  // namespace mocapress
