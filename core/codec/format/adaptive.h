// SPDX-License-Identifier: MIT
// The coding "adaptive" of FORMAT.md: quantised coefficients, each bit predicted from what was
// coded before it.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/codec/format/quantised_signals.h"
#include "core/motion/skeleton.h"
#include "core/runtime/format/coefficient_coder.h"
#include "core/runtime/format/signal_neighbours.h"
#include "core/runtime/own_memory.h"

namespace mocapress {

using runtime::SignalNeighbours;

using runtime::kLevels;
using runtime::kSizes;
using runtime::size_of;

/// Owns a model of the runtime decoder and its memory.
class CoefficientModel {
 public:
  /// Starts in the state before the first bit.
  explicit CoefficientModel(int signal_count);

  /// A model without trained priors, used when priors are fitted.
  static CoefficientModel untaught(int signal_count);

  CoefficientModel(CoefficientModel&&) = default;
  CoefficientModel& operator=(CoefficientModel&&) = default;

  runtime::CoefficientModel& operator*() { return model_; }
  runtime::CoefficientModel* operator->() { return &model_; }

 private:
  struct Untaught {};
  CoefficientModel(int signal_count, Untaught);

  std::vector<runtime::AdaptiveBit> contexts_;  // moved along, never copied: model_ points into it
  runtime::CoefficientModel model_;
};

/// Finds which channels resemble one another, from the skeleton's tree alone.
std::vector<SignalNeighbours> channel_neighbours(const Skeleton& skeleton);

/// Appends the neighbours of the differences of an IK correction, which are coded after the
/// channels.
void append_correction_neighbours(int count, std::vector<SignalNeighbours>& neighbours);

/// Writes or reads the coefficients of signals by runtime::CoefficientCoder, depending on `bits`.
template <typename Bits>
void code_coefficients(Bits& bits, const std::vector<SignalNeighbours>& neighbours,
                       runtime::CoefficientModel& model, QuantisedSignals& coded,
                       int bands_left_out = 0) {
  const auto length = static_cast<int>(coded.values.rows());
  const auto signal_count = static_cast<int>(neighbours.size());
  const runtime::Bands bands(length);
  const runtime::QuantisedView view{length, signal_count, coded.step_exponent.data(),
                                    coded.values.data()};
  const OwnMemory<runtime::CoderNotes> notes(bands, signal_count);
  runtime::CoefficientCoder(bits, neighbours.data(), bands, model, view, *notes, coded.scale)
      .run(bands_left_out);
}

/// Codes signals, and checks that the bytes decode to the bits that were coded. `learned` holds a
/// bank's priors, if any: learned_priors.h.
std::vector<std::byte> adaptive_encode(const QuantisedSignals& coded,
                                       const std::vector<SignalNeighbours>& neighbours,
                                       std::span<const std::byte> learned = {});

/// The inverse of adaptive_encode(). Throws FormatError, with an offset counted from `base_offset`,
/// unless the bytes hold signals of that length. If `bands_left_out` is not 0, the bytes end before
/// as many of the finest bands, and the values of these are zeros.
QuantisedSignals adaptive_decode(std::span<const std::byte> bytes,
                                 const std::vector<SignalNeighbours>& neighbours, int length,
                                 std::size_t base_offset = 0,
                                 std::span<const std::byte> learned = {}, int bands_left_out = 0);

/// Returns how many of the first bytes that adaptive_encode() made hold all but the
/// `bands_left_out` finest bands.
std::size_t bytes_without_bands(std::span<const std::byte> bytes,
                                const std::vector<SignalNeighbours>& neighbours, int length,
                                int bands_left_out);

}  // namespace mocapress
