// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QString>
#include <Qt3DRender/QMaterial>
#include <Qt3DRender/QParameter>
#include <Qt3DRender/QRenderState>
#include <vector>

namespace mocapress {

/// A step of drawing a material; the frame graph orders steps by name.
struct ShaderPass {
  QString name;
  std::vector<Qt3DRender::QRenderState*> states;  // owned by the material
};

/// The single pass of solid things.
std::vector<ShaderPass> solidPasses();

/// Writes a ghost's depth first, so that only its nearest surface is blended and overlapping parts
/// look like one body.
std::vector<ShaderPass> ghostPasses();

inline constexpr float kGhostOpacity = 0.26f;

/// A material for OpenGL 3 of `:/shaders/<vertex>.vert` and `<fragment>.frag`.
class ShaderMaterial : public Qt3DRender::QMaterial {
 public:
  /// `defined` is the macro for #ifdef in the shaders; empty: none.
  ShaderMaterial(const QString& vertex, const QString& fragment,
                 const std::vector<ShaderPass>& passes, QNode* parent,
                 const QByteArray& defined = {});
  ShaderMaterial(const QString& both, const std::vector<ShaderPass>& passes, QNode* parent)
      : ShaderMaterial(both, both, passes, parent) {}

  /// Sets a uniform; a colour becomes a vec3.
  void set(const QString& uniform, const QVariant& value);
  void setColour(const QString& uniform, const QColor& colour);
};

/// Blends over the target, keeps an opaque target opaque (for captures), and leaves the depth
/// buffer alone.
std::vector<Qt3DRender::QRenderState*> translucent();

/// The key that passes and filters share.
inline const QString kPassKey = QStringLiteral("pass");

}  // namespace mocapress
