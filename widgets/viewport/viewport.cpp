// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/viewport/viewport.h"

#include <QLabel>
#include <QSurfaceFormat>
#include <QVBoxLayout>
#include <QtMath>
#include <algorithm>
#include <chrono>
#include <utility>

#include "core/motion/landmarks.h"
#include "core/motion/own_lengths.h"
#include "widgets/viewport/exaggeration.h"
#include "widgets/viewport/figure_front.h"
#include "widgets/viewport/orbit_camera.h"
#include "widgets/viewport/ring.h"
#include "widgets/viewport/scene.h"
#include "widgets/viewport/trails.h"

namespace mocapress {
namespace {

constexpr int kFramedPoses = 24;          // number of the clip's poses that the camera frames
constexpr float kLeastRadius = 0.1f;      // smallest framed radius, per size of the figure
constexpr float kJointReach = 0.18f;      // radius around a framed joint, per size
constexpr float kTrailPerSize = 0.006f;   // radius of a slide's trail, per size
constexpr float kPathPerSize = 0.006f;    // radius of a joint's path, per size
constexpr float kDiscPerSize = 0.055f;    // radius of a foot's disc, per size
constexpr float kBehindPerSize = 0.002f;  // depth offset of a ghost, per size
constexpr float kFarBehind = 2;           // depth offset to get behind a whole figure, per size
constexpr double kTrailSeconds = 0.1;     // time between poses of the ghost trail
constexpr double kPathSeconds = 0.5;      // length of a path, before and after now
constexpr auto kBlinkTime = std::chrono::milliseconds(400);
constexpr double kNoteSeconds = 0.5;  // a note is shown so long around its frame

bool isEmpty(const Viewport::Tracks& tracks) {
  return !tracks || tracks->size() == 0;
}

}  // namespace

void prepareViewport() {
  // Qt's rhi renderer captures upside down and crashes without OpenGL.
  if (!qEnvironmentVariableIsSet("QT3D_RENDERER")) qputenv("QT3D_RENDERER", "opengl");
  QSurfaceFormat format;
  format.setVersion(4, 3);
  format.setProfile(QSurfaceFormat::CoreProfile);
  format.setDepthBufferSize(24);
  QSurfaceFormat::setDefaultFormat(format);
}

Viewport::Viewport(QWidget* parent) : QWidget(parent) {
  setMinimumSize(160, 120);
  setAccessibleName(tr("3D view"));
  setFocusPolicy(Qt::StrongFocus);
  camera_.lookAt({0, 90, 0}, 100);
  blink_.setInterval(kBlinkTime);
  connect(&blink_, &QTimer::timeout, this, [this] {
    blink_turn_ = !blink_turn_;
    arrangeFigures();
  });
  showSceneOrNotice();
}

Viewport::~Viewport() = default;

void Viewport::showSceneOrNotice() {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins({});
  const OpenGl open_gl = findOpenGl();
  if (open_gl == OpenGl::None) {
    auto* notice = new QLabel(tr("The 3D view needs OpenGL 3.2, which is not available here."));
    notice->setAlignment(Qt::AlignCenter);
    notice->setWordWrap(true);
    layout->addWidget(notice);
    return;
  }
  scene_ = new Scene(open_gl);
  colours_ = sceneColours(palette());
  scene_->setColours(colours_);
  scene_->installEventFilter(this);
  connect(scene_, &Scene::captured, this, &Viewport::captured);
  connect(scene_, &Scene::drawn, this, &Viewport::drawn);
  layout->addWidget(QWidget::createWindowContainer(scene_, this));
  showCamera();
}

void Viewport::setSkeleton(const Skeleton& skeleton) {
  skeleton_ = skeleton;
  shape_.emplace(skeleton);
  original_.reset();
  compressed_.reset();
  original_of_clip_.reset();
  compressed_of_clip_.reset();
  original_poses_ = nullptr;
  compressed_poses_ = nullptr;
  seen_poses_ = nullptr;
  setSkin(nullptr);
  pinned_.clear();
  seen_pinned_.clear();
  errors_.reset();
  contacts_.clear();
  slides_.clear();
  selected_joint_ = -1;
  camera_is_framed_ = false;
  frame_ = 0;  // the old clip's frame means nothing here
  if (scene_) scene_->setCell(gridCell(shape_->size()));
  arrangeFigures();
}

void Viewport::setSkin(std::shared_ptr<const Skin> skin) {
  if (skin == skin_) return;
  skin_ = std::move(skin);
  if (scene_) {
    for (SkinFigure* figure : {&scene_->bodySkin(), &scene_->shellSkin()}) figure->setSkin(skin_);
    for (std::size_t i = 0; i < kMostPinned; ++i) scene_->pinnedSkin(i).setSkin(skin_);
  }
  // Makes the camera frame the figure anew, unless the user has moved the camera.
  camera_is_framed_ = camera_is_framed_ && !camera_is_as_framed_;
  placeAll();
  arrangeFigures();
}

/// Measures the figure's proportions as shown, and the direction that it faces.
void Viewport::measureFigure() {
  const Eigen::MatrixXd* tracks = leadingTracks();
  if (!tracks) return;
  shape_.emplace(skeleton_, *tracks);
  camera_.setFront(frontOf(skeleton_, *tracks).value_or(0));
}

void Viewport::setOriginal(Tracks tracks, Poses poses) {
  original_of_clip_ = isEmpty(tracks) ? nullptr : std::move(tracks);
  original_poses_ = std::move(poses);
  placeAll();
  arrangeFigures();
}

void Viewport::setCompressed(Tracks tracks, Poses poses) {
  compressed_of_clip_ = isEmpty(tracks) ? nullptr : std::move(tracks);
  compressed_poses_ = std::move(poses);
  placeCompressed();
  arrangeFigures();
}

void Viewport::placeOriginal() {
  original_ = asSeen(original_of_clip_, original_poses_);
  measureFigure();
}

void Viewport::placeCompressed() {
  compressed_ = withExaggeration(asSeen(compressed_of_clip_, compressed_poses_));
  seen_poses_ = withExaggeration(compressed_poses_);
  if (!original_) measureFigure();
}

void Viewport::placePinned() {
  seen_pinned_ = pinned_;
  for (PinnedFigure& pinned : seen_pinned_) {
    pinned.tracks = withExaggeration(pinned.tracks);
    pinned.poses = withExaggeration(pinned.poses);
  }
}

void Viewport::placeAll() {
  placeOriginal();
  placeCompressed();
  placePinned();
}

Viewport::Tracks Viewport::withExaggeration(const Tracks& seen) const {
  const bool comparable = exaggerates() && seen && seen->rows() == original_->rows() &&
                          seen->cols() == original_->cols();
  if (!comparable) return seen;
  return std::make_shared<const Eigen::MatrixXd>(
      exaggerated(*original_, *seen, options_.exaggeration));
}

Viewport::Poses Viewport::withExaggeration(const Poses& poses) const {
  if (!exaggerates()) return poses;
  return exaggeratedPoses(original_poses_, poses, options_.exaggeration);
}

/// Moves tracks to the joints of the character, which may have bones of other lengths.
Viewport::Tracks Viewport::asSeen(const Tracks& of_clip, const Poses& poses) const {
  if (!of_clip || !hasSkin(poses) || skin_->lengths.bones.empty()) return of_clip;
  std::vector<Landmark> points = landmarks(skeleton_);
  for (Landmark& point : points) point.in_joint *= skin_->lengths.scale;
  auto seen = std::make_shared<Eigen::MatrixXd>(of_clip->rows(), of_clip->cols());
  Pose pose;
  for (int frame = 0; frame < static_cast<int>(seen->rows()); ++frame) {
    poses(frame, pose);
    pose.origin = own_origins(skin_->lengths, pose);
    place_landmarks(points, pose, frame, *seen);
  }
  return seen;
}

void Viewport::setPinned(std::vector<PinnedFigure> pinned) {
  pinned_ = std::move(pinned);
  if (pinned_.size() > kMostPinned) pinned_.resize(kMostPinned);
  placePinned();
  arrangeFigures();
}

void Viewport::setSlides(std::vector<SlideFinding> slides) {
  slides_ = std::move(slides);
  showTrails();
  showFigures();
}

void Viewport::setContacts(std::vector<ContactSpan> contacts) {
  contacts_ = std::move(contacts);
  showFigures();
}

void Viewport::setErrors(std::shared_ptr<const Eigen::MatrixXf> errors, const ErrorScale& scale) {
  errors_ = std::move(errors);
  error_scale_ = scale;
  showFigures();
  showOverlay();
}

void Viewport::setOptions(const ViewOptions& options) {
  if (options == options_) return;
  const ViewOptions before = std::exchange(options_, options);
  if (options_.skin != before.skin || options_.exaggeration != before.exaggeration) placeAll();
  blink_turn_ = false;
  options_.blinking ? blink_.start() : blink_.stop();
  arrangeFigures();
}

/// Arranges the figures by the options. If the number of panes changes, so does the camera's part
/// of the window.
void Viewport::arrangeFigures() {
  const std::pair parts(arrangement_.panes, arrangement_.quartered);
  arrangement_ =
      arrange(options_, original_ && compressed_, blink_turn_, static_cast<int>(pinned_.size()));
  if (std::pair(arrangement_.panes, arrangement_.quartered) != parts) sizeCamera();
  showTrails();
  showFigures();
  showOverlay();
}

void Viewport::setNotes(std::vector<PlacedNote> notes) {
  notes_ = std::move(notes);
  showNotes();
}

void Viewport::setFrame(int frame) {
  frame_ = frame;
  showFigures();
}

void Viewport::setSelectedJoint(int joint) {
  selected_joint_ = joint;
  showFigures();
}

void Viewport::setFollow(bool follow) {
  follow_ = follow;
  const Eigen::MatrixXd* tracks = leadingTracks();
  if (!follow || !tracks) return;
  camera_.moveBy(shape_->centre(*tracks, frameOf(*tracks)) + offset() - camera_.target());
  showCamera();
}

void Viewport::resetCamera() {
  camera_is_as_framed_ = true;
  if (leadingTracks()) {
    std::vector<QVector3D> body = leadingBody();
    for (QVector3D& point : body) point += offset();
    camera_.frame(body, kLeastRadius * shape_->size());
    OrbitCamera::Place place = camera_.place();
    place.distance *= options_.room;
    camera_.setPlace(place);
  }
  showCamera();
}

void Viewport::frameJoint() {
  const Eigen::MatrixXd* tracks = leadingTracks();
  if (!tracks || selected_joint_ < 0) return resetCamera();
  camera_is_as_framed_ = false;
  camera_.lookClose(landmarkAt(*tracks, frameOf(*tracks), selected_joint_) + offset(),
                    kJointReach * shape_->size());
  showCamera();
}

void Viewport::lookAlong(ViewAxis axis) {
  camera_is_as_framed_ = false;
  camera_.lookAlong(axis);
  showCamera();
}

OrbitCamera::Place Viewport::cameraPlace() const {
  OrbitCamera::Place place = camera_.place();
  place.target -= root_;
  return place;
}

void Viewport::setCameraPlace(const OrbitCamera::Place& place) {
  OrbitCamera::Place here = place;
  here.target += root_;
  camera_is_as_framed_ = false;
  camera_.setPlace(here);
  showCamera();
}

void Viewport::turnCamera(double degrees) {
  OrbitCamera::Place place = camera_.place();
  place.azimuth += static_cast<float>(qDegreesToRadians(degrees));
  camera_.setPlace(place);
  showCamera();
}

void Viewport::capture() {
  if (scene_) return scene_->capture();
  // Emits later, as a scene does: the caller may not have connected yet.
  QMetaObject::invokeMethod(
      this, [this] { emit captured({}); }, Qt::QueuedConnection);
}

void Viewport::showFigures() {
  if (const Eigen::MatrixXd* tracks = leadingTracks()) {
    const QVector3D root = landmarkAt(*tracks, frameOf(*tracks), shape_->bodyRoot()) + offset();
    if (!std::exchange(camera_is_framed_, true)) {
      resetCamera();
    } else if (follow_) {
      camera_.moveBy(root - root_);
      showCamera();
    }
    root_ = root;
  }
  if (!scene_) return;
  const Role original{original_, original_poses_, arrangement_.original, colours_.original,
                      colours_.original};
  const Role compressed{compressed_, seen_poses_, arrangement_.compressed, colours_.compressed,
                        QColor()};
  // The shell is drawn over the body, so the ghost must be the shell.
  const bool turned = arrangement_.compressed.ghost;
  const Parts body{scene_->body(), scene_->bodySkin(), scene_->bodyShadow(), scene_->bodyPath(),
                   scene_->bodyRing()};
  const Parts shell{scene_->shell(), scene_->shellSkin(), scene_->shellShadow(),
                    scene_->shellPath(), scene_->shellRing()};
  showFigure(turned ? body : shell, original, {});
  showFigure(turned ? shell : body, compressed, compressedMarks());
  showMarks();
  showPinned();
  showGhosts();
  showNotes();
}

void Viewport::showFigure(const Parts& parts, const Role& role, const FigureMarks& marks) {
  const auto& [figure, skin, shadow, path, ring] = parts;
  const bool shown = role.tracks && role.placement.shown;
  const bool as_skin = shown && hasSkin(role.poses);
  if (!shown || as_skin) figure.hide();
  if (!as_skin) skin.hide();
  // A ghost casts no shadow: it would be taken for the other figure's shadow.
  const bool has_shadow = shown && !role.placement.ghost;
  if (!has_shadow) shadow.hide();
  if (!shown || !options_.path) path.hide();
  if (!shown || selected_joint_ < 0) ring.hide();
  if (!shown) return;
  const int frame = frameOf(*role.tracks);
  for (Figure* each : {&figure, &path}) {
    each->setColours(role.colour, colours_.alert);
    each->setPane(role.placement.pane);
    each->setOffset(offset());
  }
  const std::vector<Capsule> capsules = shape_->posed(*role.tracks, frame, marks);
  if (has_shadow) {
    shadow.setPane(role.placement.pane);
    shadow.setOffset(offset());
    shadow.show(std::span(capsules).last(static_cast<std::size_t>(shape_->partCount())));
  }
  if (as_skin) {
    Pose pose;
    role.poses(frame, pose);
    skin.setColour(role.skin_colour);
    skin.setPane(role.placement.pane);
    skin.setOffset(offset());
    skin.show(pose, jointCovers(marks, shape_->jointCount(), colours_.alert));
    skin.setGhost(role.placement.ghost);
    skin.setBehind(behindOf(role.placement, 1));
  } else {
    figure.setGhost(role.placement.ghost);
    figure.setBehind(behindOf(role.placement, 1));
    figure.show(capsules);
  }
  if (selected_joint_ >= 0) {
    ring.setPane(role.placement.pane);
    ring.show(landmarkAt(*role.tracks, frame, selected_joint_) + offset(),
              shape_->ringRadius(selected_joint_));
  }
  if (!options_.path) return;
  const auto reach = std::max(1, static_cast<int>(kPathSeconds * sample_rate_hz_));
  path.show(jointPath(*role.tracks, std::max(selected_joint_, 0), frame, reach,
                      kPathPerSize * shape_->size()));
}

void Viewport::showPinned() {
  for (std::size_t i = 0; i < kMostPinned; ++i) {
    Figure& figure = scene_->pinned(i);
    SkinFigure& skin = scene_->pinnedSkin(i);
    const bool shown = shape_ && i < seen_pinned_.size() && arrangement_.pinned[i].shown;
    const bool as_skin = shown && hasSkin(seen_pinned_[i].poses);
    if (!shown || as_skin) figure.hide();
    if (!as_skin) skin.hide();
    if (!shown) continue;
    const PinnedFigure& pinned = seen_pinned_[i];
    const Placement& placement = arrangement_.pinned[i];
    const float behind = behindOf(placement, 2 + static_cast<int>(i));
    if (as_skin) {
      Pose pose;
      pinned.poses(frameOf(*pinned.tracks), pose);
      skin.setColour(pinned.colour);
      skin.setGhost(placement.ghost);
      skin.setBehind(behind);
      skin.setPane(placement.pane);
      skin.setOffset(offset());
      skin.show(pose, {});
      continue;
    }
    figure.setColours(pinned.colour, colours_.alert);
    figure.setGhost(placement.ghost);
    figure.setBehind(behind);
    figure.setPane(placement.pane);
    figure.setOffset(offset());
    figure.show(shape_->posed(*pinned.tracks, frameOf(*pinned.tracks), {}));
  }
}

/// Moves ghosts back, so that where they agree with the solid figure, it covers them instead of
/// flickering, and each ghost covers the next. Where colours show errors, ghosts move behind the
/// whole coloured figure.
float Viewport::behindOf(const Placement& placement, int rank) const {
  if (!placement.ghost) return 0;
  const bool over_colours = colouredByError() && !arrangement_.compressed.ghost;
  return (static_cast<float>(rank) * kBehindPerSize + (over_colours ? kFarBehind : 0)) *
         shape_->size();
}

bool Viewport::colouredByError() const {
  return options_.by_error && errors_ && compressed_ && errors_->rows() == compressed_->rows();
}

/// Shows poses of the compressed figure before and after the current frame.
void Viewport::showGhosts() {
  Figure& ghosts = scene_->ghosts();
  if (options_.trail == 0 || !shape_ || !compressed_ || !arrangement_.compressed.shown)
    return ghosts.hide();
  const int step = std::max(1, static_cast<int>(kTrailSeconds * sample_rate_hz_));
  ghosts.setBehind(colouredByError() ? kFarBehind * shape_->size() : 0);
  ghosts.setPane(arrangement_.compressed.pane);
  ghosts.setOffset(offset());
  ghosts.show(ghostTrail(*shape_, *compressed_, {frameOf(*compressed_), step, options_.trail},
                         {colours_.past, colours_.future, colours_.backdrop_centre}));
}

FigureMarks Viewport::compressedMarks() const {
  FigureMarks marks;
  if (!shape_ || !compressed_) return marks;
  const int frame = frameOf(*compressed_);
  if (!colouredByError()) {
    marks.alerts = slideAlerts(slides_, shape_->jointCount(), frame);
    return marks;
  }
  // Where the character has its own bone lengths, colours by the distance of the figures as drawn.
  const bool has_own_lengths = original_ != original_of_clip_ && compressed_ != compressed_of_clip_;
  const auto times = static_cast<float>(options_.exaggeration);
  for (int landmark = 0; landmark < static_cast<int>(errors_->cols()); ++landmark) {
    const float cm = has_own_lengths
                         ? landmarkAt(*compressed_, frame, landmark)
                                   .distanceToPoint(landmarkAt(*original_, frame, landmark)) /
                               times
                         : (*errors_)(frame, landmark);
    marks.tints.push_back(tintOf(error_scale_.colour(static_cast<double>(cm))));
  }
  return marks;
}

/// Shows on the ground below the compressed figure where feet stand and how much they slide.
void Viewport::showMarks() {
  const bool shown = shape_ && compressed_ && arrangement_.compressed.shown;
  for (Figure* marks : {&scene_->trails(), &scene_->discs()}) {
    marks->setPane(arrangement_.compressed.pane);
    marks->setOffset(offset());
    if (!shown) marks->hide();
  }
  if (!shown) return;
  scene_->discs().show(footDiscs(contacts_, slides_, *compressed_, frameOf(*compressed_),
                                 kDiscPerSize * shape_->size()));
}

/// Draws the trails of sliding feet, which do not change from frame to frame.
void Viewport::showTrails() {
  if (!scene_ || !shape_ || !compressed_ || !arrangement_.compressed.shown) return;
  scene_->trails().show(slideTrails(slides_, *compressed_, kTrailPerSize * shape_->size()));
}

void Viewport::showCamera() {
  if (!scene_) return;
  scene_->setCameras(picture().cameras(), arrangement_.panes);
  showNotes();
  scene_->announce();
}

void Viewport::sizeCamera() {
  if (!scene_) return;
  const double parts = arrangement_.quartered ? 2 : 1;  // number of views in each direction
  camera_.setViewSize({static_cast<double>(scene_->width()) / arrangement_.panes / parts,
                       static_cast<double>(scene_->height()) / parts});
  // In a view of another shape, the figure may be cut off: the camera frames it anew, unless the
  // user has moved the camera.
  camera_is_as_framed_ ? resetCamera() : showCamera();
}

void Viewport::showOverlay() {
  if (!scene_) return;
  const bool coloured = options_.by_error && errors_ && compressed_;
  scene_->overlay().show({arrangement_, options_.titles && original_ != nullptr,
                          options_.titles && compressed_ != nullptr, pinned_,
                          coloured ? std::optional(error_scale_) : std::nullopt,
                          exaggerates() && compressed_ ? options_.exaggeration : 1, scene_->size(),
                          devicePixelRatioF()});
  scene_->announce();
}

/// Shows notes near their frames, for long enough to be seen during playback.
void Viewport::showNotes() {
  if (!scene_) return;
  std::vector<OverlayNote> shown;
  const bool on_compressed = compressed_ && arrangement_.compressed.shown;
  const Tracks& tracks = on_compressed ? compressed_ : original_;
  const Placement& placement = on_compressed ? arrangement_.compressed : arrangement_.original;
  const double half = kNoteSeconds / 2 * sample_rate_hz_;
  for (const PlacedNote& note : notes_) {
    const bool is_now = frame_ >= note.frame - half && frame_ <= note.last_frame + half;
    if (!tracks || !shape_ || !is_now) continue;
    if (!note.place_cm && (note.joint < 0 || note.joint >= shape_->jointCount())) continue;
    const QVector3D place = note.place_cm.value_or(
        note.joint < 0 ? QVector3D() : landmarkAt(*tracks, frameOf(*tracks), note.joint));
    if (const auto at = picture().pixelOf(place, placement.pane)) shown.push_back({*at, note.text});
  }
  scene_->overlay().showNotes(shown, scene_->size(), devicePixelRatioF());
  scene_->announce();
}

QVector3D Viewport::offset() const {
  const Eigen::MatrixXd* tracks = leadingTracks();
  if (!options_.in_place || !tracks) return {};
  const int root = shape_->bodyRoot();
  QVector3D away = landmarkAt(*tracks, 0, root) - landmarkAt(*tracks, frameOf(*tracks), root);
  away.setY(0);
  return away;
}

const Eigen::MatrixXd* Viewport::leadingTracks() const {
  return original_ ? original_.get() : compressed_.get();
}

/// The points that the camera frames: the leading figure, its skin if that is shown, and other
/// poses of the clip, moved to the present root. A camera that follows the figure then shows all of
/// it, even when it lies down.
std::vector<QVector3D> Viewport::leadingBody() const {
  const Eigen::MatrixXd& tracks = *leadingTracks();
  const Poses& poses = original_ ? original_poses_ : compressed_poses_;
  std::vector<QVector3D> body = shape_->body(tracks, frameOf(tracks));
  const QVector3D root = landmarkAt(tracks, frameOf(tracks), shape_->bodyRoot());
  for (int i = 0; i < kFramedPoses; ++i) {
    const auto frame = static_cast<int>(i * (tracks.rows() - 1) / (kFramedPoses - 1));
    const QVector3D away = root - landmarkAt(tracks, frame, shape_->bodyRoot());
    for (const QVector3D& point : shape_->body(tracks, frame)) body.push_back(point + away);
  }
  if (!hasSkin(poses)) return body;
  Pose pose;
  poses(frameOf(tracks), pose);
  for (const Eigen::Vector3d& place : skinned_positions(*skin_, pose)) {
    const Eigen::Vector3f point = place.cast<float>();
    body.emplace_back(point.x(), point.y(), point.z());
  }
  return body;
}

int Viewport::frameOf(const Eigen::MatrixXd& tracks) const {
  return std::clamp(frame_, 0, static_cast<int>(tracks.rows()) - 1);
}

void Viewport::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange && scene_) {
    colours_ = sceneColours(palette());
    scene_->setColours(colours_);
    showFigures();
    showOverlay();
  }
  QWidget::changeEvent(event);
}

}  // namespace mocapress
