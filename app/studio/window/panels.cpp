// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/window/panels.h"

#include <QAction>
#include <QCoreApplication>
#include <QDockWidget>
#include <QGuiApplication>
#include <QLabel>
#include <QMainWindow>
#include <QScrollArea>
#include <QScrollBar>
#include <QSettings>
#include <QStatusBar>
#include <QTimer>
#include <QVBoxLayout>
#include <algorithm>
#include <tuple>

#include "app/studio/window/panels_below.h"
#include "widgets/models/library_tree.h"
#include "widgets/panels/annealing_panel.h"
#include "widgets/panels/bytes_panel.h"
#include "widgets/panels/compression_panel.h"
#include "widgets/panels/figures_bar.h"
#include "widgets/panels/footskate_panel.h"
#include "widgets/panels/importance_panel.h"
#include "widgets/panels/joints_panel.h"
#include "widgets/panels/library_panel.h"
#include "widgets/panels/message_bar.h"
#include "widgets/panels/pinned_panel.h"
#include "widgets/panels/result_panel.h"
#include "widgets/panels/slot_control.h"
#include "widgets/plots/channel_graph.h"
#include "widgets/plots/error_graph.h"
#include "widgets/plots/heat_map.h"
#include "widgets/plots/library_plot.h"
#include "widgets/plots/rate_plot.h"
#include "widgets/timeline/timeline.h"
#include "widgets/timeline/transport_bar.h"
#include "widgets/viewport/viewport.h"

namespace mocapress {

namespace {

constexpr int kLayoutVersion = 8;
const QString kGeometry = QStringLiteral("window/geometry");
const QString kState = QStringLiteral("window/state");

/// A plain title for a dock: drag it to move the dock, double-click to float it. Its size is 0
/// while it is hidden, since docks leave room even for hidden titles.
class DockTitle : public QLabel {
 public:
  DockTitle(const QString& title, QWidget* parent) : QLabel(title, parent) {
    QFont bold = font();
    bold.setWeight(QFont::DemiBold);
    setFont(bold);
    setContentsMargins(10, 7, 10, 5);
  }

  QSize sizeHint() const override { return isHidden() ? QSize(0, 0) : QLabel::sizeHint(); }
  QSize minimumSizeHint() const override {
    return isHidden() ? QSize(0, 0) : QLabel::minimumSizeHint();
  }
};

}  // namespace

KeptWidth::KeptWidth(QDockWidget* dock, QMainWindow* window)
    : QObject(dock), dock_(dock), window_(window) {
  dock->installEventFilter(this);
  window->installEventFilter(this);
}

bool KeptWidth::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() != QEvent::Resize) return false;
  // Qt lays out the docks of a resized window before it sends this event.
  if (watched == dock_ && window_->width() == window_width_) {
    const bool is_dragged = QGuiApplication::mouseButtons() != Qt::NoButton;
    width_ = is_dragged ? dock_->width() : std::max(width_, dock_->width());
  }
  if (watched == window_)
    QTimer::singleShot(0, this, [this] {
      if (dock_->width() < width_) window_->resizeDocks({dock_}, {width_}, Qt::Horizontal);
      width_ = std::max(width_, dock_->width());
      window_width_ = window_->width();
    });
  return false;
}

QDockWidget* WindowLayout::addLeft(QWidget* panel, const QString& id, const QString& title) {
  return add(Qt::LeftDockWidgetArea, panel, id, title);
}

QDockWidget* WindowLayout::addRight(QWidget* panel, const QString& id, const QString& title) {
  return add(Qt::RightDockWidgetArea, panel, id, title);
}

QDockWidget* WindowLayout::addBelow(QWidget* panel, const QString& id, const QString& title) {
  panel->setMinimumHeight(PanelsBelow::kFolded);  // else the panel's contents decide
  return add(Qt::BottomDockWidgetArea, panel, id, title);
}

QDockWidget* WindowLayout::add(Qt::DockWidgetArea area, QWidget* panel, const QString& id,
                               const QString& title) {
  auto* dock = new QDockWidget(title, window_);
  dock->setObjectName(id);
  dock->toggleViewAction()->setObjectName(QStringLiteral("show-") + id);
  dock->setTitleBarWidget(new DockTitle(title, dock));
  dock->setWidget(panel);
  window_->addDockWidget(area, dock);
  docks_ << dock;
  return dock;
}

void WindowLayout::bringUp(const QWidget* panel) const {
  for (QDockWidget* dock : docks_)
    if (dock->widget() == panel) {
      dock->show();
      dock->raise();
      if (window_->dockWidgetArea(dock) == Qt::BottomDockWidgetArea) below_->unfold();
    }
}

void WindowLayout::restore(const QWidget* view) {
  below_ = new PanelsBelow(window_, view);
  below_->restore();
  for (const QDockWidget* dock : docks_)
    QObject::connect(dock->toggleViewAction(), &QAction::triggered, window_,
                     [this, dock](bool shown) {
                       if (shown) bringUp(dock->widget());
                     });
  built_ = window_->saveState(kLayoutVersion);
  const QSettings settings;
  window_->restoreGeometry(settings.value(kGeometry).toByteArray());
  window_->restoreState(settings.value(kState).toByteArray(), kLayoutVersion);
}

void WindowLayout::remember() const {
  QSettings settings;
  settings.setValue(kGeometry, window_->saveGeometry());
  settings.setValue(kState, window_->saveState(kLayoutVersion));
  below_->remember();
}

void WindowLayout::reset() {
  window_->restoreState(built_, kLayoutVersion);
  below_->reset();
}

namespace {

constexpr int kSidebarWidth = 320;
constexpr int kLibraryWidth = 240;
constexpr int kJointsWidth = 440;

struct DockTitles {
  Q_DECLARE_TR_FUNCTIONS(mocapress::Panels)
};

QFrame* makeRule(QWidget* parent) {
  auto* rule = new QFrame(parent);
  rule->setFrameShape(QFrame::HLine);
  rule->setFrameShadow(QFrame::Sunken);
  return rule;
}

QWidget* makeCentre(Panels& panels, Playback* playback, const TransportActions& transport,
                    QWidget* window) {
  auto* centre = new QWidget(window);
  panels.messages = new MessageBar(centre);
  panels.views.viewport = new Viewport(centre);
  panels.inspection.timeline = new Timeline(centre);
  auto* column = new QVBoxLayout(centre);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(panels.messages);
  column->addWidget(panels.views.viewport, 1);
  column->addWidget(panels.inspection.timeline);
  panels.views.transport = new TransportBar(playback, transport, centre);
  column->addWidget(panels.views.transport);
  return centre;
}

QWidget* makeSidebar(Panels& panels, QWidget* window) {
  auto* sidebar = new QWidget(window);
  panels.slot_control = new SlotControl(sidebar);
  panels.views.compression = new CompressionPanel(sidebar);
  panels.views.result = new ResultPanel(sidebar);
  panels.views.annealing = new AnnealingPanel(sidebar);
  auto* column = new QVBoxLayout(sidebar);
  column->setContentsMargins(10, 2, 10, 10);
  column->setSpacing(12);
  column->addWidget(panels.slot_control);
  column->addWidget(panels.views.compression);
  column->addWidget(makeRule(sidebar));
  column->addWidget(panels.views.result);
  column->addWidget(makeRule(sidebar));
  column->addWidget(panels.views.annealing, 1);
  auto* scroll = new QScrollArea(window);  // scrolls if the screen is low
  scroll->setWidget(sidebar);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setMinimumWidth(sidebar->minimumSizeHint().width() +
                          scroll->verticalScrollBar()->sizeHint().width());
  return scroll;
}

/// Adds the settings, with the importances as a tab beside them.
QDockWidget* addRight(Panels& panels, WindowLayout* layout, QMainWindow* window) {
  QDockWidget* sidebar = layout->addRight(
      makeSidebar(panels, window), QStringLiteral("compression"), DockTitles::tr("Compression"));
  panels.views.importance = new ImportancePanel(window);
  QDockWidget* importance = layout->addRight(panels.views.importance, QStringLiteral("importance"),
                                             DockTitles::tr("Importance"));
  window->tabifyDockWidget(sidebar, importance);
  sidebar->raise();
  QObject::connect(panels.views.compression, &CompressionPanel::importanceRequested, importance,
                   [importance] {
                     importance->show();
                     importance->raise();
                   });
  return sidebar;
}

/// Adds panels below as tabs of one place. Returns the dock of the first tab, which is in front.
QDockWidget* addTabs(const std::vector<std::tuple<QWidget*, const char*, QString>>& panels,
                     WindowLayout* layout, QMainWindow* window) {
  QDockWidget* first = nullptr;
  QDockWidget* before = nullptr;
  for (const auto& [panel, id, title] : panels) {
    QDockWidget* dock = layout->addBelow(panel, QString::fromLatin1(id), title);
    if (before) window->tabifyDockWidget(before, dock);
    before = dock;
    if (!first) first = dock;
  }
  first->raise();
  return first;
}

}  // namespace

Panels makePanels(QMainWindow* window, WindowLayout* layout, const PanelModels& models,
                  Playback* playback, const TransportActions& transport) {
  Panels panels;
  window->setCentralWidget(makeCentre(panels, playback, transport, window));
  window->setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
  window->setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
  panels.library = new LibraryPanel(models.library, window);
  QDockWidget* library =
      layout->addLeft(panels.library, QStringLiteral("library"), DockTitles::tr("Library"));
  new KeptWidth(library, window);
  QDockWidget* sidebar = addRight(panels, layout, window);
  Views& views = panels.views;
  views.joints = new JointsPanel(models.clip.joints, window);
  views.footskate = new FootskatePanel(models.clip.slides, window);
  panels.pinned = new PinnedPanel(models.pinned, window);
  panels.bytes = new BytesPanel(models.bytes, window);
  panels.library_plot = new LibraryPlot(panels.library->tree()->filter(), window);
  QDockWidget* joints =
      addTabs({{views.joints, "joints", DockTitles::tr("Joints")},
               {views.footskate, "footskate", DockTitles::tr("Footskate")},
               {panels.bytes, "bytes", DockTitles::tr("Bytes")},
               {panels.pinned, "pinned", DockTitles::tr("Pinned")},
               {panels.library_plot, "library-plot", DockTitles::tr("All clips")}},
              layout, window);
  InspectionViews& inspection = panels.inspection;
  views.graph = new ErrorGraph(window);
  inspection.heat_map = new HeatMap(window);
  inspection.channel = new ChannelGraph(window);
  inspection.curve = new RatePlot(window);
  QDockWidget* graph =
      addTabs({{views.graph, "error-over-time", DockTitles::tr("Error over time")},
               {inspection.heat_map, "heat-map", DockTitles::tr("Heat map")},
               {inspection.channel, "channel", DockTitles::tr("Channel")},
               {inspection.curve, "rate-distortion", DockTitles::tr("Rate-distortion")}},
              layout, window);
  inspection.figures = new FiguresBar(window);
  window->statusBar()->addWidget(inspection.figures, 1);
  window->statusBar()->setSizeGripEnabled(false);
  window->resizeDocks({library, sidebar}, {kLibraryWidth, kSidebarWidth}, Qt::Horizontal);
  const int rest = window->width() - kLibraryWidth - kSidebarWidth - kJointsWidth;
  window->resizeDocks({joints, graph}, {kJointsWidth, rest}, Qt::Horizontal);
  return panels;
}

}  // namespace mocapress
