// SPDX-License-Identifier: MIT
// Reads any bytes as PRIO of FORMAT.md (priors learned from a bank's clips) and as a motion coded
// with it. The first four bytes give the size of PRIO, the number of signals and of frames.
#include <algorithm>
#include <cstdlib>
#include <span>

#include "core/base/error.h"
#include "core/codec/format/adaptive.h"

namespace {

using namespace mocapress;

/// Neighbours as of joints that turn about three axes; every other pair is on both sides.
std::vector<SignalNeighbours> neighbours_of(int signals) {
  std::vector<SignalNeighbours> neighbours(static_cast<std::size_t>(signals));
  for (int s = 1; s < signals; ++s) {
    neighbours[static_cast<std::size_t>(s)].sibling = s - 1;
    if (s >= 3 && s / 3 % 2 == 1) neighbours[static_cast<std::size_t>(s)].mirror = s - 3;
  }
  return neighbours;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr std::size_t kHead = 4;
  if (size < kHead) return 0;
  const std::span bytes = std::as_bytes(std::span(data, size)).subspan(kHead);
  const auto learned_bytes =
      std::min<std::size_t>(data[0] + std::size_t{256} * data[1], bytes.size());
  const std::span learned = bytes.first(learned_bytes);
  const std::vector<SignalNeighbours> neighbours = neighbours_of(1 + data[2] % 70);
  const int frames = 1 + data[3];
  try {
    const QuantisedSignals coded =
        adaptive_decode(bytes.subspan(learned_bytes), neighbours, frames, 0, learned);
    const std::vector<std::byte> again = adaptive_encode(coded, neighbours, learned);
    if (adaptive_decode(again, neighbours, frames, 0, learned) != coded) std::abort();
  } catch (const FormatError&) {
  }
  return 0;
}
