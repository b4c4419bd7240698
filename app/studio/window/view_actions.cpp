// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/window/view_actions.h"

#include <QAction>
#include <QActionGroup>
#include <QCoreApplication>
#include <QMainWindow>
#include <QMenu>
#include <QToolBar>

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

template <typename Bar>
void addAll(Bar* bar, const ViewActions& actions) {
  for (QAction* action : actions.inGroups())
    action ? bar->addAction(action) : static_cast<void>(bar->addSeparator());
}

ViewOptions chosen(const ViewActions& actions, const ViewOptions& before) {
  ViewOptions options = before;
  for (std::size_t mode = 0; mode < actions.mode.size(); ++mode)
    if (actions.mode[mode]->isChecked()) options.mode = static_cast<ViewMode>(mode);
  options.swapped = actions.swap->isChecked();
  options.blinking = actions.blink->isChecked();
  options.by_error = actions.by_error->isChecked();
  options.skin = actions.skin->isChecked();
  options.path = actions.path->isChecked();
  options.in_place = actions.in_place->isChecked();
  options.trail =
      actions.trail->isChecked() ? actions.trail_poses->checkedAction()->data().toInt() : 0;
  return options;
}

}  // namespace

QList<QAction*> ViewActions::inGroups() const {
  return {mode[0], mode[1], mode[2], swap,   blink,    nullptr, by_error,    skin,
          path,    trail,   nullptr, follow, in_place, floor,   reset_camera};
}

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
  actions.trail_poses = new QActionGroup(window);
  for (const int poses : {2, 4, 8}) {
    QAction* choice = actions.trail_poses->addAction(
        ViewTexts::tr("%Ln pose(s) before and after", nullptr, poses));
    choice->setCheckable(true);
    choice->setData(poses);
  }
  actions.trail_poses->actions().at(1)->setChecked(true);
  actions.follow = make_here("follow", ViewTexts::tr("&Follow"), Qt::Key_F,
                             ViewTexts::tr("The camera moves with the figure"));
  actions.in_place = make_here("in-place", ViewTexts::tr("I&n Place"), Qt::Key_G,
                               ViewTexts::tr("Play without the root's travel over the ground"));
  actions.floor = make_here("floor", ViewTexts::tr("F&loor View"), Qt::Key_V,
                            ViewTexts::tr("Look straight down, as on a plan"));
  actions.reset_camera = make_here("fit", ViewTexts::tr("&Reset Camera"), Qt::Key_R,
                                   ViewTexts::tr("Look at the whole figure again"));
  for (QAction* action : {actions.swap, actions.blink, actions.by_error, actions.skin, actions.path,
                          actions.trail, actions.follow, actions.in_place})
    action->setCheckable(true);
  return actions;
}

void connectViewActions(const ViewActions& actions, Viewport* viewport) {
  const auto choose = [=] { viewport->setOptions(chosen(actions, viewport->options())); };
  QObject::connect(actions.modes, &QActionGroup::triggered, viewport, choose);
  QObject::connect(actions.trail_poses, &QActionGroup::triggered, viewport, choose);
  for (const QAction* action : {actions.swap, actions.blink, actions.by_error, actions.skin,
                                actions.path, actions.trail, actions.in_place})
    QObject::connect(action, &QAction::toggled, viewport, choose);
  QObject::connect(actions.follow, &QAction::toggled, viewport, &Viewport::setFollow);
  QObject::connect(actions.floor, &QAction::triggered, viewport, &Viewport::lookDown);
  QObject::connect(actions.reset_camera, &QAction::triggered, viewport, &Viewport::resetCamera);
  actions.follow->setChecked(true);
  actions.skin->setChecked(true);
}

void addInGroups(QMenu* menu, const ViewActions& actions) {
  addAll(menu, actions);
  menu->addMenu(ViewTexts::tr("Poses of the Tra&il"))->addActions(actions.trail_poses->actions());
}

void addInGroups(QToolBar* bar, const ViewActions& actions) {
  addAll(bar, actions);
}

}  // namespace mocapress
