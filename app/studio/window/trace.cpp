// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/window/trace.h"

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <string>
#include <utility>

#include "app/studio/document/session.h"
#include "core/base/number_text.h"
#include "widgets/viewport/viewport.h"

namespace mocapress {
namespace {

constexpr double kBeat = 5;      // ms between timer events that detect blocks
constexpr double kWorthIt = 50;  // ms; shorter blocks are not written

/// Processor time of this thread in ms; 0 if the system does not tell.
double workedByThread() {
#ifdef Q_OS_UNIX
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return 1e3 * static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_nsec);
#else
  return 0;
#endif
}

}  // namespace

Trace::Trace(Session* session, Viewport* viewport, QObject* parent)
    : QObject(parent), session_(session) {
  connect(session, &Session::recompressing, this, &Trace::moved);
  connect(&session->document(), &Document::decodedChanged, this, &Trace::answered);
  connect(session, &Session::compressFailed, this, [this] { moved_.reset(); });
  connect(viewport, &Viewport::drawn, this, &Trace::drawn);
  heart_.setTimerType(Qt::PreciseTimer);
  heart_.setInterval(static_cast<int>(kBeat));
  connect(&heart_, &QTimer::timeout, this, &Trace::beat);
}

void Trace::setWriting(bool writing) {
  writing_ = writing;
  last_beat_ = Clock::now();
  longest_block_ = 0;
  longest_work_ = 0;
  worked_ = workedByThread();
  writing ? heart_.start() : heart_.stop();
}

Trace::Block Trace::takeLongestBlock() {
  return {std::exchange(longest_block_, 0), std::exchange(longest_work_, 0)};
}

void Trace::beat() {
  const double passed =
      std::chrono::duration<double, std::milli>(Clock::now() - last_beat_).count() - kBeat;
  last_beat_ = Clock::now();
  const double worked = workedByThread() - worked_;
  worked_ += worked;
  longest_block_ = std::max(longest_block_, passed);
  longest_work_ = std::max(longest_work_, worked);
  if (passed <= kWorthIt) return;
  // Shows both times: on a busy machine a thread may wait longer than it works.
  write("gui-blocked", passed);
  write("  of them at work", worked);
}

void Trace::moved() {
  if (moved_) return;
  moved_ = Clock::now();
  answered_ = false;
}

void Trace::answered() {
  if (const DecodedPtr& decoded = session_->document().decoded()) {
    write(("encode " + decoded->method).c_str(), 1000 * decoded->encode_seconds);
  }
  if (!moved_ || answered_) return;
  answered_ = true;
  write("slider-to-answer",
        std::chrono::duration<double, std::milli>(Clock::now() - *moved_).count());
}

void Trace::drawn() {
  if (!moved_ || !answered_) return;
  const double milliseconds =
      std::chrono::duration<double, std::milli>(Clock::now() - *moved_).count();
  moved_.reset();
  answered_ = false;
  write("slider-to-picture", milliseconds);
  emit sliderToPicture(milliseconds);
}

void Trace::write(const char* what, double milliseconds) const {
  if (writing_) std::fprintf(stderr, "%s: %s ms\n", what, fixed_text(milliseconds, 1).c_str());
}

}  // namespace mocapress
