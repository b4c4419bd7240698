#version 150 core
// SPDX-License-Identifier: GPL-3.0-or-later

in vec3 positionInView;
in vec3 normalInView;
in vec3 surface;  // its colour before it is lit
in vec2 sideways;

#ifdef PICTURED
in vec3 pictured;
in vec3 inPicture;
uniform sampler2D pictures;  // one below the other
uniform float pictureCount;
#endif

uniform mat4 viewMatrix;
uniform vec3 pane;
uniform float opacity;  // facing the eye; the rim of a translucent figure is denser, like glass

out vec4 fragment;

const vec3 kKeyInView = normalize(vec3(-0.45, 0.65, 0.6));

void main() {
  float device = sideways.x / sideways.y;
  if (device < pane.y || device > pane.z) discard;
  vec3 normal = normalize(normalInView);
  vec3 toEye = normalize(-positionInView);
  vec3 up = mat3(viewMatrix) * vec3(0.0, 1.0, 0.0);

  vec3 base = surface;
#ifdef PICTURED
  if (inPicture.z > -0.5) {
    vec2 within = fract(inPicture.xy);
    vec2 at = vec2(within.x, (floor(inPicture.z + 0.5) + within.y) / pictureCount);
    base += pictured * (texture(pictures, at).rgb - 1.0);
  }
#endif

  float ambient = mix(0.4, 0.64, 0.5 + 0.5 * dot(normal, up));
  float key = pow(0.5 + 0.5 * dot(normal, kKeyInView), 2.0);
  float gloss = pow(max(dot(normal, normalize(kKeyInView + toEye)), 0.0), 48.0);
  float rim = pow(1.0 - max(dot(normal, toEye), 0.0), 2.0);

  vec3 lit = base * (ambient + 0.62 * key) + 0.22 * gloss + 0.12 * rim * (0.5 + 0.5 * base);
  fragment = vec4(lit, mix(opacity, 1.0, 0.75 * rim));
}
