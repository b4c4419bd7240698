// SPDX-License-Identifier: MIT
// A worker that samples a clip: import maps do not reach it, so it names the module's file.
import { createMocapress } from '/package/mocapress.js';

onmessage = async ({ data: { url, seconds } }) => {
  const mocapress = await createMocapress();
  const clip = mocapress.openClip(await (await fetch(url)).arrayBuffer());
  postMessage(seconds.flatMap((second) => [...clip.sample(second)]));
};
