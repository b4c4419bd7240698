// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace mocapress {

class BatchSession;

/// How far a batch is, in one line.
QString statusOf(const BatchSession& session);

/// Of the button that starts, pauses and goes on.
QString startText(const BatchSession& session);

}  // namespace mocapress
