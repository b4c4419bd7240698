// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/viewport/overlay.h"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <QGuiApplication>
#include <QPainter>
#include <QVector4D>
#include <Qt3DRender/QDepthTest>
#include <Qt3DRender/QPaintedTextureImage>
#include <Qt3DRender/QTexture>
#include <algorithm>
#include <functional>

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
  image_->setPicture(nothing);  // the renderer rejects textures without data
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

namespace {

struct Texts {
  Q_DECLARE_TR_FUNCTIONS(mocapress::Overlay)
};

// Logical pixels.
constexpr double kMargin = 12;
constexpr double kPadding = 8;
constexpr double kTitleHeight = 26;
constexpr double kTitleGap = 6;
constexpr double kDot = 10;
constexpr QSizeF kLegendSize(252, 46);
constexpr double kRampHeight = 10;
constexpr double kLineWidth = 2;
constexpr double kGripSize = 30;
constexpr double kNoteRing = 18;
constexpr double kNoteText = 260;  // greatest width of a note's text

QImage painted(const QSizeF& size, double pixel_ratio,
               const std::function<void(QPainter&)>& paint) {
  QImage image((size * pixel_ratio).toSize(), QImage::Format_ARGB32_Premultiplied);
  image.setDevicePixelRatio(pixel_ratio);
  image.fill(Qt::transparent);
  QPainter painter(&image);
  painter.setRenderHint(QPainter::Antialiasing);
  paint(painter);
  painter.end();
  image.setDevicePixelRatio(1);
  return image;
}

void paintPlate(QPainter& painter, const QSizeF& size, const SceneColours& colours) {
  QColor plate = colours.plate;
  plate.setAlphaF(0.82F);
  painter.setPen(Qt::NoPen);
  painter.setBrush(plate);
  painter.drawRoundedRect(QRectF({}, size), 5, 5);
}

double widthOf(const Pane& pane, const QSize& view) {
  return static_cast<double>(pane.to - pane.from) / 2 * view.width();
}

double leftOf(const Pane& pane, const QSize& view) {
  return (1 + static_cast<double>(pane.from)) / 2 * view.width();
}

}  // namespace

Overlay::Overlay(QNode* parent)
    : QEntity(parent),
      legend_(new SceneLabel(this)),
      grip_(new SceneLabel(this)),
      exaggeration_(new SceneLabel(this)) {
  for (SceneLabel*& name : quarters_) name = new SceneLabel(this);
  for (SceneLabel*& title : titles_) title = new SceneLabel(this);
  for (SceneLabel*& line : lines_) line = new SceneLabel(this);
  for (SceneLabel*& note : notes_) note = new SceneLabel(this);
}

std::vector<std::vector<Qt3DCore::QEntity*>> Overlay::labels() const {
  std::vector<Qt3DCore::QEntity*> words(titles_.begin(), titles_.end());
  words.insert(words.end(), quarters_.begin(), quarters_.end());
  words.insert(words.end(), {legend_, exaggeration_});
  return {{lines_.begin(), lines_.end()}, {grip_}, {notes_.begin(), notes_.end()}, words};
}

void Overlay::show(const OverlayContent& content) {
  if (content.view.isEmpty()) return;
  showTitles(content);
  showLegend(content);
  showDivider(content);
  showQuarters(content);
  if (content.exaggeration == 1) return exaggeration_->hide();
  showNote(exaggeration_, Texts::tr("Difference × %L1").arg(content.exaggeration),
           content.arrangement.quartered
               ? QPointF(content.view.width() / 2.0 - kMargin, kMargin)  // in the first view
               : QPointF(content.view.width() - kMargin, kMargin),
           true, content);
}

/// Shows a line of text on a plate. A warning is bold and coloured, and `corner` is then the
/// plate's top right corner, away from the titles; otherwise it is the top left one.
void Overlay::showNote(SceneLabel* label, const QString& text, const QPointF& corner, bool warns,
                       const OverlayContent& content) {
  QFont font = QGuiApplication::font();
  font.setBold(warns);
  const QSizeF size(2 * kPadding + QFontMetricsF(font).horizontalAdvance(text), kTitleHeight);
  const QImage picture = painted(size, content.pixel_ratio, [&](QPainter& painter) {
    paintPlate(painter, size, colours_);
    painter.setFont(font);
    painter.setPen(warns ? colours_.compressed : colours_.text);
    painter.drawText(QRectF({}, size), Qt::AlignCenter, text);
  });
  label->show(picture, {corner - QPointF(warns ? size.width() : 0, 0), size}, content.view);
}

void Overlay::showQuarters(const OverlayContent& content) {
  if (!content.arrangement.quartered) {
    for (SceneLabel* name : quarters_) name->hide();
    return;
  }
  const QString names[] = {Texts::tr("Front"), Texts::tr("Side"), Texts::tr("Top")};
  for (std::size_t i = 0; i < quarters_.size(); ++i) {
    const std::size_t quarter = i + 1;
    showNote(quarters_[i], names[i],
             {kMargin + (quarter % 2 == 1 ? content.view.width() / 2.0 : 0),
              kMargin + (quarter >= 2 ? content.view.height() / 2.0 : 0)},
             false, content);
  }
}

void Overlay::showTitles(const OverlayContent& content) {
  const QFont font = QGuiApplication::font();
  const QFontMetricsF metrics(font);
  const auto title = [&](SceneLabel* label, bool exists, const Placement& placement,
                         const QStringList& parts, const QColor& colour, double top) {
    if (!exists || !placement.shown) return label->hide();
    const double room = widthOf(placement.pane, content.view) - 2 * kMargin - 3 * kPadding - kDot;
    const QString whole = parts.join(QStringLiteral(", "));
    const bool fits = metrics.horizontalAdvance(whole) <= room;
    QStringList lines;
    double width = 0;
    for (const QString& each : fits ? QStringList(whole) : parts) {
      lines << metrics.elidedText(each, Qt::ElideRight, room);
      width = std::max(width, metrics.horizontalAdvance(lines.last()));
    }
    const QSizeF size(3 * kPadding + kDot + width,
                      kTitleHeight + metrics.lineSpacing() * double(lines.size() - 1));
    const QImage picture = painted(size, content.pixel_ratio, [&](QPainter& painter) {
      paintPlate(painter, size, colours_);
      painter.setPen(QPen(colour, 1.5));
      painter.setBrush(placement.ghost ? QBrush(Qt::NoBrush) : QBrush(colour));
      painter.drawEllipse(QRectF(kPadding, (kTitleHeight - kDot) / 2, kDot, kDot));
      painter.setPen(colours_.text);
      painter.setFont(font);
      painter.drawText(QRectF(2 * kPadding + kDot, 0, size.width(), size.height()),
                       Qt::AlignVCenter | Qt::AlignLeft, lines.join(QLatin1Char('\n')));
    });
    const double left = leftOf(placement.pane, content.view) + kMargin;
    label->show(picture, {QPointF(left, top), size}, content.view);
  };
  const Arrangement& arrangement = content.arrangement;
  const bool stacked = content.has_original && content.has_compressed &&
                       arrangement.original.shown && arrangement.compressed.shown &&
                       !arrangement.has_divider;
  title(titles_[0], content.has_original, arrangement.original, {Texts::tr("Original")},
        colours_.original, kMargin);
  title(titles_[1], content.has_compressed, arrangement.compressed, {Texts::tr("Compressed")},
        colours_.compressed, kMargin + (stacked ? kTitleHeight + kTitleGap : 0));
  double top = kMargin;
  if (arrangement.panes == 1)
    for (const bool above : {content.has_original, content.has_compressed})
      top += above ? kTitleHeight + kTitleGap : 0;
  for (std::size_t i = 0; i < kMostPinned; ++i) {
    const bool exists = i < content.pinned.size() && i < arrangement.pinned.size();
    title(titles_[2 + i], exists, exists ? arrangement.pinned[i] : Placement(),
          exists ? content.pinned[i].title : QStringList(),
          exists ? content.pinned[i].colour : QColor(), top);
    if (arrangement.panes == 1) top += kTitleHeight + kTitleGap;
  }
}

void Overlay::showLegend(const OverlayContent& content) {
  if (!content.scale) return legend_->hide();
  const ErrorScale scale = *content.scale;
  const QFont font = QGuiApplication::font();
  const QImage picture = painted(kLegendSize, content.pixel_ratio, [&](QPainter& painter) {
    paintPlate(painter, kLegendSize, colours_);
    const QRectF ramp(2 * kPadding, kPadding, kLegendSize.width() - 5 * kPadding, kRampHeight);
    for (double x = ramp.left(); x < ramp.right(); ++x)
      painter.fillRect(QRectF(x, ramp.top(), 1, ramp.height()),
                       viridis((x - ramp.left()) / ramp.width()));
    painter.setPen(colours_.text);
    painter.setFont(font);
    constexpr int kTicks = 2;
    for (int tick = 0; tick <= kTicks; ++tick) {
      const double share = static_cast<double>(tick) / kTicks;
      const double x = ramp.left() + share * ramp.width();
      painter.drawLine(QPointF(x, ramp.bottom()), QPointF(x, ramp.bottom() + 4));
      const QString length = roundErrorText(share * scale.top, scale.quantity);
      const QString text = tick == 0       ? QStringLiteral("0")
                           : tick < kTicks ? length
                                           : QStringLiteral("≥ %1").arg(length);
      const QRectF around(x - 40, ramp.bottom() + 5, 80, 20);
      const double width = QFontMetricsF(font).horizontalAdvance(text);
      const double over = std::max(0.0, x + width / 2 - (kLegendSize.width() - 4));
      painter.drawText(around.translated(-over, 0), Qt::AlignHCenter | Qt::AlignTop, text);
    }
  });
  const QPointF corner(content.view.width() - kMargin - kLegendSize.width(),
                       content.view.height() - kMargin - kLegendSize.height());
  legend_->show(picture, {corner, kLegendSize}, content.view);
}

void Overlay::showNotes(const std::vector<OverlayNote>& notes, const QSize& view,
                        double pixel_ratio) {
  const QFont font = QGuiApplication::font();
  const QFontMetricsF metrics(font);
  for (std::size_t i = 0; i < notes_.size(); ++i) {
    if (i >= notes.size() || view.isEmpty()) {
      notes_[i]->hide();
      continue;
    }
    const QString text = metrics.elidedText(notes[i].text.simplified(), Qt::ElideRight, kNoteText);
    const QSizeF plate(metrics.horizontalAdvance(text) + 2 * kPadding, kTitleHeight);
    const QSizeF size(kNoteRing + kTitleGap + plate.width(), kTitleHeight);
    const QImage picture = painted(size, pixel_ratio, [&](QPainter& painter) {
      painter.setBrush(Qt::NoBrush);
      const double ring = kNoteRing - 2 * kLineWidth;
      const QRectF place(kLineWidth, (kTitleHeight - ring) / 2, ring, ring);
      // The ring has a rim, so that it is visible on dark and on bright grounds.
      painter.setPen(QPen(colours_.plate, 2 * kLineWidth));
      painter.drawEllipse(place);
      painter.setPen(QPen(QColor(kFrameNoteColour), kLineWidth));
      painter.drawEllipse(place);
      painter.translate(kNoteRing + kTitleGap, 0);
      paintPlate(painter, plate, colours_);
      painter.setPen(colours_.text);
      painter.setFont(font);
      painter.drawText(QRectF({kPadding, 0}, plate), Qt::AlignVCenter | Qt::AlignLeft, text);
    });
    const QPointF corner = notes[i].at - QPointF(kNoteRing / 2, kTitleHeight / 2);
    notes_[i]->show(picture, {corner, size}, view);
  }
}

void Overlay::showDivider(const OverlayContent& content) {
  const Arrangement& arrangement = content.arrangement;
  for (SceneLabel* line : lines_) line->hide();
  grip_->hide();
  const QImage line =
      painted({1, 1}, 1, [&](QPainter& painter) { painter.fillRect(0, 0, 1, 1, colours_.text); });
  if (arrangement.quartered) {
    const double width = content.view.width();
    const double height = content.view.height();
    lines_[0]->show(line, {(width - kLineWidth) / 2, 0, kLineWidth, height}, content.view);
    lines_[1]->show(line, {0, (height - kLineWidth) / 2, width, kLineWidth}, content.view);
  }
  if (!arrangement.has_divider) return;
  const auto show_line = [&](std::size_t index, double x) {
    lines_[index]->show(line, {x - kLineWidth / 2, 0, kLineWidth, double(content.view.height())},
                        content.view);
  };
  const double x = (1 + static_cast<double>(arrangement.dividerAt())) / 2 * content.view.width();
  show_line(0, x);
  for (int i = 1; i + 1 < arrangement.panes; ++i)
    show_line(static_cast<std::size_t>(i), leftOf(paneOf(i + 1, arrangement.panes), content.view));
  if (arrangement.panes > 1) return;  // only a wipe's divider can be dragged
  const QSizeF size(kGripSize, kGripSize);
  const QImage grip = painted(size, content.pixel_ratio, [&](QPainter& painter) {
    painter.setPen(QPen(colours_.text, kLineWidth));
    painter.setBrush(colours_.plate);
    painter.drawEllipse(QRectF({}, size).adjusted(2, 2, -2, -2));
    const double middle = kGripSize / 2;
    for (const double side : {-1.0, 1.0}) {
      const double tip = middle + 9 * side;
      painter.drawPolyline(
          QPolygonF({{tip - 4 * side, middle - 4}, {tip, middle}, {tip - 4 * side, middle + 4}}));
    }
  });
  const QPointF corner(x - kGripSize / 2, (content.view.height() - kGripSize) / 2);
  grip_->show(grip, {corner, size}, content.view);
}

}  // namespace mocapress
