// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

namespace mocapress {

/// Fits the weights of the expected scale (value_prediction.cpp) to a folder's clips, starting from
/// the current ones, and prints them.
void fit_scale_weights(const std::filesystem::path& folder);

}  // namespace mocapress
