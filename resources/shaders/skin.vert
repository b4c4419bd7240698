#version 150 core
// SPDX-License-Identifier: GPL-3.0-or-later

// Linear blend skinning: a vertex is carried by four bones at most.
in vec3 vertexPosition;  // cm, in the world of the bind pose
in vec3 vertexNormal;
in vec3 vertexColour;
in vec4 bones;           // indices
in vec4 weights;         // summing to 1
in vec3 place;           // in a picture: rightwards, downwards, which; -1: in none

// For each bone: the rows of its world_from_bind, then the skin's tint as rgb and opacity.
layout(std140) uniform Bones { vec4 rows[4 * 256]; };

uniform mat4 viewMatrix;
uniform mat4 projectionMatrix;
uniform mat4 viewProjectionMatrix;
uniform vec4 colour;   // rgb, and how much of it; the rest is the skin's own
uniform float behind;  // cm further from the eye it counts as it is
uniform vec3 offset;   // cm
uniform vec3 pane;     // sideways shift, left and right end, in normalised device coordinates

out vec3 positionInView;
out vec3 normalInView;
out vec3 surface;
out vec3 pictured;  // the part of `surface` that a picture is multiplied with
out vec3 inPicture;
out vec2 sideways;  // x and w in clip space

// The depth pass and the shading pass of the ghost must agree to the last bit.
invariant gl_Position;

void main() {
  vec4 x = vec4(0.0);
  vec4 y = vec4(0.0);
  vec4 z = vec4(0.0);
  vec4 cover = vec4(0.0);
  for (int i = 0; i < 4; ++i) {
    int bone = 4 * int(bones[i]);
    x += weights[i] * rows[bone];
    y += weights[i] * rows[bone + 1];
    z += weights[i] * rows[bone + 2];
    vec4 cover_of_bone = rows[bone + 3];
    cover += weights[i] * vec4(cover_of_bone.a * cover_of_bone.rgb, cover_of_bone.a);
  }
  vec4 bind = vec4(vertexPosition, 1.0);
  vec3 turned = vec3(dot(x.xyz, vertexNormal), dot(y.xyz, vertexNormal), dot(z.xyz, vertexNormal));
  vec3 outwards = dot(turned, turned) > 0.0 ? normalize(turned) : vec3(0.0, 1.0, 0.0);
  vec4 position = vec4(vec3(dot(x, bind), dot(y, bind), dot(z, bind)) + offset, 1.0);

  positionInView = vec3(viewMatrix * position);
  normalInView = mat3(viewMatrix) * outwards;
  surface = (1.0 - cover.a) * mix(vertexColour, colour.rgb, colour.a) + cover.rgb;
  pictured = (1.0 - cover.a) * (1.0 - colour.a) * vertexColour;
  inPicture = place;
  gl_Position = viewProjectionMatrix * position;
  vec4 deeper = projectionMatrix * vec4(positionInView + behind * normalize(positionInView), 1.0);
  gl_Position.z = deeper.z / deeper.w * gl_Position.w;
  gl_Position.x += pane.x * gl_Position.w;
  sideways = gl_Position.xw;
}
