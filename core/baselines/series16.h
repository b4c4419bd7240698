// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "core/base/byte_cursor.h"

namespace mocapress {

/// Appends numbers as 16-bit steps between their least and greatest: f32 least, f32 step, u16 each.
void write_series16(ByteWriter& writer, const Eigen::Ref<const Eigen::VectorXd>& values);

/// Reads such a series, up to quantisation. Throws FormatError before allocating for bytes that are
/// not there.
Eigen::VectorXd read_series16(ByteReader& reader, Eigen::Index count);

/// The size of such a series in bytes.
constexpr std::size_t series16_bytes(std::size_t count) {
  return 2 * sizeof(float) + count * sizeof(std::uint16_t);
}

}  // namespace mocapress
