// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace mocapress {

/// The bytes of a .mcpr file by joint and time. A coefficient's bits count for the joint that its
/// channel turns or moves (a correction's, for its effector) and evenly for the frames that it
/// stands for: 2^k in the k-th finest band. Bits that say which bands of a channel are empty, and
/// a channel's step, count evenly for all frames.
struct ByteCosts {
  struct Part {
    std::string name;  // "skeleton", "description" ...
    double bytes = 0;
  };

  int slice_frames = 1;    // frames of a slice, at most those of the clip
  Eigen::MatrixXd bytes;   // slices x joints; all zeros where the coding cannot be divided
  std::vector<Part> rest;  // everything else in the file
  std::size_t file_bytes = 0;

  Eigen::RowVectorXd by_joint() const { return bytes.colwise().sum(); }
  Eigen::VectorXd by_slice() const { return bytes.rowwise().sum(); }
};

/// Divides a file into its costs. Each bit costs -log2 of the probability with which the decoder
/// expects it, so the sum of `bytes` and `rest` is the file's size; the coder's own rounding (less
/// than 8 bytes a segment) is part of `rest`. Only the adaptive coding is divided: other motions
/// are one part of `rest`. Throws FormatError for a file that is not valid.
ByteCosts byte_costs(std::span<const std::byte> mcpr, int slice_frames);

}  // namespace mocapress
