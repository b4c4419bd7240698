// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/pinned_results.h"

#include <algorithm>
#include <array>

#include "app/studio/session.h"
#include "widgets/models/palette.h"
#include "widgets/models/pinned_model.h"
#include "widgets/models/study_rows_model.h"
#include "widgets/panels/names.h"
#include "widgets/panels/pinned_panel.h"
#include "widgets/viewport/viewport.h"

namespace mocapress {
namespace {

/// Told apart from each other, from the red of the current result and from the grey original.
constexpr std::array<QRgb, kMostPinned> kColours = {kCurveColours[0], kCurveColours[2],
                                                    kCurveColours[4], kCurveColours[5]};

}  // namespace

PinnedResults::PinnedResults(Session* session, PinnedModel* model, PinnedPanel* panel,
                             Viewport* viewport, QObject* parent)
    : QObject(parent), session_(session), model_(model), panel_(panel), viewport_(viewport) {
  const Document* document = &session->document();
  connect(document, &Document::clipChanged, this, [this] {
    pins_.clear();
    final_ = false;
    show();
  });
  connect(session, &Session::recompressing, this, [this] { setFinal(false); });
  connect(session, &Session::settled, this, [this] { setFinal(true); });
  connect(document, &Document::decodedChanged, this, &PinnedResults::showWhetherToPin);
  connect(document, &Document::optionsChanged, this, [this] {
    if (!pins_.empty()) show();  // the weighting may be another
  });
  connect(panel, &PinnedPanel::pinRequested, this, &PinnedResults::pinCurrent);
  connect(panel, &PinnedPanel::unpinRequested, this, &PinnedResults::unpin);
  connect(panel, &PinnedPanel::makeCurrentRequested, this, &PinnedResults::makeCurrent);
  connect(model, &PinnedModel::nameEdited, this, &PinnedResults::rename);
}

bool PinnedResults::canPin() const {
  const Document& document = session_->document();
  const DecodedPtr& decoded = document.decoded();
  return final_ && document.final() && document.original() && decoded && decoded->distortion &&
         pins_.size() < kMostPinned &&
         std::none_of(pins_.begin(), pins_.end(),
                      [&](const Pin& pin) { return pin.decoded == decoded; });
}

void PinnedResults::pinCurrent() {
  if (!canPin()) return;
  const DecodedPtr& decoded = session_->document().decoded();
  const EncodeOptions& options = session_->document().options();
  const QString name = tr("%1, %2").arg(targetText(options.target),
                                        displayName(decoded->compressed.provenance.method));
  pins_.push_back({name, freeColour(), decoded, options});
  show();
}

void PinnedResults::unpin(int row) {
  if (row < 0 || row >= static_cast<int>(pins_.size())) return;
  pins_.erase(pins_.begin() + row);
  show();
}

void PinnedResults::rename(int row, const QString& name) {
  pins_[static_cast<std::size_t>(row)].name = name;
  show();
}

void PinnedResults::makeCurrent(int row) {
  if (row < 0 || row >= static_cast<int>(pins_.size())) return;
  session_->setOptions(pins_[static_cast<std::size_t>(row)].options);
}

void PinnedResults::setFinal(bool final) {
  final_ = final;
  showWhetherToPin();
}

QColor PinnedResults::freeColour() const {
  const auto found = std::find_if(kColours.begin(), kColours.end(), [this](QRgb colour) {
    return std::none_of(pins_.begin(), pins_.end(),
                        [&](const Pin& pin) { return pin.colour == QColor(colour); });
  });
  return {*found};
}

void PinnedResults::show() {
  const Weighting weighting = session_->document().options().weighting;
  std::vector<PinnedEntry> entries;
  std::vector<PinnedFigure> figures;
  for (const Pin& pin : pins_) {
    const Distortion& distortion = *pin.decoded->distortion;
    PinnedEntry entry{pin.name,
                      pin.colour,
                      pin.decoded->ratio,
                      distortion.eps(weighting),
                      distortion.p95,
                      distortion.max.cm,
                      {}};
    if (pin.decoded->footskate) entry.footskate_cm = pin.decoded->footskate->total_cm;
    figures.push_back({pin.decoded->tracks,
                       pin.colour,
                       {pin.name, tr("%L1 : 1").arg(entry.ratio, 0, 'f', 1),
                        tr("%L1 cm").arg(entry.eps_cm, 0, 'f', 2)}});
    entries.push_back(std::move(entry));
  }
  model_->setEntries(std::move(entries));
  viewport_->setPinned(std::move(figures));
  showWhetherToPin();
}

void PinnedResults::showWhetherToPin() {
  panel_->setCanPin(canPin());
  emit canPinChanged(canPin());
}

}  // namespace mocapress
