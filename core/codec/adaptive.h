// SPDX-License-Identifier: MIT
// The coding "adaptive" of FORMAT.md: quantised coefficients, each bit predicted from what was
// coded before it.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/base/own_memory.h"
#include "core/codec/quantised_signals.h"
#include "core/decoder/coefficient_coder.h"
#include "core/decoder/signal_kin.h"
#include "core/motion/skeleton.h"

namespace mocapress {

using decoder::SignalKin;

/// Which channels resemble one another, found from the tree alone.
std::vector<SignalKin> channel_kin(const Skeleton& skeleton);

/// The same for the differences of an IK correction, which follow the channels.
void append_correction_kin(int count, std::vector<SignalKin>& kin);

/// Walks through signals as decoder::CoefficientCoder does, with a model and memory of its own.
template <typename Bits>
void code_coefficients(Bits& bits, const std::vector<SignalKin>& kin,
                       decoder::CoefficientModel& model, QuantisedSignals& coded,
                       decoder::ContextCount* tally = nullptr) {
  const auto length = static_cast<int>(coded.values.rows());
  const auto signal_count = static_cast<int>(kin.size());
  const decoder::Bands bands(length);
  const decoder::QuantisedView view{length, signal_count, coded.fineness.data(),
                                    coded.values.data()};
  const OwnMemory<decoder::CoderNotes> notes(bands, signal_count);
  decoder::CoefficientCoder(bits, kin.data(), bands, model, view, *notes, tally).run();
}

/// The coded bytes.
std::vector<std::byte> adaptive_encode(const QuantisedSignals& coded,
                                       const std::vector<SignalKin>& kin);

/// The inverse. Throws FormatError, with an offset counted from `base_offset`, unless the bytes are
/// those of signals of that length.
QuantisedSignals adaptive_decode(std::span<const std::byte> bytes,
                                 const std::vector<SignalKin>& kin, int length,
                                 std::size_t base_offset = 0);

}  // namespace mocapress
