// SPDX-License-Identifier: MIT
// What a sweep of the gradient does to columns of numbers, one a frame, in the instruction set that
// the machine has.
#pragma once

#include <Eigen/Core>

namespace mocapress {

/// Six columns that lie one after the other: a motion or a force of each frame.
struct SixColumns {
  const float* first;
  Eigen::Index stride;

  const float* operator[](Eigen::Index i) const { return first + i * stride; }
  SixColumns from(Eigen::Index frame) const { return {first + frame, stride}; }
};

/// Those of a joint or channel, of a matrix with six for each.
inline SixColumns six_of(const Eigen::MatrixXf& matrix, int index) {
  return {matrix.data() + Eigen::Index{6} * index * matrix.rows(), matrix.rows()};
}

/// out = force . motion + other_force . other_motion, at each frame.
void find_work(SixColumns force, SixColumns motion, SixColumns other_force, SixColumns other_motion,
               Eigen::Index frames, float* out);

/// sum += factor * (force . motion), at each frame.
void add_work(SixColumns force, SixColumns motion, const float* factors, Eigen::Index frames,
              float* sum);

/// The inner product of so many numbers, a multiple of eight.
float inner_product(const float* a, const float* b, Eigen::Index count);

/// A column and up to three that are added to it, each times another.
struct AddedProducts {
  const float* before;
  const float* units[3];
  const float* factors[3];
};

/// Writes the sum there or elsewhere.
void add_products(const AddedProducts& columns, int count, Eigen::Index frames, float* sum);

}  // namespace mocapress
