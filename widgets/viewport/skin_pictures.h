// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Qt3DRender/QTexture>
#include <memory>

#include "core/motion/skin.h"

namespace mocapress {

/// Stacks all pictures of a skin, scaled to equal squares. A picture that cannot be decoded is
/// grey.
QImage stackedPictures(const Skin& skin);

/// Makes a texture for stacked pictures. It starts as one grey pixel.
Qt3DRender::QTexture2D* makePictureTexture(Qt3DCore::QNode* parent);

/// Decodes a skin's pictures on a renderer thread and then shows them in the texture.
void showPictures(Qt3DRender::QTexture2D* texture, std::shared_ptr<const Skin> skin);

}  // namespace mocapress
