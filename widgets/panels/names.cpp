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
  switch (weighting) {
    case Weighting::BoneEnds:
      return Names::tr("Bone ends");
    case Weighting::JointOrigins:
      return Names::tr("Joint origins");
    case Weighting::Surface:
      return Names::tr("Surface");
    case Weighting::Shell:
      return Names::tr("Shell");
  }
  return {};
}

QString displayName(CorrectAt at) {
  return at == CorrectAt::EveryFrame ? Names::tr("Every frame") : Names::tr("Contacts");
}

}  // namespace mocapress
