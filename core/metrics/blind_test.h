// SPDX-License-Identifier: MIT
// Based on:
// A. B. Watson and D. G. Pelli, "QUEST: a Bayesian adaptive psychometric method", 1983;
// F. A. Wichmann and N. J. Hill, "The psychometric function: I. Fitting, sampling, and goodness of
// fit", 2001.
// A blind test (ABX): A is the original, B a compressed form, X is one of them. The answers of one
// viewer give the size of error that the viewer just notices.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/random.h"

namespace mocapress {

/// The share of right answers to errors of some level, by a logistic function of the level's
/// logarithm.
struct PsychometricCurve {
  double threshold = 1;  // level half-way between guessing and certainty: 74 % are right
  double slope = 4;      // of the logistic function, over the natural logarithm of the level

  double right(double level) const;
};

inline constexpr double kGuessed = 0.5;  // share of right answers to errors that nobody sees
inline constexpr double kLapses = 0.02;  // share of wrong answers to errors that everybody sees

/// An answer to a question at one level.
struct BlindAnswer {
  double level = 1;
  bool right = false;

  bool operator==(const BlindAnswer&) const = default;
};

/// The curve estimated from answers, by their likelihood over a grid of thresholds and slopes.
struct ThresholdFit {
  PsychometricCurve curve;  // means of threshold and slope, in logarithms
  double low = 0;           // 95 % interval of the threshold
  double high = 0;
  bool found = false;  // false: the interval reaches the end of the grid, so that answers are too
                       // few, or all right, or no better than guessed
};

/// The likelihood of every threshold and slope, by the answers so far.
class ThresholdGrid {
 public:
  /// Thresholds from a quarter of `least` to four times `most`.
  ThresholdGrid(double least, double most);

  void add(const BlindAnswer& answer);
  ThresholdFit fit() const;

 private:
  Eigen::ArrayXd thresholds_;   // logarithms
  Eigen::ArrayXd slopes_;       // likewise
  Eigen::ArrayXXd likelihood_;  // thresholds x slopes, likewise
};

/// ThresholdGrid::fit() after adding all answers at once.
ThresholdFit fit_threshold(std::span<const BlindAnswer> answers, double least, double most);

/// The probability of so many right answers or more by guessing.
double p_by_guessing(int right, int answers);

/// Chooses the questions: the level of error of the next one, and whether X is A or B.
class BlindTest {
 public:
  static constexpr int kUsualQuestions = 40;

  struct Question {
    int level = 0;  // index of a level
    bool x_is_b = false;
  };

  /// `levels` ascend and are above 0.
  BlindTest(std::vector<double> levels, std::uint64_t seed, int questions = kUsualQuestions);

  const std::vector<double>& levels() const { return levels_; }
  const Question& question() const { return question_; }
  int questions() const { return questions_; }
  bool finished() const { return std::ssize(answers_) >= questions_; }

  /// Takes the answer to question() and moves on to the next one. Returns whether the answer was
  /// right.
  bool answer(bool x_is_b);

  std::span<const BlindAnswer> answers() const { return answers_; }
  int right() const;
  ThresholdFit fit() const { return grid_.fit(); }

 private:
  void ask();

  std::vector<double> levels_;
  ThresholdGrid grid_;
  Random random_;
  int questions_;
  Question question_;
  std::vector<BlindAnswer> answers_;
};

}  // namespace mocapress
