#version 150 core
// SPDX-License-Identifier: GPL-3.0-or-later

in vec3 vertexPosition;  // in clip space: one triangle over the whole view

out vec2 device;

void main() {
  device = vertexPosition.xy;
  gl_Position = vec4(vertexPosition.xy, 0.0, 1.0);
}
