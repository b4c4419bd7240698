// SPDX-License-Identifier: MIT
#include "core/batch/batch_sign_off.h"

#include <filesystem>

#include "core/base/utf8_path.h"

namespace mocapress {
namespace {

SignOffClip signed_off(const BatchRow& row) {
  const std::filesystem::path input = utf8_path(row.input);
  SignOffClip clip{.name = utf8(input.filename()),
                   .path = utf8(std::filesystem::absolute(input)),
                   .take = row.reading.take.value_or(""),
                   .review = row.review,
                   .source_hash = row.stamp.source,
                   .settings_hash = settings_hash(row.preset, row.reading),
                   .figures = {},
                   .problem = row.error};
  if (!clip.take.empty()) clip.name += ": " + clip.take;
  if (!row.measured) return clip;
  const Measurement& measured = *row.measured;
  clip.sample_rate_hz = measured.sample_rate_hz;
  clip.figures = SignOffFigures{.ratio = measured.ratio,
                                .bytes = measured.motion_bytes,
                                .eps_cm = measured.eps_cm(row.preset.weighting),
                                .max_cm = measured.max_cm(row.preset.weighting),
                                .worst_frame = measured.worst_frame,
                                .worst_point = row.worst ? row.worst->landmark : "",
                                .sight = measured.seen.sight(),
                                .limits = measured.seen.limits,
                                .stale = {}};
  return clip;
}

}  // namespace

SignOff sign_off_of(const BatchRows& rows, const std::string& title) {
  SignOff report{.title = title, .clips = {}, .stamp = report_stamp()};
  rows([&report](const BatchRow& row) { report.clips.push_back(signed_off(row)); });
  return report;
}

}  // namespace mocapress
