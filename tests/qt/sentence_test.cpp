// SPDX-License-Identifier: GPL-3.0-or-later
// Sentences of core in the program's language.
#include "widgets/models/sentence.h"

#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QDirIterator>
#include <QFile>
#include <QRegularExpression>
#include <QTranslator>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <map>
#include <random>
#include <span>

#include "core/base/file.h"
#include "core/codec/methods/compared_file.h"
#include "core/formats/motion_file.h"
#include "core/formats/value_repair.h"
#include "tests/support/corpus.h"

namespace mocapress {
namespace {

namespace fs = std::filesystem;

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

TEST(Sentence, NamesTheByteTheLineOrTheKey) {
  const Speaking spanish("es");
  EXPECT_EQ(told("walk.mcpr: byte 120: the coded motion ends early"),
            "walk.mcpr: byte 120: el movimiento codificado acaba antes de tiempo");
  EXPECT_EQ(told("run.fbx: nests records deeper than 64 (byte 1200)"),
            "run.fbx: anida registros a más de 64 (byte 1200) niveles");
  EXPECT_EQ(told("own.json: \"ratio\" is neither a number nor \"auto\""),
            "own.json: \"ratio\" no es ni un número ni «auto»");
  EXPECT_EQ(told("verification: walk.glb does not read back as it was written"),
            "verificación: walk.glb no se relee como se escribió");
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

/// True for sources whose messages the studio never shows: what is only the command line's,
/// Python's or an engine's.
bool isOfOthers(const QString& path) {
  static const QStringList kOthers = {
      QStringLiteral("/core/bank/"),          // the studio makes banks by batch alone
      QStringLiteral("/core/base/windows/"),  // as its neighbours for Linux
      QStringLiteral("/core/codec/methods/additive_encoder"),
      QStringLiteral("/core/mocapress/example/"),
      QStringLiteral("/core/mocapress/player"),
      QStringLiteral("/core/mocapress/python/"),
      QStringLiteral("/core/motion/difference"),     // additive clips
      QStringLiteral("/core/report/review_script"),  // JavaScript of pages
      QStringLiteral("/core/runtime/format/memory"),
      QStringLiteral("/core/runtime/format/packed_clip"),  // clips of banks
      QStringLiteral("/core/runtime/pose/"),               // cooked clips
      QStringLiteral("/core/runtime/web/"),
      QStringLiteral("_interface.cpp")};
  return std::any_of(kOthers.begin(), kOthers.end(),
                     [&](const QString& one) { return path.contains(one); });
}

/// True for pieces of a sentence that only shards of a batch, the rivals' own interface and other
/// parts that the studio has no way to reach can say.
bool isOfOthersAlone(const QString& text) {
  static const QStringList kOthers = {
      QStringLiteral("a curve cannot be deflated"),
      QStringLiteral(
          "a shard has not all clips of a bank: make it of the .mcpr files when all are done"),
      QStringLiteral("a shard is written i/n, i from 1 to n, not"),
      QStringLiteral("an FBX is written as version 7.4 or 7.7 only"),
      QStringLiteral("has a name with half a surrogate pair, which no text holds"),  // Windows
      QStringLiteral("is neither a file nor a preset"),
      QStringLiteral("is not shown: it is not beside the file"),  // two sentences, tested above
      QStringLiteral("not a pose"),                               // caught where it is thrown
      QStringLiteral("scale and rounding"),                       // a row of a table
      QStringLiteral("section heads"),
      QStringLiteral("the skeletons of a database must have the same joints and channels")};
  return kOthers.contains(text);
}

/// Whoever writes a new message into core is told to translate it.
TEST(Sentence, AreAllThatCoreSays) {
  static const QRegularExpression kSaid(QStringLiteral(
      R"(\b(?:fail|fail_at|failure|refuse|warn|leave_out|fail_expecting|take_measure|take_number|)"
      R"(take_vector|(?:Input|Format|Write)?Error|TargetMissed|push_back)(\())"));
  const Speaking french("fr");
  const std::vector<QString> known = translatableSentences();
  int checked = 0;
  QDirIterator files(QStringLiteral(MOCAPRESS_SOURCE_DIR "/core"),
                     {QStringLiteral("*.cpp"), QStringLiteral("*.h")}, QDir::Files,
                     QDirIterator::Subdirectories);
  while (files.hasNext()) {
    const QString path = files.next();
    if (isOfOthers(path)) continue;
    QFile file(path);
    ASSERT_TRUE(file.open(QIODevice::ReadOnly)) << qPrintable(path);
    QString source = QString::fromUtf8(file.readAll());
    source.remove(QRegularExpression(QStringLiteral("//[^\n]*")));
    source.remove(QRegularExpression(QStringLiteral(R"("\s*\n\s*")")));
    auto said = kSaid.globalMatch(source);
    while (said.hasNext())
      for (const QString& literal : literalsIn(source, said.next().capturedStart(1))) {
        QString text = literal;
        text.replace(QStringLiteral("\\\""), QStringLiteral("\""));
        text.remove(QRegularExpression(QStringLiteral(R"(^[\s:,'"\\]+|[\s'"\\]+$)")));
        if (!text.contains(QLatin1Char(' ')) || isOfOthersAlone(text)) continue;
        ++checked;
        EXPECT_TRUE(std::any_of(known.begin(), known.end(),
                                [&](const QString& one) { return one.contains(text); }) ||
                    translatedSentence(text) != text)
            << qPrintable(path) << ": " << qPrintable(text);
      }
  }
  EXPECT_GT(checked, 400);
}

/// Collects what core says about files, each kind of sentence once.
class Said {
 public:
  template <typename Read>
  void collect(const Read& read) {
    try {
      for (const Warning& warning : read()) add(warning.text());
    } catch (const Error& error) {
      add(error.what());
    }
  }
  const std::map<std::string, std::string>& texts() const { return texts_; }

 private:
  void add(const std::string& text) {
    // The system's reasons are in the language of the C library.
    std::string kind;
    for (const char letter : text)
      if (letter < '0' || letter > '9') kind += letter;
    texts_.emplace(kind, text);
  }
  std::map<std::string, std::string> texts_;  // by the text without digits
};

Warnings warningsOf(const fs::path& path, const std::string& bytes) {
  if (path.extension() != ".mcpr") return read_motion_bytes(path, bytes).warnings;
  read_mcpr(std::as_bytes(std::span(bytes)));
  return {};
}

/// The messages about a file, and about copies that are cut short or have some bytes replaced.
void collectFrom(const fs::path& path, Said& said) {
  constexpr std::size_t kLargest = 30'000;
  constexpr std::size_t kCuts = 12;
  constexpr int kReplaced = 20;
  std::string bytes;
  said.collect([&] {
    bytes = read_text(path);
    return Warnings();
  });
  if (bytes.empty()) return;
  said.collect([&] { return warningsOf(path, bytes); });
  if (bytes.size() > kLargest) return;
  for (std::size_t cut = 0; cut < kCuts; ++cut)
    said.collect([&] { return warningsOf(path, bytes.substr(0, bytes.size() * cut / kCuts)); });
  std::mt19937 random(7);
  for (int i = 0; i < kReplaced; ++i) {
    std::string damaged = bytes;
    for (int j = 0; j < 3; ++j) damaged[random() % damaged.size()] = "{}[]-0,:9x \n"[random() % 12];
    said.collect([&] { return warningsOf(path, damaged); });
  }
}

/// An English word that is none in the other languages.
const QRegularExpression kEnglish(QStringLiteral(
    R"(\b(the|of|is|are|has|have|with|than|more|which|cannot|found|expected|ends|its|too|not|only)\b)"));

/// The words of a sentence that are not names: without its file and what is in quotes.
QString ownWords(QString text, const QString& file) {
  text.remove(file);
  text.remove(QRegularExpression(QStringLiteral(R"('[^']*'|"[^"]*")")));
  return text;
}

TEST(Sentence, LeavesNoEnglishOfOddAndHostileFiles) {
  std::vector<fs::path> folders = {MOCAPRESS_SOURCE_DIR "/tests/fuzz/corpus"};
  if (const auto corpus = test::corpus())
    for (const char* folder : {"attack", "fbx_fuzz", "gltf", "odd", "strangers"})
      folders.push_back(*corpus / folder);
  for (const fs::path& folder : folders) {
    Said said;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
      if (entry.is_regular_file() && entry.path().extension() != ".mcpk" &&
          entry.path().extension() != ".md" && entry.path().has_extension())
        collectFrom(entry.path(), said);
    for (const char* language : {"es", "fr", "ja"}) {
      const Speaking speaking(language);
      for (const auto& [kind, text] : said.texts()) {
        if (text.ends_with("...")) continue;  // cut after 200 characters
        const std::string translated = told(text);
        EXPECT_FALSE(
            kEnglish
                .match(ownWords(QString::fromStdString(translated),
                                QString::fromStdString(text).section(QLatin1String(": "), 0, 0)))
                .hasMatch())
            << text << "\n  " << language << ": " << translated;
      }
    }
    std::printf("%s: %zu sentences\n", folder.c_str(), said.texts().size());
  }
}

}  // namespace
}  // namespace mocapress
