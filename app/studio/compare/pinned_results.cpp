// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/compare/pinned_results.h"

#include <algorithm>
#include <array>

#include "app/studio/document/edit_step.h"
#include "app/studio/document/session.h"
#include "core/codec/methods/compared_file.h"
#include "core/codec/methods/compression_method.h"
#include "widgets/models/colours.h"
#include "widgets/models/display_names.h"
#include "widgets/models/number_text.h"
#include "widgets/models/pinned_model.h"
#include "widgets/models/study_rows_model.h"
#include "widgets/panels/pinned_panel.h"
#include "widgets/viewport/viewport.h"

namespace mocapress {
namespace {

/// Colours that differ from each other, from the red current result and from the grey original.
constexpr std::array<QRgb, kMostPinned> kColours = {kCurveColours[0], kCurveColours[2],
                                                    kCurveColours[4], kCurveColours[5]};

constexpr const char* kEngineMethod = "key-frames";

bool isOfEngine(const Pin& pin) {
  return pin.settings.preset.method == kEngineMethod;
}

/// Encodes a pin. `options` are those of its settings; an engine's pin uses key frames instead.
DecodedPtr made(const Pin& pin, const EncodeSettings& options, const OriginalClip& original,
                const Job& job) {
  const auto observer = [&job](const EncodeProgress&) { return !job.stopRequested(); };
  if (!isOfEngine(pin))
    return decodedClip(original.encoder->encode(options, observer), *original.encoder, options);
  const Encoding encoding =
      MethodEncoder(original.motion())
          .compress(*find_compression_method(kEngineMethod), options, observer);
  return decodedClip(read_mcpr(encoding.file), &original, options.limits);
}

}  // namespace

PinnedResults::PinnedResults(Session* session, PinnedModel* model, QObject* parent)
    : QObject(parent), session_(session), model_(model) {
  const Document* document = &session->document();
  connect(document, &Document::clipChanged, this, [this] {
    const OriginalPtr& clip = session_->document().original();
    if (clip && clip == clip_) return show();
    clip_ = clip;
    pins_.clear();
    engine_.abandon();
    final_ = false;
    recall();
    show();
  });
  // Only the skin has changed: it is the same clip, and its pins stay.
  connect(document, &Document::skinChanged, this,
          [this] { clip_ = session_->document().original(); });
  connect(session, &Session::recompressing, this, [this] { setFinal(false); });
  connect(session, &Session::settled, this, [this] { setFinal(true); });
  connect(document, &Document::decodedChanged, this, &PinnedResults::showWhetherToPin);
  connect(document, &Document::optionsChanged, this, [this] {
    if (!pins_.empty()) show();  // the weighting may have changed
  });
  connect(model, &PinnedModel::nameEdited, this, &PinnedResults::rename);
}

void PinnedResults::showIn(PinnedPanel* panel, Viewport* viewport) {
  panel_ = panel;
  viewport_ = viewport;
  connect(panel, &PinnedPanel::pinRequested, this, &PinnedResults::pinCurrent);
  connect(panel, &PinnedPanel::unpinRequested, this, &PinnedResults::unpin);
  connect(panel, &PinnedPanel::makeCurrentRequested, this, &PinnedResults::makeCurrent);
}

bool PinnedResults::canPin() const {
  const Document& document = session_->document();
  const DecodedPtr& decoded = document.decoded();
  return hasRoom() && std::none_of(pins_.begin(), pins_.end(),
                                   [&](const Result& result) { return result.decoded == decoded; });
}

/// True if the result is final and measured, and one more can be pinned.
bool PinnedResults::hasRoom() const {
  const Document& document = session_->document();
  return final_ && document.final() && document.original() && document.decoded() &&
         document.decoded()->distortion && pins_.size() + unmade_.size() < kMostPinned;
}

void PinnedResults::pinEngine() {
  if (!hasRoom()) return emit failed(tr("The result is not final yet, or four are pinned."));
  const Document& document = session_->document();
  const auto bytes = static_cast<double>(document.decoded()->compressed.motion_bytes());
  Pin pin;
  pin.settings.preset.method = kEngineMethod;
  pin.settings.preset.weighting = document.options().weighting;
  pin.settings.preset.limits = document.options().limits;
  pin.settings.preset.target = {Target::Kind::Size, bytes};
  const OriginalPtr original = document.original();
  engine_.start(
      [pin, original, options = settingsFor(pin.settings, original->motion()).encode](
          const Job& job) { return made(pin, options, *original, job); },
      [this, pin](const DecodedPtr& decoded) {
        // Other results may have been pinned meanwhile.
        if (pins_.size() + unmade_.size() >= kMostPinned)
          return emit failed(tr("Four results are pinned already."));
        const Result result{{freeName(methodTitle(kEngineMethod)), freeColour(), pin.settings},
                            decoded};
        session_->history()->push(new EditStep(
            [] { return tr("Pin"); }, [this, result, row = pins_.size()] { put(result, row); },
            [this, colour = result.pin.colour] { drop(colour); }));
      },
      [this](const QString& message) { emit failed(message); });
}

void PinnedResults::pinCurrent() {
  if (!canPin()) return;
  const DecodedPtr& decoded = session_->document().decoded();
  const EncodeSettings& options = session_->document().options();
  const QString name = freeName(tr("%1, %2").arg(
      targetText(options.target), displayName(decoded->compressed.provenance.method)));
  const NamedSettings settings = namedSettings({options, {}, {}}, *session_->document().skeleton());
  const Result result{{name, freeColour(), settings}, decoded};
  session_->history()->push(new EditStep([] { return tr("Pin"); },
                                         [this, result, row = pins_.size()] { put(result, row); },
                                         [this, colour = result.pin.colour] { drop(colour); }));
}

void PinnedResults::unpin(int row) {
  if (row < 0 || row >= static_cast<int>(pins_.size())) return;
  const Result result = pins_[static_cast<std::size_t>(row)];
  session_->history()->push(new EditStep(
      [] { return tr("Take Off a Pin"); }, [this, colour = result.pin.colour] { drop(colour); },
      [this, result, row] { put(result, static_cast<std::size_t>(row)); }));
}

void PinnedResults::rename(int row, const QString& name) {
  const Pin pin = pins_[static_cast<std::size_t>(row)].pin;
  if (name == pin.name) return;
  session_->history()->push(
      new EditStep([] { return tr("Name of a Pin"); },
                   [this, colour = pin.colour, name] { this->name(colour, name); },
                   [this, pin] { this->name(pin.colour, pin.name); }));
}

void PinnedResults::put(const Result& result, std::size_t row) {
  pins_.insert(pins_.begin() + static_cast<std::ptrdiff_t>(std::min(row, pins_.size())), result);
  noteEdit();
}

void PinnedResults::drop(const QColor& colour) {
  std::erase_if(pins_, [&](const Result& result) { return result.pin.colour == colour; });
  if (std::erase_if(unmade_, [&](const Pin& pin) { return pin.colour == colour; }) > 0) {
    making_.abandon();
    makeNext();
  }
  noteEdit();
}

void PinnedResults::name(const QColor& colour, const QString& name) {
  for (Result& result : pins_)
    if (result.pin.colour == colour) result.pin.name = name;
  for (Pin& pin : unmade_)
    if (pin.colour == colour) pin.name = name;
  noteEdit();
}

void PinnedResults::makeCurrent(int row) {
  if (row < 0 || row >= static_cast<int>(pins_.size())) return;
  const Pin& pin = pins_[static_cast<std::size_t>(row)].pin;
  if (isOfEngine(pin)) return;  // no settings of the studio make such a clip
  session_->setOptions(settingsFor(pin.settings, session_->document().original()->motion()).encode);
}

void PinnedResults::recall() {
  making_.abandon();
  unmade_.clear();
  const OriginalPtr& original = session_->document().original();
  if (!memory_ || !original) return;
  for (Pin& pin : memory_(session_->openKey()))
    if (unmade_.size() < kMostPinned) unmade_.push_back(std::move(pin));
  makeNext();
}

/// Encodes one pin after the other and leaves out those that can no longer be encoded.
void PinnedResults::makeNext() {
  if (unmade_.empty()) return;
  const auto take = [this](const DecodedPtr& decoded) {
    const Pin pin = std::move(unmade_.front());
    unmade_.pop_front();
    if (decoded) pins_.push_back({pin, decoded});
    if (!pin.colour.isValid() && decoded) pins_.back().pin.colour = freeColour();
    show();
    makeNext();
  };
  const OriginalPtr original = session_->document().original();
  making_.start([pin = unmade_.front(), original,
                 options = settingsFor(unmade_.front().settings, original->motion()).encode](
                    const Job& job) { return made(pin, options, *original, job); },
                take, [take](const QString&) { take(nullptr); });
}

void PinnedResults::noteEdit() {
  show();
  if (!session_->document().original()) return;
  emit edited(session_->openKey(), all());
}

std::vector<Pin> PinnedResults::all() const {
  std::vector<Pin> pins;
  for (const Result& result : pins_) pins.push_back(result.pin);
  pins.insert(pins.end(), unmade_.begin(), unmade_.end());
  return pins;
}

void PinnedResults::setFinal(bool final) {
  final_ = final;
  showWhetherToPin();
}

/// Makes a name unique: pins with equal names would differ by colour only.
QString PinnedResults::freeName(const QString& wanted) const {
  const std::vector<Pin> taken = all();
  QString name = wanted;
  for (int count = 2;
       std::any_of(taken.begin(), taken.end(), [&](const Pin& pin) { return pin.name == name; });
       ++count)
    name = tr("%1 (%L2)").arg(wanted).arg(count);
  return name;
}

QColor PinnedResults::freeColour() const {
  const std::vector<Pin> taken = all();
  const auto found = std::find_if(kColours.begin(), kColours.end(), [&](QRgb colour) {
    return std::none_of(taken.begin(), taken.end(),
                        [&](const Pin& pin) { return pin.colour == QColor(colour); });
  });
  return {*found};
}

void PinnedResults::show() {
  const Weighting weighting = session_->document().options().weighting;
  std::vector<PinnedEntry> entries;
  std::vector<PinnedFigure> figures;
  for (const auto& [pin, decoded] : pins_) {
    const Distortion& distortion = *decoded->distortion;
    const Spread spread = distortion.spread(weighting);
    PinnedEntry entry{pin.name,      pin.colour, decoded->ratio, spread.rms, spread.p95,
                      spread.max.cm, {}};
    if (decoded->footskate) entry.drift_cm = decoded->footskate->drift_worst_cm;
    figures.push_back({decoded->tracks,
                       pin.colour,
                       {pin.name, ratioText(entry.ratio), lengthText(entry.eps_cm)},
                       posesOf(decoded)});
    entries.push_back(std::move(entry));
  }
  model_->setEntries(std::move(entries));
  if (viewport_) viewport_->setPinned(std::move(figures));
  showWhetherToPin();
}

void PinnedResults::showWhetherToPin() {
  if (panel_) panel_->setCanPin(canPin());
  emit canPinChanged(canPin());
}

}  // namespace mocapress
