#version 150 core
// SPDX-License-Identifier: GPL-3.0-or-later

in vec3 vertexPosition;  // a square from -1 to 1 on y = 0

uniform vec4 place;  // left, bottom, right, top in clip space

out vec2 across;  // 0, 0 at the picture's top left

void main() {
  across = 0.5 + 0.5 * vertexPosition.xz;
  gl_Position = vec4(mix(place.x, place.z, across.x), mix(place.w, place.y, across.y), 0.0, 1.0);
}
