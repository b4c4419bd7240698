// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace mocapress {

/// How much the calling thread, and those that it starts, give way to others: the window comes
/// before all work, and work that is waited for before what is not. No effect but on Linux.
enum class LowerPriority { ToTheWindow, ToEverything };
void lowerPriority(LowerPriority how);

}  // namespace mocapress
