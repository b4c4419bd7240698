// SPDX-License-Identifier: GPL-3.0-or-later
// The studio's window, used at random by a process that expects to be killed. What it does is in a
// journal before it can be on the disk.
#pragma once

#include <QByteArray>
#include <QString>

namespace mocapress::test {

/// The words of the journal: a JSON object a line, with the time "t" in ms.
namespace journal {

inline constexpr auto kBegun = "begun";     // the state that the window found, its title too
inline constexpr auto kState = "state";     // of the project: "path" and "text"
inline constexpr auto kSaved = "saved";     // all states so far are said to be on the disk
inline constexpr auto kBeat = "beat";       // the window is alive
inline constexpr auto kNew = "new";         // about to begin a new project
inline constexpr auto kOpen = "open";       // about to open the project "path"
inline constexpr auto kSaveAs = "save-as";  // about to save the project as "path"

}  // namespace journal

inline constexpr int kBeatTime = 50;  // ms

/// Of a clock that all processes share.
qint64 millisecondsNow();

/// Below `folder`: clips/ to work on, data/ for the studio, named/ for projects with a name, and
/// journal.jsonl.
int useStudioAtRandom(int argc, char** argv, const QString& folder, unsigned seed);

}  // namespace mocapress::test
