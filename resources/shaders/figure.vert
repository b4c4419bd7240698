#version 150 core
// SPDX-License-Identifier: GPL-3.0-or-later

// One capsule of a figure: the unit mesh laid between two balls given by the instance.
in vec3 vertexPosition;  // on the unit ball; y along the capsule
in float along;          // 0: on the start's ball, 1: on the end's
in vec4 start;           // xyz in the world, radius (cm)
in vec4 end;
in float alert;
in vec4 startTint;       // rgb, and how much of it
in vec4 endTint;

uniform mat4 viewMatrix;
uniform mat4 projectionMatrix;
uniform mat4 viewProjectionMatrix;
uniform vec3 colour;
uniform vec3 alertColour;
uniform float thickness;
uniform float flatness;  // 1: round, less: pressed flat onto the ground
uniform float behind;    // cm further from the eye it counts as it is
uniform vec3 offset;     // cm
uniform vec3 pane;       // sideways shift, left and right end, in normalised device coordinates

out vec3 positionInView;
out vec3 normalInView;
out vec3 surface;
out vec2 sideways;  // x and w in clip space

// The depth pass and the shading pass of the ghost must agree to the last bit.
invariant gl_Position;

void main() {
  vec3 span = end.xyz - start.xyz;
  float size = length(span);
  vec3 axis = size > 0.0 ? span / size : vec3(0.0, 1.0, 0.0);
  vec3 side = normalize(abs(axis.y) < 0.9 ? cross(axis, vec3(0.0, 1.0, 0.0))
                                          : cross(axis, vec3(1.0, 0.0, 0.0)));
  vec3 outwards = mat3(side, axis, cross(side, axis)) * vertexPosition;
  vec4 ball = mix(start, end, along);
  vec3 swell = thickness * ball.w * outwards;
  vec4 position = vec4(ball.xyz + offset + vec3(swell.x, flatness * swell.y, swell.z), 1.0);

  float taper = size > 0.0 ? thickness * (start.w - end.w) / size : 0.0;
  positionInView = vec3(viewMatrix * position);
  normalInView = mat3(viewMatrix) * normalize(outwards + taper * axis);
  vec4 tint = mix(startTint, endTint, along);
  surface = mix(mix(colour, alertColour, alert), tint.rgb, tint.a);
  gl_Position = viewProjectionMatrix * position;
  vec4 deeper = projectionMatrix * vec4(positionInView + behind * normalize(positionInView), 1.0);
  gl_Position.z = deeper.z / deeper.w * gl_Position.w;
  gl_Position.x += pane.x * gl_Position.w;
  sideways = gl_Position.xw;
}
