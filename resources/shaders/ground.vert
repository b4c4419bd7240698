#version 150 core
// SPDX-License-Identifier: GPL-3.0-or-later

in vec3 vertexPosition;  // a square from -1 to 1 on y = 0

uniform mat4 viewProjectionMatrix;
uniform vec2 centre;  // x, z in the world (cm)
uniform float reach;  // cm
uniform vec3 pane;    // as for the figure

out vec2 ground;  // x, z in the world (cm)
out vec2 sideways;

void main() {
  ground = centre + reach * vertexPosition.xz;
  gl_Position = viewProjectionMatrix * vec4(ground.x, 0.0, ground.y, 1.0);
  gl_Position.x += pane.x * gl_Position.w;
  sideways = gl_Position.xw;
}
