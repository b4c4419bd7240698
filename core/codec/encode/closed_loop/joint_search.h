// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <array>
#include <span>
#include <utility>
#include <vector>

namespace mocapress {

/// Coefficients that make good each other's errors, such as those of all channels at one time and
/// scale: which of them to move by a step so that error and price together become least.
///
/// A local search. One coefficient after the other is moved, and all others answer with what is
/// then best for them; that stays where the whole has gained. So it finds what takes three or more
/// at a time.
class JointSearch {
 public:
  /// By x steps the error grows by 2 slope x + curve x^2 with all others as they are.
  struct Coefficient {
    float slope;                  // bits that so much error is worth, as all that follows
    float curve;                  // > 0
    std::array<float, 3> prices;  // bits a step lower, as it is, and a step higher
  };

  /// The rows of a matrix for so many coefficients: those beyond are zeros.
  static Eigen::Index rows_for(Eigen::Index count) { return (count + 7) / 8 * 8; }

  /// What moves x of all add to the error: 2 slopes x + x^T cross x, whose diagonal is the curves:
  /// rows_for(coefficients) x coefficients. Both must outlive this.
  JointSearch(std::span<const Coefficient> coefficients, const Eigen::MatrixXf& cross);

  /// The moves found, -1 to 1 for each coefficient; zeros where none pays.
  const std::vector<int>& run();

 private:
  /// Moves one either way if that may pay. Returns whether it did. Once for each length of vectors.
  template <typename Vector>
  bool visit(int c);
  bool visit_with_avx2(int c);

  /// Moves one and lets the others answer; keeps that if it pays.
  template <typename Vector>
  bool attempt(int c, int by);

  /// The change of error and price that a move of one makes.
  float cost_of(int c, int by) const;

  /// What others would gain by answering to a step of one down, and up, each by itself.
  template <typename Vector>
  std::array<float, 2> gains_of_answers(int c) const;

  /// Moves one. Returns cost_of().
  template <typename Vector>
  float move(int c, int by);
  void set_limits(int c);

  /// Of as many as a vector has, from `first` on, the next from `from` on whose slope is beyond its
  /// limits; the one after them where there is none.
  template <typename Vector>
  int next_beyond_limits(int first, int from) const;

  int count() const { return static_cast<int>(coefficients_.size()); }

  std::span<const Coefficient> coefficients_;
  const Eigen::MatrixXf& cross_;
  Eigen::ArrayXf slopes_;  // where the moves have come to
  Eigen::ArrayXf slopes_before_;
  Eigen::ArrayXf low_;   // slopes below which a step up pays
  Eigen::ArrayXf high_;  // above which a step down pays
  std::vector<int> moved_;
  std::vector<std::pair<int, int>> changed_;  // in an attempt: which, and by how much
};

}  // namespace mocapress
