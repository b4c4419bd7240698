// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/names.h"

#include <QCoreApplication>

#include "widgets/models/method_names.h"

namespace mocapress {
namespace {

struct Names {
  Q_DECLARE_TR_FUNCTIONS(mocapress::Names)
};

}  // namespace

QString displayName(Method method) {
  return methodTitle(name(method));
}

QString displayName(Coding coding) {
  switch (coding) {
    case Coding::Rle16:
      return Names::tr("16-bit runs");
    case Coding::Deflate:
      return Names::tr("16-bit runs + DEFLATE");
    case Coding::Adaptive:
      return Names::tr("Adaptive");
  }
  return {};
}

QString displayName(Weighting weighting) {
  return weighting == Weighting::BoneEnds ? Names::tr("Bone ends") : Names::tr("Joint origins");
}

QString displayName(CorrectAt at) {
  return at == CorrectAt::EveryFrame ? Names::tr("Every frame") : Names::tr("Contacts");
}

}  // namespace mocapress
