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

std::string_view name(Coding coding) {
  switch (coding) {
    case Coding::Rle16:
      return "rle16";
    case Coding::Deflate:
      return "deflate";
  }
  return "unknown";
}

}  // namespace mocapress
