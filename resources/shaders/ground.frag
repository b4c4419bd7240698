#version 150 core
// SPDX-License-Identifier: GPL-3.0-or-later

in vec2 ground;
in vec2 sideways;

uniform vec3 pane;
uniform vec2 centre;
uniform float reach;
uniform float cell;  // cm between lines
uniform vec3 lineColour;
uniform vec3 xAxisColour;
uniform vec3 zAxisColour;

out vec4 fragment;

// The share of a pixel that lines of a given pitch cover, about `pixels` wide.
vec2 coverage(float pitch, float pixels) {
  vec2 lines = ground / pitch;
  vec2 footprint = fwidth(lines);
  vec2 pixelsAway = abs(fract(lines - 0.5) - 0.5) / footprint;
  // Lines denser than the pixels would shimmer: they fade into their mean.
  vec2 resolved = 1.0 - smoothstep(0.2, 0.6, footprint);
  return clamp(0.5 + 0.5 * pixels - pixelsAway, 0.0, 1.0) * resolved;
}

float either(vec2 alphas) { return max(alphas.x, alphas.y); }

void main() {
  float device = sideways.x / sideways.y;
  if (device < pane.y || device > pane.z) discard;
  float fine = 0.28 * either(coverage(cell, 1.0));
  float coarse = 0.55 * either(coverage(2.0 * cell, 1.2));
  vec2 onAxis = clamp(1.4 - abs(ground.yx) / fwidth(ground.yx), 0.0, 1.0);  // the x axis is z = 0

  vec3 colour = mix(lineColour, xAxisColour, onAxis.x);
  colour = mix(colour, zAxisColour, onAxis.y);
  float alpha = max(max(fine, coarse), 0.9 * either(onAxis));
  float fade = 1.0 - smoothstep(0.15, 1.0, length(ground - centre) / reach);
  fragment = vec4(colour, alpha * fade * fade);
}
