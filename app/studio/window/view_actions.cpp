// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/window/view_actions.h"

#include <QAction>
#include <QActionGroup>
#include <QCoreApplication>
#include <QMainWindow>
#include <QMenu>
#include <QSettings>
#include <QToolBar>
#include <optional>

#include "widgets/icons/themed_icon.h"
#include "widgets/viewport/viewport.h"

namespace mocapress {
namespace {

struct ViewTexts {
  Q_DECLARE_TR_FUNCTIONS(mocapress::ViewActions)
};

QAction* make(QObject* parent, const char* icon, const QString& text, const QKeySequence& shortcut,
              const QString& explanation) {
  auto* action = new QAction(themedIcon(QString::fromLatin1(icon)), text, parent);
  action->setShortcut(shortcut);
  action->setToolTip(
      QStringLiteral("%1 (%2)").arg(explanation, shortcut.toString(QKeySequence::NativeText)));
  return action;
}

QAction* makePlain(QObject* parent, const QString& text, const QKeySequence& shortcut,
                   const QString& explanation) {
  auto* action = new QAction(text, parent);
  action->setShortcut(shortcut);
  action->setToolTip(explanation);
  return action;
}

/// Makes exclusive choices and checks the one at index `first`.
QActionGroup* makeNumberChoices(QObject* parent, const QList<std::pair<QString, int>>& choices,
                                int first) {
  auto* group = new QActionGroup(parent);
  for (const auto& [text, value] : choices) {
    QAction* choice = group->addAction(text);
    choice->setCheckable(true);
    choice->setData(value);
  }
  group->actions().at(first)->setChecked(true);
  return group;
}

QString settingOf(std::size_t bookmark) {
  return QStringLiteral("view/camera%1").arg(bookmark + 1);
}

QVariantList listOf(const OrbitCamera::Place& place) {
  return {place.target.x(), place.target.y(), place.target.z(),
          place.distance,   place.azimuth,    place.elevation};
}

std::optional<OrbitCamera::Place> placeOf(const QVariantList& list) {
  if (list.size() != 6) return {};
  const auto number = [&](int i) { return list[i].toFloat(); };
  return OrbitCamera::Place{{number(0), number(1), number(2)}, number(3), number(4), number(5)};
}

void connectBookmarks(const ViewActions& actions, Viewport* viewport) {
  for (std::size_t i = 0; i < actions.go_to.size(); ++i) {
    QAction* const go = actions.go_to[i];
    go->setEnabled(placeOf(QSettings().value(settingOf(i)).toList()).has_value());
    QObject::connect(go, &QAction::triggered, viewport, [=] {
      if (const auto place = placeOf(QSettings().value(settingOf(i)).toList()))
        viewport->setCameraPlace(*place);
    });
    QObject::connect(actions.keep[i], &QAction::triggered, viewport, [=] {
      QSettings().setValue(settingOf(i), listOf(viewport->cameraPlace()));
      go->setEnabled(true);
    });
  }
}

ViewOptions chosen(const ViewActions& actions, const ViewOptions& before) {
  ViewOptions options = before;
  for (std::size_t mode = 0; mode < actions.mode.size(); ++mode)
    if (actions.mode[mode]->isChecked()) options.mode = static_cast<ViewMode>(mode);
  options.quartered = actions.quarters->isChecked();
  options.swapped = actions.swap->isChecked();
  options.blinking = actions.blink->isChecked();
  options.by_error = actions.by_error->isChecked();
  options.skin = actions.skin->isChecked();
  options.path = actions.path->isChecked();
  options.in_place = actions.in_place->isChecked();
  options.exaggeration =
      actions.exaggerate->isChecked() ? actions.exaggeration->checkedAction()->data().toInt() : 1;
  options.trail =
      actions.trail->isChecked() ? actions.trail_poses->checkedAction()->data().toInt() : 0;
  return options;
}

}  // namespace

ViewActions makeViewActions(QMainWindow* window) {
  ViewActions actions;
  const auto make_here = [window](const char* icon, const QString& text,
                                  const QKeySequence& shortcut, const QString& explanation) {
    return make(window, icon, text, shortcut, explanation);
  };
  actions.mode = {make_here("overlay", ViewTexts::tr("&Overlay"), Qt::Key_1,
                            ViewTexts::tr("The original as a ghost over the compressed figure")),
                  make_here("side-by-side", ViewTexts::tr("&Side by Side"), Qt::Key_2,
                            ViewTexts::tr("Original and compressed figure beside each other")),
                  make_here("wipe", ViewTexts::tr("&Wipe"), Qt::Key_3,
                            ViewTexts::tr("Original on one side of a divider that can be dragged, "
                                          "compressed figure on the other"))};
  actions.modes = new QActionGroup(window);
  for (QAction* mode : actions.mode) {
    mode->setCheckable(true);
    actions.modes->addAction(mode);
  }
  actions.mode[0]->setChecked(true);
  actions.quarters = make_here(
      "quarters", ViewTexts::tr("Fo&ur Views"), Qt::Key_4,
      ViewTexts::tr("The same figures from anywhere, from the front, the side and the top"));
  actions.swap = make_here("swap", ViewTexts::tr("Sw&ap"), Qt::Key_X,
                           ViewTexts::tr("Swap original and compressed figure"));
  actions.blink =
      make_here("blink", ViewTexts::tr("&Blink"), Qt::Key_C,
                ViewTexts::tr("Original and compressed figure take turns in one place"));
  actions.by_error =
      make_here("by-error", ViewTexts::tr("Colour by &Error"), Qt::Key_E,
                ViewTexts::tr("Colour every joint by its distance from the original, in cm"));
  actions.skin = make_here("skin", ViewTexts::tr("Show Skin"), Qt::Key_M,
                           ViewTexts::tr("Show figures with their skin or as skeletons"));
  actions.path = make_here(
      "path", ViewTexts::tr("&Path of the Joint"), Qt::Key_P,
      ViewTexts::tr(
          "Path of the selected joint, half a second before and after the current frame"));
  actions.trail = make_here("trail", ViewTexts::tr("Ghost &Trail"), Qt::Key_T,
                            ViewTexts::tr("Faded poses of the compressed figure before (blue) and "
                                          "after (orange) the current frame"));
  QList<std::pair<QString, int>> poses, factors;
  for (const int count : {2, 4, 8})
    poses << std::pair(ViewTexts::tr("%Ln pose(s) before and after", nullptr, count), count);
  actions.trail_poses = makeNumberChoices(window, poses, 1);
  actions.exaggerate =
      make_here("exaggerate", ViewTexts::tr("E&xaggerate the Difference"), Qt::Key_Y,
                ViewTexts::tr("Show poses and paths with a difference from the original that is "
                              "so many times larger than it is"));
  for (const int factor : {2, 3, 5, 10, 20})
    factors << std::pair(ViewTexts::tr("%L1 times").arg(factor), factor);
  actions.exaggeration = makeNumberChoices(window, factors, 2);
  actions.follow = make_here("follow", ViewTexts::tr("&Follow"), Qt::SHIFT | Qt::Key_F,
                             ViewTexts::tr("The camera moves with the figure"));
  actions.in_place = make_here("in-place", ViewTexts::tr("I&n Place"), Qt::Key_G,
                               ViewTexts::tr("Play without the root's travel over the ground"));
  actions.front = makePlain(window, ViewTexts::tr("From the Fro&nt"), Qt::Key_5,
                            ViewTexts::tr("Look along the z axis; again: as before"));
  actions.side = makePlain(window, ViewTexts::tr("From the S&ide"), Qt::Key_6,
                           ViewTexts::tr("Look along the x axis; again: as before"));
  actions.frame_joint =
      makePlain(window, ViewTexts::tr("Frame &Joint"), Qt::Key_F,
                ViewTexts::tr("Look at the selected joint, or at the whole figure without one"));
  for (int i = 0; i < static_cast<int>(actions.go_to.size()); ++i) {
    const auto at = static_cast<std::size_t>(i);
    actions.go_to[at] =
        makePlain(window, ViewTexts::tr("Camera &%L1").arg(i + 1), Qt::Key(Qt::Key_F5 + i),
                  ViewTexts::tr("Look from where the camera was when it was kept"));
    actions.keep[at] = makePlain(window, ViewTexts::tr("Keep as Camera %L1").arg(i + 1),
                                 Qt::SHIFT | Qt::Key(Qt::Key_F5 + i),
                                 ViewTexts::tr("Keep the camera's place, relative to the figure"));
  }
  actions.floor = make_here("floor", ViewTexts::tr("F&loor View"), Qt::Key_V,
                            ViewTexts::tr("Look straight down, as on a plan"));
  actions.reset_camera = make_here("fit", ViewTexts::tr("&Reset Camera"), Qt::Key_R,
                                   ViewTexts::tr("Look at the whole figure again"));
  for (QAction* action :
       {actions.quarters, actions.swap, actions.blink, actions.by_error, actions.skin, actions.path,
        actions.trail, actions.exaggerate, actions.follow, actions.in_place})
    action->setCheckable(true);
  return actions;
}

void connectViewActions(const ViewActions& actions, Viewport* viewport) {
  const auto choose = [=] { viewport->setOptions(chosen(actions, viewport->options())); };
  QObject::connect(actions.modes, &QActionGroup::triggered, viewport, choose);
  QObject::connect(actions.trail_poses, &QActionGroup::triggered, viewport, choose);
  // A user who chooses a factor wants to see its effect.
  QObject::connect(actions.exaggeration, &QActionGroup::triggered, viewport, [=] {
    actions.exaggerate->setChecked(true);
    choose();
  });
  for (const QAction* action :
       {actions.quarters, actions.swap, actions.blink, actions.by_error, actions.skin, actions.path,
        actions.trail, actions.exaggerate, actions.in_place})
    QObject::connect(action, &QAction::toggled, viewport, choose);
  QObject::connect(actions.follow, &QAction::toggled, viewport, &Viewport::setFollow);
  for (const auto& [action, axis] :
       {std::pair(actions.front, ViewAxis::Front), std::pair(actions.side, ViewAxis::Side),
        std::pair(actions.floor, ViewAxis::Top)})
    QObject::connect(action, &QAction::triggered, viewport,
                     [viewport, axis = axis] { viewport->lookAlong(axis); });
  QObject::connect(actions.frame_joint, &QAction::triggered, viewport, &Viewport::frameJoint);
  connectBookmarks(actions, viewport);
  QObject::connect(actions.reset_camera, &QAction::triggered, viewport, &Viewport::resetCamera);
  actions.follow->setChecked(true);
  actions.skin->setChecked(true);
}

void showOptions(const ViewActions& actions, Viewport* viewport, const ViewOptions& options) {
  const auto check = [](const QActionGroup* group, int value) {
    for (QAction* action : group->actions())
      if (action->data().toInt() == value) action->setChecked(true);
  };
  actions.mode[static_cast<std::size_t>(options.mode)]->setChecked(true);
  check(actions.trail_poses, options.trail);
  check(actions.exaggeration, static_cast<int>(options.exaggeration));
  for (const auto& [action, on] :
       {std::pair(actions.quarters, options.quartered), std::pair(actions.swap, options.swapped),
        std::pair(actions.blink, options.blinking), std::pair(actions.by_error, options.by_error),
        std::pair(actions.skin, options.skin), std::pair(actions.path, options.path),
        std::pair(actions.trail, options.trail > 0),
        std::pair(actions.exaggerate, options.exaggeration != 1),
        std::pair(actions.in_place, options.in_place)})
    action->setChecked(on);
  viewport->setOptions(options);
}

void addInGroups(QMenu* menu, const ViewActions& actions) {
  menu->addActions({actions.mode.begin(), actions.mode.end()});
  menu->addActions({actions.quarters, actions.swap, actions.blink});
  menu->addSeparator();
  menu->addActions({actions.skin, actions.in_place, actions.path, actions.trail});
  menu->addMenu(ViewTexts::tr("Poses of the Tra&il"))->addActions(actions.trail_poses->actions());
  menu->addAction(actions.exaggerate);
  menu->addMenu(ViewTexts::tr("Exaggeration"))->addActions(actions.exaggeration->actions());
  QMenu* cameras = menu->addMenu(ViewTexts::tr("Cameras"));
  cameras->addActions({actions.reset_camera, actions.frame_joint, actions.follow});
  cameras->addSeparator();
  cameras->addActions({actions.front, actions.side, actions.floor});
  cameras->addSeparator();
  cameras->addActions({actions.go_to.begin(), actions.go_to.end()});
  cameras->addSeparator();
  cameras->addActions({actions.keep.begin(), actions.keep.end()});
  menu->addSeparator();
}

void addInGroups(QToolBar* bar, const ViewActions& actions) {
  const QList<QAction*> groups[] = {
      {actions.mode[0], actions.mode[1], actions.mode[2], actions.quarters, actions.swap,
       actions.blink},
      {actions.by_error, actions.skin, actions.exaggerate, actions.path, actions.trail},
      {actions.follow, actions.in_place, actions.floor, actions.reset_camera}};
  for (const QList<QAction*>& group : groups) {
    bar->addActions(group);
    bar->addSeparator();
  }
}

}  // namespace mocapress
