// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/blind_test/blind_test_window.h"

#include <QCheckBox>
#include <QCloseEvent>
#include <QDir>
#include <QDoubleSpinBox>
#include <QFileInfo>
#include <QFormLayout>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QRandomGenerator>
#include <QShortcut>
#include <QSpinBox>
#include <QStackedWidget>
#include <QStandardPaths>
#include <QVBoxLayout>
#include <algorithm>
#include <ctime>

#include "app/studio/document/own_limits.h"
#include "app/studio/document/session.h"
#include "core/base/error.h"
#include "core/base/utc_time.h"
#include "widgets/models/display_names.h"
#include "widgets/models/report_texts.h"
#include "widgets/models/sentence.h"
#include "widgets/timeline/playback.h"
#include "widgets/viewport/viewport.h"

namespace mocapress {
namespace {

const std::vector<double> kAskedLevels = {0.5, 0.7, 1, 1.4, 2, 2.8, 4, 5.7, 8};
constexpr double kNear = 1.05;      // levels closer than this factor count as one
constexpr double kLoopSeconds = 3;  // length of the loop around the worst moment
constexpr std::size_t kLeastLevels = 3;
constexpr float kRoom = 1.25;

double levelOf(const DecodedPtr& decoded) {
  return decoded->visibility->worst().times_noticed();
}

}  // namespace

QString BlindTestWindow::usualFile() {
  return QDir(QStandardPaths::writableLocation(QStandardPaths::AppConfigLocation))
      .filePath(QStringLiteral("blind_tests.json"));
}

BlindTestWindow::BlindTestWindow(Session* session, const QString& file, QWidget* parent)
    : QWidget(parent, Qt::Window),
      session_(session),
      file_(file),
      playback_(new Playback(Playback::steadyClock(), this)),
      pages_(new QStackedWidget(this)) {
  setWindowTitle(tr("Blind Test"));
  resize(1000, 640);
  pages_->addWidget(makePreparation());
  pages_->addWidget(makeQuestions());
  pages_->addWidget(makeResult());
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(pages_);
  makeKeys();
  connect(&encoder_, &LevelEncoder::made, this, &BlindTestWindow::take);
  connect(&encoder_, &LevelEncoder::ended, this, &BlindTestWindow::startTest);
  connect(playback_, &Playback::frameChanged, this, [this](int frame) {
    for (Viewport* view : views_)
      if (!view->isHidden()) view->setFrame(frame);
  });
}

QWidget* BlindTestWindow::makePreparation() {
  auto* page = new QWidget(this);
  about_ = new QLabel(page);
  about_->setWordWrap(true);
  viewer_ = new QLineEdit(qEnvironmentVariable("USER", qEnvironmentVariable("USERNAME")), page);
  viewer_->setAccessibleName(tr("Viewer"));
  distance_ = new QDoubleSpinBox(page);
  distance_->setRange(kLeastDistance, kMostDistance);
  distance_->setDecimals(1);
  distance_->setSuffix(tr(" m"));
  distance_->setAccessibleName(tr("Viewing distance"));
  distance_->setToolTip(
      tr("Distance at which a person would look as tall as the figure does on your screen"));
  count_ = new QSpinBox(page);
  count_->setRange(10, 200);
  count_->setValue(BlindTest::kUsualQuestions);
  count_->setAccessibleName(tr("Questions"));
  beside_ = new QCheckBox(tr("Show A, X and B side by side"), page);
  limits_ = new QLabel(page);
  limits_->setWordWrap(true);
  use_built_in_ = new QPushButton(tr("Use Built-in Limits"), page);
  use_built_in_->setToolTip(tr("Judge visibility as before any test"));
  start_ = new QPushButton(tr("Begin"), page);
  start_->setDefault(true);
  progress_ = new QProgressBar(page);
  progress_->setRange(0, static_cast<int>(kAskedLevels.size()));
  progress_->setFormat(tr("Compressing the clip at %m levels: %v"));
  auto* form = new QFormLayout;
  form->addRow(tr("Viewer"), viewer_);
  form->addRow(tr("Viewing distance"), distance_);
  form->addRow(tr("Questions"), count_);
  form->addRow(QString(), beside_);
  auto* column = new QVBoxLayout(page);
  column->setContentsMargins(40, 30, 40, 30);
  column->setSpacing(16);
  column->addWidget(about_);
  column->addLayout(form);
  column->addWidget(start_, 0, Qt::AlignLeft);
  column->addWidget(progress_);
  column->addStretch();
  column->addWidget(limits_);
  column->addWidget(use_built_in_, 0, Qt::AlignLeft);
  connect(use_built_in_, &QPushButton::clicked, this, [this] { use({}, limits_); });
  connect(start_, &QPushButton::clicked, this, &BlindTestWindow::begin);
  connect(viewer_, &QLineEdit::returnPressed, this, &BlindTestWindow::begin);
  return page;
}

QWidget* BlindTestWindow::makeQuestions() {
  auto* page = new QWidget(this);
  question_ = new QLabel(page);
  question_->setAlignment(Qt::AlignCenter);
  QFont large = page->font();
  large.setPointSizeF(2 * large.pointSizeF());
  large.setBold(true);
  auto* grid = new QGridLayout;
  grid->setSpacing(1);
  grid->setRowStretch(1, 1);
  for (const Figure figure : {A, X, B}) {
    QLabel*& letter = letters_[figure];
    letter = new QLabel(page);
    letter->setAlignment(Qt::AlignCenter);
    letter->setFont(large);
    grid->addWidget(letter, 0, figure);
    Viewport*& view = views_[figure];
    view = new Viewport(page);
    view->setFocusPolicy(Qt::NoFocus);
    // The camera frames and follows the original in every view: otherwise its moves would tell
    // which figure is shown. The room keeps the feet off the edge of the view.
    view->setOptions({.alone = true, .titles = false, .room = kRoom});
    view->setFollow(true);  // a runner would leave the view otherwise
    grid->addWidget(view, 1, figure);
  }
  auto* keys = new QLabel(
      tr("1: A, the original    2: X    3: B, compressed        ←: X is A    →: X is B        "
         "Esc: stop"),
      page);
  keys->setAlignment(Qt::AlignCenter);
  auto* column = new QVBoxLayout(page);
  column->setContentsMargins(0, 10, 0, 10);
  column->addWidget(question_);
  column->addLayout(grid, 1);
  column->addWidget(keys);
  return page;
}

QWidget* BlindTestWindow::makeResult() {
  auto* page = new QWidget(this);
  verdict_ = new QLabel(page);
  verdict_->setWordWrap(true);
  use_ = new QPushButton(tr("Use as Limits"), page);
  use_->setToolTip(
      tr("Judge visibility by your own threshold from now on; other cues keep their limits"));
  auto* again = new QPushButton(tr("Another Test"), page);
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(use_);
  buttons->addWidget(again);
  buttons->addStretch();
  auto* column = new QVBoxLayout(page);
  column->setContentsMargins(40, 30, 40, 30);
  column->setSpacing(16);
  column->addWidget(verdict_);
  column->addLayout(buttons);
  column->addStretch();
  connect(again, &QPushButton::clicked, this, &BlindTestWindow::prepare);
  connect(use_, &QPushButton::clicked, this, [this] {
    if (!use(limits_by({record()}, ownLimits().limits), verdict_)) return;
    use_->setEnabled(false);
    use_->setText(tr("In Use"));
  });
  return page;
}

/// Makes these limits the user's. If they cannot be saved, shows the reason in `trouble` and
/// returns false.
bool BlindTestWindow::use(const SightLimits& limits, QLabel* trouble) {
  try {
    setOwnLimits(limits);
  } catch (const Error& error) {
    trouble->setText(translatedSentence(QString::fromUtf8(error.what())));
    return false;
  }
  emit limitsChanged();
  showLimits();
  return true;
}

void BlindTestWindow::showLimits() {
  const SightLimits& limits = session_->document().options().limits;
  limits_->setText(tr("Visibility is judged by %1.")
                       .arg(QString::fromStdString(reportLanguage()(limits_text(limits)))));
  use_built_in_->setVisible(limits.of_cues != SightLimits().of_cues);
}

void BlindTestWindow::makeKeys() {
  const auto on = [this](const QKeySequence& key, auto act) {
    // The shortcut works while the page is shown, even when the 3D view's own window has the focus.
    auto* shortcut = new QShortcut(key, pages_->widget(1));
    connect(shortcut, &QShortcut::activated, this, act);
  };
  on(Qt::Key_1, [this] { look(A); });
  on(Qt::Key_2, [this] { look(X); });
  on(Qt::Key_3, [this] { look(B); });
  on(Qt::Key_Left, [this] { answer(false); });
  on(Qt::Key_Right, [this] { answer(true); });
  on(Qt::Key_Escape, [this] { finish(); });
}

void BlindTestWindow::prepare() {
  encoder_.abandon();
  playback_->pause();
  original_ = session_->document().original();
  options_ = session_->document().options();
  const bool possible = original_ && options_.method == Method::ClosedLoop;
  about_->setText(
      possible
          ? tr("A is the original of %1, B the same clip compressed, more or less visibly. X is "
               "one of the two: say which. The test finds the smallest error that you notice, "
               "in about five minutes. Nobody is told whether an answer was right.")
                .arg(QFileInfo(original_->path).fileName())
          : tr("Open a motion and compress it by the closed loop: the test takes the open clip."));
  distance_->setValue(options_.limits.distance_m);
  start_->setEnabled(possible);
  progress_->hide();
  showLimits();
  pages_->setCurrentIndex(0);
  viewer_->setEnabled(true);
  viewer_->setFocus();
}

void BlindTestWindow::begin() {
  if (!original_ || !start_->isEnabled()) return;
  start_->setEnabled(false);
  viewer_->setEnabled(false);  // keys pressed too early must not change the name
  levels_.clear();
  test_.reset();
  progress_->setValue(0);
  progress_->show();
  options_.limits.distance_m = distance_->value();
  encoder_.start(original_->encoder, options_, kAskedLevels);
}

/// Keeps a level if it is clearly above the last one kept.
void BlindTestWindow::take(const DecodedPtr& decoded) {
  progress_->setValue(progress_->value() + 1);
  if (!decoded->visibility || levelOf(decoded) <= 0) return;
  if (levels_.empty() || levelOf(decoded) > kNear * levelOf(levels_.back()))
    levels_.push_back(decoded);
}

void BlindTestWindow::startTest() {
  progress_->hide();
  if (levels_.size() < kLeastLevels) {
    about_->setText(tr("This clip cannot be compressed at enough levels for a test."));
    return;
  }
  std::vector<double> levels;
  for (const DecodedPtr& decoded : levels_) levels.push_back(levelOf(decoded));
  test_.emplace(std::move(levels), QRandomGenerator::global()->generate64(), count_->value());
  const Motion& motion = original_->motion();
  for (Viewport* view : views_) {
    view->setSkeleton(motion.skeleton);
    view->setSampleRate(motion.clip.sample_rate_hz);
    view->setOriginal(original_->tracks());
  }
  for (const Figure figure : {A, B}) {
    views_[figure]->setVisible(beside_->isChecked());
    letters_[figure]->setVisible(beside_->isChecked());
  }
  playback_->setClip(motion.clip.frames(), motion.clip.sample_rate_hz);
  pages_->setCurrentIndex(1);
  pages_->widget(1)->setFocus();
  ask();
}

const DecodedClip& BlindTestWindow::compressed() const {
  return *levels_[static_cast<std::size_t>(test_->question().level)];
}

/// Asks the next question and loops the time around the worst moment of its level.
void BlindTestWindow::ask() {
  if (test_->finished()) return finish();
  const int asked = static_cast<int>(test_->answers().size());
  question_->setText(tr("Question %L1 of %L2: is X the original or the compressed one?")
                         .arg(asked + 1)
                         .arg(test_->questions()));
  const Clip& clip = original_->motion().clip;
  const int half = static_cast<int>(kLoopSeconds / 2 * clip.sample_rate_hz);
  const int worst = compressed().visibility->worst().frame;
  const int first = std::clamp(worst - half, 0, std::max(0, clip.frames() - 1 - 2 * half));
  playback_->setRange(std::pair(first, std::min(first + 2 * half, clip.frames() - 1)));
  playback_->setLoops(true);
  playback_->seek(first);
  playback_->play();
  if (!beside_->isChecked()) return look(A);
  for (const Figure figure : {A, X, B}) look(figure);
}

/// Shows a figure in its own view, or in the one view that all figures share. Each is drawn as the
/// compressed figure, so that all look alike.
void BlindTestWindow::look(Figure figure) {
  if (!test_ || test_->finished()) return;
  const bool is_b = figure == B || (figure == X && test_->question().x_is_b);
  const Figure place = beside_->isChecked() ? figure : X;
  views_[place]->setCompressed(is_b ? compressed().tracks : original_->tracks());
  static constexpr char kNames[] = {'A', 'X', 'B'};
  letters_[place]->setText(QString(QLatin1Char(kNames[figure])));
}

bool BlindTestWindow::running() const {
  return isVisible() && pages_->currentIndex() == 1;
}

void BlindTestWindow::answer(bool x_is_b) {
  if (!test_ || test_->finished()) return;
  test_->answer(x_is_b);
  ask();
}

BlindTestRecord BlindTestWindow::record() const {
  // The cue that is the most visible one at most levels.
  std::array<int, kCues> counts{};
  for (const DecodedPtr& decoded : levels_)
    ++counts[static_cast<std::size_t>(decoded->visibility->worst().cue)];
  const auto most = std::max_element(counts.begin(), counts.end()) - counts.begin();
  return {.viewer = viewer_->text().trimmed().toStdString(),
          .clip = QFileInfo(original_->path).fileName().toStdString(),
          .character = QFileInfo(original_->character).fileName().toStdString(),
          .time = utc_text(std::time(nullptr)),
          .cue = static_cast<Cue>(most),
          .limits = options_.limits,
          .levels = test_->levels(),
          .answers = {test_->answers().begin(), test_->answers().end()}};
}

void BlindTestWindow::finish() {
  playback_->pause();
  if (!test_ || test_->answers().empty()) return prepare();
  const BlindTestRecord made = record();
  const ThresholdFit fit = made.fit();
  QString text = tr("%L1 of %L2 answers were right. Somebody who guesses has as many with a "
                    "probability of %L3.")
                     .arg(made.right())
                     .arg(made.answers.size())
                     .arg(made.p(), 0, 'g', 2);
  text += QStringLiteral("\n\n");
  text += fit.found ? tr("You notice errors from %L1 times what the limits say (95 % interval: %L2 "
                         "to %L3). Most were seen as: %4, from %L5 m.")
                          .arg(fit.curve.threshold, 0, 'f', 2)
                          .arg(fit.low, 0, 'f', 2)
                          .arg(fit.high, 0, 'f', 2)
                          .arg(displayName(made.cue))
                          .arg(made.limits.distance_m, 0, 'f', 1)
                    : tr("The answers do not tell a threshold: they are too few, or it lies "
                         "outside of the levels.");
  try {
    QDir().mkpath(QFileInfo(file_).path());
    add_blind_test(file_.toStdU16String(), made);
    text += QStringLiteral("\n\n") + tr("Kept in %1.").arg(QDir::toNativeSeparators(file_));
  } catch (const Error& error) {
    text += QStringLiteral("\n\n") + translatedSentence(QString::fromUtf8(error.what()));
  }
  verdict_->setText(text);
  use_->setText(tr("Use as Limits"));
  use_->setEnabled(fit.found);
  pages_->setCurrentIndex(2);
}

/// Finishes a running test, so that its answers are kept.
void BlindTestWindow::closeEvent(QCloseEvent* event) {
  if (running()) finish();
  encoder_.abandon();
  playback_->pause();
  event->accept();
}

}  // namespace mocapress
