// SPDX-License-Identifier: GPL-3.0-or-later
// Uses the studio's window at random in a process that will be killed. Each action is in the
// journal before it can be on the disk.
#pragma once

#include <QByteArray>
#include <QString>

namespace mocapress::test {

/// Words of the journal, which has a JSON object on each line, with the time "t" in ms.
namespace journal {

inline constexpr auto kBegun = "begun";     // the state found by the window, with its title
inline constexpr auto kState = "state";     // state of the project: "path" and "text"
inline constexpr auto kSaved = "saved";     // all states so far are reported as saved
inline constexpr auto kBeat = "beat";       // the window is alive
inline constexpr auto kNew = "new";         // about to begin a new project
inline constexpr auto kOpen = "open";       // about to open the project "path"
inline constexpr auto kSaveAs = "save-as";  // about to save the project as "path"

}  // namespace journal

inline constexpr int kBeatTime = 50;  // ms

/// Milliseconds of a clock that all processes share.
qint64 millisecondsNow();

/// Works below `folder`: clips/ to work on, data/ for the studio, named/ for named projects, and
/// journal.jsonl.
int useStudioAtRandom(int argc, char** argv, const QString& folder, unsigned seed);

}  // namespace mocapress::test
