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

/// A note on a frame or a range, in the picture.
struct PlacedNote {
  int frame = 0;
  int last_frame = 0;
  int joint = -1;                     // it is drawn there, unless it has a place
  std::optional<QVector3D> place_cm;  // in the clip's world
  QString text;
};

/// Chooses Qt3D's OpenGL renderer and the surface format. Call before QApplication is made.
void prepareViewport();

/// The 3D view: ground grid, the original in grey and the compressed figure in red at the same
/// frame, and other results in colours of their own. Figures stand over each other, side by side,
/// or with a divider to drag between them. The view shows values and starts no work. Mouse: left
/// drag orbits, right or middle drag pans, wheel zooms, a click on a joint selects it, a right
/// click asks for a menu. A quartered
/// window shows the same from the front, the side and the top, too. Without OpenGL it shows a text,
/// accepts every call and never emits drawn(). viewport_mouse.cpp has the mouse.
class Viewport : public QWidget {
  Q_OBJECT

 public:
  /// World positions as landmark_tracks() gives them: frames x 3 * landmarks, cm.
  using Tracks = std::shared_ptr<const Eigen::MatrixXd>;

  explicit Viewport(QWidget* parent = nullptr);
  ~Viewport() override;

  /// Poses of all joints at a frame of a figure's motion, for its skin.
  using Poses = std::function<void(int frame, Pose& pose)>;

  /// A new skeleton hides both figures until their tracks are set, and frames the camera anew with
  /// the first of them. It has no skin.
  void setSkeleton(const Skeleton& skeleton);

  /// The skin of figures that have poses, for that skeleton. Null: none.
  void setSkin(std::shared_ptr<const Skin> skin);

  /// Null hides the figure.
  void setOriginal(Tracks tracks, Poses poses = {});
  void setCompressed(Tracks tracks, Poses poses = {});

  /// Other results of the clip, kMostPinned at most. A new skeleton removes them.
  void setPinned(std::vector<PinnedFigure> pinned);
  const std::vector<PinnedFigure>& pinned() const { return pinned_; }

  /// Colours the compressed figure's sliding feet and draws their trails on the ground.
  void setSlides(std::vector<SlideFinding> slides);

  /// Draws a disc under each foot that stands.
  void setContacts(std::vector<ContactSpan> contacts);

  /// Distance of the compressed figure's landmarks from the original (frames x landmarks, cm), for
  /// ViewOptions::by_error. Null: unknown.
  void setErrors(std::shared_ptr<const Eigen::MatrixXf> errors, const ErrorScale& scale);

  /// The frame rate, for the length of a path.
  void setSampleRate(double sample_rate_hz) { sample_rate_hz_ = sample_rate_hz; }

  void setOptions(const ViewOptions& options);
  const ViewOptions& options() const { return options_; }

  /// Notes on frames, drawn over the picture near their frames; of four views, over the first.
  void setNotes(std::vector<PlacedNote> notes);

  void setFrame(int frame);

  /// The joint with a ring around it; -1: none.
  void setSelectedJoint(int joint);

  /// Moves the camera with the root.
  void setFollow(bool follow);

  /// Looks at the whole figure again.
  void resetCamera();

  /// Looks at the joint with the ring, or at the whole figure without one.
  void frameJoint();

  /// Looks along an axis; again: as before. The top shows the floor as on a plan.
  void lookAlong(ViewAxis axis);

  /// The camera's place, with its target relative to the root, so that it fits other clips.
  OrbitCamera::Place cameraPlace() const;

  /// True while the camera frames the figure by itself, as resetCamera() does.
  bool framesByItself() const { return camera_is_as_framed_; }
  void setCameraPlace(const OrbitCamera::Place& place);

  /// Turns the camera around its target, in degrees.
  void turnCamera(double degrees);

  /// The camera of a pane, in the pane's logical pixels: a half of the view side by side, a quarter
  /// of a quartered window, else all.
  const OrbitCamera& camera() const { return camera_; }

  /// Renders the 3D scene and delivers it by captured(); the image is null on failure.
  void capture();

 signals:
  void jointClicked(int joint);

  /// A click with Ctrl: the joint there, or -1 and the place at the depth of the nearest joint, in
  /// the clip's world.
  void placePointed(int joint, const QVector3D& place_cm);

  /// A right click that was no drag, at a place on the screen.
  void menuRequested(const QPoint& at);

  /// The wipe's divider was dragged; options() have its new place.
  void dividerMoved(double share);
  void captured(const QImage& image);

  /// A picture with the newest tracks, frame and camera has been rendered and shown. A hidden view
  /// emits this once it is shown.
  void drawn();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  /// Data of one of the two figures.
  struct Role {
    const Tracks& tracks;
    const Poses& poses;
    const Placement& placement;
    const QColor& colour;
    QColor skin_colour;  // invalid: the skin's own colour
  };

  /// Entities that draw one figure.
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

  /// The offset (cm) that keeps the root in its place.
  QVector3D offset() const;

  Skeleton skeleton_;
  std::optional<FigureShape> shape_;
  Tracks original_of_clip_;
  Tracks compressed_of_clip_;
  Tracks original_;    // the original as it is shown; all that is drawn follows from it
  Tracks compressed_;  // likewise
  Poses original_poses_;
  Poses compressed_poses_;
  Poses seen_poses_;  // the compressed figure's
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
  bool blink_turn_ = false;  // the compressed figure's turn
  int frame_ = 0;
  int selected_joint_ = -1;
  bool follow_ = false;

  OrbitCamera camera_;
  bool camera_is_framed_ = false;     // the camera is framed for this skeleton
  bool camera_is_as_framed_ = false;  // the user has not moved the camera since
  QVector3D root_;                    // root of the leading figure when last shown, cm

  QPointF pressed_at_;
  QPointF dragged_to_;
  int pressed_quarter_ = 0;
  bool is_click_ = false;
  bool drags_divider_ = false;

  Scene* scene_ = nullptr;  // a child; null without OpenGL
};

}  // namespace mocapress
