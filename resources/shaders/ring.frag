#version 150 core
// SPDX-License-Identifier: GPL-3.0-or-later

in vec2 across;
in vec2 sideways;

uniform vec3 pane;

out vec4 fragment;

// Pixels to either side of the ring. White is seen on dark, its dark edges on light.
const float kWhite = 1.2;
const float kEdge = 2.4;
const vec3 kEdgeColour = vec3(0.09, 0.1, 0.11);

void main() {
  float device = sideways.x / sideways.y;
  if (device < pane.y || device > pane.z) discard;
  float away = abs(length(across) - 1.0) / length(dFdx(across));
  float white = 1.0 - smoothstep(kWhite - 0.5, kWhite + 0.5, away);
  float covered = 1.0 - smoothstep(kEdge - 0.5, kEdge + 0.5, away);
  fragment = vec4(mix(kEdgeColour, vec3(1.0), white), mix(0.75 * covered, 1.0, white));
}
