// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>
#include <optional>
#include <span>

class QCoreApplication;

namespace mocapress {

/// The studio's command line.
struct LaunchOptions {
  QStringList files;            // folders, a project; none: what was open last, or the bundled walk
  QString skeleton;             // for an .amc
  std::optional<double> ratio;  // compression ratio to begin with
  std::optional<double> ik;     // IK ratio to begin with; unset: feet are not held
  QString screenshot;           // write the window to this PNG once all is computed, and quit
  bool trace = false;           // timings on standard error
};

/// Whether --help or --version is asked for, which need no display.
bool asksForWords(std::span<char* const> arguments);

/// Ends the program on --help, --version and errors.
LaunchOptions parseLaunchOptions(const QCoreApplication& application);

}  // namespace mocapress
