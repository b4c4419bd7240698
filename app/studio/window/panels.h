// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/studio/compare/inspector.h"
#include "app/studio/compare/presenter.h"

class QMainWindow;

namespace mocapress {

class LibraryModel;
class LibraryPanel;
class MessageBar;
class PinnedModel;
class PinnedPanel;
class SlotControl;
class WindowLayout;
struct TransportActions;

/// All that the main window shows: 3D view, timeline and transport in the middle, the library to
/// the left, settings and figures to the right, joints and their errors below.
struct Panels {
  Views views;
  InspectionViews inspection;
  LibraryPanel* library = nullptr;
  SlotControl* slot_control = nullptr;
  PinnedPanel* pinned = nullptr;
  MessageBar* messages = nullptr;
};

/// What lists and tables of them show.
struct PanelModels {
  Models clip;
  LibraryModel* library = nullptr;
  PinnedModel* pinned = nullptr;
};

/// Makes and places them.
Panels makePanels(QMainWindow* window, WindowLayout* layout, const PanelModels& models,
                  Playback* playback, const TransportActions& transport);

}  // namespace mocapress
