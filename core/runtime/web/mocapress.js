// SPDX-License-Identifier: MIT
// Plays .mcpr files and .mcpk banks of Mocapress in a page, a worker or Node. See mocapress.d.ts.
import { fetchFile, MocapressError, named, partsOf, rangesOf, stem } from './fetching.js';

export { MocapressError, stem };

/** A module of one instruction that only machines with SIMD128 know. */
const simdProbe = new Uint8Array([
  0, 97, 115, 109, 1, 0, 0, 0, 1, 5, 1, 96, 0, 1, 123, 3, 2, 1, 0, 10, 10, 1, 8, 0, 65, 0, 253, 15, 253, 98, 11,
]);

const headBytes = 104; // MCPK_HEAD_BYTES

const tiersHeadBytes = 133; // MCPR_TIERS_HEAD_BYTES

const wraps = ['clamp', 'loop', 'pingPong', 'loopJump', 'loopBlend', 'loopHold']; // mcpr_wrap

const trackKinds = ['property', 'morphWeight', 'scaleX', 'scaleY', 'scaleZ'];

/** The file that plays everything here: with SIMD where the machine has it. */
export function defaultModule() {
  return WebAssembly.validate(simdProbe)
    ? new URL('./mocapress.wasm', import.meta.url)
    : new URL('./mocapress_plain.wasm', import.meta.url);
}

async function moduleBytes(source) {
  if (!(source instanceof URL) && typeof source !== 'string') return source;
  if (new URL(source, import.meta.url).protocol === 'file:' && typeof process !== 'undefined') {
    const { readFile } = await import(/* webpackIgnore: true */ /* @vite-ignore */ 'node:fs/promises');
    return readFile(new URL(source, import.meta.url));
  }
  return fetchFile(source);
}

async function compile(source) {
  const bytes = await moduleBytes(source);
  return WebAssembly.compile(bytes).catch((cause) => {
    const name = bytes === source ? 'the module' : source;
    throw new MocapressError(`${name}: is no WebAssembly that this machine knows: ${cause.message}`, { cause });
  });
}

export async function createMocapress(source = defaultModule()) {
  const module = source instanceof WebAssembly.Module ? source : await compile(source);
  const noticeOfGrowth = { emscripten_notify_memory_growth() {} };
  const instance = await WebAssembly.instantiate(module, { env: noticeOfGrowth });
  instance.exports._initialize?.();
  return new Mocapress(instance.exports);
}

export class Mocapress {
  #exports;

  constructor(exports) {
    this.#exports = exports;
  }

  openClip(bytes, name = '', tiers = 0) {
    const memory = this.#copy(bytes);
    try {
      return new Clip(this.#exports, this.#decoder('web_open')(memory, bytes.byteLength, tiers), name);
    } finally {
      this.#exports.web_free(memory);
    }
  }

  tiersOf(bytes) {
    const memory = this.#copy(bytes);
    try {
      const count = this.#decoder('web_tiers')(memory, bytes.byteLength);
      if (count < 0) throw lastError(this.#exports);
      return Array.from({ length: count }, (_, tier) => {
        const numbers = this.#exports.web_tier(memory, bytes.byteLength, tier);
        const [bytesOfTier, error, maxError] = new Float64Array(this.#exports.memory.buffer, numbers, 3);
        return { bytes: bytesOfTier, error, maxError };
      });
    } finally {
      this.#exports.web_free(memory);
    }
  }

  async streamClip(url, options) {
    const start = await rangesOf(url, options)(0, tiersHeadBytes);
    const tiers = named(url, () => this.tiersOf(start));
    const isStart = tiers.length === 0 && start.length === tiersHeadBytes; // without tiers it comes as a whole
    const bytes = isStart ? await fetchFile(url, options) : start;
    return new StreamedClip(this, stem(url), tiers, bytes, partsOf(url, options));
  }

  openBank(bytes) {
    const memory = this.#copy(bytes);
    const bank = this.#exports.web_open_bank(memory, bytes.byteLength);
    if (bank === 0) {
      this.#exports.web_free(memory);
      throw lastError(this.#exports);
    }
    return new Bank(this.#exports, bank);
  }

  async streamBank(url, options) {
    const exports = this.#exports;
    const fetchPart = partsOf(url, options);
    const head = await rangesOf(url, options)(0, headBytes);
    if (head.byteLength !== headBytes) return named(url, () => this.openBank(head)); // the whole bank
    const ofHead = this.#copy(head);
    let memory = 0;
    try {
      const bank = named(url, () => opened(exports, exports.web_open_head(ofHead)));
      const [offset, bytes] = placeIn(exports, bank, exports.web_bank_clips(bank));
      const size = exports.web_bank_bytes(bank);
      const shared = await fetchPart(offset, bytes);
      memory = this.#allocate(size);
      write(exports, memory, head);
      write(exports, memory + offset, shared);
      named(url, () => opened(exports, exports.web_open_shared(memory, size)));
      return new Bank(exports, memory, url, fetchPart);
    } catch (error) {
      exports.web_free(memory);
      throw error;
    } finally {
      exports.web_free(ofHead);
    }
  }

  /** Copies bytes to where the runtime reads them. */
  #copy(bytes) {
    const memory = this.#allocate(bytes.byteLength);
    write(this.#exports, memory, bytes);
    return memory;
  }

  #allocate(bytes) {
    return allocate(this.#exports, bytes, 'file');
  }

  #decoder(name) {
    return decoderOf(this.#exports, name);
  }
}

export class Bank {
  #exports;
  #bank;
  #numbers = new Map();
  #url;
  #fetchPart;
  #loads = new Map();
  #tiersLoaded = new Map();

  constructor(exports, bank, url, fetchPart) {
    this.#exports = exports;
    this.#bank = bank;
    this.#url = url;
    this.#fetchPart = fetchPart;
    for (let i = 0; i < exports.web_bank_clips(bank); ++i)
      this.#numbers.set(textAt(exports, exports.web_bank_name(bank, i)), i);
    this.names = [...this.#numbers.keys()];
    this.isCooked = exports.web_bank_is_cooked(bank) !== 0;
    this.tiers = exports.web_bank_tiers(bank);
  }

  async load(name, tiers = this.tiers) {
    const number = this.#number(name);
    while (this.tiersLoaded(name) < Math.min(tiers, this.tiers)) {
      if (!this.#loads.has(number))
        this.#loads.set(number, this.#loadNext(number).finally(() => this.#loads.delete(number)));
      await this.#loads.get(number);
    }
  }

  tiersLoaded(name) {
    const number = this.#number(name);
    return this.#fetchPart ? (this.#tiersLoaded.get(number) ?? 0) : this.tiers;
  }

  isLoaded(name) {
    return this.tiersLoaded(name) > 0;
  }

  openClip(name, tiers = this.tiersLoaded(name)) {
    if (!(tiers > 0 && tiers <= this.tiersLoaded(name)))
      throw new MocapressError(`the clip ${name} is not there yet: load() gets it`);
    const open = this.isCooked ? this.#exports.web_open_cooked : decoderOf(this.#exports, 'web_open_packed');
    return new Clip(this.#exports, open(this.#bank, this.#number(name), tiers), name);
  }

  tags(name) {
    const number = this.#number(name);
    const tags = [];
    for (let tag; (tag = this.#exports.web_bank_tag(this.#bank, number, tags.length)) !== 0; )
      tags.push(textAt(this.#exports, tag));
    return tags;
  }

  dispose() {
    this.#exports.web_free(this.#bank);  // the bank is its bytes
    this.#bank = 0;
  }

  /** Loads a clip's next tier. */
  async #loadNext(number) {
    const tier = this.#tiersLoaded.get(number) ?? 0;
    const [offset, bytes] = placeIn(this.#exports, this.#bank, number, tier);
    if (bytes > 0) {
      const part = await this.#fetchPart(offset, bytes);
      if (this.#bank === 0) throw new MocapressError('the bank was disposed of');
      write(this.#exports, this.#bank + offset, part);
    }
    named(this.#url, () => opened(this.#exports, this.#exports.web_check(this.#bank, number)));
    this.#tiersLoaded.set(number, tier + 1);
  }

  #number(name) {
    if (this.#bank === 0) throw new MocapressError('the bank was disposed of');
    const number = this.#numbers.get(name);
    if (number === undefined) throw new MocapressError(`the bank has no clip ${name}`);
    return number;
  }
}

export class StreamedClip {
  #mocapress;
  #fetchPart;
  #bytes; // of the file's start, as far as they have come
  #loading;
  #tierInfo;

  constructor(mocapress, name, tiers, bytes, fetchPart) {
    this.#mocapress = mocapress;
    this.#bytes = bytes;
    this.#fetchPart = fetchPart;
    this.#tierInfo = tiers.length > 0 ? tiers : [{ bytes: bytes.length, error: 0, maxError: 0 }];
    this.names = [name];
    this.isCooked = false;
    this.tiers = this.#tierInfo.length;
  }

  tier(number) {
    return this.#tierInfo[number];
  }

  async load(name = this.names[0], tiers = this.tiers) {
    this.#check(name);
    while (this.tiersLoaded() < Math.min(tiers, this.tiers)) {
      this.#loading ??= this.#loadNext().finally(() => (this.#loading = undefined));
      await this.#loading;
    }
  }

  tiersLoaded(name = this.names[0]) {
    this.#check(name);
    return this.#tierInfo.filter((tier) => tier.bytes <= this.#bytes.length).length;
  }

  isLoaded(name) {
    return this.tiersLoaded(name) > 0;
  }

  openClip(name = this.names[0], tiers = this.tiersLoaded(name)) {
    if (!(tiers > 0 && tiers <= this.tiersLoaded(name)))
      throw new MocapressError(`the clip ${name} is not there yet: load() gets it`);
    return this.#mocapress.openClip(this.#bytes.subarray(0, this.tier(tiers - 1).bytes), name, tiers);
  }

  tags(name) {
    this.#check(name);
    return [];
  }

  dispose() {
    this.#bytes = undefined;
  }

  async #loadNext() {
    const { length } = this.#bytes;
    const end = this.tier(this.tiersLoaded()).bytes;
    const part = await this.#fetchPart(length, end - length);
    if (this.#bytes === undefined) throw new MocapressError('the clip was disposed of');
    const bytes = new Uint8Array(end);
    bytes.set(this.#bytes);
    bytes.set(part, length);
    this.#bytes = bytes;
  }

  #check(name) {
    if (this.#bytes === undefined) throw new MocapressError('the clip was disposed of');
    if (name !== this.names[0]) throw new MocapressError(`the file has no clip ${name}`);
  }
}

export class Clip {
  #exports;
  #clip;
  #players = new Set();
  #own;

  constructor(exports, clip, name) {
    if (clip === 0) throw lastError(exports);
    this.#exports = exports;
    this.#clip = clip;
    this.name = name;
    const dimensions = new Float64Array(exports.memory.buffer, exports.web_dimensions(clip), 5);
    const [sampleRate, frames, joints, loopFrames, tracks] = dimensions;
    this.sampleRate = sampleRate;
    this.frames = frames;
    this.loopFrames = loopFrames;
    this.duration = (frames - 1) / sampleRate;
    this.joints = Array.from({ length: joints }, (_, j) => this.#joint(j));
    this.tracks = Array.from({ length: tracks }, (_, t) => this.#track(t));
  }

  createPlayer() {
    const player = new Player(this.#exports, this.#open(), this, () => this.#players.delete(player));
    this.#players.add(player);
    return player;
  }

  sample(seconds, options) {
    this.#own ??= this.createPlayer();
    return this.#own.sample(seconds, options);
  }

  positions(seconds, options) {
    this.#own ??= this.createPlayer();
    return this.#own.positions(seconds, options);
  }

  decode(first = 0, count = this.frames - first) {
    const clip = this.#open();
    if (!(first >= 0 && count >= 0 && first + count <= this.frames))
      throw new MocapressError(`the clip has ${this.frames} frames, not ${first} to ${first + count - 1}`);
    const values = 7 * this.joints.length * count;
    if (!this.#exports.web_is_decoded?.(clip)) return this.#sampledFrames(first, count);
    const memory = allocate(this.#exports, 4 * values, 'frames');
    try {
      if (this.#exports.web_decode(clip, first, count, memory) === 0) throw lastError(this.#exports);
      return new Float32Array(this.#exports.memory.buffer, memory, values).slice();
    } finally {
      this.#exports.web_free(memory);
    }
  }

  sampleTracks(seconds, { loop = false, wrap = loop ? 'loop' : 'clamp' } = {}) {
    const frame = nearFrame(seconds * this.sampleRate);
    const number = numberOfWrap(wrap);
    if (this.tracks.length === 0) return new Float32Array(0);
    const values = this.#exports.web_sample_tracks(this.#open(), frame, number);
    if (values === 0) throw lastError(this.#exports);
    return new Float32Array(this.#exports.memory.buffer, values, this.tracks.length);
  }

  dispose() {
    for (const player of [...this.#players]) player.dispose();
    if (this.#clip !== 0) this.#exports.web_close(this.#clip);
    this.#clip = 0;
    this.#own = undefined;
  }

  #open() {
    if (this.#clip === 0) throw new MocapressError('the clip was disposed of');
    return this.#clip;
  }

  #joint(number) {
    const record = this.#exports.web_joint(this.#clip, number);
    if (record === 0) throw lastError(this.#exports);
    const view = new DataView(this.#exports.memory.buffer, record, 36);
    const vector = (at) => [0, 4, 8].map((i) => view.getFloat32(at + i, true));
    return {
      name: textAt(this.#exports, view.getUint32(0, true)),
      parent: view.getInt32(4, true),
      offset: vector(8),
      endSite: view.getInt32(20, true) !== 0 ? vector(24) : undefined,
    };
  }

  #track(number) {
    const record = this.#exports.web_track(this.#clip, number);
    if (record === 0) throw lastError(this.#exports);
    const [kind, node, name, steps] = new Uint32Array(this.#exports.memory.buffer, record, 4);
    return {
      kind: trackKinds[kind],
      node: textAt(this.#exports, node),
      name: textAt(this.#exports, name),
      steps: steps !== 0,
    };
  }

  #sampledFrames(first, count) {
    const joints = this.joints.length;
    const out = new Float32Array(7 * joints * count);
    for (let i = 0, to = 0; i < count; ++i) {
      const pose = this.sample((first + i) / this.sampleRate);
      for (let j = 0; j < joints; ++j, to += 7) out.set(pose.subarray(8 * j, 8 * j + 7), to);
    }
    return out;
  }
}

export class Player {
  #exports;
  #player;
  #forget;
  #positions;

  constructor(exports, clip, owner, forget) {
    this.#exports = exports;
    this.#player = exports.web_play(clip);
    this.#forget = forget;
    this.clip = owner;
    if (this.#player === 0) throw lastError(exports);
  }

  sample(seconds, { loop = false, wrap = loop ? 'loop' : 'clamp', bandsLeftOut = 0 } = {}) {
    if (this.#player === 0) throw new MocapressError('the player was disposed of');
    const pose = this.#exports.web_sample(this.#player, seconds, numberOfWrap(wrap), bandsLeftOut);
    if (pose === 0) throw lastError(this.#exports);
    return new Float32Array(this.#exports.memory.buffer, pose, 8 * this.clip.joints.length);
  }

  positions(seconds, options) {
    return worldPositions(this.clip.joints, this.sample(seconds, options), 8);
  }

  dispose() {
    if (this.#player !== 0) this.#exports.web_stop(this.#player);
    this.#player = 0;
    this.#forget();
  }
}

export function blendPose(pose, other, share) {
  for (let at = 0; at < pose.length; at += 8) {
    let dot = 0;
    for (let i = at; i < at + 4; ++i) dot += pose[i] * other[i];
    const kept = dot < 0 ? share - 1 : 1 - share;
    const rotation = [0, 1, 2, 3].map((i) => kept * pose[at + i] + share * other[at + i]);
    const length = Math.hypot(...rotation);
    for (let i = 0; i < 4; ++i) pose[at + i] = rotation[i] / length;
    for (let i = at + 4; i < at + 7; ++i) pose[i] += share * (other[i] - pose[i]);
  }
  return pose;
}

export function worldPositions(joints, pose, stride = 7) {
  const rotations = new Float64Array(4 * joints.length);
  const positions = new Float32Array(3 * joints.length);
  for (let j = 0; j < joints.length; ++j) {
    const p = joints[j].parent;
    const [w, x, y, z, tx, ty, tz] = pose.subarray(stride * j, stride * j + 7);
    if (p < 0) {
      rotations.set([w, x, y, z], 4 * j);
      positions.set([tx, ty, tz], 3 * j);
      continue;
    }
    const [a, b, c, d] = rotations.subarray(4 * p, 4 * p + 4);
    rotations.set(
      [
        a * w - b * x - c * y - d * z,
        a * x + b * w + c * z - d * y,
        a * y - b * z + c * w + d * x,
        a * z + b * y - c * x + d * w,
      ],
      4 * j,
    );
    // v' = v + 2 q x (q x v + a v)
    const ux = c * tz - d * ty + a * tx;
    const uy = d * tx - b * tz + a * ty;
    const uz = b * ty - c * tx + a * tz;
    positions[3 * j] = positions[3 * p] + tx + 2 * (c * uz - d * uy);
    positions[3 * j + 1] = positions[3 * p + 1] + ty + 2 * (d * ux - b * uz);
    positions[3 * j + 2] = positions[3 * p + 2] + tz + 2 * (b * uy - c * ux);
  }
  return positions;
}

function placeIn(exports, bank, number, tier = 0) {
  const place = exports.web_place(bank, number, tier);
  if (place === 0) throw lastError(exports);
  return new Float64Array(exports.memory.buffer, place, 2);
}

function numberOfWrap(wrap) {
  const number = wraps.indexOf(wrap);
  if (number < 0) throw new MocapressError(`there is no wrap ${wrap}, but ${wraps.join(', ')}`);
  return number;
}

/** Bytes for what is named, which is told where there are none: the module takes sizes below 2 GiB. */
function allocate(exports, bytes, what) {
  const memory = bytes < 2 ** 31 ? exports.web_allocate(bytes) : 0;
  if (memory === 0) throw new MocapressError(`there is not enough memory for the ${what}`);
  return memory;
}

/** A frame that rounding missed is meant, as the runtime has it for poses. */
function nearFrame(frame) {
  const near = Math.round(frame);
  return Math.abs(frame - near) < 2 ** -16 ? near : frame;
}

/** Copies bytes into the module's memory. */
function write(exports, address, bytes) {
  const view = ArrayBuffer.isView(bytes)
    ? new Uint8Array(bytes.buffer, bytes.byteOffset, bytes.byteLength)
    : new Uint8Array(bytes);
  new Uint8Array(exports.memory.buffer, address, view.length).set(view);
}

function decoderOf(exports, name) {
  if (exports[name] === undefined)
    throw new MocapressError('this module plays cooked banks only: mocapress.wasm plays the others');
  return exports[name];
}

/** Passes on what a call of the module gives, an address or 1, and throws where it failed. */
function opened(exports, address) {
  if (address === 0) throw lastError(exports);
  return address;
}

function lastError(exports) {
  return new MocapressError(textAt(exports, exports.web_error()));
}

/** The text that ends with a zero. */
function textAt(exports, address) {
  const bytes = new Uint8Array(exports.memory.buffer);
  return new TextDecoder().decode(bytes.subarray(address, bytes.indexOf(0, address)));
}
