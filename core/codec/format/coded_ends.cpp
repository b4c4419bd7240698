// SPDX-License-Identifier: MIT
#include "core/codec/format/coded_ends.h"

#include <algorithm>

#include "core/base/byte_cursor.h"
#include "core/codec/format/end_poses.h"
#include "core/codec/format/format_error.h"
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

CodedEnds read_ends(const runtime::FileSections& sections) {
  CodedEnds ends;
  std::copy_n(sections.end_reach, 2, ends.reach.begin());
  std::copy_n(sections.end_step_exponent, 2, ends.step_exponent.begin());
  runtime::EndReader reader(sections.coded_ends);
  ends.steps.resize(sections.channels, 2);
  for (int& value : ends.steps.reshaped()) value = reader.next();
  require(reader.finish());
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
