// SPDX-License-Identifier: MIT
#include "core/baselines/series16.h"

#include <algorithm>
#include <cmath>

namespace mocapress {
namespace {

constexpr double kMostSteps16 = 65535;

}  // namespace

void write_series16(ByteWriter& writer, const Eigen::Ref<const Eigen::VectorXd>& values) {
  const auto least = static_cast<float>(values.size() > 0 ? values.minCoeff() : 0.0);
  const double range = values.size() > 0 ? values.maxCoeff() - least : 0.0;
  const auto step = static_cast<float>(range / kMostSteps16);
  writer.write(least);
  writer.write(step);
  for (const double value : values) {
    const double steps = step > 0 ? std::round((value - least) / step) : 0;
    writer.write(static_cast<std::uint16_t>(std::clamp(steps, 0.0, kMostSteps16)));
  }
}

Eigen::VectorXd read_series16(ByteReader& reader, Eigen::Index count) {
  const double least = reader.read<float>();
  const double step = reader.read<float>();
  if (!std::isfinite(least) || !std::isfinite(step)) reader.fail("a range that is not finite");
  ByteReader steps(reader.take(static_cast<std::size_t>(count) * sizeof(std::uint16_t)));
  Eigen::VectorXd values(count);
  for (double& value : values) value = least + step * steps.read<std::uint16_t>();
  return values;
}

}  // namespace mocapress
