#version 150 core
// SPDX-License-Identifier: GPL-3.0-or-later

// One capsule's spot on the ground: a square laid around the line below it.
in vec3 vertexPosition;  // from -1 to 1 on y = 0
in vec4 start;           // xyz in the world, radius (cm)
in vec4 end;

uniform mat4 viewProjectionMatrix;
uniform vec3 offset;  // cm
uniform vec3 pane;    // as for the figure

out vec2 ground;     // x, z in the world (cm)
flat out vec4 line;  // the same of both ends
flat out vec2 wide;  // how far the spot reaches around either (cm)
flat out vec2 dark;  // there
out vec2 sideways;

// The higher, the wider, and by as much fainter: the light that is kept away stays the same.
const float kSpread = 0.32;  // cm a cm of height
const float kBeside = 1.5;   // radii
const float kDarkest = 0.3;

void main() {
  vec2 radius = vec2(start.w, end.w);
  vec2 height = max(vec2(start.y, end.y), 0.0);
  wide = kBeside * radius + kSpread * height;
  vec2 share = radius / max(radius + 0.5 * kSpread * height, 1e-6);
  dark = kDarkest * share * sqrt(share);
  line = vec4(start.xz, end.xz) + offset.xzxz;

  vec2 span = line.zw - line.xy;
  float size = length(span);
  vec2 axis = size > 0.0 ? span / size : vec2(1.0, 0.0);
  float reach = max(wide.x, wide.y);
  vec2 from = vertexPosition.x < 0.0 ? line.xy - reach * axis : line.zw + reach * axis;
  ground = from + reach * vertexPosition.z * vec2(-axis.y, axis.x);
  gl_Position = viewProjectionMatrix * vec4(ground.x, 0.0, ground.y, 1.0);
  gl_Position.x += pane.x * gl_Position.w;
  sideways = gl_Position.xw;
}
