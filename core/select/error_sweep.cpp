// SPDX-License-Identifier: MIT
// Based on: R. Featherstone, "Rigid Body Dynamics Algorithms", 2008, section 5.3 (the recursive
// Newton-Euler algorithm), with small displacements for velocities.
#include "core/select/error_sweep.h"

namespace mocapress {
namespace {

auto six(Eigen::MatrixXf& matrix, int index) {
  return matrix.middleCols(Eigen::Index{6} * index, 6);
}

auto six(const Eigen::MatrixXf& matrix, int index) {
  return matrix.middleCols(Eigen::Index{6} * index, 6);
}

/// The work of forces along motions: frames x 6 each. Written out, for one pass over both.
template <typename Force, typename Motion>
auto work(const Force& f, const Motion& m) {
  return f.col(0).array() * m.col(0).array() + f.col(1).array() * m.col(1).array() +
         f.col(2).array() * m.col(2).array() + f.col(3).array() * m.col(3).array() +
         f.col(4).array() * m.col(4).array() + f.col(5).array() * m.col(5).array();
}

template <typename Sum, typename Unit>
void add_times(Sum&& sum, const Unit& unit, const Eigen::ArrayXf& factor) {
  for (int i = 0; i < 6; ++i) sum.col(i).array() += unit.col(i).array() * factor;
}

}  // namespace

ErrorSweep::ErrorSweep(const ErrorModel& model, const Eigen::MatrixXd& errors)
    : model_(model),
      errors_(errors),
      motions_(model.frames(), 6 * std::ssize(model.parents_)),
      forces_(model.frames(), 6 * std::ssize(model.parents_)),
      force_(model.frames(), 6) {
  restart();
}

void ErrorSweep::restart() {
  channel_ = -1;
  joint_ = -1;
  forces_.setZero();
  // From the leaves up: a joint hands its parent what errors below call up, and its own.
  int channel = model_.channels() - 1;
  for (int j = static_cast<int>(std::ssize(model_.parents_)) - 1; j >= 0; --j) {
    const int parent = model_.parents_[static_cast<std::size_t>(j)];
    force_ = six(forces_, j);
    for (; channel >= 0 && model_.places_[static_cast<std::size_t>(channel)].joint == j; --channel)
      add_times(force_, six(model_.forces_, channel), errors_.col(channel).cast<float>().array());
    if (parent >= 0) six(forces_, parent) += force_;
  }
  of_terms_.clear();
  for (const PointTerm& term : model_.terms_) {
    Eigen::MatrixXd& forces = of_terms_.emplace_back(term.no_forces());
    for (int c = 0; c < model_.channels(); ++c) term.add_forces(c, errors_.col(c), forces);
  }
}

void ErrorSweep::enter_joint(int joint) {
  while (joint_ < joint) {
    ++joint_;
    auto motion = six(motions_, joint_);
    if (const int parent = model_.parents_[static_cast<std::size_t>(joint_)]; parent >= 0)
      motion = six(motions_, parent);
    else
      motion.setZero();
    for (int c = channel_;
         c < model_.channels() && model_.places_[static_cast<std::size_t>(c)].joint == joint_; ++c)
      add_times(motion, six(model_.motions_, c), errors_.col(c).cast<float>().array());
  }
}

Eigen::VectorXd ErrorSweep::next() {
  ++channel_;
  const int joint = model_.places_[static_cast<std::size_t>(channel_)].joint;
  enter_joint(joint);
  // Summed before it is widened: a conversion within would be made a number at a time.
  work_ = work(six(model_.forces_, channel_), six(motions_, joint)) +
          work(six(forces_, joint), six(model_.motions_, channel_));
  Eigen::VectorXd gradient = work_.cast<double>();
  for (std::size_t i = 0; i < of_terms_.size(); ++i)
    model_.terms_[i].add_work(channel_, of_terms_[i], gradient);
  return gradient;
}

void ErrorSweep::add(const Eigen::VectorXd& delta) {
  add_times(six(motions_, joint_), six(model_.motions_, channel_), delta.cast<float>().array());
  for (std::size_t i = 0; i < of_terms_.size(); ++i)
    model_.terms_[i].add_forces(channel_, delta, of_terms_[i]);
}

}  // namespace mocapress
