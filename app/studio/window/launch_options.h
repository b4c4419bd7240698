// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>
#include <optional>
#include <span>

class QCoreApplication;

namespace mocapress {

/// Options of the studio's command line.
struct LaunchOptions {
  QStringList files;            // clips, folders, a project, or a link; none: the last clip
  QString skeleton;             // for an .amc
  std::optional<double> ratio;  // initial compression ratio
  std::optional<double> ik;     // initial IK ratio; unset: no IK
  QString screenshot;           // saves a picture of the window once it is complete, and quits
  bool trace = false;           // writes timings to standard error
};

/// True for --help and --version, which need no display.
bool asksForWords(std::span<char* const> arguments);

/// Parses the arguments. Ends the program on --help, --version and errors.
LaunchOptions parseLaunchOptions(const QCoreApplication& application);

}  // namespace mocapress
