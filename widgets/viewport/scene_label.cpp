// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/viewport/scene_label.h"

#include <QPainter>
#include <QVector4D>
#include <Qt3DRender/QDepthTest>
#include <Qt3DRender/QPaintedTextureImage>
#include <Qt3DRender/QTexture>

#include "widgets/viewport/mesh.h"

namespace mocapress {

class PaintedImage : public Qt3DRender::QPaintedTextureImage {
 public:
  void setPicture(const QImage& picture) {
    if (picture == picture_) return;
    picture_ = picture;
    setSize(picture.size());
    update();
  }

 protected:
  void paint(QPainter* painter) override {
    painter->setCompositionMode(QPainter::CompositionMode_Source);
    painter->drawImage(QRect({}, picture_.size()), picture_);
  }

 private:
  QImage picture_;
};

SceneLabel::SceneLabel(QNode* parent) : QEntity(parent), image_(new PaintedImage) {
  std::vector<Qt3DRender::QRenderState*> states = translucent();
  auto* over_all = new Qt3DRender::QDepthTest;
  over_all->setDepthFunction(Qt3DRender::QDepthTest::Always);
  states.push_back(over_all);
  material_ = new ShaderMaterial("label", {{"shade", states}}, this);
  QImage nothing(1, 1, QImage::Format_ARGB32_Premultiplied);
  nothing.fill(Qt::transparent);
  image_->setPicture(nothing);  // the renderer does not take textures without data
  auto* texture = new Qt3DRender::QTexture2D(this);
  texture->addTextureImage(image_);
  texture->setMinificationFilter(Qt3DRender::QAbstractTexture::Linear);
  texture->setMagnificationFilter(Qt3DRender::QAbstractTexture::Linear);
  texture->setGenerateMipMaps(false);
  texture->setWrapMode(Qt3DRender::QTextureWrapMode(Qt3DRender::QTextureWrapMode::ClampToEdge));
  material_->set("picture",
                 QVariant::fromValue(static_cast<Qt3DRender::QAbstractTexture*>(texture)));
  addComponent(makeRenderer(groundMesh(), this));
  addComponent(material_);
  hide();
}

void SceneLabel::show(const QImage& picture, const QRectF& place, const QSizeF& view) {
  image_->setPicture(picture);
  const auto x = [&](double pixel) { return static_cast<float>(2 * pixel / view.width() - 1); };
  const auto y = [&](double pixel) { return static_cast<float>(1 - 2 * pixel / view.height()); };
  material_->set("place",
                 QVector4D(x(place.left()), y(place.bottom()), x(place.right()), y(place.top())));
  setEnabled(true);
}

void SceneLabel::hide() {
  setEnabled(false);
}

}  // namespace mocapress
