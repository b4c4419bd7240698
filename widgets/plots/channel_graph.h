// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <QStringList>
#include <QWidget>
#include <vector>

#include "widgets/models/kept_coefficients.h"

class QComboBox;
class QCPAxisRect;
class QCPItemStraightLine;
class QCustomPlot;
class QLabel;

namespace mocapress {

/// One channel of the skeleton over time, as recorded and as compressed.
struct ChannelCurves {
  Eigen::VectorXd original;    // degrees or cm; empty: unknown
  Eigen::VectorXd compressed;  // like `original`
  bool rotation = false;
  std::vector<KeptBand> kept;  // coefficients kept in `compressed`; empty: unknown
  double sample_rate_hz = 120;
};

/// Plots the original, the compressed motion and the difference of one channel, and the number of
/// wavelet coefficients kept in each scale. A click seeks.
class ChannelGraph : public QWidget {
  Q_OBJECT

 public:
  explicit ChannelGraph(QWidget* parent = nullptr);

  /// Sets the channels to choose from, and the shown one, `current`; -1: none.
  void setChannels(const QStringList& names, int current);
  void setCurves(const ChannelCurves& curves);
  void setFrame(int frame);

  QComboBox* channels() const { return channels_; }

 signals:
  void channelChosen(int index);
  void seekRequested(int frame);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void redraw();
  void drawCurves();
  void drawBands();
  void applyColours();
  void seekTo(int x_pixel);

  QComboBox* channels_;
  QLabel* hint_;
  QCustomPlot* curves_plot_;
  QCustomPlot* bands_plot_;
  QCPAxisRect* difference_;
  std::vector<QCPItemStraightLine*> playheads_;
  bool playhead_waits_ = false;  // a redraw is pending
  ChannelCurves curves_;
};

}  // namespace mocapress
