// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QString;
class QWidget;

namespace mocapress {

/// Saves the window from the screen, since QWidget::grab() misses the 3D view. False: it could not
/// be written.
bool writeScreenshot(const QWidget& window, const QString& path);

}  // namespace mocapress
