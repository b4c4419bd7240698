// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/compare/inspector.h"

#include <QAction>
#include <QEvent>
#include <QtMath>
#include <algorithm>
#include <numbers>
#include <utility>

#include "app/studio/compare/clip_curve.h"
#include "app/studio/compare/error_display.h"
#include "app/studio/compare/figures.h"
#include "app/studio/compare/range_actions.h"
#include "app/studio/document/session.h"
#include "core/motion/body.h"
#include "core/motion/landmarks.h"
#include "core/motion/rig.h"
#include "widgets/models/error_profile.h"
#include "widgets/models/number_text.h"
#include "widgets/panels/figures_bar.h"
#include "widgets/plots/channel_graph.h"
#include "widgets/plots/heat_map.h"
#include "widgets/plots/rate_plot.h"
#include "widgets/timeline/contact_strip.h"
#include "widgets/timeline/error_strip.h"
#include "widgets/timeline/playback.h"
#include "widgets/timeline/pose_strip.h"
#include "widgets/timeline/sight_strip.h"
#include "widgets/timeline/time_ruler.h"
#include "widgets/timeline/timeline.h"

namespace mocapress {
namespace {

constexpr double kWorstApart = 0.25;  // s, least distance between worst frames
constexpr int kMostWorst = 20;
constexpr double kContactSeconds = 0.25;  // length of an added contact

/// The current joint, or the root.
int shownJoint(const Document& document) {
  return std::max(document.currentJoint(), 0);
}

/// Moves angles (radians) by whole turns towards `model`. Whole turns do not move the joint, but
/// would hide the real difference.
void likeOf(const Eigen::VectorXd& model, Eigen::VectorXd& values) {
  constexpr double kTurn = 2 * std::numbers::pi;
  if (model.size() != values.size()) return;
  for (Eigen::Index t = 0; t < values.size(); ++t)
    values[t] += kTurn * std::round((model[t] - values[t]) / kTurn);
}

ChannelCurves curvesOf(const Document& document, int channel) {
  ChannelCurves curves;
  curves.sample_rate_hz = document.sampleRate();
  curves.rotation = is_rotation(document.skeleton()->channel_kind(channel));
  if (const DecodedPtr& decoded = document.decoded()) {
    curves.compressed = decoded->clip.channels.col(channel);
    const Clip& of_coefficients =
        decoded->correction ? decoded->correction->uncorrected : decoded->clip;
    const bool known = !decoded->compressed.correction || decoded->correction;
    if (decoded->of_wavelets && known)
      curves.kept = keptByScale(of_coefficients.channels.col(channel), decoded->compressed.basis);
  }
  if (const OriginalPtr& original = document.original())
    curves.original = original->motion().clip.channels.col(channel);
  if (!curves.rotation) return curves;
  likeOf(curves.compressed, curves.original);
  for (Eigen::VectorXd* values : {&curves.original, &curves.compressed})
    *values *= qRadiansToDegrees(1.0);
  return curves;
}

}  // namespace

Inspector::Inspector(Session* session, Playback* playback, const InspectionViews& views,
                     ErrorDisplay* error_display, QObject* parent)
    : QObject(parent),
      session_(session),
      playback_(playback),
      views_(views),
      error_display_(error_display),
      curve_(new ClipCurve(session, this)),
      range_actions_(new RangeActions(session, playback, this)),
      map_rule_(new QAction(this)) {
  map_rule_->setSeparator(true);
  const Document* document = &session->document();
  connect(document, &Document::clipChanged, this, [this] {
    views_.timeline->showAll();
    showErrors();
    showContacts();
    showRanges();
    showPoses();
    showJoint();
  });
  connect(document, &Document::decodedChanged, this, [this] {
    showErrors();
    showChannel();
    showCurve();
  });
  connect(document, &Document::shownChanged, this, &Inspector::showContacts);
  connect(document, &Document::optionsChanged, this, &Inspector::showContacts);
  connect(document, &Document::optionsChanged, this, &Inspector::showRanges);
  connect(document, &Document::currentJointChanged, this, &Inspector::showJoint);
  connect(error_display_, &ErrorDisplay::changed, this, [this] {
    showErrorScales();
    showErrors();
  });
  connect(curve_, &ClipCurve::changed, this, &Inspector::showCurve);
  connectViews();
  showCurve();
}

void Inspector::connectViews() {
  Timeline* timeline = views_.timeline;
  timeline->errors()->addActions(error_display_->scales(ErrorQuantity::Distance)->actions());
  views_.heat_map->setSwitches({error_display_->inDegrees(), error_display_->asSeen()});
  showErrorScales();
  connect(timeline, &Timeline::seekRequested, playback_, &Playback::seek);
  connect(timeline->contacts(), &ContactStrip::contactsEdited, session_, &Session::setContacts);
  connect(timeline->sight(), &SightStrip::chosen, this, &Inspector::chooseCell);
  timeline->addRangeActions(range_actions_->actions());
  connect(timeline->ruler(), &TimeRuler::rangeChosen, playback_, &Playback::setRange);
  connect(playback_, &Playback::rangeChanged, timeline->ruler(),
          [=, this] { timeline->ruler()->setRange(playback_->range()); });
  connect(timeline->errors(), &ErrorStrip::rangeChosen, playback_,
          [this](const FrameRange& range) { playback_->setRange(range); });
  connect(playback_, &Playback::rangeChanged, this, &Inspector::showRangeErrors);
  connect(playback_, &Playback::rangeChanged, timeline->errors(),
          [=, this] { timeline->errors()->setRange(playback_->range()); });
  connect(playback_, &Playback::frameChanged, timeline, &Timeline::setFrame);
  connect(playback_, &Playback::frameChanged, views_.heat_map, &HeatMap::setFrame);
  connect(playback_, &Playback::frameChanged, views_.channel, [this](int frame) {
    if (views_.channel->isVisible()) views_.channel->setFrame(frame);
  });
  connect(views_.heat_map, &HeatMap::chosen, this, &Inspector::chooseCell);
  connect(views_.channel, &ChannelGraph::seekRequested, playback_, &Playback::seek);
  connect(views_.channel, &ChannelGraph::channelChosen, this, [this](int index) {
    channel_ = index;
    showChannel();
  });
  connect(views_.curve, &RatePlot::pointChosen, this, &Inspector::chooseRatio);
  views_.channel->installEventFilter(this);
  views_.curve->installEventFilter(this);
  views_.curve->setHint(tr("The curve of this clip appears after it is compressed."));
}

/// Puts the scales of the shown quantity into the heat map's menu.
void Inspector::showErrorScales() {
  HeatMap* map = views_.heat_map;
  for (QAction* action : std::exchange(map_actions_, {})) map->removeAction(action);
  map_actions_ = {error_display_->inDegrees(), error_display_->asSeen()};
  if (!error_display_->tellsSight())
    map_actions_ << map_rule_ << error_display_->scales(error_display_->quantity())->actions();
  map->insertActions(map->actions().value(0), map_actions_);
}

void Inspector::showErrors() {
  const Document& document = session_->document();
  const DecodedPtr& decoded = document.decoded();
  const bool measured = decoded && decoded->distortion;
  const auto scale_of = [&](ErrorQuantity quantity) {
    return error_display_->scales(quantity)->scaleFor(decoded);
  };
  const ErrorsPtr errors = measured ? ErrorsPtr(decoded, &*decoded->distortion) : nullptr;
  const ErrorProfile profile = errors ? errorProfile(errors->distances) : ErrorProfile();
  const std::vector<QString> names = document.landmarkNames();
  views_.timeline->errors()->setErrors(profile, scale_of(ErrorQuantity::Distance),
                                       document.frames());
  views_.timeline->errors()->setGlitches(measured ? decoded->glitches : std::vector<Glitch>(),
                                         names);
  const SightPtr sight =
      measured && decoded->visibility ? SightPtr(decoded, &decoded->visibility->table) : nullptr;
  views_.timeline->sight()->setSight(sight, names, document.frames());
  views_.heat_map->setSight(sight, error_display_->tellsSight());
  views_.heat_map->setErrors(errors, names, scale_of(error_display_->quantity()));
  views_.figures->setFigures(figuresOf(document));
  const int apart = std::max(1, static_cast<int>(kWorstApart * document.sampleRate()));
  worst_ = worstFrames(profile.max, apart, kMostWorst);
  showRangeErrors();
}

/// Shows the errors in the chosen range instead of those in the whole clip.
void Inspector::showRangeErrors() {
  const DecodedPtr& decoded = session_->document().decoded();
  const auto& range = playback_->range();
  if (!range || !decoded || !decoded->distortion ||
      range->second >= decoded->distortion->distances.rows())
    return views_.figures->setRange({});
  const RangeErrors errors =
      rangeErrors(decoded->distortion->distances, range->first, range->second);
  views_.figures->setRange(
      tr("Frames %L1–%L2: RMS %3, p95 %4, max %5 (%6, frame %L7)")
          .arg(range->first + 1)
          .arg(range->second + 1)
          .arg(lengthText(errors.rms), lengthText(errors.p95), lengthText(errors.max),
               session_->document().landmarkNames()[static_cast<std::size_t>(errors.landmark)])
          .arg(errors.frame + 1));
}

void Inspector::showPoses() {
  const Document& document = session_->document();
  const OriginalPtr& original = document.original();
  if (!original) return views_.timeline->poses()->setPoses(nullptr, {}, 0);
  const Skeleton& skeleton = *document.skeleton();
  std::vector<int> parents;
  for (int joint = 0; joint < skeleton.joint_count(); ++joint)
    parents.push_back(skeleton.joint(joint).parent);
  views_.timeline->poses()->setPoses(original->tracks(), parents, body_root(skeleton));
}

void Inspector::showContacts() {
  const Document& document = session_->document();
  const Footskate* footskate = document.shownFootskate();
  Timeline* timeline = views_.timeline;
  timeline->setContacts(document.contacts(), document.landmarkNames(), document.frames());
  timeline->contacts()->setUsualLength(
      std::max(2, static_cast<int>(kContactSeconds * document.sampleRate())));
  timeline->contacts()->setFindings(footskate ? footskate->findings : std::vector<SlideFinding>());
}

void Inspector::showRanges() {
  const Document& document = session_->document();
  views_.timeline->setRate(document.sampleRate());
  views_.timeline->ruler()->setCare(document.options().ranges);
}

void Inspector::showJoint() {
  const Document& document = session_->document();
  if (!document.skeleton()) {
    views_.channel->setChannels({}, -1);
    return showChannel();
  }
  const Skeleton& skeleton = *document.skeleton();
  const int joint = shownJoint(document);
  QStringList names;
  const Joint& shown = skeleton.joint(joint);
  const std::size_t shared = shared_namespace(skeleton).size();
  for (std::size_t c = 0; c < shown.channels.size(); ++c)
    names << QString::fromStdString(
        skeleton.channel_name(skeleton.first_channel(joint) + static_cast<int>(c)).substr(shared));
  channel_ = std::clamp(channel_, 0, std::max(0, static_cast<int>(names.size()) - 1));
  views_.channel->setChannels(names, names.isEmpty() ? -1 : channel_);
  views_.heat_map->setCurrentLandmark(document.currentJoint());
  showChannel();
}

bool Inspector::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Show) {
    const auto waiting = waiting_.extract(watched);
    if (waiting) waiting.mapped()();
  }
  return QObject::eventFilter(watched, event);
}

void Inspector::whenSeen(QWidget* view, std::function<void()> show) {
  if (view->isVisible()) return show();
  waiting_.insert_or_assign(view, std::move(show));
}

void Inspector::showChannel() {
  whenSeen(views_.channel, [this] { drawChannel(); });
}

void Inspector::showCurve() {
  whenSeen(views_.curve, [this] { drawCurve(); });
}

void Inspector::drawChannel() {
  const Document& document = session_->document();
  if (!document.skeleton()) return views_.channel->setCurves({});
  const Skeleton& skeleton = *document.skeleton();
  const int joint = shownJoint(document);
  if (skeleton.joint(joint).channels.empty()) return views_.channel->setCurves({});
  views_.channel->setCurves(curvesOf(document, skeleton.first_channel(joint) + channel_));
  views_.channel->setFrame(playback_->frame());
}

void Inspector::drawCurve() {
  const Document& document = session_->document();
  views_.curve->setWeighting(document.options().weighting);
  std::optional<CurvePoint> here;
  if (const DecodedPtr& decoded = document.decoded(); decoded && decoded->distortion)
    here = CurvePoint{decoded->ratio, decoded->distortion->eps(document.options().weighting)};
  views_.curve->setCurves(curve_->curves());
  views_.curve->setHere(here);
}

void Inspector::chooseCell(int frame, int landmark) {
  Document& document = session_->document();
  playback_->seek(frame);
  document.setCurrentJoint(
      landmarks(*document.skeleton())[static_cast<std::size_t>(landmark)].joint);
  views_.heat_map->setCurrentLandmark(landmark);
}

/// Makes the ratio of a chosen point of the curve the target.
void Inspector::chooseRatio(int point) {
  const std::vector<double> ratios = curve_->ratios();
  if (point < 0 || point >= static_cast<int>(ratios.size())) return;
  EncodeSettings options = session_->document().options();
  options.target = {Target::Kind::Ratio, ratios[static_cast<std::size_t>(point)]};
  session_->setOptions(options);
}

void Inspector::showNextWorst(int step) {
  if (worst_.empty()) return;
  // Goes on only from the frame that this function showed last. At any other frame it starts with
  // the worst, even if the playhead is at one of worst_ by chance.
  const bool goes_on = playback_->frame() == shown_worst_;
  const int frame = goes_on ? nextWorst(worst_, shown_worst_, step) : worst_.front();
  shown_worst_ = frame;
  playback_->seek(frame);
  const DecodedPtr& decoded = session_->document().decoded();
  if (!decoded || !decoded->distortion) return;
  Eigen::Index landmark = 0;
  decoded->distortion->distances.row(frame).maxCoeff(&landmark);
  chooseCell(frame, static_cast<int>(landmark));
}

}  // namespace mocapress
