// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <QImage>
#include <QPointF>
#include <QString>
#include <QTimer>
#include <QWidget>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "core/feet/footskate.h"
#include "core/motion/skeleton.h"
#include "core/motion/skin.h"
#include "widgets/models/colours.h"
#include "widgets/models/error_colour.h"
#include "widgets/viewport/figure_shape.h"
#include "widgets/viewport/orbit_camera.h"
#include "widgets/viewport/picture_space.h"
#include "widgets/viewport/view_arrangement.h"

class QMouseEvent;

namespace mocapress {

class Figure;
class Ring;
class Scene;
class SkinFigure;

/// A note on a frame or a range, with its place in the picture.
struct PlacedNote {
  int frame = 0;
  int last_frame = 0;
  int joint = -1;                     // the note is drawn at this joint, unless it has a place
  std::optional<QVector3D> place_cm;  // in the clip's world
  QString text;
};

/// Chooses Qt3D's OpenGL renderer and the surface format. Call before QApplication is made.
void prepareViewport();

/// The 3D view: ground grid, the original in grey and the compressed figure in red at the same
/// frame, and other results in colours of their own. Figures are shown one over the other, side by
/// side, or with a divider that can be dragged. The view shows values and starts no work. Mouse
/// (viewport_mouse.cpp): left drag orbits, right or middle drag pans, the wheel zooms, a click on a
/// joint selects it, a right click asks for a menu. A quartered window also has views from the
/// front, from the side and from above. Without OpenGL the widget shows a text, accepts every call
/// and never emits drawn().
class Viewport : public QWidget {
  Q_OBJECT

 public:
  /// World-space positions as given by landmark_tracks(): frames x 3 * landmarks, cm.
  using Tracks = std::shared_ptr<const Eigen::MatrixXd>;

  explicit Viewport(QWidget* parent = nullptr);
  ~Viewport() override;

  /// Computes the pose of all joints at a frame of a figure's motion, for its skin.
  using Poses = std::function<void(int frame, Pose& pose)>;

  /// Sets a new skeleton, without a skin. It hides both figures until their tracks are set; then
  /// the camera frames the first of them.
  void setSkeleton(const Skeleton& skeleton);

  /// Sets the skin for the skeleton. It is shown on figures that have poses. Null: none.
  void setSkin(std::shared_ptr<const Skin> skin);

  /// Sets a figure's positions, and its poses for the skin. Null hides the figure.
  void setOriginal(Tracks tracks, Poses poses = {});
  void setCompressed(Tracks tracks, Poses poses = {});

  /// Sets other results of the clip, at most kMostPinned. A new skeleton removes them.
  void setPinned(std::vector<PinnedFigure> pinned);
  const std::vector<PinnedFigure>& pinned() const { return pinned_; }

  /// Colours the compressed figure's sliding feet and draws their trails on the ground.
  void setSlides(std::vector<SlideFinding> slides);

  /// Draws a disc under each foot that stands.
  void setContacts(std::vector<ContactSpan> contacts);

  /// Sets the distance of the compressed figure's landmarks from the original (frames x landmarks,
  /// cm), for ViewOptions::by_error. Null: unknown.
  void setErrors(std::shared_ptr<const Eigen::MatrixXf> errors, const ErrorScale& scale);

  /// Sets the sample rate, which paths, trails and notes need for their length in time.
  void setSampleRate(double sample_rate_hz) { sample_rate_hz_ = sample_rate_hz; }

  void setOptions(const ViewOptions& options);
  const ViewOptions& options() const { return options_; }

  /// Sets notes on frames. Each is drawn over the picture near its frame; in a quartered window,
  /// over the first view.
  void setNotes(std::vector<PlacedNote> notes);

  void setFrame(int frame);

  /// Draws a ring around a joint; -1: around none.
  void setSelectedJoint(int joint);

  /// Tells whether the camera moves with the root.
  void setFollow(bool follow);

  /// Looks at the whole figure again, from the front right.
  void resetCamera();

  /// Looks at the selected joint, or at the whole figure if none is selected.
  void frameJoint();

  /// Looks along an axis; a second call returns to the earlier view. The view from above shows the
  /// floor like a plan.
  void lookAlong(ViewAxis axis);

  /// The camera's place, with the target relative to the root, so that it fits other clips.
  OrbitCamera::Place cameraPlace() const;

  /// True while the camera frames the figure, that is, since resetCamera() until the user moves it.
  bool framesByItself() const { return camera_is_as_framed_; }
  void setCameraPlace(const OrbitCamera::Place& place);

  /// Turns the camera around its target, in degrees.
  void turnCamera(double degrees);

  /// The camera of a pane. Its pixels are logical ones of the pane: an equal share of the view side
  /// by side, a quarter of a quartered window, else the whole window.
  const OrbitCamera& camera() const { return camera_; }

  /// Renders the 3D scene and delivers the picture by captured(); it is null on failure.
  void capture();

 signals:
  void jointClicked(int joint);

  /// A click with Ctrl on a joint, or (-1) on a place at the depth of the nearest joint; in the
  /// clip's world.
  void placePointed(int joint, const QVector3D& place_cm);

  /// A right click without a drag, at a position on the screen.
  void menuRequested(const QPoint& at);

  /// The wipe's divider was dragged; options() has its new position.
  void dividerMoved(double share);
  void captured(const QImage& image);

  /// A picture with the latest tracks, frame and camera has been rendered and shown. A hidden view
  /// emits this once it is shown.
  void drawn();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  /// The data of one of the two figures.
  struct Role {
    const Tracks& tracks;
    const Poses& poses;
    const Placement& placement;
    const QColor& colour;
    QColor skin_colour;  // invalid: the skin's own colour
  };

  /// The entities that draw one figure.
  struct Parts {
    Figure& figure;
    SkinFigure& skin;
    Figure& shadow;
    Figure& path;
    Ring& ring;
  };

  void showSceneOrNotice();
  void showFigures();
  void showFigure(const Parts& parts, const Role& role, const FigureMarks& marks);
  void showMarks();
  void showPinned();
  void showGhosts();
  void showTrails();
  void showCamera();
  void showOverlay();
  void showNotes();

  PictureSpace picture() const;
  std::optional<PictureSpace::Pointed> pointedAt(const QPointF& position, double reach) const;
  void measureFigure();
  void placeOriginal();
  void placeCompressed();
  void placePinned();
  void placeAll();
  bool exaggerates() const { return options_.exaggeration != 1 && original_; }
  Tracks withExaggeration(const Tracks& seen) const;
  Poses withExaggeration(const Poses& poses) const;
  Tracks asSeen(const Tracks& of_clip, const Poses& poses) const;
  void arrangeFigures();
  void sizeCamera();
  void press(const QMouseEvent& event);
  void drag(const QMouseEvent& event);
  void release(const QMouseEvent& event);

  /// The figure that the camera looks at: the original, or without one the compressed figure.
  const Eigen::MatrixXd* leadingTracks() const;
  int frameOf(const Eigen::MatrixXd& tracks) const;
  FigureMarks compressedMarks() const;
  bool colouredByError() const;
  float behindOf(const Placement& placement, int rank) const;
  bool hasSkin(const Poses& poses) const { return skin_ && options_.skin && poses; }
  std::vector<QVector3D> leadingBody() const;

  /// The offset (cm) that keeps the root in its place, if the options say so.
  QVector3D offset() const;

  Skeleton skeleton_;
  std::optional<FigureShape> shape_;
  Tracks original_of_clip_;
  Tracks compressed_of_clip_;
  Tracks original_;    // as drawn: in a character's proportions
  Tracks compressed_;  // as drawn: also exaggerated
  Poses original_poses_;
  Poses compressed_poses_;
  Poses seen_poses_;  // of the compressed figure, as drawn
  std::shared_ptr<const Skin> skin_;
  std::vector<PinnedFigure> pinned_;
  std::vector<PinnedFigure> seen_pinned_;
  std::vector<SlideFinding> slides_;
  std::vector<ContactSpan> contacts_;
  std::vector<PlacedNote> notes_;
  std::shared_ptr<const Eigen::MatrixXf> errors_;
  ErrorScale error_scale_;
  double sample_rate_hz_ = 120;
  ViewOptions options_;
  Arrangement arrangement_;
  SceneColours colours_;
  QTimer blink_;
  bool blink_turn_ = false;  // a blinking view now shows the compressed figure
  int frame_ = 0;
  int selected_joint_ = -1;
  bool follow_ = false;

  OrbitCamera camera_;
  bool camera_is_framed_ = false;     // the camera has framed this skeleton
  bool camera_is_as_framed_ = false;  // the camera has not been moved since it framed the figure
  QVector3D root_;                    // root of the leading figure when it was last shown, cm

  QPointF pressed_at_;
  QPointF dragged_to_;
  int pressed_quarter_ = 0;
  bool is_click_ = false;
  bool drags_divider_ = false;

  Scene* scene_ = nullptr;  // a child; null without OpenGL
};

}  // namespace mocapress
