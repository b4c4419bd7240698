// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/models/method_names.h"

#include <QCoreApplication>
#include <string>

#include "core/baselines/compression_method.h"

namespace mocapress {
namespace {

struct Methods {
  Q_DECLARE_TR_FUNCTIONS(mocapress::Methods)
};

// The titles are core's; lupdate finds them here. A test tells when one is missing.
[[maybe_unused]] constexpr const char* kTitles[] = {
    QT_TRANSLATE_NOOP("mocapress::Methods", "Closed-loop wavelets"),
    QT_TRANSLATE_NOOP("mocapress::Methods", "Annealed wavelets"),
    QT_TRANSLATE_NOOP("mocapress::Methods", "Standard wavelets"),
    QT_TRANSLATE_NOOP("mocapress::Methods", "Per-channel wavelets"),
    QT_TRANSLATE_NOOP("mocapress::Methods", "Haar wavelets"),
    QT_TRANSLATE_NOOP("mocapress::Methods", "Linear wavelets"),
    QT_TRANSLATE_NOOP("mocapress::Methods", "PCA"),
    QT_TRANSLATE_NOOP("mocapress::Methods", "Frame subsampling"),
    QT_TRANSLATE_NOOP("mocapress::Methods", "Quaternion wavelets"),
    QT_TRANSLATE_NOOP("mocapress::Methods", "Segment PCA, after Liu & McMillan"),
    QT_TRANSLATE_NOOP("mocapress::Methods", "Clustered PCA, after Arikan"),
};

}  // namespace

QString methodTitle(std::string_view name) {
  return Methods::tr(std::string(method_title(name)).c_str());
}

QString seriesTitle(std::string_view method, const std::optional<double>& ik_ratio) {
  const QString title = methodTitle(method);
  return ik_ratio ? Methods::tr("%1 + IK %L2:1").arg(title).arg(*ik_ratio) : title;
}

}  // namespace mocapress
