// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/compare/presenter.h"

#include "app/studio/compare/error_display.h"
#include "app/studio/compare/figures.h"
#include "app/studio/document/session.h"
#include "core/motion/landmarks.h"
#include "core/motion/rig.h"
#include "widgets/panels/annealing_panel.h"
#include "widgets/panels/compression_panel.h"
#include "widgets/panels/correction_control.h"
#include "widgets/panels/footskate_panel.h"
#include "widgets/panels/importance_panel.h"
#include "widgets/panels/joints_panel.h"
#include "widgets/panels/result_panel.h"
#include "widgets/panels/target_control.h"
#include "widgets/plots/error_graph.h"
#include "widgets/timeline/playback.h"
#include "widgets/timeline/transport_bar.h"
#include "widgets/viewport/viewport.h"

namespace mocapress {
namespace {

std::vector<ErrorCurve> curvesOf(const Document& document) {
  std::vector<ErrorCurve> curves;
  if (!document.skeleton()) return curves;
  const std::vector<Landmark> points = landmarks(*document.skeleton());
  const std::vector<QString> shown = document.landmarkNames();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const QString name = QString::fromStdString(points[i].name);
    if (document.curves().contains(name))
      curves.push_back({shown[i], document.curves().colour(name), static_cast<int>(i)});
  }
  return curves;
}

}  // namespace

Presenter::Presenter(Session* session, Playback* playback, const Models& models, const Views& views,
                     ErrorDisplay* error_display, QObject* parent)
    : QObject(parent),
      session_(session),
      playback_(playback),
      models_(models),
      views_(views),
      error_display_(error_display) {
  connectDocument();
  connectViews();
  if (session->document().skeleton()) {
    showClip();
  } else {
    showOptions();
    showDecoded();
    showShown();
  }
}

void Presenter::connectDocument() {
  Document* document = &session_->document();
  connect(document, &Document::clipChanged, this, &Presenter::showClip);
  // If another take cannot be read, the list shows the open one again.
  connect(session_, &Session::openFailed, this, &Presenter::showTakes);
  connect(document, &Document::decodedChanged, this, &Presenter::showDecoded);
  connect(document, &Document::shownChanged, this, &Presenter::showShown);
  connect(document, &Document::skinChanged, this, [this] {
    showSkin();
    showSkeleton();
  });
  connect(document, &Document::curvesChanged, this, &Presenter::showCurves);
  connect(document, &Document::currentJointChanged, this, &Presenter::showCurrentJoint);
  connect(document, &Document::optionsChanged, this, &Presenter::showOptions);
  connect(error_display_, &ErrorDisplay::changed, this, &Presenter::showErrors);
  AnnealingPanel* annealing = views_.annealing;
  connect(session_, &Session::recompressing, annealing, &AnnealingPanel::await);
  connect(session_, &Session::opened, annealing, [this, annealing] {
    session_->document().decoded() ? annealing->rest() : annealing->await();
  });
  connect(session_, &Session::refiningChanged, annealing, [this, annealing](bool refining) {
    refining ? annealing->begin(session_->document().options()) : annealing->end();
  });
  connect(session_, &Session::annealed, annealing, &AnnealingPanel::append);
  connect(session_, &Session::settled, annealing, &AnnealingPanel::rest);
  connect(session_, &Session::compressFailed, annealing, [this, annealing] {
    if (!session_->busy()) annealing->rest();
  });
  TargetControl* target = views_.compression->target();
  connect(session_, &Session::recompressing, target, [target] { target->setTrouble({}); });
  connect(session_, &Session::opened, target, [target] { target->setTrouble({}); });
  connect(session_, &Session::compressFailed, target,
          [target](const QString& message, bool out_of_reach) {
            if (out_of_reach)
              target->setTrouble(tr("This method cannot reach the target for this clip."), message);
          });
}

void Presenter::connectViews() {
  connect(views_.compression, &CompressionPanel::optionsChanged, session_, &Session::setOptions);
  connect(views_.compression, &CompressionPanel::trackErrorChanged, session_,
          &Session::setTrackError);
  connect(views_.importance, &ImportancePanel::importanceChanged, session_,
          &Session::setImportance);
  connect(views_.annealing, &AnnealingPanel::cancelRequested, session_, &Session::cancelAnnealing);
  connect(models_.joints, &JointErrorModel::checkRequested, this, &Presenter::setChecked);
  connect(views_.joints, &JointsPanel::currentJointChanged, &session_->document(),
          &Document::setCurrentJoint);
  connect(views_.viewport, &Viewport::jointClicked, this, &Presenter::toggleJoint);
  views_.graph->setSwitch(error_display_->inDegrees());
  connect(views_.graph, &ErrorGraph::seekRequested, playback_, &Playback::seek);
  connect(views_.footskate, &FootskatePanel::findingChosen, this, &Presenter::showFinding);
  connect(views_.footskate, &FootskatePanel::settingsChanged, session_,
          &Session::setContactSettings);
  connect(views_.transport, &TransportBar::takeChosen, session_, &Session::chooseTake);
  connect(playback_, &Playback::frameChanged, views_.graph, &ErrorGraph::setFrame);
  connect(playback_, &Playback::frameChanged, views_.viewport, &Viewport::setFrame);
}

void Presenter::showClip() {
  const Document& document = session_->document();
  const OriginalPtr& original = document.original();
  const Skeleton none;
  const Skeleton& skeleton = document.skeleton() ? *document.skeleton() : none;
  views_.viewport->setSkeleton(skeleton);
  views_.viewport->setSampleRate(document.sampleRate());
  showSkin();
  views_.compression->setEnabled(original != nullptr);
  views_.compression->setHasTracks(original && !original->scalars.empty());
  showSkeleton();
  views_.importance->setEnabled(original != nullptr);
  views_.importance->setSkeleton(skeleton);
  showOptions();
  models_.joints->setLandmarks(landmarks(skeleton), shared_namespace(skeleton));
  playback_->setClip(document.frames(), document.sampleRate());
  showTakes();
  showDecoded();
  showShown();
  showCurrentJoint();
}

/// Shows the skeleton, and offers the choices that need a mesh only if there is one.
void Presenter::showSkeleton() {
  const Document& document = session_->document();
  const OriginalPtr& original = document.original();
  views_.compression->setSkeleton(document.skeleton() ? *document.skeleton() : Skeleton());
  views_.viewport->setOriginal(original ? original->tracks() : nullptr,
                               original ? original->poses() : Poses());
}

void Presenter::showTakes() {
  const OriginalPtr& original = session_->document().original();
  const Takes takes = original ? original->takes : Takes();
  QStringList names;
  for (const std::string& key : takes.keys) names << QString::fromStdString(key);
  views_.transport->setTakes(names, static_cast<int>(takes.read));
}

void Presenter::showOptions() {
  const EncodeSettings& options = session_->document().options();
  views_.compression->setOptions(options);
  views_.compression->setTrackError(session_->document().settings().track_error);
  views_.importance->setMethod(options.method);
  views_.importance->setImportance(options.importance);
}

void Presenter::showDecoded() {
  const Document& document = session_->document();
  const DecodedPtr& decoded = document.decoded();
  views_.result->setFigures(figuresOf(document));
  views_.result->setState(stateOf(document));
  playback_->setRepeatsFirst(decoded && decoded->compressed.loop == Loop::Repeats);
  const bool measured = decoded && decoded->distortion;
  const ErrorsPtr errors = measured ? ErrorsPtr(decoded, &*decoded->distortion) : nullptr;
  models_.joints->setErrors(
      errors.get(), measured && decoded->visibility ? &decoded->visibility->table : nullptr);
  models_.joints->setSelection(document.curves());
  views_.graph->setErrors(errors, document.sampleRate(), curvesOf(document));
  showErrors();
  showTarget();
}

void Presenter::showErrors() {
  const DecodedPtr& decoded = session_->document().decoded();
  const bool measured = decoded && decoded->distortion;
  using Distances = std::shared_ptr<const Eigen::MatrixXf>;
  views_.viewport->setErrors(
      measured ? Distances(decoded, &decoded->distortion->distances) : nullptr,
      error_display_->scales(ErrorQuantity::Distance)->scaleFor(decoded));
  views_.graph->setQuantity(error_display_->quantity());
}

/// Shows the values reached beside the target.
void Presenter::showTarget() {
  const Document& document = session_->document();
  const DecodedPtr& decoded = document.decoded();
  const bool answered = decoded && document.final() && !document.unanswered();
  views_.compression->correction()->setFound(
      answered && decoded->correction ? std::optional(decoded->correction->ratio) : std::nullopt);
  if (!decoded || !decoded->distortion) return;
  views_.compression->target()->setAchieved(
      {{Target::Kind::Ratio, decoded->ratio},
       {Target::Kind::Size, static_cast<double>(decoded->compressed.motion_bytes())},
       {Target::Kind::Error, decoded->distortion->eps(document.options().weighting)},
       {Target::Kind::MaxError, decoded->distortion->worst(document.options().weighting).cm}});
}

void Presenter::showShown() {
  const Document& document = session_->document();
  const std::vector<ContactSpan> contacts = document.contacts();
  const Footskate* footskate = document.shownFootskate();
  const std::vector<SlideFinding> slides =
      footskate ? footskate->findings : std::vector<SlideFinding>();
  const std::vector<QString> names = document.landmarkNames();
  views_.viewport->setCompressed(document.shownTracks(), document.shownPoses());
  views_.viewport->setContacts(contacts);
  views_.viewport->setSlides(slides);
  models_.slides->setFindings(slides, names);
  views_.footskate->setSummary(footskateSummary(document));
}

void Presenter::showSkin() {
  views_.viewport->setSkin(session_->document().skin());
}

/// Goes to a finding: moves the playhead to its worst frame and draws the foot's curve.
void Presenter::showFinding(int frame, int landmark) {
  playback_->seek(frame);
  const std::vector<Landmark> points = landmarks(*session_->document().skeleton());
  setChecked(QString::fromStdString(points[static_cast<std::size_t>(landmark)].name), true);
  session_->document().setCurrentJoint(models_.joints->jointOf(landmark));
}

void Presenter::showCurves() {
  models_.joints->setSelection(session_->document().curves());
  views_.graph->setCurves(curvesOf(session_->document()));
}

void Presenter::showCurrentJoint() {
  const int joint = session_->document().currentJoint();
  views_.viewport->setSelectedJoint(joint);
  views_.joints->setCurrentJoint(joint);
}

void Presenter::setChecked(const QString& name, bool checked) {
  CurveSelection curves = session_->document().curves();
  if (checked)
    curves.add(name);
  else
    curves.remove(name);
  session_->document().setCurves(curves);
}

/// A first click makes a joint current and draws its curve; a click on the current joint hides it.
void Presenter::toggleJoint(int joint) {
  Document& document = session_->document();
  const QString name = QString::fromStdString(document.skeleton()->joint(joint).name);
  const bool hide = joint == document.currentJoint() && document.curves().contains(name);
  document.setCurrentJoint(joint);
  setChecked(name, !hide);
}

}  // namespace mocapress
