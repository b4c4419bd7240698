// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

namespace mocapress {

/// Fits the weights of the expected scale (value_prediction.cpp) to the clips of a folder, from
/// those of today on, and prints them.
void fit_scale_weights(const std::filesystem::path& folder);

}  // namespace mocapress
