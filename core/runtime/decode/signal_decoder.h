// SPDX-License-Identifier: MIT
#pragma once

#include "core/runtime/decode/synthesis.h"

namespace mocapress::runtime {

/// Which signals are wanted, and where.
struct SignalRequest {
  const std::int32_t* column_of_signal;  // ResidentSignals::Columns::kNone: left out
  bool in_order;                         // signal s in column s, as many as there are columns
  int columns;
  int bands_left_out;  // of the finest: as if they were zero
  const RowKernels* kernels;
};

/// Signals of a resident form, window by window: in floats, and the few that are too large for that
/// in doubles.
class SignalDecoder {
 public:
  SignalDecoder(Memory& memory, const ResidentSignals& motion, const SignalRequest& request)
      : SignalDecoder(memory, motion.shape(), &motion, request) {}

  /// Only with measuring memory, to know how much.
  SignalDecoder(Memory& memory, const SignalsShape& shape, const SignalRequest& request)
      : SignalDecoder(memory, shape, nullptr, request) {}

  /// Rows of frames first ... first + count - 1, out_step apart. 0 < count <= kWindow, and all
  /// frames exist.
  void decode_window(int first, int count, float* out, std::ptrdiff_t out_step);

 private:
  SignalDecoder(Memory& memory, const SignalsShape& shape, const ResidentSignals* motion,
                const SignalRequest& request);
  SynthesisPlan<double> wide_plan(Memory& memory);

  SignalsShape shape_;
  const ResidentSignals* motion_;
  SignalRequest request_;
  Synthesis<float> floats_;
  std::int32_t* wide_columns_ = nullptr;  // of each signal
  Synthesis<double> wide_;
  double* wide_rows_;
};

}  // namespace mocapress::runtime
