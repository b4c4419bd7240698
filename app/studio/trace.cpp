// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/trace.h"

#include <cstdio>
#include <string>

#include "app/studio/session.h"
#include "widgets/viewport/viewport.h"

namespace mocapress {

Trace::Trace(Session* session, Viewport* viewport, QObject* parent)
    : QObject(parent), session_(session) {
  connect(session, &Session::recompressing, this, &Trace::moved);
  connect(&session->document(), &Document::decodedChanged, this, &Trace::answered);
  connect(session, &Session::compressFailed, this, [this] { moved_.reset(); });
  connect(viewport, &Viewport::drawn, this, &Trace::drawn);
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
  if (writing_) std::fprintf(stderr, "%s: %.1f ms\n", what, milliseconds);
}

}  // namespace mocapress
