// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "core/base/byte_cursor.h"

namespace mocapress {

/// Appends numbers, quantised in 16 bits between the least and the greatest of them: f32 least, f32
/// step, u16 each.
void write_series16(ByteWriter& writer, const Eigen::Ref<const Eigen::VectorXd>& values);

/// Reads what write_series16() wrote. Throws FormatError if bytes are missing, before it allocates
/// memory.
Eigen::VectorXd read_series16(ByteReader& reader, Eigen::Index count);

/// The size in bytes of what write_series16() writes.
constexpr std::size_t series16_bytes(std::size_t count) {
  return 2 * sizeof(float) + count * sizeof(std::uint16_t);
}

}  // namespace mocapress
