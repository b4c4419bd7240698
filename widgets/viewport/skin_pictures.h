// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Qt3DRender/QTexture>
#include <memory>

#include "core/motion/skin.h"

namespace mocapress {

/// All pictures of a skin, one below the other, each as high as the others, and not repeated. One
/// that cannot be decoded is grey.
QImage stackedPictures(const Skin& skin);

/// A texture for them, of one grey point at first.
Qt3DRender::QTexture2D* makePictureTexture(Qt3DCore::QNode* parent);

/// Decodes them on a thread of the renderer.
void showPictures(Qt3DRender::QTexture2D* texture, std::shared_ptr<const Skin> skin);

}  // namespace mocapress
