// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/models/report_texts.h"

#include <QCoreApplication>
#include <QLocale>
#include <QRegularExpression>
#include <map>
#include <optional>

#include "core/codec/format/coding.h"
#include "core/metrics/visibility.h"
#include "core/motion/landmarks.h"
#include "widgets/models/display_names.h"
#include "widgets/models/sentence.h"

namespace mocapress {
namespace {

/// Translates the texts of the reports that core writes.
struct ReportTexts {
  Q_DECLARE_TR_FUNCTIONS(mocapress::Report)
 public:
  [[maybe_unused]] static constexpr const char* kAll[] = {
      // Verdicts and what they are about.
      QT_TR_NOOP("approved"),
      QT_TR_NOOP("rejected"),
      QT_TR_NOOP("the clip's file changed"),
      QT_TR_NOOP("the settings changed"),
      QT_TR_NOOP("the clip's file and the settings changed"),
      QT_TR_NOOP("it does not say which file and settings were reviewed"),
      QT_TR_NOOP("the file is missing"),
      QT_TR_NOOP("not visible"),
      QT_TR_NOOP("borderline"),
      QT_TR_NOOP("visible"),
      QT_TR_NOOP("%1 from %2 m"),
      QT_TR_NOOP("built-in limits"),
      QT_TR_NOOP("The eye judges from the viewing distance that is named, by %1."),
      // Sign-offs.
      QT_TR_NOOP("Sign-off"),
      QT_TR_NOOP("Sign-off: %1"),
      QT_TR_NOOP("%1 of %2 reviewed: %3 approved, %4 rejected"),
      QT_TR_NOOP("; %1 verdicts stale"),
      QT_TR_NOOP("; %1 without a verdict"),
      QT_TR_NOOP("Worst frames"),
      QT_TR_NOOP("Every clip"),
      QT_TR_NOOP("Notes"),
      QT_TR_NOOP("Clip"),
      QT_TR_NOOP("frame"),
      QT_TR_NOOP("error, cm"),
      QT_TR_NOOP("largest, cm"),
      QT_TR_NOOP("point"),
      QT_TR_NOOP("joint"),
      QT_TR_NOOP("note"),
      QT_TR_NOOP("verdict"),
      QT_TR_NOOP("by"),
      QT_TR_NOOP("when"),
      QT_TR_NOOP("stale"),
      QT_TR_NOOP("eye"),
      QT_TR_NOOP("ratio"),
      QT_TR_NOOP("bytes"),
      QT_TR_NOOP(
          "A verdict or note is stale if the clip's file or its settings have changed since; stale "
          "verdicts do not count as reviewed. Links open the clip in Mocapress on this computer."),
      // Several reports.
      QT_TR_NOOP("The frame with the largest error of each clip, the largest first."),
      QT_TR_NOOP("frame %1"),
      QT_TR_NOOP("frames %1"),
      QT_TR_NOOP("stale: %1"),
      QT_TR_NOOP("%1 by %2"),
      QT_TR_NOOP("largest error %1 cm"),
      QT_TR_NOOP("errors %1, by %2"),
      QT_TR_NOOP("%1 of %2 at frame %3: %4, noticed from %5"),
      // Review pages.
      QT_TR_NOOP("The viewer needs JavaScript."),
      QT_TR_NOOP("View"),
      QT_TR_NOOP("%1 cannot be shown: %2"),
      QT_TR_NOOP("%1 cannot be loaded"),
      QT_TR_NOOP("Previous clip"),
      QT_TR_NOOP("Next clip"),
      QT_TR_NOOP("Loading"),
      QT_TR_NOOP("Frame"),
      QT_TR_NOOP("Key: %1"),
      QT_TR_NOOP("Play"),
      QT_TR_NOOP("Pause"),
      QT_TR_NOOP("Overlay"),
      QT_TR_NOOP("Side by side"),
      QT_TR_NOOP("Wipe"),
      QT_TR_NOOP("Swap"),
      QT_TR_NOOP("Original"),
      QT_TR_NOOP("Compressed"),
      QT_TR_NOOP("Colour by error"),
      QT_TR_NOOP("Follow"),
      QT_TR_NOOP("Worst frame before"),
      QT_TR_NOOP("Next worst frame"),
      QT_TR_NOOP("Reset camera"),
      QT_TR_NOOP("Frame %1 of %2, %3 s."),
      QT_TR_NOOP("On the bones, %1 is %2 cm off."),
      QT_TR_NOOP("The lightest colour is %1 cm."),
      // Charts.
      QT_TR_NOOP("%1 to %2 s: %3"),
      QT_TR_NOOP("any"),
      QT_TR_NOOP("Rows are joints, the first row is any joint. A full bar marks times with visible "
                 "errors, half a bar borderline ones, no bar errors that nobody sees."),
      QT_TR_NOOP("compression ratio %1 smaller"),
      QT_TR_NOOP("%1: %2 cm at %3"),
      // Reports of batches.
      QT_TR_NOOP("Batch export"),
      QT_TR_NOOP("Errors from 1 to 2 times the noticeable size are borderline, larger ones "
                 "visible. Each clip is judged from the viewing distance that its verdict names, "
                 "by %1. report.csv lists distance and own limits of each clip."),
      QT_TR_NOOP("clips with visible errors"),
      QT_TR_NOOP("clips with borderline errors"),
      QT_TR_NOOP("without visible errors"),
      QT_TR_NOOP("clips done, each read back and measured"),
      QT_TR_NOOP("failed"),
      QT_TR_NOOP("%1 of %2"),
      QT_TR_NOOP("reviewed: %1 approved, %2 rejected"),
      QT_TR_NOOP("stale verdicts"),
      QT_TR_NOOP("still waiting"),
      QT_TR_NOOP("compression ratio of all clips together: %1 KB to %2 KB"),
      QT_TR_NOOP("largest error of any point at any frame; largest %1 %2 cm"),
      QT_TR_NOOP("%1 over its original at its worst frame"),
      QT_TR_NOOP("%1, %2 s: error of %3 cm at the %4."),
      QT_TR_NOOP("The frame with the largest error of each of the clips whose errors are most "
                 "visible: original in grey, compressed in red."),
      QT_TR_NOOP("Failed"),
      QT_TR_NOOP("No file was written for these clips; older files of theirs are unchanged."),
      QT_TR_NOOP("preset"),
      QT_TR_NOOP("reason"),
      QT_TR_NOOP("feet held"),
      QT_TR_NOOP("Errors of the file as read back from the disk, against the original: distances "
                 "in centimetres, rotation errors of joints, head and hands in degrees."),
      QT_TR_NOOP("visibility"),
      QT_TR_NOOP("warnings"),
      QT_TR_NOOP("max"),
      QT_TR_NOOP("at frame"),
      QT_TR_NOOP("joints"),
      QT_TR_NOOP("head"),
      QT_TR_NOOP("hands"),
      QT_TR_NOOP("foot drift"),
      QT_TR_NOOP("worst drift"),
      QT_TR_NOOP("foot path"),
      QT_TR_NOOP("frames"),
      QT_TR_NOOP("asked"),
      QT_TR_NOOP("method"),
      QT_TR_NOOP("The charts show the %1 clips with the most visible errors, out of %2."),
      QT_TR_NOOP("Visible errors over time"),
      QT_TR_NOOP("%1: visible errors over time"),
      QT_TR_NOOP("Repaired or guessed on reading"),
      QT_TR_NOOP("report.csv lists each warning with its file and line."),
      QT_TR_NOOP("warning"),
      QT_TR_NOOP("count"),
      QT_TR_NOOP("clips"),
      QT_TR_NOOP("Verified"),
      QT_TR_NOOP(
          "Each file was read back and decoded as an engine would, by the runtime decoder within "
          "its default limits; errors are those of the decoded motion. Engines cannot play files "
          "in the paper's codings and of comparison methods: the library decodes these. The column "
          "verified_by of report.csv names the decoder of each clip."),
      QT_TR_NOOP("Ratio"),
      QT_TR_NOOP("Bytes of the channels as 32-bit floats, divided by the bytes of the coded "
                 "motion. The skeleton counts on neither side. 1 KB = 1024 bytes."),
      QT_TR_NOOP("Weighted root mean square distance between points of the body and the same "
                 "points of the original. report.csv has it in two more weightings."),
      QT_TR_NOOP("p95, p99, max"),
      QT_TR_NOOP(
          "Percentiles and maximum of these distances over all points and frames, unweighted."),
      QT_TR_NOOP("Visibility"),
      QT_TR_NOOP("Joints, head, hands"),
      QT_TR_NOOP("Angle between a joint's world-space rotation and the original's, root mean "
                 "square over frames and joints. Head and hands are recognised by their names."),
      QT_TR_NOOP("Foot drift, foot path"),
      QT_TR_NOOP("Both are measured while a foot stands in the original. Drift is the distance "
                 "between a foot and its place in the original, as the mean over contacts and in "
                 "the worst contact. Path is the length of the foot's path beyond the original's, "
                 "summed over all contacts; a foot that trembles in place has a long path."),
      QT_TR_NOOP("Verdict, note"),
      QT_TR_NOOP("The reviewer's verdict and note, with name and date. A verdict is stale, and "
                 "does not count, if the clip's file or its settings have changed since."),
      QT_TR_NOOP("Warnings"),
      QT_TR_NOOP("Number of places that were repaired or guessed when the clip was read; they are "
                 "listed above."),
      QT_TR_NOOP("How clips were measured"),
      // Texts that the reports' script shows.
      QT_TR_NOOP("any visibility"),
      QT_TR_NOOP("any verdict"),
      QT_TR_NOOP("none"),
      QT_TR_NOOP("with warnings or without"),
      QT_TR_NOOP("with warnings"),
      QT_TR_NOOP("without warnings"),
      QT_TR_NOOP("max over, cm"),
      QT_TR_NOOP("ratio below"),
      QT_TR_NOOP("name, preset, reason ..."),
      QT_TR_NOOP("show all"),
      QT_TR_NOOP("%1 of %2 clips"),
      QT_TR_NOOP("%1 of %2 clips, the first %3 of them below"),
      // Reports of studies.
      QT_TR_NOOP("Compression study"),
      QT_TR_NOOP("Clips: %1, methods: %2, compressions: %3. Error weighting: %4."),
      QT_TR_NOOP("Error against compression ratio, averaged over the clips"),
      QT_TR_NOOP("Error against compression ratio"),
      QT_TR_NOOP("%1: error against compression ratio"),
      QT_TR_NOOP("The paper"),
      QT_TR_NOOP("The paper: %1"),
      QT_TR_NOOP("%1 frames"),
      QT_TR_NOOP("one clip"),
      QT_TR_NOOP("geometric mean of %1 clips"),
      QT_TR_NOOP("%1 at %2 = %3 cm, %4"),
      QT_TR_NOOP(" (the paper: about %1:1)"),
      QT_TR_NOOP("smaller than %1 at equal error"),
      QT_TR_NOOP("to compress a frame by %1, including the search for the target"),
      QT_TR_NOOP("Use %1: it has the smallest files at %2 = %3 cm over all clips."),
      QT_TR_NOOP("Recommended method"),
      QT_TR_NOOP(
          "The presets use %1. The table shows the ratio at the error of each preset. Presets also "
          "bound the errors of heads, hands and roots, which costs some more bytes."),
      QT_TR_NOOP("Preset"),
      QT_TR_NOOP("mean ratio"),
      QT_TR_NOOP("wavelets by %1"),
      QT_TR_NOOP("no wavelets"),
      QT_TR_NOOP(
          "Bytes of the channels as 32-bit floats, divided by the bytes of the coded motion. The "
          "skeleton counts on neither side, as in the paper. 1 KB = 1024 bytes."),
      QT_TR_NOOP("The paper's positional distortion (section 3.1), weighted by %1: the weighted "
                 "root mean square distance between points of the body and the same points of the "
                 "original. The paper's own figures use the weighting %2."),
      QT_TR_NOOP("Judged from %1 m, by %2."),
      QT_TR_NOOP("Mean"),
      QT_TR_NOOP("Geometric mean over the clips of the ratio at equal %1, at errors within the "
                 "measured range of every clip. Ratios between measured points are interpolated, "
                 "linearly in the logarithms of ratio and error, and marked %2."),
      QT_TR_NOOP("Coding"),
      QT_TR_NOOP("%1, seed %2"),
      QT_TR_NOOP("Time"),
      QT_TR_NOOP("Wall time of a compression, including the search for the target; compressions at "
                 "the same time: up to %1. Work that the compressions of a clip share counts in "
                 "the first of them. The paper used a 2 GHz Athlon 64."),
      QT_TR_NOOP("Figures marked as the paper's are from Tables 1 and 2 of %1."),
      QT_TR_NOOP(
          "These methods have no mean, since no error is within the range of all clips: %1."),
      QT_TR_NOOP("Files are smaller to the right, errors smaller to the bottom. Curves are "
                 "geometric means of the ratio at equal error. The dotted line is 0.5 cm: the "
                 "paper saw no artifacts below it."),
      QT_TR_NOOP("Hollow marks are the paper's Table 1."),
      QT_TR_NOOP("frame %1, %2 s"),
      QT_TR_NOOP("%1 at %2: %3 %4 cm over the clip, largest error %5 cm; at this frame: %6."),
      QT_TR_NOOP("%1, %2 to %3"),
      QT_TR_NOOP("%1: foot that slides most"),
      QT_TR_NOOP("%1: %2 slides %3 cm while planted."),
      QT_TR_NOOP("%1 at %2:1"),
      QT_TR_NOOP("Compressed motion in red over the original in grey, all at the same ratio. The "
                 "first pictures show the frame with the largest error of %1: %2. Lines on the "
                 "floor are half a metre apart."),
      QT_TR_NOOP("The foot that slides most"),
      QT_TR_NOOP(
          "Path of the foot over the floor during one contact: original in grey, compressed dark."),
      QT_TR_NOOP("Size at equal error"),
      QT_TR_NOOP("Time of the annealing"),
      QT_TR_NOOP("Feet held by inverse kinematics"),
      QT_TR_NOOP("Sliding feet"),
      QT_TR_NOOP("Rotation errors"),
      QT_TR_NOOP("Missed targets"),
      QT_TR_NOOP("drift %1"),
      QT_TR_NOOP("contacts"),
      QT_TR_NOOP("mean of a contact"),
      QT_TR_NOOP("At the paper's coefficient ratio r = %1"),
      QT_TR_NOOP("At the compression ratio %1:1"),
      QT_TR_NOOP("KB (ratio)"),
      QT_TR_NOOP("paper"),
      QT_TR_NOOP("ms a frame"),
      QT_TR_NOOP("iterations"),
      QT_TR_NOOP("paper: ms"),
      QT_TR_NOOP("Horizontal path of the feet during contacts, beyond the original's; in brackets "
                 "the mean contact and the worst contact. Contacts are detected in the original; "
                 "clips without contacts are not listed."),
      QT_TR_NOOP("seconds"),
      QT_TR_NOOP("Compression ratio at %1."),
      QT_TR_NOOP("Angle between a joint's world-space rotation and the original's, root mean "
                 "square over frames and joints; in brackets that of the head and of the worse "
                 "hand, if they are recognised by their names. Measured at %1."),
      QT_TR_NOOP("%1 (cm) without, with IK"),
      QT_TR_NOOP("footskate (cm) without, with IK"),
      QT_TR_NOOP("without"),
      QT_TR_NOOP("with"),
      QT_TR_NOOP("knee"),
      QT_TR_NOOP(
          "Clips with and without IK have the same compression ratio, so bytes of the correction "
          "are missing elsewhere. Knee: its highest speed, divided by that of the original."),
      QT_TR_NOOP("every method"),
      QT_TR_NOOP("%1 gave %2"),
      QT_TR_NOOP("%1 combinations of clip and method missed a target"),
      QT_TR_NOOP("missed target"),
      QT_TR_NOOP("first reason"),
      QT_TR_NOOP("nearest result"),
      // Notes on methods.
      QT_TR_NOOP("Cubic wavelets, coefficients moved between channels by annealing: the paper's "
                 "Algorithm 1, candidates compared by a quadratic error model."),
      QT_TR_NOOP("Cubic wavelets, the largest coefficients of all channels, angles scaled by the "
                 "length of the bone: the paper's section 4."),
      QT_TR_NOOP("Cubic wavelets, the largest coefficients of each channel, equally many: the "
                 "paper's first approach in section 4."),
      QT_TR_NOOP("Standard selection in the Haar basis, with which Arikan (2006) compared."),
      QT_TR_NOOP("Standard selection in the interpolating linear basis."),
      QT_TR_NOOP("Cubic wavelets, each coefficient quantised by what its step does to the error in "
                 "the world, channels making good what others lost; adaptive coding."),
      QT_TR_NOOP("Our reading of Arikan (2006): clustered PCA of short Bezier curves of virtual "
                 "markers, the database being the clip alone; k-means clusters, DEFLATE, and no "
                 "special care of the feet."),
      QT_TR_NOOP(
          "What engines do: each channel by itself, key frames left out where a line comes within "
          "the tolerance, steps as fine as the channel needs (as ACL's bit rates), DEFLATE."),
      QT_TR_NOOP("Our reading of Liu and McMillan (2006): PCA of segments, adaptive key frames "
                 "with cubic splines; on channels weighted by what they move, not on markers, and "
                 "with no special care of the feet."),
      QT_TR_NOOP("Principal components of the poses without the root's position, everything in 16 "
                 "bits, DEFLATE: the paper's section 3.2."),
      QT_TR_NOOP("Cubic wavelets on unit quaternions, coefficients moved between components by "
                 "annealing on the linearised rotation: the paper's section 6.3."),
      QT_TR_NOOP("Every s-th frame in 16 bits, DEFLATE; natural cubic splines between."),
  };
};

std::optional<QString> translatedCue(const QString& english) {
  for (std::size_t i = 0; i < kCues; ++i)
    if (const auto cue = static_cast<Cue>(i); english.toStdString() == name(cue))
      return displayName(cue);
  return std::nullopt;
}

/// Translates an amount with its unit.
QString translatedAmount(QString english) {
  return english.replace(QLatin1String(" degrees"), QStringLiteral("°"));
}

/// Translates the reason of a verdict on visibility, in the form that core's reason() writes.
std::optional<QString> translatedReason(const QString& english) {
  static const QRegularExpression kReason(
      QStringLiteral("^(.+?) of (.+) at frame (\\d+): (.+), noticed from (.+)$"));
  const QRegularExpressionMatch match = kReason.match(english);
  const std::optional<QString> cue = translatedCue(match.captured(1));
  if (!cue) return std::nullopt;
  return ReportTexts::tr("%1 of %2 at frame %3: %4, noticed from %5")
      .arg(*cue, match.captured(2), match.captured(3), translatedAmount(match.captured(4)),
           translatedAmount(match.captured(5)));
}

/// Translates the user's own limits, in the form that core's limits_text() writes.
std::optional<QString> translatedLimits(const QString& english) {
  static const QRegularExpression kOwn(QStringLiteral("^own limits: (.+)$"));
  static const QRegularExpression kLimit(QStringLiteral("^(.+?) ([\\d.]+ \\S+)(?: or (.+))?$"));
  const QRegularExpressionMatch own = kOwn.match(english);
  if (!own.hasMatch()) return std::nullopt;
  QStringList limits;
  for (const QString& one : own.captured(1).split(QStringLiteral(", "))) {
    const QRegularExpressionMatch limit = kLimit.match(one);
    const std::optional<QString> cue = translatedCue(limit.captured(1));
    if (!cue) return std::nullopt;
    const QString least = *cue + QLatin1Char(' ') + translatedAmount(limit.captured(2));
    limits << (limit.captured(3).isEmpty()
                   ? least
                   : ReportTexts::tr("%1 or %2").arg(least, limit.captured(3)));
  }
  return ReportTexts::tr("own limits: %1").arg(limits.join(QStringLiteral(", ")));
}

/// Makes a name's first letter small, for use within a sentence.
QString withinSentence(QString name) {
  name[0] = name[0].toLower();
  return name;
}

/// Translates the name of a weighting or coding.
std::optional<QString> translatedChoice(const std::string& english) {
  for (const Weighting weighting : kWeightings)
    if (name(weighting) == english) return withinSentence(displayName(weighting));
  for (const Coding coding : {Coding::Rle16, Coding::Deflate, Coding::Adaptive})
    if (name(coding) == english) return withinSentence(displayName(coding));
  return std::nullopt;
}

std::string translated(const std::string& english) {
  if (english.empty()) return english;
  const QString source = QString::fromStdString(english);
  for (const QString& text : {ReportTexts::tr(english.c_str()), translatedMethod(english.c_str())})
    if (text != source) return text.toStdString();
  if (const auto choice = translatedChoice(english)) return choice->toStdString();
  if (const auto reason = translatedReason(source)) return reason->toStdString();
  return translatedLimits(source).value_or(translatedSentence(source)).toStdString();
}

}  // namespace

ReportLanguage reportLanguage() {
  if (translated("not visible") == "not visible") return {};  // no texts in the user's language
  return {.code = QLocale().bcp47Name().toStdString(),
          .translate =
              [known = std::map<std::string, std::string>()](const std::string& english) mutable {
                const auto [text, is_new] = known.try_emplace(english);
                if (is_new) text->second = translated(english);
                return text->second;
              }};
}

}  // namespace mocapress
