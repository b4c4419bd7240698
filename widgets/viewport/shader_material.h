// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QString>
#include <Qt3DRender/QMaterial>
#include <Qt3DRender/QParameter>
#include <Qt3DRender/QRenderState>
#include <vector>

namespace mocapress {

/// One pass of drawing a material. The frame graph orders passes by name.
struct ShaderPass {
  QString name;
  std::vector<Qt3DRender::QRenderState*> states;  // owned by the material
};

/// The single pass of solid objects.
std::vector<ShaderPass> solidPasses();

/// The two passes of ghosts. The first writes only depth, so that the second blends only the
/// nearest surface and overlapping parts look like one body.
std::vector<ShaderPass> ghostPasses();

inline constexpr float kGhostOpacity = 0.26f;

/// A material for OpenGL 3 with the shaders `:/shaders/<vertex>.vert` and `<fragment>.frag`.
class ShaderMaterial : public Qt3DRender::QMaterial {
 public:
  /// `defined` is a macro that the shaders can test by #ifdef; empty: none.
  ShaderMaterial(const QString& vertex, const QString& fragment,
                 const std::vector<ShaderPass>& passes, QNode* parent,
                 const QByteArray& defined = {});
  ShaderMaterial(const QString& both, const std::vector<ShaderPass>& passes, QNode* parent)
      : ShaderMaterial(both, both, passes, parent) {}

  /// Sets a uniform; a colour becomes a vec3.
  void set(const QString& uniform, const QVariant& value);
  void setColour(const QString& uniform, const QColor& colour);
};

/// The states of translucent things: they blend over the target, keep an opaque target opaque (for
/// captures), and leave the depth buffer alone.
std::vector<Qt3DRender::QRenderState*> translucent();

/// The key that identifies a pass in materials and filters.
inline const QString kPassKey = QStringLiteral("pass");

}  // namespace mocapress
