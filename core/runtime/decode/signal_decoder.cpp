// SPDX-License-Identifier: MIT
#include "core/runtime/decode/signal_decoder.h"

#include <algorithm>

namespace mocapress::runtime {

SignalDecoder::SignalDecoder(Memory& memory, const SignalsShape& shape,
                             const ResidentSignals* motion, const SignalRequest& request)
    : shape_(shape),
      motion_(motion),
      request_(request),
      floats_(memory, motion, shape.length,
              {.columns = {.of_signal = request.column_of_signal,
                           .in_order = request.in_order,
                           .stride = 0,
                           .kernels = request.kernels},
               .count = request.columns,
               .bands_left_out = request.bands_left_out,
               .kernels = request.kernels == nullptr ? nullptr : &request.kernels->lifting}),
      wide_(memory, motion, shape.length, wide_plan(memory)),
      wide_rows_(memory.take<double>(static_cast<std::uint64_t>(kWindow) *
                                     static_cast<std::uint64_t>(shape.double_precision_count))) {}

SynthesisPlan<double> SignalDecoder::wide_plan(Memory& memory) {
  if (shape_.double_precision_count > 0)
    wide_columns_ = memory.take<std::int32_t>(static_cast<std::uint64_t>(shape_.signal_count));
  if (wide_columns_ != nullptr) {
    std::fill_n(wide_columns_, shape_.signal_count, ResidentSignals::Columns::kNone);
    for (int i = 0; i < shape_.double_precision_count; ++i)
      wide_columns_[motion_->double_precision_signals()[i]] = i;
  }
  return {
      .columns = {.of_signal = wide_columns_, .in_order = false, .stride = 0, .kernels = nullptr},
      .count = shape_.double_precision_count,
      .bands_left_out = request_.bands_left_out,
      .kernels = &kWideRows};
}

void SignalDecoder::decode_window(int first, int count, float* out, std::ptrdiff_t out_step) {
  floats_.decode_window(first, count, out, out_step);
  const int double_precision_count = shape_.double_precision_count;
  if (double_precision_count == 0) return;
  wide_.decode_window(first, count, wide_rows_, double_precision_count);
  for (int i = 0; i < double_precision_count; ++i) {
    const std::int32_t column = request_.column_of_signal[motion_->double_precision_signals()[i]];
    for (int t = 0; t < count && column != ResidentSignals::Columns::kNone; ++t)
      out[t * out_step + column] = static_cast<float>(wide_rows_[t * double_precision_count + i]);
  }
}

}  // namespace mocapress::runtime
