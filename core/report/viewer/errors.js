// SPDX-License-Identifier: MIT
// Errors of the compressed motion against the original: numbers, colours, and the worst frames.
import { Color } from 'three';

/** Distances in metres: of each point at each frame, of the worst point at each frame, and what the scale ends at. */
export function measure(original, compressed) {
  const count = original.points.length;
  const ofPoints = new Float32Array(count * original.frames);
  const ofFrames = new Float32Array(original.frames);
  for (let frame = 0; frame < original.frames; ++frame) {
    const a = original.positions[frame];
    const b = compressed.positions[frame];
    for (let i = 0; i < count; ++i) {
      const error = Math.hypot(a[3 * i] - b[3 * i], a[3 * i + 1] - b[3 * i + 1], a[3 * i + 2] - b[3 * i + 2]);
      ofPoints[count * frame + i] = error;
      ofFrames[frame] = Math.max(ofFrames[frame], error);
    }
  }
  const sorted = Float32Array.from(ofPoints).sort();
  return { ofPoints, ofFrames, largest: Math.max(sorted[Math.floor(0.99 * (sorted.length - 1))], 1e-6) };
}

/** Up to twelve frames, the worst first, a quarter of a second apart. */
export function findWorstFrames(ofFrames, sampleRate) {
  const order = Array.from(ofFrames.keys()).sort((a, b) => ofFrames[b] - ofFrames[a]);
  const found = [];
  for (const frame of order) {
    if (found.length === 12) break;
    if (found.every((other) => Math.abs(other - frame) >= sampleRate / 4)) found.push(frame);
  }
  return found;
}

// Dark to light, so that it reads without colours too.
const stops = ['#2d1e6b', '#8b2a8e', '#d8476a', '#f89441', '#f6e35a'].map((text) => new Color(text));

/** The colour of an error, given as a share of the largest. */
export function errorColour(share) {
  const at = Math.min(Math.max(share, 0), 1) * (stops.length - 1);
  const stop = Math.min(Math.floor(at), stops.length - 2);
  return stops[stop].clone().lerp(stops[stop + 1], at - stop);
}

/** The same colours for a page's style. */
export const errorGradient = `linear-gradient(to right, ${stops.map((stop) => stop.getStyle()).join(', ')})`;
