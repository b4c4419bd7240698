// SPDX-License-Identifier: GPL-3.0-or-later
// Sentences of core in the program's language.
#include "widgets/models/sentence.h"

#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QFile>
#include <QRegularExpression>
#include <QTranslator>
#include <algorithm>

#include "core/formats/value_repair.h"

namespace mocapress {
namespace {

/// The program speaks it as long as this lives.
class Speaking {
 public:
  explicit Speaking(const char* language) {
    EXPECT_TRUE(texts_.load(QStringLiteral(":/i18n/mocapress_%1.qm").arg(language)));
    QCoreApplication::installTranslator(&texts_);
  }
  ~Speaking() { QCoreApplication::removeTranslator(&texts_); }

 private:
  QTranslator texts_;
};

std::string told(const std::string& sentence) {
  return translatedSentence(QString::fromStdString(sentence)).toStdString();
}

TEST(Sentence, KeepsItsFileItsLineAndWhatItNames) {
  const Speaking french("fr");
  EXPECT_EQ(told("walk.amc:12: frame '7' has only 3 bones"),
            "walk.amc:12: l'image '7' n'a que 3 os");
  EXPECT_EQ(told("a: b.fbx: take Run: fast is read; there are also Idle, Walk and 4 more"),
            "a: b.fbx: la prise Run: fast est lue ; il y a aussi Idle, Walk et 4 de plus");
  EXPECT_EQ(told("c.bvh:3:9: expected the number of frames, found 'x'"),
            "c.bvh:3:9: attendu : le nombre d'images, trouvé : 'x'");
}

TEST(Sentence, CountsAsTheLanguageDoes) {
  const Speaking french("fr");
  EXPECT_EQ(told("1 joint with the name of another joint"),
            "1 articulation portant le nom d'une autre");
  EXPECT_EQ(told("w.bvh: 3 joints with the name of another joint"),
            "w.bvh: 3 articulations portant le nom d'une autre");
  EXPECT_EQ(told(std::string("2 values") + kRepaired),
            "2 valeurs : non finies ou au-delà de 1e9, remplacées par l'image précédente");
}

TEST(Sentence, IsTranslatedWithinAnother) {
  const Speaking french("fr");
  EXPECT_EQ(told("g.glb: its character is not read: bufferView 6 is compressed by "
                 "EXT_meshopt_compression, which this program cannot read: it was built without "
                 "libmeshoptimizer"),
            "g.glb: son personnage n'est pas lu : la bufferView 6 est compressé par "
            "EXT_meshopt_compression, que ce programme ne peut lire : il a été compilé sans "
            "libmeshoptimizer");
}

TEST(Sentence, StaysWhereNobodyTranslatedIt) {
  const Speaking french("fr");
  EXPECT_EQ(told("x.bvh: something new happened"), "x.bvh: something new happened");
  EXPECT_EQ(told(""), "");
}

TEST(Sentence, IsInEnglishAsItWas) {
  const std::vector<std::string> sentences = {
      "w.bvh: 1 joint with the name of another joint",
      "w.bvh: 3 joints with the name of another joint",
      "f.fbx: take Run is read; there are also Idle and 4 more",
      "1 End Site beside other children left out"};
  for (const std::string& sentence : sentences) EXPECT_EQ(told(sentence), sentence);
  const Speaking english("en");
  for (const std::string& sentence : sentences) EXPECT_EQ(told(sentence), sentence);
}

/// The texts in quotes within the parentheses that open at `start`, those in a row as one.
QStringList literalsIn(const QString& source, qsizetype start) {
  static const QRegularExpression kToken(
      QStringLiteral(R"re("((?:[^"\\]|\\.)*)"|'(?:[^'\\]|\\.)'|[();])re"));
  QStringList literals;
  int depth = 0;
  auto tokens = kToken.globalMatch(source, start);
  while (tokens.hasNext()) {
    const QRegularExpressionMatch token = tokens.next();
    const QString text = token.captured(0);
    if (text.startsWith(QLatin1Char('"'))) literals << token.captured(1);
    depth += text == QLatin1String("(") ? 1 : text == QLatin1String(")") ? -1 : 0;
    if (depth == 0 || text == QLatin1String(";")) break;
  }
  return literals;
}

/// Whoever writes a new sentence into a reader is told to translate it.
TEST(Sentence, AreAllThatReadersSay) {
  static const QRegularExpression kSaid(QStringLiteral(
      R"(\b(?:fail|refuse|warn|leave_out|fail_expecting|take_measure|take_number|take_vector|)"
      R"(InputError|Error|push_back)(\())"));
  const Speaking french("fr");
  const std::vector<QString> known = translatableSentences();
  int checked = 0;
  for (const char* name : {"formats/amc_reader",
                           "formats/asf_reader",
                           "formats/bvh_reader",
                           "formats/csv_reader",
                           "formats/text_cursor",
                           "formats/take_choice",
                           "formats/node_motion",
                           "formats/node_skin",
                           "formats/motion_file",
                           "formats/clip_files",
                           "formats/gltf_reader",
                           "formats/gltf_target",
                           "formats/gltf_meshopt_absent",
                           "formats/gltf_draco_absent",
                           "formats/fbx/fbx_scene",
                           "base/file",
                           "motion/skin",
                           "motion/landmarks",
                           "codec/encode/options/importance",
                           "codec/encode/search/goal"}) {
    QFile file(QStringLiteral(MOCAPRESS_SOURCE_DIR "/core/%1.cpp").arg(QLatin1String(name)));
    ASSERT_TRUE(file.open(QIODevice::ReadOnly)) << name;
    QString source = QString::fromUtf8(file.readAll());
    source.remove(QRegularExpression(QStringLiteral("//[^\n]*")));
    source.remove(QRegularExpression(QStringLiteral(R"("\s*\n\s*")")));
    auto said = kSaid.globalMatch(source);
    while (said.hasNext())
      for (const QString& literal : literalsIn(source, said.next().capturedStart(1))) {
        QString text = literal;
        text.remove(QRegularExpression(QStringLiteral(R"(^[\s:,'"\\]+|[\s'"\\]+$)")));
        if (!text.contains(QLatin1Char(' '))) continue;
        ++checked;
        EXPECT_TRUE(std::any_of(known.begin(), known.end(),
                                [&](const QString& one) { return one.contains(text); }) ||
                    translatedSentence(text) != text)
            << name << ": " << qPrintable(text);
      }
  }
  EXPECT_GT(checked, 120);
}

}  // namespace
}  // namespace mocapress
