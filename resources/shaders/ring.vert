#version 150 core
// SPDX-License-Identifier: GPL-3.0-or-later

in vec3 vertexPosition;  // a square from -1 to 1 on y = 0

uniform mat4 viewMatrix;
uniform mat4 projectionMatrix;
uniform vec4 place;  // xyz in the world, radius (cm)
uniform vec3 pane;   // as for the figure

out vec2 across;    // of length 1 on the ring
out vec2 sideways;  // x and w in clip space

const float kRoom = 1.5;            // around the ring, for its line
const float kLeastInView = 0.0135;  // radius a cm of depth

void main() {
  across = kRoom * vec2(vertexPosition.x, -vertexPosition.z);  // its front to the eye
  vec3 centre = vec3(viewMatrix * vec4(place.xyz, 1.0));
  float radius = max(place.w, -kLeastInView * centre.z);
  gl_Position = projectionMatrix * vec4(centre + radius * vec3(across, 0.0), 1.0);
  gl_Position.x += pane.x * gl_Position.w;
  sideways = gl_Position.xw;
}
