// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace mocapress {

class StudySession;

/// How far the study is, in a line or two.
QString statusOf(const StudySession& session);

/// What to do first, for an empty plot.
QString hintOf(const StudySession& session);

}  // namespace mocapress
