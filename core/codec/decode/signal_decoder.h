// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/base/byte_cursor.h"
#include "core/wavelet/lifting.h"

namespace mocapress {

/// The signals (samples x signals) of quantised coefficients (coarse to fine), by the runtime
/// decoder: what it gives, to the bit, 32-bit floats. `steps` are those of each signal, which
/// Lifting::gains() divide. Signals with samples beyond their limit, or 8 where none is given,
/// are decoded in double precision on the way.
Eigen::MatrixXd decode_signals(const Eigen::MatrixXi& values, const std::vector<float>& steps,
                               Basis basis, const std::vector<float>& double_precision_limits = {});

/// The next signals of words (FORMAT.md, MOTN), samples x count. Throws FormatError when the words
/// are not valid.
Eigen::MatrixXd read_signals(ByteReader& words, Basis basis, int samples, int count);

}  // namespace mocapress
