// SPDX-License-Identifier: MIT
#include "core/select/point_term.h"

#include <cassert>

#include "core/select/error_model.h"

namespace mocapress {
namespace {

/// `these` and all channels that share landmarks with any of them.
std::vector<int> related(const ErrorModel& model, const std::vector<int>& these) {
  std::vector<int> channels;
  for (int c = 0; c < model.channels(); ++c)
    for (const int one : these)
      if (model.are_related(c, one)) {
        channels.push_back(c);
        break;
      }
  return channels;
}

}  // namespace

PointTerm::PointTerm(const ErrorModel& model, const PointResponse& response)
    : place_(static_cast<std::size_t>(model.channels()), -1) {
  const Eigen::Index frames = model.frames();
  const Eigen::Index rows = 3 * std::ssize(response.joints);
  assert(response.turns.cols() == std::ssize(response.angles) * rows);
  assert(response.weights.rows() == frames && 3 * response.weights.cols() == rows);
  std::vector<int> movers = response.angles;
  for (const int joint : response.joints)
    for (int c = 0; c < model.channels(); ++c)
      if (model.moves(c, joint)) movers.push_back(c);
  channels_ = related(model, movers);
  const auto count = std::ssize(channels_);
  Eigen::MatrixXd jacobians = Eigen::MatrixXd::Zero(frames, rows * count);
  Eigen::MatrixXd couplings = jacobians;  // B
  const auto jacobian = [&](Eigen::Index i) { return jacobians.middleCols(rows * i, rows); };
  const auto coupling = [&](Eigen::Index i) { return couplings.middleCols(rows * i, rows); };
  const auto turns = [&](Eigen::Index a) { return response.turns.middleCols(rows * a, rows); };
  for (Eigen::Index i = 0; i < count; ++i) {
    const int channel = channels_[i];
    place_[channel] = static_cast<int>(i);
    for (Eigen::Index p = 0; p < std::ssize(response.joints); ++p) {
      const int joint = response.joints[p];
      if (model.moves(channel, joint))
        jacobian(i).middleCols<3>(3 * p) =
            model.velocity(channel, response.places.middleCols(3 * p, 3));
    }
    for (Eigen::Index a = 0; a < std::ssize(response.angles); ++a) {
      const int angle = response.angles[a];
      if (model.are_related(angle, channel))
        coupling(i) += model.entry(angle, channel).cast<double>().matrix().asDiagonal() * turns(a);
    }
  }

  // C: rows x rows numbers a frame.
  Eigen::MatrixXd costs = Eigen::MatrixXd::Zero(frames, rows * rows);
  for (Eigen::Index r = 0; r < rows; ++r)
    for (Eigen::Index s = 0; s < rows; ++s) {
      auto cost = costs.col(rows * r + s);
      if (r == s) cost = response.weights.col(r / 3);
      for (Eigen::Index a = 0; a < std::ssize(response.angles); ++a) {
        const int place = place_[response.angles[a]];
        cost += coupling(place).col(r).cwiseProduct(turns(a).col(s));
      }
    }
  width_ = response.angles.empty() ? rows : 2 * rows;
  motions_.resize(frames, width_ * count);
  forces_.resize(frames, width_ * count);
  for (Eigen::Index i = 0; i < count; ++i) {
    Eigen::MatrixXd force = -coupling(i);
    for (Eigen::Index r = 0; r < rows; ++r)
      for (Eigen::Index s = 0; s < rows; ++s)
        force.col(r) += costs.col(rows * r + s).cwiseProduct(jacobian(i).col(s));
    motions_.middleCols(width_ * i, rows) = jacobian(i).cast<float>();
    forces_.middleCols(width_ * i, rows) = force.cast<float>();
    if (width_ == rows) continue;
    motions_.middleCols(width_ * i + rows, rows) = coupling(i).cast<float>();
    forces_.middleCols(width_ * i + rows, rows) = -jacobian(i).cast<float>();
  }
}

void PointTerm::add_curvature(Eigen::MatrixXd& curvature) const {
  for (Eigen::Index i = 0; i < std::ssize(channels_); ++i)
    curvature.col(channels_[i]) += motions_.middleCols(width_ * i, width_)
                                       .cwiseProduct(forces_.middleCols(width_ * i, width_))
                                       .rowwise()
                                       .sum()
                                       .cast<double>();
}

Eigen::MatrixXf PointTerm::forces_of(const Eigen::MatrixXf& errors) const {
  Eigen::MatrixXf forces = no_forces();
  for (const int channel : channels_) add_forces(channel, errors.col(channel).array(), forces);
  return forces;
}

void PointTerm::add_forces(int channel, const Eigen::Ref<const Eigen::ArrayXf>& delta,
                           Eigen::MatrixXf& forces) const {
  if (place_of(channel) < 0) return;
  for (Eigen::Index n = 0; n < width_; ++n)
    forces.col(n).array() += delta * forces_.col(width_ * place_of(channel) + n).array();
}

void PointTerm::add_work(int channel, const Eigen::MatrixXf& forces,
                         Eigen::Ref<Eigen::ArrayXf> gradient) const {
  if (place_of(channel) < 0) return;
  for (Eigen::Index n = 0; n < width_; ++n)
    gradient += forces.col(n).array() * motions_.col(width_ * place_of(channel) + n).array();
}

void PointTerm::add_sums(const std::vector<int>& channels, Eigen::Index first, Eigen::Index apart,
                         const Eigen::ArrayXf& weights, Eigen::MatrixXf& sums) const {
  std::vector<Eigen::Index> mine;  // indices in `channels` of those that have a place here
  for (Eigen::Index i = 0; i < std::ssize(channels); ++i)
    if (place_of(channels[i]) >= 0) mine.push_back(i);
  const Eigen::Index samples = weights.size();
  const auto count = std::ssize(mine);
  Eigen::MatrixXf motions(width_ * samples, count);
  Eigen::MatrixXf forces(width_ * samples, count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const int channel = channels[mine[i]];
    for (Eigen::Index n = 0; n < width_; ++n) {
      const Eigen::Index column = width_ * place_of(channel) + n;
      const auto at_samples = [&](const Eigen::MatrixXf& of) {
        return of.col(column)(Eigen::seqN(first, samples, apart));
      };
      motions.col(i).segment(n * samples, samples) =
          at_samples(motions_).cwiseProduct(weights.matrix());
      forces.col(i).segment(n * samples, samples) = at_samples(forces_);
    }
  }
  if (forces.isZero(0)) return;
  const Eigen::MatrixXf products = motions.transpose() * forces;
  sums(mine, mine) += products;
}

void PointTerm::add_to_gradient(int channel, const Eigen::VectorXd& delta,
                                Eigen::MatrixXd& gradient) const {
  if (place_of(channel) < 0) return;
  Eigen::MatrixXf forces = no_forces();
  add_forces(channel, delta.cast<float>().array(), forces);
  for (const int other : channels_) {
    Eigen::ArrayXf work = Eigen::ArrayXf::Zero(delta.size());
    add_work(other, forces, work);
    gradient.col(other) += work.matrix().cast<double>();
  }
}

}  // namespace mocapress
