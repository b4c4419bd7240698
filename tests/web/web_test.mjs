// SPDX-License-Identifier: MIT
// The npm package in a headless Chromium, on pages from localhost: node --test web_test.mjs, started by tests/web/run,
// which says where things are. Pictures of what the pages show go to the folder WEB_PICTURES.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { copyFileSync, existsSync, mkdirSync, mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { createServer } from 'node:http';
import { tmpdir } from 'node:os';
import { basename, extname, join, normalize } from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { gzipSync } from 'node:zlib';

const source = fileURLToPath(new URL('../..', import.meta.url));
const { WEB_PROGRAM, WEB_NATIVE_POSES, WEB_PACKAGE, WEB_NODE, WEB_PICTURES } = process.env;
const { chromium } = createRequire(join(WEB_NODE, 'package.json'))('playwright-core');
const { createMocapress, worldPositions } = await import(join(WEB_PACKAGE, 'mocapress.js'));
const corpus = process.env.MOCAPRESS_CORPUS ?? join(source, '../shared/corpus');
const files = mkdtempSync(join(tmpdir(), 'mocapress-web-'));
const character = join(source, 'resources/samples/character.glb');

const types = {
  '.html': 'text/html',
  '.js': 'text/javascript',
  '.wasm': 'application/wasm',
  '.json': 'application/json',
};
const roots = { package: WEB_PACKAGE, node_modules: join(WEB_NODE, 'node_modules'), files };

let knowsRanges = true;
let bytesSent = 0;
const pageInsteadOfFile = '<!DOCTYPE html><title>Not found</title>' + ' '.repeat(1000);
const server = createServer((request, response) => {
  if (request.url.startsWith('/pages/')) return response.writeHead(200, { 'content-type': 'text/html' }).end(pageInsteadOfFile);
  const path = normalize(decodeURIComponent(new URL(request.url, 'http://localhost').pathname));
  const [, first, ...rest] = path.split('/');
  const file = roots[first] ? join(roots[first], ...rest) : join(source, 'tests/web', path);
  if (!existsSync(file)) return response.writeHead(404).end();
  const type = { 'content-type': types[extname(file)] ?? 'application/octet-stream' };
  const bytes = readFileSync(file);
  const range = knowsRanges && /^bytes=(\d+)-(\d+)$/.exec(request.headers.range);
  if (range && Number(range[1]) >= bytes.length) return response.writeHead(416).end();
  const sent = range ? bytes.subarray(Number(range[1]), Number(range[2]) + 1) : bytes;
  if (['.mcpk', '.mcpr'].includes(extname(file))) bytesSent += sent.length;
  response.writeHead(range ? 206 : 200, range ? { ...type, 'content-range': `bytes ${range[1]}-${range[2]}/${bytes.length}` } : type);
  response.end(sent);
});

server.maxRequestsPerSocket = 1; // programs stop this process for seconds, in which idle connections would close

let browser;
let page;
const pageErrors = [];

const mocapress = (...words) => execFileSync(WEB_PROGRAM, words, { stdio: ['ignore', 'pipe', 'pipe'] });
const native = (name, instants) =>
  JSON.parse(execFileSync(WEB_NATIVE_POSES, [join(files, name), String(instants)], { maxBuffer: 1 << 28 }));
const largestDifference = (a, b) => {
  assert.equal(a.length, b.length);
  return a.reduce((most, value, i) => Math.max(most, Math.abs(value - b[i])), 0);
};
const inPage = (name, ...values) => page.evaluate(([name, values]) => window.page[name](...values), [name, values]);

/** A copy of a .glb whose skeleton hangs on a node that is turned and scaled, as exporters of Mixamo's characters do. */
function withArmature(glb) {
  const jsonBytes = glb.readUInt32LE(12);
  const json = JSON.parse(glb.subarray(20, 20 + jsonBytes).toString());
  const joints = new Set(json.skins.flatMap((skin) => skin.joints));
  const below = new Set([...joints].flatMap((joint) => json.nodes[joint].children ?? []));
  const tops = [...joints].filter((joint) => !below.has(joint));
  const armature = json.nodes.length;
  const replaced = (list) => [...(list ?? []).filter((node) => !tops.includes(node))];
  for (const node of json.nodes)
    if (node.children?.some((child) => tops.includes(child))) node.children = [...replaced(node.children), armature];
  for (const scene of json.scenes)
    if (scene.nodes.some((node) => tops.includes(node))) scene.nodes = [...replaced(scene.nodes), armature];
  json.nodes.push({ name: 'Armature', children: tops, rotation: [-0.5, 0.5, 0.5, 0.5], scale: [0.5, 0.5, 0.5] });
  let text = JSON.stringify(json);
  text += ' '.repeat((4 - (text.length % 4)) % 4);
  const head = Buffer.from(glb.subarray(0, 20));
  const rest = glb.subarray(20 + jsonBytes);
  head.writeUInt32LE(20 + text.length + rest.length, 8);
  head.writeUInt32LE(text.length, 12);
  return Buffer.concat([head, Buffer.from(text), rest]);
}

/** Compresses a character's own motion, and puts the character beside it. */
function prepare(model, bytes, ...options) {
  const path = join(files, model);
  writeFileSync(path, bytes);
  mocapress('compress', path, '-o', path.replace(/\.[^.]*$/, '.mcpr'), ...options);
}

before(async () => {
  await new Promise((resolve) => server.listen(0, '127.0.0.1', resolve));
  mkdirSync(WEB_PICTURES, { recursive: true });
  prepare('character.glb', readFileSync(character));
  for (const clip of ['human_walk', 'human_run', 'human_jump'])
    mocapress('compress', join(source, `resources/samples/${clip}.amc`), '-o', join(files, `${clip}.mcpr`));
  const clips = ['human_jump', 'human_run', 'human_walk'].map((clip) => join(files, `${clip}.mcpr`));
  mocapress('bank', 'make', join(files, 'packed.mcpk'), ...clips);
  mocapress('bank', 'make', join(files, 'cooked.mcpk'), ...clips, '--cooked');
  mocapress('bank', 'make', join(files, 'character.mcpk'), join(files, 'character.mcpr'), '--cooked');
  mkdirSync(join(files, 'tiers'));
  for (const clip of [character, join(source, 'resources/samples/human_run.amc'), join(source, 'resources/samples/human_walk.amc')])
    mocapress('compress', clip, '-o', join(files, 'tiers', basename(clip).replace(/\.[^.]*$/, '.mcpr')), '--tiers', '3');
  mocapress('bank', 'make', join(files, 'tiers.mcpk'), join(files, 'tiers'));
  browser = await chromium.launch({
    executablePath: process.env.WEB_CHROMIUM ?? '/usr/bin/chromium',
    args: ['--no-sandbox', '--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader'],
  });
  page = await browser.newPage({ viewport: { width: 1280, height: 720 } });
  page.setDefaultTimeout(120_000);
  page.on('pageerror', (error) => pageErrors.push(String(error)));
  await page.goto(`http://127.0.0.1:${server.address().port}/page.html`);
  await page.waitForFunction(() => window.page);
});

after(async () => {
  await browser?.close();
  server.close();
  rmSync(files, { recursive: true });
});

test('the package has all files, and the cooked player is below 60 KB', () => {
  const listed = JSON.parse(execFileSync('npm', ['pack', '--dry-run', '--json'], { cwd: WEB_PACKAGE }));
  const names = listed[0].files.map((file) => file.path).sort();
  assert.deepEqual(names, [
    'LICENSE',
    'README.md',
    'fetching.js',
    'mocapress.d.ts',
    'mocapress.js',
    'mocapress.wasm',
    'mocapress_cooked.wasm',
    'mocapress_plain.wasm',
    'mocapress_three.d.ts',
    'mocapress_three.js',
    'package.json',
  ]);
  for (const name of readdirSync(WEB_PACKAGE).filter((name) => name.endsWith('.wasm')))
    console.log(`${name}: ${gzipSync(readFileSync(join(WEB_PACKAGE, name)), { level: 9 }).length} bytes gzipped`);
  assert.ok(gzipSync(readFileSync(join(WEB_PACKAGE, 'mocapress_cooked.wasm')), { level: 9 }).length < 60_000);
});

test('the module leaves no globals', async () => {
  assert.equal(await inPage('leavesNoGlobals'), true);
});

test('every module samples the poses of the native runtime', async () => {
  const expected = native('human_walk.mcpr', 300);
  for (const module of ['', 'package/mocapress_plain.wasm']) {
    const { poses, usPlaying, usRandom } = await inPage('poses', module, 'files/human_walk.mcpr', expected.seconds);
    assert.ok(largestDifference(poses, expected.poses) < 1e-3);
    console.log(
      `${module || 'package/mocapress.wasm'}: ${usPlaying.toFixed(2)} us a pose playing, ${usRandom.toFixed(2)} random; ` +
        `native ${expected.us_playing} and ${expected.us_random}`,
    );
  }
});

test('a clip with inverse kinematics has the poses of the native runtime, cooked as coarsely', async () => {
  mocapress('compress', join(source, 'resources/samples/human_walk.amc'), '-o', join(files, 'held.mcpr'), '--ik', '0.2');
  const expected = native('held.mcpr', 60);
  const clip = (await createMocapress()).openClip(readFileSync(join(files, 'held.mcpr')));
  const poses = expected.seconds.flatMap((second) => [...clip.sample(second)]);
  assert.ok(largestDifference(poses, expected.poses) < 1e-4);
});

test('a clip goes on after its end as the caller wants', async () => {
  const clip = (await createMocapress()).openClip(readFileSync(join(files, 'human_walk.mcpr')));
  const end = clip.duration;
  const apart = (seconds, wrap, other) =>
    largestDifference([...clip.sample(seconds, { wrap })], [...clip.sample(other)]);
  assert.ok(apart(end + 0.3, 'clamp', end) < 1e-3);
  assert.ok(apart(end + 0.3, 'pingPong', end - 0.3) < 1e-3);
  assert.ok(apart(end + 0.3, 'loopJump', 0.3) < 1e-3);
  assert.ok(apart(end + 0.7 / clip.sampleRate, 'loopHold', end) < 1e-3);
  assert.ok(apart(end + 1.3 / clip.sampleRate, 'loopBlend', 0.3 / clip.sampleRate) < 1e-3);
  assert.equal(clip.sampleTracks(end + 1, { wrap: 'pingPong' }).length, clip.tracks.length);
  assert.throws(() => clip.sample(0, { wrap: 'sideways' }), /no wrap sideways/);
});

test('banks give the poses of their clips, packed and cooked', async () => {
  const expected = native('human_run.mcpr', 100);
  for (const [module, bank] of [
    ['', 'packed'],
    ['', 'cooked'],
    ['package/mocapress_cooked.wasm', 'cooked'],
  ]) {
    const made = await inPage('posesOfBank', module, `files/${bank}.mcpk`, 'human_run', expected.seconds);
    assert.deepEqual(made.names, ['human_jump', 'human_run', 'human_walk']);
    assert.ok(largestDifference(made.poses, expected.poses) < 1e-3, `${module} ${bank}`);
  }
});

test('a bank on a server is loaded clip by clip, or whole where ranges are not known', async () => {
  const expected = native('human_run.mcpr', 100);
  for (const form of ['packed', 'cooked']) {
    const bank = readFileSync(join(files, `${form}.mcpk`));
    for (knowsRanges of [true, false]) {
      const { loads, poses, again, early } = await inPage('posesOfStream', `files/${form}.mcpk`, 'human_run', expected.seconds);
      assert.ok(largestDifference(poses, expected.poses) < 1e-3);
      assert.deepEqual(again, poses, 'by MocapressLoader');
      assert.equal(loads, knowsRanges);
      if (knowsRanges) assert.match(early, /^MocapressError: the clip human_run is not there yet/);
    }
    knowsRanges = true;
    bytesSent = 0;
    await inPage('posesOfStream', `files/${form}.mcpk`, 'human_run', [0], false);
    const clips = 3;
    console.log(`${form}.mcpk: ${bytesSent} of ${bank.length} bytes for one of ${clips} clips`);
    assert.ok(bytesSent < bank.length / 2);
  }
});

for (const file of ['tiers.mcpk', 'tiers/character.mcpr'])
  test(`${file} is loaded tier by tier, and a finer one is blended in`, async () => {
    const { joints } = native('character.mcpr', 2);
    const names = joints.map((joint) => joint.name);
    const frames = 30;
    const poses = await inPage('refined', 'files/character.glb', `files/${file}`, 'character', names, frames, 0.2);
    const apart = poses.map(([coarse, all]) => largestDifference(coarse, all));
    const off = poses.map(([, all, shown]) => shown.map((value, i) => value - all[i]));
    assert.ok(Math.max(...apart) > 0.1, 'the first tier is coarse');
    assert.ok(largestDifference(poses[0][0], poses[0][2]) < 1e-4, 'it is shown first');
    for (let frame = 14; frame < frames; ++frame)
      assert.ok(largestDifference(poses[frame][1], poses[frame][2]) < 1e-4, 'all tiers are shown at last');
    for (let frame = 1; frame < 14; ++frame) {
      const step = largestDifference(off[frame], off[frame - 1]);
      const motionOfError = largestDifference(
        poses[frame][0].map((value, i) => value - poses[frame][1][i]),
        poses[frame - 1][0].map((value, i) => value - poses[frame - 1][1][i]),
      );
      assert.ok(step < Math.max(...apart) / 12 + motionOfError + 0.01, `nothing jumps at frame ${frame}: ${step} cm`);
    }
  });

test('the first bytes of a file with tiers are a clip', async () => {
  const expected = native('tiers/human_walk.mcpr', 60);
  const file = readFileSync(join(files, 'tiers/human_walk.mcpr'));
  const opened = await inPage('posesOfTiers', 'files/tiers/human_walk.mcpr', expected.seconds);
  assert.equal(opened.length, 3);
  assert.equal(opened[2].tier.bytes, file.length);
  opened.forEach(({ tier, poses, refusal }, t) => {
    const off = largestDifference(poses, expected.poses);
    console.log(`tier ${t + 1}: ${tier.bytes} bytes, ${tier.error.toFixed(3)} cm RMS; quaternions and cm up to ${off.toFixed(3)} off`);
    assert.equal(off < 1e-3, t === 2);
    assert.match(refusal, /^MocapressError: [^.]+$/);
    assert.equal(tier.error > 0 && tier.maxError > tier.error, t < 2, 'the last one is that of the file');
    if (t > 0) assert.ok(tier.bytes > opened[t - 1].tier.bytes);
  });
});

test('a file on a server comes tier by tier where it has some, else as a whole', async () => {
  const mocapress = await createMocapress();
  const address = (path) => `http://127.0.0.1:${server.address().port}/files/${path}`;
  const size = readFileSync(join(files, 'tiers/human_walk.mcpr')).length;
  const expected = native('tiers/human_walk.mcpr', 60);
  const posesOf = (clip) => expected.seconds.flatMap((second) => [...clip.sample(second)]);
  bytesSent = 0;
  const streamed = await mocapress.streamClip(address('tiers/human_walk.mcpr'));
  assert.deepEqual([streamed.names, streamed.tiers], [['human_walk'], 3]);
  assert.throws(() => streamed.openClip(), /is not there yet/);
  for (let tiers = 1; tiers <= 3; ++tiers) {
    await Promise.all([streamed.load('human_walk', tiers), streamed.load('human_walk', tiers)]);
    assert.equal(bytesSent, streamed.tier(tiers - 1).bytes, 'each byte once');
    assert.equal(largestDifference(posesOf(streamed.openClip()), expected.poses) < 1e-3, tiers === 3);
  }
  assert.equal(bytesSent, size);
  await assert.rejects(streamed.load('human_run'), /no clip human_run/);
  for (const [path, ranges] of [
    ['human_walk.mcpr', true],
    ['tiers/human_walk.mcpr', false],
  ]) {
    const native60 = native(path, 60);
    knowsRanges = ranges;
    const whole = await mocapress.streamClip(address(path)).finally(() => (knowsRanges = true));
    assert.equal(whole.tiersLoaded(), whole.tiers);
    assert.ok(largestDifference(native60.seconds.flatMap((second) => [...whole.openClip().sample(second)]), native60.poses) < 1e-3);
  }
  await assert.rejects(mocapress.streamClip(address('tiers.mcpk')), /tiers.mcpk: not a Mocapress file/);
});

test('each tier of a streamed bank is one more range, and all of them give the poses of the file', async () => {
  const bank = readFileSync(join(files, 'tiers.mcpk'));
  const mocapress = await createMocapress();
  const streamed = await mocapress.streamBank(`http://127.0.0.1:${server.address().port}/files/tiers.mcpk`);
  assert.equal(streamed.tiers, 3);
  const expected = native('tiers/human_walk.mcpr', 60);
  const posesOf = (clip) => expected.seconds.flatMap((second) => [...clip.sample(second)]);
  assert.throws(() => streamed.openClip('human_walk'), /is not there yet/);
  for (let tiers = 1; tiers <= 3; ++tiers) {
    bytesSent = 0;
    await Promise.all([streamed.load('human_walk', tiers), streamed.load('human_walk', tiers)]);
    assert.ok(bytesSent > 0 && bytesSent < bank.length / 3, `tier ${tiers}: ${bytesSent} bytes`);
    assert.equal(streamed.tiersLoaded('human_walk'), tiers);
    const off = largestDifference(posesOf(streamed.openClip('human_walk')), expected.poses);
    console.log(`tier ${tiers}: ${bytesSent} bytes, quaternions and cm up to ${off.toFixed(3)} off`);
    assert.equal(off < 1e-3, tiers === 3);
  }
  assert.throws(() => streamed.openClip('human_walk', 4), /is not there yet/);
  assert.equal(streamed.isLoaded('human_run'), false);
});

test('the example streams a bank of a hundred clips', () => {
  const hundred = join(files, 'hundred');
  mkdirSync(hundred);
  for (let i = 0; i < 100; ++i)
    copyFileSync(join(files, 'tiers', i % 2 ? 'human_run.mcpr' : 'human_walk.mcpr'), join(hundred, `clip${i}.mcpr`));
  mocapress('bank', 'make', join(files, 'hundred.mcpk'), hundred);
  const example = join(source, 'core/runtime/web/example/stream.mjs');
  const printed = execFileSync(process.execPath, [example, WEB_PACKAGE, join(files, 'hundred.mcpk')]).toString();
  console.log(printed);
  const rows = printed.split('\n').filter((line) => line.includes('of 100 in tier'));
  const [bytes, errors] = [2, 5].map((column) => rows.map((row) => parseFloat(row.split('|')[column])));
  assert.equal(rows.length, 12);
  for (let i = 1; i < rows.length; ++i) assert.ok(bytes[i] > bytes[i - 1]);
  assert.ok(errors[3] > errors[7] && errors[7] > errors[11]);
  assert.equal(errors[11], 0);
  const [, atOnce, blended] = /jump by up to ([0-9.]+) cm; blended in within 0.2 s, by up to ([0-9.]+) cm/.exec(printed).map(Number);
  assert.ok(blended < atOnce / 3, `${blended} cm after ${atOnce}`);
});

test('the example streams a file, too', () => {
  const example = join(source, 'core/runtime/web/example/stream.mjs');
  const printed = execFileSync(process.execPath, [example, WEB_PACKAGE, join(files, 'tiers/human_walk.mcpr')]).toString();
  console.log(printed);
  const rows = printed.split('\n').filter((line) => line.includes('of 1 in tier'));
  const [bytes, errors] = [2, 5].map((column) => rows.map((row) => parseFloat(row.split('|')[column])));
  assert.equal(rows.length, 3);
  assert.equal(bytes[2], readFileSync(join(files, 'tiers/human_walk.mcpr')).length);
  assert.ok(errors[0] > errors[1] && errors[1] > errors[2]);
  assert.equal(errors[2], 0);
});

test('a mixer goes on after the end as its wrap says', async () => {
  const { joints } = native('character.mcpr', 2);
  const clip = (await createMocapress()).openClip(readFileSync(join(files, 'character.mcpr')));
  const end = clip.duration;
  const instants = [
    [end + 0.3, { wrap: 'clamp' }, end],
    [end + 0.3, { loop: false }, end],
    [end + 0.3, { wrap: 'pingPong' }, end - 0.3],
    [end + 0.3, { wrap: 'loopJump' }, 0.3],
    [end + 0.7 / clip.sampleRate, { wrap: 'loopHold' }, end],
  ];
  if (clip.loopFrames === 0) instants.push([end + 0.3, {}, 0.3]);
  const names = joints.map((joint) => joint.name);
  const placed = await inPage(
    'wrapped',
    'files/character.glb',
    'files/character.mcpr',
    names,
    instants.flatMap(([seconds, options, same]) => [
      { seconds, options },
      { seconds: same, options: { wrap: 'clamp' } },
    ]),
  );
  for (let i = 0; i < instants.length; ++i)
    assert.ok(largestDifference(placed[2 * i], placed[2 * i + 1]) < 1e-2, JSON.stringify(instants[i]));
});

test('a streamed bank that is damaged is refused, and so is a damaged clip', async () => {
  const bank = readFileSync(join(files, 'cooked.mcpk'));
  const items = Number(bank.readBigUInt64LE(32));
  for (const [place, refused] of [
    [20, 'streamBank'],
    [items + 8, 'streamBank'],
    [items - 64, 'load'],
  ]) {
    const damaged = Buffer.from(bank);
    damaged[place] ^= 1;
    writeFileSync(join(files, 'damaged.mcpk'), damaged);
    assert.match(await inPage('refusalOfStream', 'files/damaged.mcpk', 'human_walk'), new RegExp(`^${refused}: MocapressError: files/damaged.mcpk: [^.]+$`));
  }
});

test('MocapressLoader opens a file by load(), loadAsync() and parse()', async () => {
  const expected = native('human_walk.mcpr', 20);
  const opened = await inPage('posesByLoader', 'files/human_walk.mcpr', expected.seconds);
  assert.deepEqual(opened.map(({ names }) => names), [['human_walk'], ['human_walk'], ['parsed']]);
  for (const { poses, tracks } of opened) {
    assert.ok(largestDifference(poses, expected.poses) < 1e-3);
    assert.ok(tracks >= expected.joints.length);
  }
});

test('a worker samples the same poses', async () => {
  const expected = native('human_walk.mcpr', 20);
  const poses = await inPage('posesInWorker', '/files/human_walk.mcpr', expected.seconds);
  assert.ok(largestDifference(poses, expected.poses) < 1e-3);
});

test('damaged files are refused in one sentence', async () => {
  const whole = readFileSync(join(files, 'human_walk.mcpr'));
  const flipped = Buffer.from(whole);
  flipped[whole.length >> 1] ^= 1;
  for (const bytes of [[], [1, 2, 3], whole.subarray(0, 500), flipped])
    assert.match(await inPage('refusal', [...bytes]), /^MocapressError: [^.]+$/);
});

for (const call of ['load', 'stream'])
  test(`a file that cannot be had from a server is refused in one sentence with its address: ${call}`, async () => {
    const other = createServer((_, response) => response.end(readFileSync(join(files, 'packed.mcpk'))));
    await new Promise((resolve) => other.listen(0, '127.0.0.1', resolve));
    for (const name of ['tiers/human_walk.mcpr', 'packed.mcpk']) {
      const cut = `cut_${basename(name)}`;
      writeFileSync(join(files, cut), readFileSync(join(files, name)).subarray(0, 600));
      writeFileSync(join(files, `empty_${basename(name)}`), '');
      for (const [address, why] of [
        [`files/${cut}`, /: (the file|the bank) [^.]*(cut short|ends)[^.]*$/],
        [`files/empty_${basename(name)}`, /: (not a Mocapress file|the bank is cut short)$/],
        [`files/none${extname(name)}`, /: the server answers 404$/],
        [`pages/${basename(name)}`, /: the server sends a page \(HTML\), not this file$/],
        [`http://127.0.0.1:${other.address().port}/${basename(name)}`, /: cannot be fetched: [^.]+ \(CORS\)$/],
      ]) {
        const refusal = await inPage('refusalOfLoader', call, address);
        assert.ok(refusal.startsWith(`MocapressError: ${address}: `), refusal);
        assert.match(refusal, why);
      }
    }
    other.close();
  });

test('WebAssembly that a server lacks is refused in one sentence', async () => {
  const refusals = await inPage('refusalsOfModules', ['pages/mocapress.wasm', 'files/none.wasm', 'files/human_walk.mcpr']);
  assert.match(refusals[0], /^MocapressError: pages\/mocapress.wasm: the server sends a page \(HTML\), not this file$/);
  assert.match(refusals[1], /^MocapressError: files\/none.wasm: the server answers 404$/);
  assert.match(refusals[2], /^MocapressError: files\/human_walk.mcpr: is no WebAssembly that this machine knows: /);
});

test('the first example of the README shows a character', async () => {
  const readme = readFileSync(join(WEB_PACKAGE, 'README.md'), 'utf8');
  const [example] = /^    import \* as THREE[^]*?(?=\n\S)/m.exec(readme);
  const [importMap] = /^    <script type="importmap">[^]*?<\/script>$/m.exec(readme);
  copyFileSync(join(files, 'character.mcpr'), join(files, 'walk.mcpr'));
  writeFileSync(join(files, 'readme.html'), `<!DOCTYPE html><body style="margin: 0">${importMap}<script type="module">${example}</script>`);
  const reader = await browser.newPage({ viewport: { width: 800, height: 600 } });
  const errors = [];
  reader.on('pageerror', (error) => errors.push(String(error)));
  await reader.goto(`http://127.0.0.1:${server.address().port}/files/readme.html`);
  await reader.waitForSelector('canvas');
  await reader.evaluate(async () => {
    for (let frame = 0; frame < 10; ++frame) await new Promise(requestAnimationFrame);
  });
  const picture = join(WEB_PICTURES, 'readme.png');
  await reader.screenshot({ path: picture });
  await reader.close();
  assert.deepEqual(errors, []);
  assert.ok(readFileSync(picture).length > 4000, 'the picture is not empty');
});

const ofCorpus = (path) => [path.replace(/^.*\/|\.[^.]*$/g, ''), join(corpus, path)];
const rigs = [
  ['character', character],
  ['armature', character, withArmature],
  ofCorpus('gltf/character_meshopt.glb'),
  ofCorpus('strangers/g_base.gltf'),
  ofCorpus('strangers/g_twochars.gltf'),
];
for (const [name, file, changed] of rigs)
  test(`bones of ${name} are where the native runtime has its joints`, { skip: !existsSync(file) }, async () => {
    const model = name + extname(file);
    prepare(model, (changed ?? ((bytes) => bytes))(readFileSync(file)));
    const expected = native(`${name}.mcpr`, 60);
    const { sampled, keyframes } = await inPage(
      'positions',
      `files/${model}`,
      `files/${name}.mcpr`,
      expected.joints.map((joint) => joint.name),
      expected.seconds,
    );
    // A mixer has the poses of a cursor, which differ from decoded ones by up to 2e-3 cm; at frames keyframes are decoded.
    const ofMixer = largestDifference(sampled, positionsOfPoses(expected));
    const ofKeyframes = largestDifference(atFrames(keyframes, expected), atFrames(expected.positions, expected));
    console.log(`${name}: MocapressMixer ${ofMixer.toExponential(1)} cm, AnimationClip ${ofKeyframes.toExponential(1)} cm`);
    assert.ok(ofMixer < 1e-3);
    assert.ok(ofKeyframes < 1e-3);
  });

function positionsOfPoses({ joints, poses, seconds }) {
  const all = Float32Array.from(poses);
  const stride = 8 * joints.length;
  return seconds.flatMap((_, i) => [...worldPositions(joints, all.subarray(stride * i, stride * (i + 1)), 8)]);
}

/** The positions at instants that are frames. */
function atFrames(positions, { seconds, joints, sample_rate }) {
  const isFrame = (second) => Math.abs(second * sample_rate - Math.round(second * sample_rate)) < 1e-3;
  return positions.filter((_, i) => isFrame(seconds[Math.floor(i / (3 * joints.length))]));
}

const morphCube = join(corpus, 'gltf/AnimatedMorphCube.gltf');
test('weights of morph targets are the same sampled and as keyframes', { skip: !existsSync(morphCube) }, async () => {
  copyFileSync(join(corpus, 'gltf/AnimatedMorphCube.bin'), join(files, 'AnimatedMorphCube.bin'));
  prepare('AnimatedMorphCube.gltf', readFileSync(morphCube), '--target-error', '0.5');
  const seconds = [0, 0.5, 1, 1.5, 2, 3];
  const { sampled, keyframes } = await inPage(
    'morphs',
    'files/AnimatedMorphCube.gltf',
    'files/AnimatedMorphCube.mcpr',
    seconds,
  );
  assert.ok(Math.max(...sampled) > 0.5 && Math.min(...sampled) < 0.1, String(sampled));
  assert.ok(largestDifference(sampled, keyframes) < 1e-3);
});

test('a crowd of 200 is sampled within a frame of 60 a second', async () => {
  const one = await inPage('crowd', 'files/character.glb', 'files/character.mcpr', 1, 1);
  await page.screenshot({ path: join(WEB_PICTURES, 'character.png') });
  await page.evaluate(() => document.querySelector('canvas').remove());
  const all = await inPage('crowd', 'files/character.glb', 'files/character.mcpk', 200, 5);
  await page.screenshot({ path: join(WEB_PICTURES, 'crowd.png') });
  const posed = await inPage('crowd', 'files/character.glb', 'files/character.mcpk', 200, 3, false);
  console.log('one character', one, '200 characters', all, 'not drawn', posed);
  assert.ok(one.triangles > 1000 && all.triangles > 200 * 1000);
  // At least, for other programs may run, and drawing without a graphics card takes all processors.
  assert.ok(posed.msAtLeast < 1000 / 60);
});

test('the page had no error', () => assert.deepEqual(pageErrors, []));
