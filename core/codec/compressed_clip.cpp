// SPDX-License-Identifier: MIT
#include "core/codec/compressed_clip.h"

namespace mocapress {

std::string_view name(Method method) {
  switch (method) {
    case Method::PerChannel:
      return "per-channel";
    case Method::Standard:
      return "standard";
    case Method::Annealed:
      return "annealed";
  }
  return "unknown";
}

std::size_t CodedCorrection::bytes() const {
  return 2 + 4 * effectors.size() + differences.size();
}

}  // namespace mocapress
