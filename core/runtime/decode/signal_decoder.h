// SPDX-License-Identifier: MIT
#pragma once

#include "core/runtime/decode/synthesis.h"

namespace mocapress::runtime {

/// The signals to decode, and the columns that they go to.
struct SignalRequest {
  const std::int32_t* column_of_signal;  // one per signal; ResidentSignals::Columns::kNone: the
                                         // signal is not decoded
  bool in_order;  // the first signals go to the columns in order: signal s to column s
  int columns;
  int bands_left_out;  // finest bands, treated as zero
  const RowKernels* kernels;
};

/// Decodes windows of a resident form's signals: most in single precision, and those that need it
/// in double precision.
class SignalDecoder {
 public:
  SignalDecoder(Memory& memory, const ResidentSignals& motion, const SignalRequest& request)
      : SignalDecoder(memory, motion.shape(), &motion, request) {}

  /// Only counts the bytes of work space: `memory` must be a measuring one.
  SignalDecoder(Memory& memory, const SignalsShape& shape, const SignalRequest& request)
      : SignalDecoder(memory, shape, nullptr, request) {}

  /// Decodes frames first ... first + count - 1 into rows that are out_step apart. 0 < count <=
  /// kWindow, and all frames must exist.
  void decode_window(int first, int count, float* out, std::ptrdiff_t out_step);

 private:
  SignalDecoder(Memory& memory, const SignalsShape& shape, const ResidentSignals* motion,
                const SignalRequest& request);
  SynthesisPlan<double> wide_plan(Memory& memory);

  SignalsShape shape_;
  const ResidentSignals* motion_;
  SignalRequest request_;
  Synthesis<float> floats_;
  std::int32_t* wide_columns_ = nullptr;  // one per signal
  Synthesis<double> wide_;
  double* wide_rows_;
};

}  // namespace mocapress::runtime
