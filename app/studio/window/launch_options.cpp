// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/window/launch_options.h"

#include <QCommandLineParser>
#include <QCoreApplication>
#include <QUrl>
#include <algorithm>
#include <array>
#include <string_view>

namespace mocapress {
namespace {

struct Launch {
  Q_DECLARE_TR_FUNCTIONS(mocapress::LaunchOptions)
};

std::optional<double> positive(const QString& text) {
  bool is_number = false;
  const double value = text.toDouble(&is_number);
  return is_number && value > 0 ? std::optional(value) : std::nullopt;
}

}  // namespace

bool asksForWords(std::span<char* const> arguments) {
  constexpr std::array kAsking = {"-h", "--help", "--help-all", "-v", "--version"};
  return std::any_of(arguments.begin(), arguments.end(), [&](std::string_view argument) {
    return std::find(kAsking.begin(), kAsking.end(), argument) != kAsking.end();
  });
}

LaunchOptions parseLaunchOptions(const QCoreApplication& application) {
  QCommandLineParser parser;
  parser.setApplicationDescription(
      Launch::tr("Compress human motion capture clips with wavelets, and look at the result."));
  parser.addHelpOption();
  parser.addVersionOption();
  parser.addPositionalArgument(QStringLiteral("file"),
                               Launch::tr("A project (.mocapress), a motion or a .mcpr file. "
                                          "Several files, and folders, are added to the library. "
                                          "Or a link (mocapress://...)."),
                               QStringLiteral("[FILE|FOLDER...]"));
  const QCommandLineOption skeleton(
      QStringLiteral("skeleton"), Launch::tr("Skeleton (.asf) of an .amc."), QStringLiteral("ASF"));
  const QCommandLineOption ratio(
      QStringLiteral("ratio"), Launch::tr("Compression ratio at the start."), QStringLiteral("R"));
  const QCommandLineOption ik(QStringLiteral("ik"),
                              Launch::tr("Hold the feet, with this IK ratio at the start."),
                              QStringLiteral("R_IK"));
  const QCommandLineOption trace(QStringLiteral("trace"),
                                 Launch::tr("Write timings to standard error."));
  const QCommandLineOption screenshot(
      QStringLiteral("screenshot"),
      Launch::tr("After the clip is compressed, write a picture of the window and quit."),
      QStringLiteral("PNG"));
  parser.addOptions({skeleton, ratio, ik, trace, screenshot});
  parser.process(application);
  LaunchOptions options;
  for (const QString& file : parser.positionalArguments())  // a desktop may give file: addresses
    options.files << (file.startsWith(QLatin1String("file:")) ? QUrl(file).toLocalFile() : file);
  options.skeleton = parser.value(skeleton);
  options.ratio = positive(parser.value(ratio));
  options.ik = positive(parser.value(ik));
  options.screenshot = parser.value(screenshot);
  options.trace = parser.isSet(trace);
  return options;
}

}  // namespace mocapress
