// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QString>
#include <Qt3DRender/QMaterial>
#include <Qt3DRender/QParameter>
#include <Qt3DRender/QRenderState>
#include <vector>

namespace mocapress {

/// A step of drawing a material; the frame graph picks steps by name and so orders them.
struct ShaderPass {
  QString name;
  std::vector<Qt3DRender::QRenderState*> states;  // the material takes them over
};

/// What is solid is shaded at once.
std::vector<ShaderPass> solidPasses();

/// A ghost's depth goes first, so that its nearest surface alone is blended and what overlaps in it
/// looks like one body.
std::vector<ShaderPass> ghostPasses();

inline constexpr float kGhostOpacity = 0.26f;

/// A material for OpenGL 3 of `:/shaders/<vertex>.vert` and `<fragment>.frag`.
class ShaderMaterial : public Qt3DRender::QMaterial {
 public:
  /// `defined`: what #ifdef asks there; empty: nothing.
  ShaderMaterial(const QString& vertex, const QString& fragment,
                 const std::vector<ShaderPass>& passes, QNode* parent,
                 const QByteArray& defined = {});
  ShaderMaterial(const QString& both, const std::vector<ShaderPass>& passes, QNode* parent)
      : ShaderMaterial(both, both, passes, parent) {}

  /// Sets a uniform, a colour as its vec3.
  void set(const QString& uniform, const QVariant& value);
  void setColour(const QString& uniform, const QColor& colour);
};

/// Blending over what is there, which leaves an opaque target opaque (captures keep their colours),
/// and leaves the depth buffer alone.
std::vector<Qt3DRender::QRenderState*> translucent();

/// Pass and filter keys share this name.
inline const QString kPassKey = QStringLiteral("pass");

}  // namespace mocapress
