// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/pybind11.h>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "core/codec/format/coding.h"
#include "core/mocapress/player.h"
#include "core/report/measurement.h"

namespace mocapress::python {

/// A .mcpr in memory. Makes a player for it on first use.
class CodedClip {
 public:
  /// Throws FormatError.
  explicit CodedClip(std::vector<std::byte> file, std::optional<Measurement> measurement = {});

  const std::vector<std::byte>& file() const { return file_; }
  const std::optional<Measurement>& measurement() const { return measurement_; }
  const Skeleton& skeleton() const { return skeleton_; }
  const std::string& method() const { return method_; }
  Weighting weighting() const { return weighting_; }
  int frames() const { return frames_; }
  double sample_rate_hz() const { return sample_rate_hz_; }

  /// Throws FormatError if no engine plays the method.
  const Player& player() const;

 private:
  std::vector<std::byte> file_;
  std::optional<Measurement> measurement_;  // set if the clip was encoded, not opened
  Skeleton skeleton_;
  std::string method_;
  Weighting weighting_ = Weighting::Surface;
  int frames_ = 0;
  double sample_rate_hz_ = 0;
  mutable std::once_flag opened_;
  mutable std::optional<Player> player_;
};

/// Reads a clip from a file. Throws InputError, which names the file.
std::shared_ptr<CodedClip> open_clip(const std::filesystem::path& path);

/// Adds Clip, open_clip() and write_bytes().
void bind_clip(pybind11::module_& module);

/// Adds Encoder, which compresses one motion any number of times, and Progress.
void bind_encoder(pybind11::module_& module);

/// Adds Bank.
void bind_bank(pybind11::module_& module);

}  // namespace mocapress::python
