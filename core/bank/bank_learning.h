// SPDX-License-Identifier: MIT
// Learns from the clips of a packed bank how to code them: PRIO of FORMAT.md.
#pragma once

#include <cstddef>
#include <vector>

#include "core/bank/bank.h"

namespace mocapress {

/// Learns from up to some hundreds of the clips, read through `files`. Returns the payload of PRIO;
/// empty if it would take more bytes than it saves, or if the observer stopped it. Throws
/// InputError.
std::vector<std::byte> learn_from(const std::vector<BankSource>& sources,
                                  const BankSourceReader& files,
                                  const Observer<BankProgress>& observer = {});

}  // namespace mocapress
