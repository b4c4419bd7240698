// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/study/study_row_request.h"

#include <QFileInfo>

#include "core/baselines/compression_method.h"

namespace mocapress {
namespace {

/// The studio does not ask for coefficient ratios: they become the ratio they came to.
Target targetOf(const StudyRow& row) {
  if (row.target.kind != Target::Kind::CoefficientRatio || !row.measured) return row.target;
  return {Target::Kind::Ratio, row.measured->ratio};
}

}  // namespace

OpenRequest requestOf(const StudyRow& row) {
  OpenRequest request;
  request.path = QFileInfo(QString::fromStdString(row.clip)).absoluteFilePath();
  EncodeOptions options{.weighting = row.weighting, .target = targetOf(row), .seed = row.seed};
  if (row.coding) options.coding = *row.coding;
  if (row.ik_ratio) options.correction = CorrectionOptions{.ratio = row.ik_ratio};
  const CompressionMethod* compression_method = find_compression_method(row.method);
  if (!compression_method || !choose_wavelets(*compression_method, options))
    request.comparison = row.method;
  request.options = options;
  return request;
}

}  // namespace mocapress
