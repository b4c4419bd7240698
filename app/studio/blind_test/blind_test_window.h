// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <array>
#include <optional>
#include <vector>

#include "app/jobs/level_encoder.h"
#include "core/metrics/blind_test.h"
#include "core/report/blind_test_record.h"

class QCheckBox;
class QDoubleSpinBox;
class QLabel;
class QLineEdit;
class QProgressBar;
class QPushButton;
class QSpinBox;
class QStackedWidget;

namespace mocapress {

class Playback;
class Session;
class Viewport;

/// A blind test (ABX) on the open clip: A is the original, B is compressed, X is one of them. Every
/// question is answered by keys alone. The result is kept in a file of all tests, and may become
/// the user's limits of visibility.
class BlindTestWindow : public QWidget {
  Q_OBJECT

 public:
  /// Results are appended to `file`.
  BlindTestWindow(Session* session, const QString& file, QWidget* parent);

  /// The default file, among the program's settings.
  static QString usualFile();

  /// Asks for viewer and distance before a test of the open clip.
  void prepare();

  /// Answers the question, as the arrow keys do.
  void answer(bool x_is_b);

  /// True while the viewer answers questions.
  bool running() const;

  QPushButton* start() const { return start_; }
  QCheckBox* beside() const { return beside_; }
  QPushButton* useAsLimits() const { return use_; }
  QPushButton* useBuiltInLimits() const { return use_built_in_; }
  const std::optional<BlindTest>& test() const { return test_; }
  QLabel* verdict() const { return verdict_; }

 signals:
  /// The user chose the limits that a test found, or the built-in ones.
  void limitsChanged();

 protected:
  void closeEvent(QCloseEvent* event) override;

 private:
  enum Figure { A, X, B };

  QWidget* makePreparation();
  QWidget* makeQuestions();
  QWidget* makeResult();
  void makeKeys();
  void begin();
  void take(const DecodedPtr& decoded);
  void startTest();
  void ask();
  void look(Figure figure);
  void finish();
  bool use(const SightLimits& limits, QLabel* trouble);
  void showLimits();
  BlindTestRecord record() const;
  const DecodedClip& compressed() const;

  Session* session_;
  QString file_;
  LevelEncoder encoder_;
  OriginalPtr original_;
  EncodeSettings options_;          // for compressing and measuring the levels
  std::vector<DecodedPtr> levels_;  // ascending by visibility
  std::optional<BlindTest> test_;
  Playback* playback_;
  QStackedWidget* pages_;
  QLineEdit* viewer_;
  QDoubleSpinBox* distance_;
  QSpinBox* count_;
  QCheckBox* beside_;
  QLabel* about_;
  QLabel* limits_;
  QPushButton* use_built_in_;
  QProgressBar* progress_;
  QPushButton* start_;
  std::array<Viewport*, 3> views_{};  // by Figure; X's shows all in turn if not side by side
  std::array<QLabel*, 3> letters_{};  // above the views
  QLabel* question_;
  QLabel* verdict_;
  QPushButton* use_;
};

}  // namespace mocapress
