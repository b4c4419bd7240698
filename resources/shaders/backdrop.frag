#version 150 core
// SPDX-License-Identifier: GPL-3.0-or-later

in vec2 device;

uniform vec3 centreColour;
uniform vec3 edgeColour;

out vec4 fragment;

void main() {
  vec2 away = device - vec2(0.0, 0.15);
  float outwards = min(0.55 * dot(away, away), 1.0);
  // A grain below one step of 8-bit colour hides the bands of a slow gradient.
  float grain = fract(53.0 * fract(dot(gl_FragCoord.xy, vec2(0.0671, 0.00584)))) - 0.5;
  fragment = vec4(mix(centreColour, edgeColour, outwards) + grain / 255.0, 1.0);
}
