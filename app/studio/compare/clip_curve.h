// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "app/jobs/curve_filler.h"
#include "widgets/models/rate_curves.h"

namespace mocapress {

class Session;

/// The rate-distortion curves of the clip that is open: standard selection, and the method that is
/// chosen. Filled while nothing else is to be done; what was measured stays while only the target
/// changes.
class ClipCurve : public QObject {
  Q_OBJECT

 public:
  explicit ClipCurve(Session* session, QObject* parent = nullptr);

  /// The points' rows are the places of their ratios among ratios().
  std::vector<RateCurve> curves() const;

  /// Of all points.
  std::vector<double> ratios() const;

  bool busy() const { return filler_.busy(); }

 signals:
  void changed();

 private:
  /// Points of one method, by the ratio that was asked for.
  using Points = std::map<double, CurvePoint>;

  void clear();
  void fill();
  void addOwn();

  Session* session_;
  CurveFiller filler_;
  CurveTask task_;   // started last
  std::string key_;  // of the settings that all points share
  std::map<Method, Points> points_;
  std::map<Method, std::set<double>> done_;  // ratios that need not be asked for again
};

}  // namespace mocapress
