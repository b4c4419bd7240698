// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Qt3DRender/QTexture>
#include <memory>

#include "core/motion/skin.h"

namespace mocapress {

/// All pictures of a skin, scaled to equal squares and stacked. A picture that cannot be decoded is
/// grey.
QImage stackedPictures(const Skin& skin);

/// Makes a texture for them that starts as one grey point.
Qt3DRender::QTexture2D* makePictureTexture(Qt3DCore::QNode* parent);

/// Decodes the pictures on a renderer thread and shows them.
void showPictures(Qt3DRender::QTexture2D* texture, std::shared_ptr<const Skin> skin);

}  // namespace mocapress
