// SPDX-License-Identifier: MIT
#include "core/codec/format/coded_ends.h"

#include "core/base/byte_cursor.h"
#include "core/base/error.h"
#include "core/codec/format/end_poses.h"
#include "core/codec/format/range_coder.h"

namespace mocapress {

std::string_view name(Ends ends) {
  switch (ends) {
    case Ends::Free:
      return "free";
    case Ends::Even:
      return "even";
    case Ends::Exact:
      return "exact";
  }
  return "unknown";
}

std::vector<std::byte> CodedEnds::write() const {
  ByteWriter writer;
  for (const int of_end : reach) writer.write(static_cast<std::uint8_t>(of_end));
  for (const int of_end : step_exponent) writer.write(static_cast<std::int8_t>(of_end));
  RangeEncoder bits;
  runtime::EndCoder coder;
  for (const int value : steps.reshaped()) coder.code(bits, value);
  writer.append(bits.finish());
  return writer.release();
}

CodedEnds read_ends(std::span<const std::byte> payload, std::size_t base_offset, int frames,
                    int channels) {
  ByteReader reader(payload, base_offset);
  CodedEnds ends;
  for (int& of_end : ends.reach) of_end = reader.read<std::uint8_t>();
  for (int& of_end : ends.step_exponent) of_end = reader.read<std::int8_t>();
  for (const int of_end : ends.reach)
    if (of_end < 1 || of_end > frames) throw FormatError(base_offset, "ends of impossible length");
  for (const int of_end : ends.step_exponent)
    if (of_end < runtime::kLeastEndStepExponent || of_end > runtime::kMostEndStepExponent)
      throw FormatError(base_offset + 2, "ends in impossible steps");
  const std::span<const std::byte> coded = payload.last(reader.remaining());
  runtime::RangeDecoder bits(reinterpret_cast<const std::uint8_t*>(coded.data()), coded.size());
  runtime::EndCoder coder;
  ends.steps.resize(channels, 2);
  for (int& value : ends.steps.reshaped()) value = coder.code(bits, 0);
  const std::size_t offset = reader.offset() + bits.position();
  if (bits.exhausted()) throw FormatError(offset, "the coded ends end early");
  if (!bits.is_at_end()) throw FormatError(offset, "bytes after the coded ends");
  return ends;
}

EndPoses::EndPoses(const CodedEnds& coded, const std::vector<float>& first_steps,
                   const std::vector<float>& last_steps)
    : reach_(coded.reach), values_(coded.steps.rows(), 2) {
  for (Eigen::Index c = 0; c < values_.rows(); ++c) {
    const auto channel = static_cast<std::size_t>(c);
    values_(c, 0) =
        runtime::end_value(coded.steps(c, 0), first_steps[channel], coded.step_exponent[0]);
    values_(c, 1) =
        runtime::end_value(coded.steps(c, 1), last_steps[channel], coded.step_exponent[1]);
  }
}

void EndPoses::add_to(int first_frame, int frames_of_clip, Eigen::MatrixXd& channels) const {
  for (Eigen::Index row = 0; row < channels.rows(); ++row) {
    const int frame = first_frame + static_cast<int>(row);
    const int away[2] = {frame, frames_of_clip - 1 - frame};
    for (int end = 0; end < 2; ++end) {
      const int reach = reach_[static_cast<std::size_t>(end)];
      if (away[end] >= reach) continue;
      const float share = runtime::end_share(away[end], reach);
      for (Eigen::Index c = 0; c < values_.rows(); ++c)
        channels(row, c) =
            static_cast<double>(static_cast<float>(channels(row, c)) + share * values_(c, end));
    }
  }
}

}  // namespace mocapress
