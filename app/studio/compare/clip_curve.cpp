// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/compare/clip_curve.h"

#include <algorithm>
#include <array>

#include "app/jobs/result_cache.h"
#include "app/studio/document/session.h"
#include "core/batch/row.h"
#include "core/codec/format/compressed_clip.h"
#include "widgets/models/display_names.h"

namespace mocapress {
namespace {

// Standard selection takes moments; slower methods get fewer ratios, the middle ones first.
constexpr std::array kStandardRatios = {25.0, 10.0, 60.0, 5.0, 40.0, 15.0, 90.0, 130.0, 7.5};
constexpr std::array kRatios = {25.0, 60.0, 10.0, 40.0, 90.0};

/// A key of all settings except target and method.
std::string sharedKey(EncodeSettings options) {
  options.target = {};
  options.method = Method::Standard;
  return settingsKey(options);
}

/// A key of everything that errors are measured on: files, reading options and the character.
std::string clipKey(const OriginalPtr& clip) {
  return clip ? clip->stamp.hash + settings_hash({}, clip->reading) + clip->character.toStdString()
              : std::string();
}

}  // namespace

ClipCurve::ClipCurve(Session* session, QObject* parent) : QObject(parent), session_(session) {
  connect(&session->document(), &Document::clipChanged, this, &ClipCurve::takeUp);
  connect(&session->document(), &Document::skinChanged, this, &ClipCurve::takeUp);
  connect(session, &Session::recompressing, &filler_, [this] { filler_.abandon(); });
  connect(session, &Session::settled, this, [this] {
    addOwn();
    fill();
  });
  connect(&filler_, &CurveFiller::measured, this, [this](double asked, const CurvePoint& point) {
    curve_->points[task_.options.method].insert_or_assign(asked, point);
    curve_->done[task_.options.method].insert(asked);
    emit changed();
  });
  connect(&filler_, &CurveFiller::ended, this, [this] {
    // The clip cannot reach a ratio that has no point; such a ratio is not tried again.
    curve_->done[task_.options.method].insert(task_.ratios.begin(), task_.ratios.end());
    fill();
  });
  takeUp();
}

void ClipCurve::takeUp() {
  filler_.abandon();
  curve_ = &curves_[clipKey(session_->document().original())];
  emit changed();
}

/// Adds the result that the user asked for to the curve.
void ClipCurve::addOwn() {
  const Document& document = session_->document();
  if (!document.original() || !document.decoded() || !document.decoded()->distortion) return;
  const std::string key = sharedKey(document.options());
  if (key != curve_->key) {
    filler_.abandon();
    *curve_ = {key, {}, {}};
  }
  const DecodedClip& decoded = *document.decoded();
  const Provenance& provenance = decoded.compressed.provenance;
  if (!decoded.of_wavelets || !decoded.complete || !decoded.coefficient_ratio) return;
  curve_->points[provenance.method].insert_or_assign(
      decoded.ratio, CurvePoint{decoded.ratio, decoded.distortion->eps(provenance.weighting)});
  emit changed();
}

void ClipCurve::fill() {
  const Document& document = session_->document();
  if (!document.original() || curve_->key.empty()) return;
  task_ = {document.original()->encoder, document.options(), {}};
  const auto ask = [&](Method method, const auto& wanted) {
    task_.options.method = method;
    for (const double ratio : wanted)
      if (!curve_->done[method].contains(ratio)) task_.ratios.push_back(ratio);
    return !task_.ratios.empty();
  };
  if (ask(Method::Standard, kStandardRatios) || ask(document.options().method, kRatios))
    filler_.start(task_);
}

std::vector<double> ClipCurve::ratios() const {
  std::vector<double> all;
  for (const auto& [method, points] : curve_->points)
    for (const auto& [asked, point] : points) all.push_back(point.ratio);
  return all;
}

std::vector<RateCurve> ClipCurve::curves() const {
  std::vector<RateCurve> curves;
  int row = 0;
  for (const auto& [method, points] : curve_->points) {
    RateCurve curve{.series = {std::string(name(method)), {}, displayName(method).toStdString()}};
    std::vector<CurvePoint> line;
    for (const auto& [asked, point] : points) {
      curve.points.push_back({point.ratio, point.eps_cm, row++});
      line.push_back(point);
    }
    curve.line = best_of(line);
    curves.push_back(std::move(curve));
  }
  return curves;
}

}  // namespace mocapress
