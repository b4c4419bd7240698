#version 150 core
// SPDX-License-Identifier: GPL-3.0-or-later

in vec2 ground;
flat in vec4 line;
flat in vec2 wide;
flat in vec2 dark;
in vec2 sideways;

uniform vec3 pane;

out vec4 fragment;

void main() {
  float device = sideways.x / sideways.y;
  if (device < pane.y || device > pane.z) discard;
  vec2 span = line.zw - line.xy;
  float along = clamp(dot(ground - line.xy, span) / max(dot(span, span), 1e-6), 0.0, 1.0);
  float away = length(ground - mix(line.xy, line.zw, along)) / mix(wide.x, wide.y, along);
  float shade = (1.0 - smoothstep(0.0, 1.0, away)) * mix(dark.x, dark.y, along);
  // Many faint spots in 8 bits would leave rings.
  float noise = fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));
  fragment = vec4(0.0, 0.0, 0.0, shade + (noise - 0.5) / 255.0 * step(1e-4, shade));
}
