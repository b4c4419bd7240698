// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/models/sentence.h"

#include <QCoreApplication>
#include <QRegularExpression>
#include <QStringList>
#include <algorithm>
#include <functional>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "widgets/models/sentence_lists.h"

namespace mocapress {
namespace {

constexpr const char* kContext = "mocapress::Sentence";

/// The sentences of the readers and the encoder; %1, %2 and so on stand for the parts that vary.
constexpr const char* kSentences[] = {
    // Warnings of all formats.
    QT_TRANSLATE_NOOP("mocapress::Sentence",
                      "%1 not finite or beyond 1e9, replaced by the frame before"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "%1 with the name of another joint, numbered: Name.2"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "%1 with the name of another joint"),
    QT_TRANSLATE_NOOP("mocapress::Sentence",
                      "the file ends within its last frame, which is dropped"),
    QT_TRANSLATE_NOOP(
        "mocapress::Sentence",
        "keys lie unevenly: %1 of %2 frames carry keys; frames between are interpolated"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "take %1 is read; there are also %2"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "%1 and %2 more"),
    QT_TRANSLATE_NOOP(
        "mocapress::Sentence",
        "looks like an additive clip, near its rest pose with the root at the origin: errors are "
        "those that it makes on that pose, and where feet stand means nothing"),
    QT_TRANSLATE_NOOP(
        "mocapress::Sentence",
        "no bone has a length: errors are measured on three points 3 cm from each joint"),
    QT_TRANSLATE_NOOP("mocapress::Sentence",
                      "the mesh reaches much further than the bones at %1, first %2 (%3 cm, not "
                      "%4): the surface there is the mesh"),
    // Warnings of BVH, ASF and AMC.
    QT_TRANSLATE_NOOP("mocapress::Sentence",
                      "the figure stands along Z, but Y is taken to point up: --up z, or the "
                      "import options of the studio, read it upright"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "%1 beside other children left out"),
    QT_TRANSLATE_NOOP("mocapress::Sentence",
                      "the header says %1 frames, %2 follow: all of them are read"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "%1 of scale kept as tracks, which move no joint"),
    QT_TRANSLATE_NOOP("mocapress::Sentence",
                      "a Frame Time of %1 s cannot be right: taken as %2 frames per second"),
    QT_TRANSLATE_NOOP(
        "mocapress::Sentence",
        "translation channels of the root are taken to replace OFFSET, as their values suggest"),
    QT_TRANSLATE_NOOP("mocapress::Sentence",
                      "translation channels of the joints below the root are taken to replace "
                      "OFFSET, as their values suggest"),
    QT_TRANSLATE_NOOP("mocapress::Sentence",
                      "translation channels of the root are taken to replace OFFSET, as Blender "
                      "and MotionBuilder do: their values do not tell"),
    QT_TRANSLATE_NOOP("mocapress::Sentence",
                      "translation channels of the joints below the root are taken to replace "
                      "OFFSET, as Blender and MotionBuilder do: their values do not tell"),
    QT_TRANSLATE_NOOP(
        "mocapress::Sentence",
        "no unit of length is given: a rest pose %1 units tall is taken to have %2 cm to the unit"),
    QT_TRANSLATE_NOOP("mocapress::Sentence",
                      "frame numbers do not run 1, 2, 3 from here: frames are taken as they come"),
    QT_TRANSLATE_NOOP("mocapress::Sentence",
                      "%1 missing from a frame, where the frame before is repeated"),
    QT_TRANSLATE_NOOP("mocapress::Sentence",
                      "%1 with three values where the skeleton names fewer, read as its dof and "
                      "the axes missing from it"),
    QT_TRANSLATE_NOOP("mocapress::Sentence",
                      "%1 with three values where the skeleton names fewer, read as rx ry rz"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "%1 with dof but without values, left at rest"),
    QT_TRANSLATE_NOOP("mocapress::Sentence",
                      "%1 with a length that changes (dof l), which is ignored"),
    // Warnings of glTF and FBX.
    QT_TRANSLATE_NOOP(
        "mocapress::Sentence",
        "%1 whose scale changes over time: joints are in their places, those of joints are kept as "
        "tracks, but errors are measured on a skin with the scales of the first frame"),
    QT_TRANSLATE_NOOP("mocapress::Sentence",
                      "%1 scaled unevenly, first %2: joints are in their places, but a skin has "
                      "the scales of the first frame"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "%1 of the animation left out, which moves no node"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "%1 of the animation left out, which move no node"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "morph weights are not read: the file %1"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "its character is not read: %1"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "the picture %1 is not shown: %2"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "it is not beside the file"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "it is neither PNG nor JPEG"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "it has more than 64 MiB"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "it has more than %1 bones"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "it has too many vertices"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "a vertex is not finite, or farther than 1e9 cm away"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "the first take, %1, stands still"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "%1 left out: not a finite number"),
    QT_TRANSLATE_NOOP("mocapress::Sentence",
                      "%1 with spheric XYZ angles, which are read as XYZ angles"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "%1 stated again: each counts once"),
    QT_TRANSLATE_NOOP("mocapress::Sentence",
                      "%1 with quaternions between keys, which are read as angles"),
    QT_TRANSLATE_NOOP(
        "mocapress::Sentence",
        "%1 of weights or properties left out: too many, too long a name, or beyond 1e9"),
    // Warnings of characters.
    QT_TRANSLATE_NOOP(
        "mocapress::Sentence",
        "the clip has no joint %1, nor %2 more: what hangs there stays in its bind pose"),
    QT_TRANSLATE_NOOP("mocapress::Sentence",
                      "the clip has no joint %1: what hangs there stays in its bind pose"),
    QT_TRANSLATE_NOOP("mocapress::Sentence",
                      "the clip has no joint %1, nor %2 more: they carry most of the character"),
    QT_TRANSLATE_NOOP("mocapress::Sentence",
                      "the clip has no joint %1: they carry most of the character"),
    QT_TRANSLATE_NOOP(
        "mocapress::Sentence",
        "has other proportions than the clip, and legs of %1 % the length: it is shown and "
        "coloured with its own bones, and figures are measured on the clip's"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "is not put on: %1"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "cannot be put on: %1"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "has no mesh that hangs on joints"),
    // Files that cannot be read at all.
    QT_TRANSLATE_NOOP("mocapress::Sentence", "No such file or directory"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "is a folder, not a file"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "is a pipe or a device, not a file"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "cannot be read to its end"),
    QT_TRANSLATE_NOOP("mocapress::Sentence",
                      "is a pointer of Git LFS, not the file itself: 'git lfs pull' fetches that"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "is none of %1"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "holds none of %1"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "is a link that leads nowhere"),
    QT_TRANSLATE_NOOP("mocapress::Sentence",
                      "is a skeleton without motion: open one of its .amc files"),
    QT_TRANSLATE_NOOP("mocapress::Sentence",
                      "needs its skeleton, but neither %1.asf nor %2.asf is beside it"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "needs its skeleton, but %1.asf is not beside it"),
    QT_TRANSLATE_NOOP("mocapress::Sentence",
                      "holds no animation, but may be put on a clip as its character"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "has no take %1: there are %2"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "has neither bones nor anything else that moves"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "no joint moves or is turned"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "needs more than %1 frames"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "needs more than %1 samples"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "joints are nested deeper than %1"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "more than %1 joints"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "the name of a joint has more than %1 bytes"),
    QT_TRANSLATE_NOOP("mocapress::Sentence",
                      "%1 has a transform that is not finite, or beyond 1e9"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "%1 is farther than 1e9 cm away"),
    QT_TRANSLATE_NOOP("mocapress::Sentence",
                      "has a JSON value of another type than its place asks for"),
    QT_TRANSLATE_NOOP("mocapress::Sentence",
                      "cannot be read: a library that reads its parts failed"),
    // Text that breaks the rules of its format.
    QT_TRANSLATE_NOOP("mocapress::Sentence", "expected one sample per second or more, found %1"),
    QT_TRANSLATE_NOOP(
        "mocapress::Sentence",
        "expected a new line after the %1 values of the frame that begins in line %2, found %3"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "expected %1 values for %2, found %3"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "expected a bone of %1, found %2"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "expected a positive unit of length, found %1"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "expected a complete frame, found none"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "expected a name after 'name'"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "expected a number, found %1"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "expected %1, found %2"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "%1 channels such as Xposition or Zrotation"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "a frame number"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "nothing"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "samples per second"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "the end of the file"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "the number of frames"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "the number of channels"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "the time of a frame in seconds"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "the name of the joint"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "the name of a bone"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "a coordinate of OFFSET"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "a coordinate of direction"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "a coordinate of position"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "an angle of axis"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "an angle of orientation"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "an order of axes such as XYZ"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "the length of the bone"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "the unit of length"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "the end of the bone"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "the end of the hierarchy"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "a section such as :units or :bonedata"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "OFFSET, CHANNELS, JOINT, End Site or }"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "OFFSET or the } of the End Site"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "deg or rad"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "tx, ty, tz, rx, ry, rz or l"),
    QT_TRANSLATE_NOOP("mocapress::Sentence",
                      "numbers have a decimal comma, such as %1: a decimal point is read"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "is UTF-16: save it as UTF-8 to have it read"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "no joint has a channel: nothing moves"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "no complete frame follows"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "a second CHANNELS line for one joint"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "channel %1 twice in one joint"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "more than %1 channels of scale that change"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "the file ends within its first frame"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "no bone has a value: nothing moves"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "frame %1 has only %2 bones"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "%1 is not in the first frame"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "%1 twice in one frame"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "%1 twice in one bone"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "more than %1 bones"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "this bone has no name"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "bone %1 lacks its direction or length"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "bone %1 is nested deeper than %2"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "bone %1 does not hang from the root in :hierarchy"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "the name of a bone has more than %1 bytes"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "a second bone named %1"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "a second parent for %1"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "has no line of names"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "a column needs a name of 1 to 255 bytes"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "a name of a column has no quotes"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "two columns are called %1"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "is one more than the clip's %1"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "ends after values of %1, the clip has %2"),
    // glTF and FBX that cannot be read.
    QT_TRANSLATE_NOOP("mocapress::Sentence",
                      "is compressed by EXT_meshopt_compression, which this program cannot read: "
                      "it was built without libmeshoptimizer"),
    QT_TRANSLATE_NOOP("mocapress::Sentence",
                      "is compressed by KHR_draco_mesh_compression, which this program cannot "
                      "read: it was built without libdraco"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "is not what %1 makes"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "is too large to read"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "bufferView %1 %2"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "has a mesh that %1"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "has an animation without keys"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "has an animation with %1 key times, but %2 values"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "has an animation whose key times go back"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "has an animation channel without a sampler"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "has an animation channel without a target"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "has an animation of node %1, which it has not"),
    QT_TRANSLATE_NOOP("mocapress::Sentence",
                      "has an animation that moves the morph weights of a node twice"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "has an unknown interpolation, %1"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "has a rotation of length 0"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "has a node that is below itself"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "has node %1 below two nodes, or twice below one"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "has more than %1 nodes"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "has a name of more than %1 bytes"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "has morph weights of a node without a mesh"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "has too many morph targets"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "has too many morph weights"),
    QT_TRANSLATE_NOOP("mocapress::Sentence",
                      "moves neither nodes nor morph weights that can be read"),
    QT_TRANSLATE_NOOP("mocapress::Sentence",
                      "asks for %1 frames of %2 nodes, too many for a file of so few bytes"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "holds no keys"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "its take %1 moves no node"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "its nodes hang in a circle"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "its nodes hang deeper than %1"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "has keys at impossible times"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "has too many nodes for so many frames"),
    // Errors of the encoder.
    QT_TRANSLATE_NOOP(
        "mocapress::Sentence",
        "the target of %1 is out of reach with this method: the nearest is %2, a smaller file"),
    QT_TRANSLATE_NOOP(
        "mocapress::Sentence",
        "the target of %1 is out of reach with this method: the nearest is %2, a larger file"),
    QT_TRANSLATE_NOOP("mocapress::Sentence",
                      "the target of %1 is out of reach with this method: the nearest is %2"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "a promise beside the target is out of reach: %1"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "no joint is of any importance"),
    QT_TRANSLATE_NOOP("mocapress::Sentence",
                      "the importance of a joint must be a number, 0 or more"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "the importance of every joint is needed, or of none"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "the skeleton has no joint named %1"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "%1 is turned (degrees, RMS) by %2, not %3"),
    QT_TRANSLATE_NOOP("mocapress::Sentence",
                      "the weighting skin needs a clip with a mesh on its joints, or a character "
                      "that is put on it"),
    // Files that cannot be written, and what fits nowhere else.
    QT_TRANSLATE_NOOP(
        "mocapress::Sentence",
        "cannot be written: its extension is none of .bvh, .fbx, .glb, .gltf, .amc, .csv"),
    QT_TRANSLATE_NOOP("mocapress::Sentence",
                      "is not written: the motion has values that are not finite"),
    QT_TRANSLATE_NOOP("mocapress::Sentence",
                      "only an .fbx can be written onto an .fbx, and a .glb or .gltf onto a glTF"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "cannot be written: %1"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "cannot be read: %1"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "cannot be looked at: %1"),
    QT_TRANSLATE_NOOP("mocapress::Sentence", "has %1 for %2"),
};

/// Counted nouns that occur within the sentences.
constexpr const char* kCounts[] = {
    QT_TRANSLATE_N_NOOP("mocapress::Sentence", "%n value(s)"),
    QT_TRANSLATE_N_NOOP("mocapress::Sentence", "%n joint(s)"),
    QT_TRANSLATE_N_NOOP("mocapress::Sentence", "%n node(s)"),
    QT_TRANSLATE_N_NOOP("mocapress::Sentence", "%n connection(s)"),
    QT_TRANSLATE_N_NOOP("mocapress::Sentence", "%n bone(s)"),
    QT_TRANSLATE_N_NOOP("mocapress::Sentence", "%n channel(s)"),
    QT_TRANSLATE_N_NOOP("mocapress::Sentence", "%n curve(s)"),
    QT_TRANSLATE_N_NOOP("mocapress::Sentence", "%n key(s)"),
    QT_TRANSLATE_N_NOOP("mocapress::Sentence", "%n frame(s)"),
    QT_TRANSLATE_N_NOOP("mocapress::Sentence", "%n column(s)"),
    QT_TRANSLATE_N_NOOP("mocapress::Sentence", "%n End Site(s)"),
};

/// A sentence with placeholders, and a regular expression that matches it.
struct Pattern {
  const char* source;
  QRegularExpression fits;
};

QRegularExpression expressionOf(const char* source) {
  QString text = QRegularExpression::escape(QString::fromUtf8(source));
  static const QRegularExpression kPlace(QStringLiteral("\\\\%\\d"));
  // A placeholder at the beginning must not match a "file:line: " before the sentence.
  if (text.startsWith(QLatin1String("\\%1"))) text.replace(0, 3, QStringLiteral("((?:(?!: ).)+?)"));
  text.replace(kPlace, QStringLiteral("(.+?)"));
  text.replace(QStringLiteral("\\%n"), QStringLiteral("(\\d+)"));
  text.replace(QStringLiteral("\\(s\\)"), QStringLiteral("s?"));
  return QRegularExpression(QRegularExpression::anchoredPattern(text));
}

std::vector<Pattern> patternsOf(std::span<const char* const> sources) {
  std::vector<Pattern> patterns;
  for (const char* source : sources) patterns.push_back({source, expressionOf(source)});
  return patterns;
}

std::vector<const char*> allSentences() {
  std::vector<const char*> all(std::begin(kSentences), std::end(kSentences));
  for (const std::span<const char* const> list : {sentencesOfBytes(), sentencesOfWork()})
    all.insert(all.end(), list.begin(), list.end());
  // Where two patterns match, the longer one is more specific, so it is tried first.
  std::ranges::stable_sort(all, std::ranges::greater(),
                           [](const char* source) { return std::string_view(source).size(); });
  return all;
}

/// Fills the placeholders of `pattern`: %1 is the first of `parts`.
QString filled(const QString& pattern, const QStringList& parts) {
  QString text;
  for (qsizetype i = 0; i < pattern.size(); ++i) {
    const int place =
        pattern[i] == QLatin1Char('%') && i + 1 < pattern.size() ? pattern[i + 1].digitValue() : -1;
    if (place < 1 || place > parts.size()) {
      text += pattern[i];
    } else {
      text += parts[place - 1];
      ++i;
    }
  }
  return text;
}

/// Translates a text as a whole. Unset if no pattern matches all of it; counts also need a
/// translation.
std::optional<QString> translatedWhole(const QString& text) {
  static const std::vector<Pattern> kAll = patternsOf(allSentences());
  static const std::vector<Pattern> kAllCounts = patternsOf(kCounts);
  for (const auto& [source, fits] : kAllCounts)
    if (const QRegularExpressionMatch match = fits.match(text); match.hasMatch())
      if (const QString counted =
              QCoreApplication::translate(kContext, source, nullptr, match.captured(1).toInt());
          !counted.contains(QLatin1String("(s)")))
        return counted;
  for (const auto& [source, fits] : kAll) {
    const QRegularExpressionMatch match = fits.match(text);
    if (!match.hasMatch()) continue;
    QStringList parts;
    for (const QString& part : match.capturedTexts().mid(1)) parts << translatedSentence(part);
    return filled(QCoreApplication::translate(kContext, source), parts);
  }
  return std::nullopt;
}

}  // namespace

QString translatedSentence(const QString& sentence) {
  const QString colon = QStringLiteral(": ");
  for (qsizetype start = 0;; start += colon.size()) {
    if (const std::optional<QString> found = translatedWhole(sentence.mid(start)))
      return sentence.left(start) + *found;
    start = sentence.indexOf(colon, start);
    if (start < 0) return sentence;
  }
}

std::vector<QString> translatableSentences() {
  std::vector<QString> sentences;
  for (const char* source : allSentences()) sentences.push_back(QString::fromUtf8(source));
  for (const char* source : kCounts) sentences.push_back(QString::fromUtf8(source));
  return sentences;
}

}  // namespace mocapress
