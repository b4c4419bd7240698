// SPDX-License-Identifier: MIT
// Based on: R. Featherstone, "Rigid Body Dynamics Algorithms", 2008, section 5.3 (the recursive
// Newton-Euler algorithm), with small displacements for velocities.
#include "core/select/error_sweep.h"

#include <algorithm>

#include "core/select/sweep_kernels.h"

namespace mocapress {
namespace {

auto six(Eigen::MatrixXf& matrix, Eigen::Index index) {
  return matrix.middleCols(6 * index, 6);
}

/// The sums of a joint: those of joint `from`, and what units of channels from `first` to before
/// `end` come to, each times its error. Three at a time, so that sums are read and written once for
/// most joints.
template <typename Factor>
void sum_units(const Eigen::MatrixXf& units, int first, int end, const Factor& factor_of,
               Eigen::MatrixXf& sums, Eigen::Index from, Eigen::Index joint) {
  constexpr int kMost = 3;
  if (first == end && from != joint) six(sums, joint) = six(sums, from);
  for (Eigen::Index i = 0; i < 6; ++i) {
    float* const sum = sums.col(6 * joint + i).data();
    AddedProducts columns{sums.col(6 * from + i).data(), {}, {}};
    for (int c = first; c < end; c += kMost) {
      const int count = std::min(kMost, end - c);
      for (int k = 0; k < count; ++k) {
        columns.units[k] = units.col(Eigen::Index{6} * (c + k) + i).data();
        columns.factors[k] = factor_of(c + k);
      }
      add_products(columns, count, units.rows(), sum);
      columns.before = sum;
    }
  }
}

}  // namespace

ErrorSweep::ErrorSweep(const ErrorModel& model, const Eigen::MatrixXf& errors)
    : model_(model),
      errors_(errors),
      motions_(model.frames(), 6 * std::ssize(model.parents_)),
      forces_(Eigen::MatrixXf::Zero(model.frames(), 6 * std::ssize(model.parents_))),
      is_begun_(model.parents_.size()),
      gradient_(model.frames()) {
  restart();
}

void ErrorSweep::restart() {
  channel_ = -1;
  joint_ = -1;
  std::fill(is_begun_.begin(), is_begun_.end(), false);
  const auto error_of = [this](int channel) { return errors_.col(channel).data(); };
  // From the leaves up: a joint hands its parent what errors below call up, and its own.
  int end = model_.channels();
  for (int j = static_cast<int>(std::ssize(model_.parents_)) - 1; j >= 0; --j) {
    int first = end;
    while (first > 0 && model_.places_[static_cast<std::size_t>(first - 1)].joint == j) --first;
    if (const int parent = model_.parents_[static_cast<std::size_t>(j)]; parent >= 0) {
      // Where nothing hangs on a joint its forces stay zero.
      const auto p = static_cast<std::size_t>(parent);
      if (is_begun_[p]) six(forces_, parent) += six(forces_, j);
      sum_units(model_.forces_, first, end, error_of, forces_, is_begun_[p] ? parent : j, parent);
      is_begun_[p] = true;
    }
    end = first;
  }
  of_terms_.clear();
  for (const PointTerm& term : model_.terms_) {
    Eigen::MatrixXf& forces = of_terms_.emplace_back(term.no_forces());
    for (int c = 0; c < model_.channels(); ++c) term.add_forces(c, errors_.col(c).array(), forces);
  }
}

void ErrorSweep::enter_joint(int joint) {
  while (joint_ < joint) {
    ++joint_;
    const int parent = model_.parents_[static_cast<std::size_t>(joint_)];
    if (parent < 0) six(motions_, joint_).setZero();
    int end = channel_;
    while (end < model_.channels() && model_.places_[static_cast<std::size_t>(end)].joint == joint_)
      ++end;
    sum_units(
        model_.motions_, channel_, end, [this](int channel) { return errors_.col(channel).data(); },
        motions_, parent < 0 ? joint_ : parent, joint_);
  }
}

const Eigen::ArrayXf& ErrorSweep::next() {
  ++channel_;
  const int joint = model_.places_[static_cast<std::size_t>(channel_)].joint;
  enter_joint(joint);
  find_work(six_of(model_.forces_, channel_), six_of(motions_, joint), six_of(forces_, joint),
            six_of(model_.motions_, channel_), gradient_.size(), gradient_.data());
  for (std::size_t i = 0; i < of_terms_.size(); ++i)
    model_.terms_[i].add_work(channel_, of_terms_[i], gradient_);
  return gradient_;
}

void ErrorSweep::add(const Eigen::Ref<const Eigen::ArrayXf>& delta) {
  sum_units(
      model_.motions_, channel_, channel_ + 1, [&](int) { return delta.data(); }, motions_, joint_,
      joint_);
  for (std::size_t i = 0; i < of_terms_.size(); ++i)
    model_.terms_[i].add_forces(channel_, delta, of_terms_[i]);
}

}  // namespace mocapress
