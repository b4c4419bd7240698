// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/names.h"

#include <QCoreApplication>

namespace mocapress {
namespace {

struct Names {
  Q_DECLARE_TR_FUNCTIONS(mocapress::Names)
};

}  // namespace

QString displayName(Method method) {
  switch (method) {
    case Method::PerChannel:
      return Names::tr("Per channel");
    case Method::Standard:
      return Names::tr("Standard");
    case Method::Annealed:
      return Names::tr("Annealed");
  }
  return {};
}

QString displayName(Coding coding) {
  return coding == Coding::Rle16 ? Names::tr("16-bit runs") : Names::tr("16-bit runs + DEFLATE");
}

QString displayName(Weighting weighting) {
  return weighting == Weighting::BoneEnds ? Names::tr("Bone ends") : Names::tr("Joint origins");
}

QString displayName(CorrectAt at) {
  return at == CorrectAt::EveryFrame ? Names::tr("Every frame") : Names::tr("Contacts");
}

}  // namespace mocapress
