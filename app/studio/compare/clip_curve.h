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

/// Rate-distortion curves of the open clip, for standard selection and the chosen method. They are
/// filled while the studio is idle. Points stay while only the target changes, and return when
/// their clip is opened again.
class ClipCurve : public QObject {
  Q_OBJECT

 public:
  explicit ClipCurve(Session* session, QObject* parent = nullptr);

  /// The row of a point is the index of its ratio in ratios().
  std::vector<RateCurve> curves() const;

  /// The ratios of all points.
  std::vector<double> ratios() const;

  bool busy() const { return filler_.busy(); }

 signals:
  void changed();

 private:
  /// Points of one method, by the requested ratio.
  using Points = std::map<double, CurvePoint>;

  /// The points of one clip so far.
  struct Curve {
    std::string key;  // key of the settings that all points share
    std::map<Method, Points> points;
    std::map<Method, std::set<double>> done;  // ratios that were tried
  };

  void takeUp();
  void fill();
  void addOwn();

  Session* session_;
  CurveFiller filler_;
  CurveTask task_;                       // task that was started last
  std::map<std::string, Curve> curves_;  // by clip
  Curve* curve_ = nullptr;               // curve of the open clip
};

}  // namespace mocapress
