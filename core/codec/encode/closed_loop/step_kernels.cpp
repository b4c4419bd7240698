// SPDX-License-Identifier: MIT
#include "core/codec/encode/closed_loop/step_kernels.h"

#include "core/base/instruction_sets.h"
#include "core/codec/format/quantised_signals.h"

namespace mocapress {
namespace {

// The loops have a fixed number of iterations so that the compiler vectorises them.
constexpr int kAtATime = 8;

/// Cuts coefficients, each reduced by `less`, to whole steps.
template <int kCount>
MOCAPRESS_INLINE void cut_to_steps(const double* __restrict coefficients,
                                   const float* __restrict less, double per_unit, double added,
                                   int* __restrict values) {
  for (int i = 0; i < kCount; ++i) {
    const double steps = (coefficients[i] - static_cast<double>(less[i])) * per_unit;
    const double size = std::abs(steps) < kMostSteps ? std::abs(steps) : kMostSteps;
    values[i] = static_cast<int>(std::copysign(size + added, steps));
  }
}

template <int kCount>
MOCAPRESS_INLINE void find_differences(const int* __restrict values, double step,
                                       const double* __restrict coefficients,
                                       float* __restrict differences) {
  for (int i = 0; i < kCount; ++i)
    differences[i] = static_cast<float>(values[i] * step - coefficients[i]);
}

}  // namespace

void cut_to_steps(const double* coefficients, const float* less, int count, double per_unit,
                  double added, int* values) {
  int i = 0;
  with_avx2([&]() MOCAPRESS_INLINED {
    for (; i + kAtATime <= count; i += kAtATime)
      cut_to_steps<kAtATime>(coefficients + i, less + i, per_unit, added, values + i);
  });
  for (; i + 4 <= count; i += 4)
    cut_to_steps<4>(coefficients + i, less + i, per_unit, added, values + i);
  for (; i < count; ++i) cut_to_steps<1>(coefficients + i, less + i, per_unit, added, values + i);
}

void find_differences(const int* values, int count, double step, const double* coefficients,
                      float* differences) {
  int i = 0;
  with_avx2([&]() MOCAPRESS_INLINED {
    for (; i + kAtATime <= count; i += kAtATime)
      find_differences<kAtATime>(values + i, step, coefficients + i, differences + i);
  });
  for (; i + 4 <= count; i += 4)
    find_differences<4>(values + i, step, coefficients + i, differences + i);
  for (; i < count; ++i) find_differences<1>(values + i, step, coefficients + i, differences + i);
}

}  // namespace mocapress
