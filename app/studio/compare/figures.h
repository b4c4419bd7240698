// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <optional>

#include "app/studio/document/document.h"
#include "widgets/panels/result_panel.h"

namespace mocapress {

/// Figures of the shown clip: measured if the original is there, else as its file states them.
std::optional<ResultFigures> figuresOf(const Document& document);

/// A few words on the origin of figuresOf().
QString stateOf(const Document& document);

/// Footskate in one line: its amount and the number of contacts.
QString footskateSummary(const Document& document);

}  // namespace mocapress
