// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QString;
class QWidget;

namespace mocapress {

/// The window with its 3D view, from the screen: QWidget::grab() does not see the latter. False
/// where it could not be written.
bool writeScreenshot(const QWidget& window, const QString& path);

}  // namespace mocapress
