// SPDX-License-Identifier: MIT
// Streams a bank, or one file, tier by tier over HTTP ranges, from a server on this machine. Prints how many bytes have come after how
// many seconds, and how far joints then are from where all tiers place them.
// Usage: node stream.mjs PACKAGE BANK.mcpk|FILE.mcpr [KB_A_SECOND]
// PACKAGE is what core/runtime/web/build makes (build/web/package). A bank with tiers is made of files that have some:
// mocapress compress CLIP -o FILE.mcpr --tiers 3, then mocapress bank make BANK.mcpk FILES.
import { readFileSync } from 'node:fs';
import { createServer } from 'node:http';
import { basename, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';

const [folder, path, kbASecond = '0'] = process.argv.slice(2);
const { blendPose, createMocapress, worldPositions } = await import(pathToFileURL(resolve(folder, 'mocapress.js')));
const file = readFileSync(path);

/** A server whose answers share a line of so many bytes a second; 0: as fast as it can. */
async function serve(bytesASecond) {
  const counted = { bytes: 0 };
  let line = Promise.resolve();
  const server = createServer((request, response) => {
    const [, first, last] = /^bytes=(\d+)-(\d+)$/.exec(request.headers.range).map(Number);
    const part = file.subarray(first, last + 1);
    const milliseconds = bytesASecond > 0 ? (1000 * part.length) / bytesASecond : 0;
    line = line.then(() => new Promise((done) => setTimeout(done, milliseconds)));
    line.then(() => {
      counted.bytes += part.length;
      const head = { 'content-range': `bytes ${first}-${last}/${file.length}`, connection: 'close' };
      response.writeHead(206, head).end(part);
    });
  });
  await new Promise((ready) => server.listen(0, '127.0.0.1', ready));
  return { counted, server, url: `http://127.0.0.1:${server.address().port}/${encodeURIComponent(basename(path))}` };
}

/** Positions of all joints at some instants of a clip. */
function positionsOf(clip) {
  const instants = 20;
  return Array.from({ length: instants }, (_, i) => clip.positions((clip.duration * i) / (instants - 1)));
}

const distance = (a, b, at) => Math.hypot(a[at] - b[at], a[at + 1] - b[at + 1], a[at + 2] - b[at + 2]);

/** The distances of a clip's joints from where all tiers place them: sum of squared cm, their number, the largest cm. */
function errorOf(clip, finest) {
  const error = { squares: 0, count: 0, largest: 0 };
  const atLast = positionsOf(finest);
  positionsOf(clip).forEach((positions, i) => {
    for (let at = 0; at < positions.length; at += 3, ++error.count) {
      const cm = distance(positions, atLast[i], at);
      error.squares += cm * cm;
      error.largest = Math.max(error.largest, cm);
    }
  });
  clip.dispose();
  finest.dispose();
  return error;
}

/**
 * Plays a clip at 60 Hz, and goes over to its next tier each second: within `fade` seconds. Returns by how many cm more
 * the error of a joint changes between two frames than that of either tier does.
 */
function largestJump(bank, name, fade) {
  const rate = 60;
  const clips = Array.from({ length: bank.tiers }, (_, tier) => bank.openClip(name, tier + 1));
  const players = clips.map((clip) => clip.createPlayer());
  const atLast = clips.at(-1).createPlayer();
  const { joints } = clips[0];
  let largest = 0;
  for (let tier = 1; tier < clips.length; ++tier) {
    let before;
    for (let frame = -1; frame < rate / 4; ++frame) {
      const [pose, finer, all] = [players[tier - 1], players[tier], atLast].map((player) =>
        player.sample(tier + frame / rate, { wrap: 'pingPong' }),
      );
      const wanted = worldPositions(joints, all, 8);
      const errorOfPose = (some) => worldPositions(joints, some, 8).map((value, i) => value - wanted[i]);
      const errors = [errorOfPose(pose), errorOfPose(finer)];
      const share = fade > 0 ? Math.min(Math.max((frame + 1) / rate / fade, 0), 1) : Number(frame >= 0);
      errors.push(errorOfPose(blendPose(pose, finer, share)));
      for (let at = 0; before && at < wanted.length; at += 3) {
        const [ofCoarse, ofFiner, shown] = errors.map((error, i) => distance(error, before[i], at));
        largest = Math.max(largest, shown - Math.max(ofCoarse, ofFiner));
      }
      before = errors;
    }
  }
  for (const clip of clips) clip.dispose();
  return largest;
}

const mocapress = await createMocapress();
const isClip = path.endsWith('.mcpr');
const whole = isClip ? { openClip: () => mocapress.openClip(file) } : mocapress.openBank(file);
const { counted, server, url } = await serve(1000 * Number(kbASecond));
const start = performance.now();
const bank = await (isClip ? mocapress.streamClip(url) : mocapress.streamBank(url));
const { names } = bank;
const errors = new Map(); // of the clips that have come
console.log('| seconds | bytes | of the file | clips | RMS cm | largest cm |\n| --- | --- | --- | --- | --- | --- |');
const print = (clips, seconds) => {
  const all = [...errors.values()];
  const sum = (value) => all.reduce((total, error) => total + value(error), 0);
  const rms = Math.sqrt(sum((error) => error.squares) / sum((error) => error.count));
  const largest = Math.max(...all.map((error) => error.largest));
  const share = ((100 * counted.bytes) / file.length).toFixed(1);
  console.log(`| ${seconds.toFixed(2)} | ${counted.bytes} | ${share} % | ${clips} | ${rms.toFixed(3)} | ${largest.toFixed(2)} |`);
};
let measuring = 0; // milliseconds that are not the line's
for (let tier = 1; tier <= bank.tiers; ++tier)
  for (let part = 0, parts = Math.min(names.length, 4); part < parts; ++part) {
    const [first, end] = [part, part + 1].map((before) => Math.floor((before * names.length) / parts));
    const some = names.slice(first, end);
    await Promise.all(some.map((name) => bank.load(name, tier)));
    const come = performance.now();
    for (const name of some) errors.set(name, errorOf(bank.openClip(name), whole.openClip(name)));
    print(`${end} of ${names.length} in tier ${tier}`, (come - start - measuring) / 1000);
    measuring += performance.now() - come;
  }
const jump = (fade) => Math.max(...names.slice(0, 2).map((name) => largestJump(bank, name, fade))).toFixed(2);
console.log(`\nWhere a finer tier comes, joints jump by up to ${jump(0)} cm; blended in within 0.2 s, by up to ${jump(0.2)} cm.`);
server.close();
server.closeAllConnections?.();
