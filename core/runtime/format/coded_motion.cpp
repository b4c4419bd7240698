// SPDX-License-Identifier: MIT
#include "core/runtime/format/coded_motion.h"

#include <algorithm>
#include <cmath>

#include "core/runtime/format/bit_pattern.h"
#include "core/runtime/format/learned_priors.h"
#include "core/runtime/format/range_decoder.h"

namespace mocapress::runtime {

double step_of(int step_exponent, float scale) {
  const double whole = std::ldexp(static_cast<double>(scale), -(step_exponent >> 1));
  return step_exponent % 2 == 0 ? whole : whole * 0x1.6a09e667f3bcdp-1;  // square root of 1/2
}

float read_scale(Cursor& coded) {
  return bit_pattern<float>(std::uint32_t{coded.read<std::uint16_t>()} << 16);
}

mcpr_result decode_coefficients(const Bytes& coded, const SignalNeighbours* neighbours,
                                const Bands& bands, CoefficientModel& model,
                                const QuantisedView& view, const CoderNotes& notes, float& scale,
                                const Bytes& learned, int bands_left_out) {
  Cursor head = coded.cursor();
  scale = read_scale(head);
  if (head.failed() || !std::isfinite(scale) || scale <= 0)
    return failure(MCPR_INVALID, coded.offset, "the scale of steps is not a positive number");
  std::fill_n(view.step_exponent, view.signal_count, 0);
  std::fill_n(view.values, std::int64_t{view.length} * view.signal_count, 0);
  RangeDecoder bits(coded.data + 2, coded.size - 2);
  model.begin();
  if (const mcpr_result result = learn(learned, model); failed(result)) return result;
  CoefficientCoder(bits, neighbours, bands, model, view, notes, scale).run(bands_left_out);
  const std::size_t offset = coded.offset + 2 + bits.position();
  if (bits.exhausted()) return failure(MCPR_INVALID, offset, "the coded motion ends early");
  if (bits.refused())
    return failure(MCPR_INVALID, offset, "a number of the motion is out of bounds");
  for (int s = 0; s < view.signal_count; ++s)
    if (step_of(view.step_exponent[s], scale) > kLargestStep)
      return failure(MCPR_INVALID, coded.offset, "a step is larger than 2^64");
  if (!bits.is_at_end()) return failure(MCPR_INVALID, offset, "bytes after the coded motion");
  return kOk;
}

}  // namespace mocapress::runtime
