// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <array>
#include <span>
#include <utility>
#include <vector>

namespace mocapress {

/// Chooses which of several coefficients to move by a step so that error and price together are
/// least. The coefficients compensate each other's errors, such as those of all channels at one
/// time and scale.
///
/// It is a local search: one coefficient is moved, all others respond with their own best moves,
/// and the result is kept if the total falls. This finds improvements that need three or more moves
/// at once.
class JointSearch {
 public:
  /// Moving by x steps changes the error by 2 slope x + curve x^2, with all others unchanged.
  struct Coefficient {
    float slope;                  // in bits, as are the values below
    float curve;                  // > 0
    std::array<float, 3> prices;  // bits a step lower, as it is, and a step higher
  };

  /// The matrix rows for `count` coefficients, a multiple of eight; rows beyond `count` are zero.
  static Eigen::Index rows_for(Eigen::Index count) { return (count + 7) / 8 * 8; }

  /// A vector x of moves changes the error by 2 slope^T x + x^T cross x. `cross` has
  /// rows_for(coefficients) rows and a column for each coefficient; its diagonal repeats
  /// Coefficient::curve. Both arguments must outlive this object.
  JointSearch(std::span<const Coefficient> coefficients, const Eigen::MatrixXf& cross);

  /// The moves found, -1 to 1 for each coefficient; zeros where none pays.
  const std::vector<int>& run();

 private:
  /// Tries a move of one coefficient in both directions. Returns whether one was kept. Instantiated
  /// once for each vector length.
  template <typename Vector>
  bool visit(int c);
  bool visit_with_avx2(int c);

  /// Moves one coefficient and lets the others respond; keeps the moves if they pay.
  template <typename Vector>
  bool attempt(int c, int by);

  /// The change of error and price when one coefficient moves.
  float cost_of(int c, int by) const;

  /// The gains from the others' responses, each taken by itself, if one coefficient moves a step
  /// down, and if it moves a step up.
  template <typename Vector>
  std::array<float, 2> gains_of_answers(int c) const;

  /// Moves one coefficient. Returns its cost_of().
  template <typename Vector>
  float move(int c, int by);
  void set_limits(int c);

  /// Searches the vector of coefficients that starts at `first`, beginning at `from`, for a slope
  /// beyond its limits. Returns that coefficient, or the one after the vector if there is none.
  template <typename Vector>
  int next_beyond_limits(int first, int from) const;

  int count() const { return static_cast<int>(coefficients_.size()); }

  std::span<const Coefficient> coefficients_;
  const Eigen::MatrixXf& cross_;
  Eigen::ArrayXf slopes_;  // after the moves so far
  Eigen::ArrayXf slopes_before_;
  Eigen::ArrayXf low_;   // a step up of a coefficient pays if its slope is below this
  Eigen::ArrayXf high_;  // a step down pays if the slope is above this
  std::vector<int> moved_;
  std::vector<std::pair<int, int>> changed_;  // the moves of an attempt: coefficient, steps
};

}  // namespace mocapress
