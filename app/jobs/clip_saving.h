// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace mocapress {

struct DecodedClip;
struct OriginalClip;

/// Writes a compressed clip. What the disk gives back is verified before it takes its place:
/// against its original where it was encoded here, else by being read. Throws Error.
void saveClip(const QString& path, const DecodedClip& decoded, const OriginalClip* original);

}  // namespace mocapress
