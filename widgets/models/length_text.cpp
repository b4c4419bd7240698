// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/models/length_text.h"

#include <QCoreApplication>

#include "widgets/models/shown_number.h"

namespace mocapress {
namespace {

struct Texts {
  Q_DECLARE_TR_FUNCTIONS(mocapress::Lengths)
};

constexpr double kMillimetres = 10;    // a centimetre
constexpr double kShownAsOne = 0.995;  // cm: from here on two decimals show a whole centimetre
constexpr double kLeastShown = 0.005;  // mm: less is not zero either

}  // namespace

QString lengthText(double cm) {
  if (cm >= kShownAsOne)
    return Texts::tr("%1 cm").arg(shown(cm, cm < 9.995 ? 2 : cm < 99.95 ? 1 : 0));
  const double mm = kMillimetres * cm;
  if (mm <= 0) return Texts::tr("%1 mm").arg(shown(0, 0));
  if (mm < kLeastShown) return Texts::tr("< %1 mm").arg(shown(0.01, 2));
  return Texts::tr("%1 mm").arg(shown(mm, mm < 0.095 ? 2 : 1));
}

QString roundLengthText(double cm) {
  const bool small = cm < kShownAsOne;
  const QString text = QLocale().toString(small ? kMillimetres * cm : cm, 'g', 3);
  return (small ? Texts::tr("%1 mm") : Texts::tr("%1 cm")).arg(text);
}

}  // namespace mocapress
