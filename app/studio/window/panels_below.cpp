// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/window/panels_below.h"

#include <QDockWidget>
#include <QGuiApplication>
#include <QMainWindow>
#include <QMouseEvent>
#include <QSettings>
#include <QTabBar>
#include <QTimer>
#include <algorithm>
#include <utility>

#include "app/studio/window/tabs_below.h"

namespace mocapress {
namespace {

constexpr double kViewShare = 0.46;  // share of the window's height
constexpr int kUsualHeight = 240;
constexpr int kLeastHeight = 120;  // with less a list or plot is of no use
const QString kHeight = QStringLiteral("window/below");
const QString kWindowHeight = QStringLiteral("window/belowAt");

}  // namespace

PanelsBelow::PanelsBelow(QMainWindow* window, const QWidget* view)
    : QObject(window),
      window_(window),
      view_(view),
      chosen_(kUsualHeight),
      unfolded_height_(kUsualHeight) {
  window->installEventFilter(this);
  for (QObject* child : window->children()) watch(child);
}

void PanelsBelow::watch(QObject* child) {
  if (qobject_cast<QTabBar*>(child)) child->installEventFilter(this);
  auto* dock = qobject_cast<QDockWidget*>(child);
  if (!dock) return;
  dock->installEventFilter(this);
  // A floating dock needs its title to be moved by.
  connect(dock, &QDockWidget::topLevelChanged, dock->titleBarWidget(), &QWidget::show);
}

QList<QDockWidget*> PanelsBelow::docks() const {
  QList<QDockWidget*> docks;
  for (auto* dock : window_->findChildren<QDockWidget*>(Qt::FindDirectChildrenOnly))
    if (window_->dockWidgetArea(dock) == Qt::BottomDockWidgetArea && !dock->isFloating())
      docks << dock;
  return docks;
}

/// The docks in front. Docks behind other tabs are outside the window.
QList<QDockWidget*> PanelsBelow::inFront() const {
  QList<QDockWidget*> seen;
  for (QDockWidget* dock : docks())
    if (dock->isVisible() && window_->rect().contains(dock->pos())) seen << dock;
  return seen;
}

int PanelsBelow::height() const {
  const QList<QDockWidget*> docks = inFront();
  return docks.isEmpty() ? 0 : docks.front()->height();
}

/// Shows or hides the docks' titles. Folded docks need none, since the tabs name them.
void PanelsBelow::showTitles(bool shown) {
  for (const QDockWidget* dock : docks()) dock->titleBarWidget()->setVisible(shown);
}

void PanelsBelow::resize(int height) {
  showTitles(height > kFolded);
  int tabs = 0;  // counts as part of the height of docks side by side
  for (const QTabBar* bar : tabBarsBelow(window_)) tabs = std::max(tabs, bar->height());
  const QList<QDockWidget*> docks = inFront();
  window_->resizeDocks(docks, QList<int>(docks.size(), height + tabs), Qt::Vertical);
}

void PanelsBelow::choose(int height) {
  if (height >= kLeastHeight) unfolded_height_ = height;
  chosen_ = height;
  chosen_at_ = window_->height();
}

void PanelsBelow::unfold() {
  if (unfolded()) return;
  choose(unfolded_height_);
  resize(chosen_);
}

void PanelsBelow::toggle() {
  if (!unfolded()) return unfold();
  choose(kFolded);
  resize(kFolded);
}

void PanelsBelow::restore() {
  const QSettings settings;
  chosen_ = settings.value(kHeight, kUsualHeight).toInt();
  chosen_at_ = settings.value(kWindowHeight, 0).toInt();
  if (chosen_ >= kLeastHeight) unfolded_height_ = chosen_;
}

void PanelsBelow::remember() const {
  QSettings settings;
  settings.setValue(kHeight, chosen_);
  settings.setValue(kWindowHeight, chosen_at_);
}

void PanelsBelow::reset() {
  chosen_ = unfolded_height_ = kUsualHeight;
  chosen_at_ = 0;
  fit();
}

void PanelsBelow::fit() {
  fitTabs(window_, inFront());
  if (inFront().isEmpty()) return;
  const int view = static_cast<int>(kViewShare * window_->height());
  const int room = view_->height() + height() - view;
  const bool is_chosen_here = window_->height() == chosen_at_;
  const int most = is_chosen_here ? chosen_ : std::min(chosen_, room);
  resize(is_chosen_here || most >= kLeastHeight ? most : kFolded);
}

void PanelsBelow::click(const QTabBar& bar, int tab, bool was_in_front) {
  if (tab < 0 || !tabBarsBelow(window_).contains(&bar)) return;
  if (!unfolded())
    unfold();
  else if (was_in_front)
    toggle();
}

bool PanelsBelow::eventFilter(QObject* watched, QEvent* event) {
  if (watched == window_) {
    // The docks are laid out after this event.
    if (event->type() == QEvent::Resize) QTimer::singleShot(0, this, &PanelsBelow::fit);
    if (event->type() == QEvent::ChildPolished) {
      QObject* child = static_cast<QChildEvent*>(event)->child();
      watch(child);
      // Bars of tabs are made when docks are first laid out.
      if (qobject_cast<QTabBar*>(child)) QTimer::singleShot(0, this, &PanelsBelow::fit);
    }
  } else if (event->type() == QEvent::Resize) {
    const auto* dock = qobject_cast<QDockWidget*>(watched);
    // A press on a tab may show a dock in another size, which nobody chose.
    const bool is_dragged = pressed_tab_ < 0 && QGuiApplication::mouseButtons() != Qt::NoButton;
    if (dock && is_dragged && inFront().contains(dock)) {
      choose(dock->height());
      showTitles(dock->height() > kFolded);
    }
  } else if (const auto* bar = qobject_cast<QTabBar*>(watched)) {
    const bool is_press = event->type() == QEvent::MouseButtonPress;
    if (!is_press && event->type() != QEvent::MouseButtonRelease) return false;
    const auto& mouse = static_cast<const QMouseEvent&>(*event);
    if (mouse.button() != Qt::LeftButton) return false;
    const int tab = bar->tabAt(mouse.pos());
    if (is_press) {
      pressed_tab_ = tab;
      pressed_in_front_ = tab == bar->currentIndex();
    } else if (tab == std::exchange(pressed_tab_, -1)) {
      click(*bar, tab, pressed_in_front_);
    }
  }
  return false;
}

}  // namespace mocapress
