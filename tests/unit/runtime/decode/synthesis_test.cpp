// SPDX-License-Identifier: MIT
// Compares the resident form and its synthesis with the transform in double precision.
#include "core/runtime/decode/signal_decoder.h"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>
#include <cstring>
#include <limits>
#include <numeric>
#include <optional>

#include "core/base/random.h"
#include "core/runtime/own_memory.h"
#include "core/wavelet/lifting.h"
#include "tests/unit/runtime/paths.h"

namespace mocapress::synthesis_test {
namespace {

/// Random values over several orders of magnitude, with the given density in every band.
Eigen::MatrixXi random_values(int length, int signal_count, double density,
                              std::uint64_t seed = 1) {
  Random random(seed);
  Eigen::MatrixXi values = Eigen::MatrixXi::Zero(length, signal_count);
  for (int& value : values.reshaped())
    if (random.unit() < density)
      value = static_cast<int>((random.unit() - 0.5) * std::exp(8 * random.unit()));
  return values;
}

/// Random values like those of motion: dense in coarse bands, sparse in fine ones.
Eigen::MatrixXi motion_like(int length, int signal_count, std::uint64_t seed = 1) {
  Random random(seed);
  Eigen::MatrixXi values = Eigen::MatrixXi::Zero(length, signal_count);
  for (int s = 0; s < signal_count; ++s)
    for (int i = 0; i < length; ++i)
      if (s % 5 != 3 && random.unit() < 8.0 / (i + 8))
        values(i, s) = static_cast<int>((random.unit() - 0.5) * 4000.0 / (i + 10));
  return values;
}

struct Resident {
  Resident(const Eigen::MatrixXi& values, Basis basis, std::uint64_t budget = 0,
           float double_precision_limit = std::numeric_limits<float>::infinity())
      : steps(static_cast<std::size_t>(values.cols())),
        double_precision_limits(steps.size(), double_precision_limit),
        notes(steps.size()) {
    for (std::size_t s = 0; s < steps.size(); ++s) steps[s] = 0.01F * static_cast<float>(s % 7 + 1);
    const runtime::QuantisedSource source{static_cast<int>(values.rows()),
                                          static_cast<int>(values.cols()),
                                          basis,
                                          steps.data(),
                                          double_precision_limits.data(),
                                          values.data(),
                                          notes.data(),
                                          budget};
    bytes.emplace(static_cast<std::size_t>(runtime::ResidentSignals::size(source)));
    std::memset(bytes->data(), 0, bytes->size());
    form = runtime::ResidentSignals::build(source, bytes->data());
  }

  /// The inverse transform of steps times values in double precision: samples x signals.
  Eigen::MatrixXd expected(const Eigen::MatrixXi& values, Basis basis,
                           int bands_left_out = 0) const {
    const Lifting lifting(basis, static_cast<int>(values.rows()));
    const std::vector<double> gains = lifting.gains();
    Eigen::MatrixXd samples = values.cast<double>();
    for (std::size_t b = lifting.bands().size(); bands_left_out > 0 && b > 1; --bands_left_out, --b)
      samples.middleRows(lifting.bands()[b - 1].first, lifting.bands()[b - 1].size).setZero();
    for (Eigen::Index s = 0; s < samples.cols(); ++s) {
      for (Eigen::Index i = 0; i < samples.rows(); ++i)
        samples(i, s) *= static_cast<double>(steps[static_cast<std::size_t>(s)]) /
                         gains[static_cast<std::size_t>(i)];
      const std::span<double> signal(samples.col(s).data(),
                                     static_cast<std::size_t>(samples.rows()));
      lifting.inverse(signal, signal);
    }
    return samples;
  }

  std::vector<float> steps;
  std::vector<float> double_precision_limits;
  std::vector<std::uint8_t> notes;
  std::optional<AlignedBytes> bytes;
  const runtime::ResidentSignals* form;
};

constexpr std::uint64_t kAllDense = std::numeric_limits<std::uint64_t>::max();

std::vector<std::int32_t> all_columns(int count) {
  std::vector<std::int32_t> columns(static_cast<std::size_t>(count));
  std::iota(columns.begin(), columns.end(), 0);
  return columns;
}

/// Frames first ... first + count - 1 decoded on their own: frames x columns.
Eigen::MatrixXf window_of(runtime::SignalDecoder& synthesis, int columns, int first, int count) {
  Eigen::MatrixXf rows(columns, count);
  synthesis.decode_window(first, count, rows.data(), columns);
  return rows.transpose();
}

void expect_near(const Eigen::MatrixXf& samples, const Eigen::MatrixXd& expected) {
  ASSERT_EQ(samples.rows(), expected.rows());
  if (samples.size() == 0) return;
  const double size = 1 + expected.cwiseAbs().maxCoeff();
  EXPECT_LT((samples.cast<double>() - expected).cwiseAbs().maxCoeff(), 1e-6 * size);
}

TEST(Synthesis, IsTheInverseTransformForEveryLengthAndBasis) {
  for (const Basis basis : {Basis::Haar, Basis::Linear, Basis::Cubic})
    for (int length = 1; length <= runtime::kWindow; ++length) {
      const Eigen::MatrixXi values = random_values(length, 11, 0.5);
      const Resident resident(values, basis);
      const auto columns = all_columns(11);
      OwnMemory<runtime::SignalDecoder> synthesis(
          *resident.form,
          runtime::SignalRequest{columns.data(), true, 11, 0, &runtime::best_rows()});
      expect_near(window_of(*synthesis, 11, 0, length), resident.expected(values, basis));
    }
}

TEST(Synthesis, AnyWindowEqualsThatPartOfTheWhole) {
  Random random(5);
  for (const Basis basis : {Basis::Haar, Basis::Linear, Basis::Cubic})
    for (const int length : {257, 500, 1001}) {
      const Eigen::MatrixXi values = motion_like(length, 19);
      const Resident resident(values, basis);
      const Eigen::MatrixXd expected = resident.expected(values, basis);
      const auto columns = all_columns(19);
      OwnMemory<runtime::SignalDecoder> synthesis(
          *resident.form,
          runtime::SignalRequest{columns.data(), true, 19, 0, &runtime::best_rows()});
      for (int round = 0; round < 60; ++round) {
        const int count = 1 + static_cast<int>(random.below(runtime::kWindow));
        const auto first =
            static_cast<int>(random.below(static_cast<std::uint64_t>(length - count + 1)));
        expect_near(window_of(*synthesis, 19, first, count), expected.middleRows(first, count));
      }
      expect_near(window_of(*synthesis, 19, 0, 1), expected.topRows(1));
      expect_near(window_of(*synthesis, 19, length - 1, 1), expected.bottomRows(1));
    }
}

TEST(Synthesis, ConsecutiveWindowsHaveTheBitsOfSingleOnes) {
  Random random(6);
  const auto columns = all_columns(13);
  for (const Basis basis : {Basis::Haar, Basis::Linear, Basis::Cubic})
    for (const std::uint64_t budget : {std::uint64_t{0}, kAllDense})
      for (const int step : {1, 2, 3, 7, 40, runtime::kWindow}) {
        const Eigen::MatrixXi values = motion_like(700, 13);
        const Resident resident(values, basis, budget);
        const runtime::SignalRequest plan{columns.data(), true, 13, 0, &runtime::best_rows()};
        OwnMemory<runtime::SignalDecoder> in_a_row(*resident.form, plan);
        int first = static_cast<int>(random.below(100));
        for (int round = 0; round < 30 && first + step <= 700; ++round) {
          OwnMemory<runtime::SignalDecoder> alone(*resident.form, plan);
          ASSERT_EQ(window_of(*in_a_row, 13, first, step), window_of(*alone, 13, first, step))
              << "frame " << first << ", " << step << " frames";
          first += round % 9 == 8 ? step + 5 : step;
        }
      }
}

TEST(Synthesis, EveryPathGivesTheSameBits) {
  const Eigen::MatrixXi values = motion_like(777, 21);
  const auto columns = all_columns(21);
  for (const Basis basis : {Basis::Haar, Basis::Linear, Basis::Cubic}) {
    const Resident resident(values, basis, kAllDense);
    const auto decoded_by = [&](const runtime::RowKernels& rows) {
      OwnMemory<runtime::SignalDecoder> synthesis(
          *resident.form, runtime::SignalRequest{columns.data(), true, 21, 0, &rows});
      Eigen::MatrixXf samples(777, 21);
      for (int first = 0; first < 777; first += 37)
        samples.middleRows(first, 37) = window_of(*synthesis, 21, first, 37);
      return samples;
    };
    const Eigen::MatrixXf plain = decoded_by(runtime::kPlainRows);
    for (const mcpr_path path : existing_paths())
      EXPECT_EQ(std::memcmp(decoded_by(*runtime::rows_of(path)).data(), plain.data(), 4 * 777 * 21),
                0);
  }
}

TEST(Synthesis, SubsetOfSignalsHasTheSameBits) {
  const Eigen::MatrixXi values = motion_like(300, 30);
  const Resident resident(values, Basis::Cubic);
  const auto all = all_columns(30);
  OwnMemory<runtime::SignalDecoder> whole(
      *resident.form, runtime::SignalRequest{all.data(), true, 30, 0, &runtime::best_rows()});
  std::vector<std::int32_t> some(30, runtime::ResidentSignals::Columns::kNone);
  some[7] = 1;
  some[29] = 0;
  some[2] = 2;
  OwnMemory<runtime::SignalDecoder> part(
      *resident.form, runtime::SignalRequest{some.data(), false, 3, 0, &runtime::best_rows()});
  const Eigen::MatrixXf expected = window_of(*whole, 30, 100, 50);
  const Eigen::MatrixXf chosen = window_of(*part, 3, 100, 50);
  EXPECT_EQ(chosen.col(1), expected.col(7));
  EXPECT_EQ(chosen.col(0), expected.col(29));
  EXPECT_EQ(chosen.col(2), expected.col(2));
}

TEST(Synthesis, LeftOutBandsCountAsZero) {
  const Eigen::MatrixXi values = motion_like(200, 9);
  const Resident resident(values, Basis::Cubic);
  const auto columns = all_columns(9);
  for (const int left_out : {0, 1, 3, 40}) {
    OwnMemory<runtime::SignalDecoder> synthesis(
        *resident.form,
        runtime::SignalRequest{columns.data(), true, 9, left_out, &runtime::best_rows()});
    expect_near(window_of(*synthesis, 9, 60, 64),
                resident.expected(values, Basis::Cubic, left_out).middleRows(60, 64));
  }
}

TEST(SignalDecoder, WideSignalsAreExactUpToTheRoundingOfTheResult) {
  // A trajectory of kilometres. In floats alone several of the last digits would be wrong.
  Eigen::MatrixXi values = motion_like(900, 12);
  values.row(0).setConstant(1 << 22);
  const Resident resident(values, Basis::Cubic, 0, 8);
  const Eigen::MatrixXd expected = resident.expected(values, Basis::Cubic);
  EXPECT_EQ(resident.form->double_precision_count(), 12);
  const auto columns = all_columns(12);
  OwnMemory<runtime::SignalDecoder> decoder(
      *resident.form, runtime::SignalRequest{columns.data(), true, 12, 0, &runtime::best_rows()});
  for (int first = 0; first + 100 <= 900; first += 100) {
    const Eigen::MatrixXf window = window_of(*decoder, 12, first, 100);
    const Eigen::MatrixXd error =
        (window.cast<double>() - expected.middleRows(first, 100)).cwiseAbs();
    EXPECT_LT((error.array() / expected.middleRows(first, 100).array().abs()).maxCoeff(), 1.0e-7);
  }
}

TEST(ResidentSignals, HoldTheLargestValuesAndManySignals) {
  Eigen::MatrixXi values = Eigen::MatrixXi::Zero(64, 300);  // more signals than fit one byte
  values(0, 0) = std::numeric_limits<int>::max();
  values(1, 0) = std::numeric_limits<int>::min();
  values(40, 299) = std::numeric_limits<int>::min();
  values(63, 270) = std::numeric_limits<int>::max();
  const Resident resident(values, Basis::Cubic);
  const auto columns = all_columns(300);
  OwnMemory<runtime::SignalDecoder> synthesis(
      *resident.form, runtime::SignalRequest{columns.data(), true, 300, 0, &runtime::best_rows()});
  expect_near(window_of(*synthesis, 300, 0, 64), resident.expected(values, Basis::Cubic));
}

TEST(ResidentSignals, AreTinyWithoutCoefficients) {
  const Resident resident(Eigen::MatrixXi::Zero(5000, 60), Basis::Cubic);
  EXPECT_LT(resident.bytes->size(), 600u);
}

TEST(ResidentSignals, UseWideBlockOffsetsInLargeBands) {
  // A fine band with so many values that its blocks take more than 64 KiB.
  Eigen::MatrixXi values = Eigen::MatrixXi::Zero(20000, 40);
  Random random(3);
  for (int s = 0; s < 40; ++s)
    for (int i = 10000; i < 20000; ++i)
      if (random.unit() < 0.16) values(i, s) = random.unit() < 0.01 ? 30000 : 1;
  const Resident resident(values, Basis::Linear);
  ASSERT_GT(resident.bytes->size(), 0x10000u);
  const auto columns = all_columns(40);
  OwnMemory<runtime::SignalDecoder> synthesis(
      *resident.form, runtime::SignalRequest{columns.data(), true, 40, 0, &runtime::best_rows()});
  const Eigen::MatrixXd expected = resident.expected(values, Basis::Linear);
  for (const int first : {0, 9000, 19936})
    expect_near(window_of(*synthesis, 40, first, 64), expected.middleRows(first, 64));
}

}  // namespace
}  // namespace mocapress::synthesis_test
