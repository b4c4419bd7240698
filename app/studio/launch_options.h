// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <optional>

class QCoreApplication;

namespace mocapress {

/// The studio's command line.
struct LaunchOptions {
  QString file;                 // empty: the newest of the recent files, or the bundled walk
  QString skeleton;             // for an .amc
  std::optional<double> ratio;  // compression ratio to begin with
  std::optional<double> ik;     // IK ratio to begin with; unset: feet are not held
  QString screenshot;           // write the window to this PNG once all is computed, and quit
  bool trace = false;           // timings on standard error
};

/// Ends the program on --help, --version and errors.
LaunchOptions parseLaunchOptions(const QCoreApplication& application);

}  // namespace mocapress
