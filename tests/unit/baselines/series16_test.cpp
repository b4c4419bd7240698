// SPDX-License-Identifier: MIT
#include "core/baselines/series16.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/base/error.h"

namespace mocapress {
namespace {

TEST(Series16, ErrsByHalfAStepOfTheRange) {
  const Eigen::VectorXd values = 3 + 40 * Eigen::VectorXd::LinSpaced(1000, 0, 9).array().sin();
  ByteWriter writer;
  write_series16(writer, values);
  EXPECT_EQ(writer.bytes().size(), series16_bytes(1000));
  ByteReader reader(writer.bytes());
  EXPECT_LT((read_series16(reader, 1000) - values).cwiseAbs().maxCoeff(), 0.51 * 80 / 65535);
  reader.expect_end();
}

TEST(Series16, KeepsConstantsAndEmptySeries) {
  ByteWriter writer;
  write_series16(writer, Eigen::VectorXd::Constant(5, -2.5));
  write_series16(writer, Eigen::VectorXd());
  ByteReader reader(writer.bytes());
  EXPECT_EQ(read_series16(reader, 5), Eigen::VectorXd::Constant(5, -2.5));
  EXPECT_EQ(read_series16(reader, 0).size(), 0);
  reader.expect_end();
}

TEST(Series16, RefusesWhatIsNotThereOrNotFinite) {
  ByteWriter writer;
  write_series16(writer, Eigen::VectorXd::Constant(5, 1));
  ByteReader reader(writer.bytes());
  EXPECT_THROW(read_series16(reader, Eigen::Index{1} << 40), FormatError);
  ByteWriter infinite;
  infinite.write(std::numeric_limits<float>::infinity());
  infinite.write(1.0F);
  ByteReader infinite_reader(infinite.bytes());
  EXPECT_THROW(read_series16(infinite_reader, 0), FormatError);
}

}  // namespace
}  // namespace mocapress
