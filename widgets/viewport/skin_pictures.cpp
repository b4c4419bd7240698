// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/viewport/skin_pictures.h"

#include <QBuffer>
#include <QImageReader>
#include <QPainter>
#include <Qt3DRender/QAbstractTextureImage>
#include <Qt3DRender/QTextureImageData>
#include <Qt3DRender/QTextureImageDataGenerator>
#include <algorithm>

namespace mocapress {
namespace {

constexpr int kSide = 1024;         // width and height of a picture in pixels
constexpr int kMostStacked = 8192;  // pixels: every graphics driver accepts this height
constexpr int kMostDecodedMiB = 256;

QImage decoded(const SkinPicture& picture, int side) {
  QByteArray bytes =
      QByteArray::fromRawData(picture.bytes.data(), static_cast<qsizetype>(picture.bytes.size()));
  QBuffer buffer(&bytes);
  QImageReader reader(&buffer);
  reader.setDecideFormatFromContent(true);
  if (reader.format() != "png" && reader.format() != "jpeg") return {};
  const QSize size = reader.size();
  if (!size.isValid() || qint64{size.width()} * size.height() > qint64{kMostDecodedMiB} << 18)
    return {};
  reader.setScaledSize({side, side});
  return reader.read();
}

/// Makes the image data for a texture.
class PicturesGenerator : public Qt3DRender::QTextureImageDataGenerator {
 public:
  explicit PicturesGenerator(std::shared_ptr<const Skin> skin) : skin_(std::move(skin)) {}

  Qt3DRender::QTextureImageDataPtr operator()() override {
    auto data = Qt3DRender::QTextureImageDataPtr::create();
    data->setImage(skin_ ? stackedPictures(*skin_) : stackedPictures({}));
    return data;
  }
  bool operator==(const Qt3DRender::QTextureImageDataGenerator& other) const override {
    const auto* same = dynamic_cast<const PicturesGenerator*>(&other);
    return same && same->skin_ == skin_;
  }
  QT3D_FUNCTOR(PicturesGenerator)

 private:
  std::shared_ptr<const Skin> skin_;
};

class Pictures : public Qt3DRender::QAbstractTextureImage {
 public:
  Pictures(std::shared_ptr<const Skin> skin, Qt3DCore::QNode* parent)
      : QAbstractTextureImage(parent), skin_(std::move(skin)) {}

 protected:
  Qt3DRender::QTextureImageDataGeneratorPtr dataGenerator() const override {
    return Qt3DRender::QTextureImageDataGeneratorPtr(new PicturesGenerator(skin_));
  }

 private:
  std::shared_ptr<const Skin> skin_;
};

}  // namespace

QImage stackedPictures(const Skin& skin) {
  const QColor grey = QColor::fromRgbF(kPlainSkin.x(), kPlainSkin.y(), kPlainSkin.z());
  const auto count = static_cast<int>(skin.pictures.size());
  const int side = count == 0 ? 1 : std::clamp(kMostStacked / count, 1, kSide);
  QImage stack(side, side * std::max(count, 1), QImage::Format_RGBA8888);
  stack.fill(grey);
  QPainter painter(&stack);
  for (int i = 0; i < count; ++i)
    painter.drawImage(0, i * side, decoded(*skin.pictures[static_cast<std::size_t>(i)], side));
  return stack;
}

Qt3DRender::QTexture2D* makePictureTexture(Qt3DCore::QNode* parent) {
  auto* texture = new Qt3DRender::QTexture2D(parent);
  texture->setMinificationFilter(Qt3DRender::QAbstractTexture::Linear);
  texture->setMagnificationFilter(Qt3DRender::QAbstractTexture::Linear);
  texture->setWrapMode(Qt3DRender::QTextureWrapMode(Qt3DRender::QTextureWrapMode::ClampToEdge));
  texture->setGenerateMipMaps(false);
  texture->setFormat(Qt3DRender::QAbstractTexture::RGBA8_UNorm);
  showPictures(texture, nullptr);
  return texture;
}

void showPictures(Qt3DRender::QTexture2D* texture, std::shared_ptr<const Skin> skin) {
  for (Qt3DRender::QAbstractTextureImage* before : texture->textureImages()) {
    texture->removeTextureImage(before);
    before->deleteLater();
  }
  texture->addTextureImage(new Pictures(std::move(skin), texture));
}

}  // namespace mocapress
