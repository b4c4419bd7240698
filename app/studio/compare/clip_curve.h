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
/// changes, and is there again with its clip.
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

  /// The points that one clip has so far.
  struct Curve {
    std::string key;  // of the settings that all points share
    std::map<Method, Points> points;
    std::map<Method, std::set<double>> done;  // ratios that need not be asked for again
  };

  void takeUp();
  void fill();
  void addOwn();

  Session* session_;
  CurveFiller filler_;
  CurveTask task_;                       // started last
  std::map<std::string, Curve> curves_;  // by the clip they were measured on
  Curve* curve_ = nullptr;               // of the clip that is open
};

}  // namespace mocapress
