// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <optional>

#include "app/studio/document/document.h"
#include "widgets/panels/result_panel.h"

namespace mocapress {

/// The figures of what is shown; measured where the original is there, else as the file records
/// them.
std::optional<ResultFigures> figuresOf(const Document& document);

/// How those figures came about.
QString stateOf(const Document& document);

/// Footskate in a line: how much, and of how many contacts.
QString footskateSummary(const Document& document);

}  // namespace mocapress
