// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/models/report_texts.h"

#include <QCoreApplication>
#include <QLocale>

#include "widgets/models/sentence.h"

namespace mocapress {
namespace {

/// The texts of reports that core writes.
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
      QT_TR_NOOP("own limits: %1"),
      QT_TR_NOOP("The eye judges from the viewing distance that is named, by %1."),
      // Sign-offs.
      QT_TR_NOOP("Sign-off"),
      QT_TR_NOOP("Sign-off: %1"),
      QT_TR_NOOP("%1 of %2 reviewed: %3 approved, %4 rejected"),
      QT_TR_NOOP("; %1 verdicts stale"),
      QT_TR_NOOP("; %1 without a verdict"),
      QT_TR_NOOP("Worst frames"),
      QT_TR_NOOP(
          "The frame with the largest error of each clip, the largest first. Frames count from 0."),
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
  };
};

}  // namespace

ReportLanguage reportLanguage() {
  return {.code = QLocale().bcp47Name().toStdString(), .translate = [](const std::string& english) {
            if (english.empty()) return english;
            const QString text = ReportTexts::tr(english.c_str());
            return translatedSentence(text).toStdString();
          }};
}

}  // namespace mocapress
