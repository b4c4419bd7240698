// SPDX-License-Identifier: MIT
// Plays clips of Mocapress on characters of three.js. See mocapress_three.d.ts.
import {
  AnimationClip,
  Bone,
  FileLoader,
  Loader,
  Matrix4,
  NumberKeyframeTrack,
  PropertyBinding,
  Quaternion,
  QuaternionKeyframeTrack,
  Skeleton,
  Vector3,
  VectorKeyframeTrack,
} from 'three';
import { MocapressError, named, refused, refusePage, stem, unreachable } from './fetching.js';
import { blendPose, createMocapress } from './mocapress.js';

const metresPerCm = 0.01;

export class MocapressLoader extends Loader {
  #mocapress;
  #module;

  setModule(source) {
    this.#module = source;
    this.#mocapress = undefined;
    return this;
  }

  load(url, onLoad, onProgress, onError) {
    const loader = new FileLoader(this.manager)
      .setPath(this.path)
      .setResponseType('arraybuffer')
      .setRequestHeader(this.requestHeader)
      .setWithCredentials(this.withCredentials);
    const address = this.manager.resolveURL(this.path + url);
    const fail = (error) => {
      if (onError) onError(error);
      else console.error(error);
    };
    const open = async (bytes) => {
      const mocapress = await this.#start();
      refusePage(address, new Uint8Array(bytes));
      return named(address, () => opened(mocapress, bytes, stem(url)));
    };
    loader.load(
      url,
      (bytes) =>
        open(bytes).then(onLoad, (error) => {
          fail(error);
          this.manager.itemError(url);
        }),
      onProgress,
      (error) => fail(error.response ? refused(address, error.response.status) : unreachable(address, error)),
    );
  }

  async streamAsync(url) {
    const mocapress = await this.#start();
    const address = this.manager.resolveURL(this.path + url);
    const options = { headers: this.requestHeader, credentials: this.withCredentials ? 'include' : 'same-origin' };
    const isClip = /\.mcpr$/i.test(address.split(/[?#]/)[0]);
    return new MocapressMotion(await (isClip ? mocapress.streamClip(address, options) : mocapress.streamBank(address, options)), true);
  }

  async parse(bytes, name = '', tiers = 0) {
    return opened(await this.#start(), bytes, name, tiers);
  }

  #start() {
    this.#mocapress ??= createMocapress(this.#module).catch((error) => {
      this.#mocapress = undefined; // the next file tries again
      throw error;
    });
    return this.#mocapress;
  }
}

function opened(mocapress, bytes, name, tiers) {
  const isBank = String.fromCharCode(...new Uint8Array(bytes, 0, Math.min(4, bytes.byteLength))) === 'MCPK';
  return new MocapressMotion(isBank ? mocapress.openBank(bytes) : mocapress.openClip(bytes, name, tiers), isBank);
}

export class MocapressMotion {
  #bank;
  #clips = new Map();
  #coarser = []; // clips that were opened before their finer tiers were loaded

  constructor(opened, isBank) {
    this.#bank = isBank ? opened : undefined;
    if (!isBank) this.#clips.set(opened.name, opened);
    this.names = isBank ? opened.names : [opened.name];
  }

  clip(name = this.names[0]) {
    if (!this.#clips.has(name)) {
      if (!this.#bank) throw new MocapressError(`the file has no clip ${name}`);
      this.#clips.set(name, this.#bank.openClip(name));
    }
    return this.#clips.get(name);
  }

  async load(name = this.names[0], tiers = undefined) {
    const before = this.#bank?.tiersLoaded(name);
    await this.#bank?.load(name, tiers);
    if (this.#clips.has(name) && before < this.#bank?.tiersLoaded(name)) {
      this.#coarser.push(this.#clips.get(name));
      this.#clips.delete(name);
    }
    return this.clip(name);
  }

  animation(name = this.names[0], root = undefined, options = {}) {
    return toAnimationClip(this.clip(name), root, options);
  }

  get animations() {
    return this.names.map((name) => this.animation(name));
  }

  createSkeleton(name = this.names[0], { scale = metresPerCm } = {}) {
    const bones = this.clip(name).joints.map((joint) => {
      const bone = new Bone();
      bone.name = PropertyBinding.sanitizeNodeName(joint.name);
      bone.userData.name = joint.name;
      bone.position.fromArray(joint.offset).multiplyScalar(scale);
      return bone;
    });
    this.clip(name).joints.forEach((joint, j) => bones[joint.parent]?.add(bones[j]));
    for (const bone of bones) if (!bone.parent) bone.updateMatrixWorld(true);
    return new Skeleton(bones);
  }

  dispose() {
    for (const clip of [...this.#clips.values(), ...this.#coarser]) clip.dispose();
    this.#clips.clear();
    this.#coarser = [];
    this.#bank?.dispose();
  }
}

export class MocapressMixer {
  #layers; // players with their shares; usually one, more while a finer clip is blended in
  #joints;
  #weights;

  constructor(root, clip, { scale, loop = true, wrap, bandsLeftOut = 0, timeScale = 1 } = {}) {
    this.root = root;
    this.clip = clip;
    this.time = 0;
    this.timeScale = timeScale;
    this.wrap = wrap ?? (!loop ? 'clamp' : clip.loopFrames > 0 ? 'loop' : 'loopJump');
    this.bandsLeftOut = bandsLeftOut;
    this.#joints = bindJoints(root, clip.joints, scale);
    this.#weights = bindWeights(root, clip.tracks);
    this.#layers = [{ player: clip.createPlayer(), share: 1, seconds: 0 }];
  }

  refine(clip, seconds = 0.2) {
    this.clip = clip;
    this.#layers.push({ player: clip.createPlayer(), share: 0, seconds });
    return this;
  }

  update(seconds) {
    for (const layer of this.#layers) layer.share = layer.seconds > 0 ? Math.min(layer.share + seconds / layer.seconds, 1) : 1;
    const finest = this.#layers.findLastIndex((layer) => layer.share === 1);
    for (const { player } of this.#layers.splice(0, finest)) player.dispose();
    return this.setTime(this.time + seconds * this.timeScale);
  }

  setTime(seconds) {
    this.time = seconds;
    const { clip, wrap, bandsLeftOut } = this;
    const [pose, ...finer] = this.#layers.map(({ player }) => player.sample(seconds, { wrap, bandsLeftOut }));
    finer.forEach((other, i) => blendPose(pose, other, this.#layers[i + 1].share));
    for (const { number, bone, before, place } of this.#joints) {
      const at = 8 * number;
      bone.quaternion.set(pose[at + 1], pose[at + 2], pose[at + 3], pose[at]);
      if (before) bone.quaternion.premultiply(before);
      bone.position.set(pose[at + 4], pose[at + 5], pose[at + 6]).applyMatrix4(place);
    }
    if (this.#weights.length > 0) {
      const values = clip.sampleTracks(seconds, { wrap });
      for (const { number, mesh, target } of this.#weights) mesh.morphTargetInfluences[target] = values[number];
    }
    return this;
  }

  dispose() {
    for (const { player } of this.#layers) player.dispose();
    this.#layers = [];
  }
}

export function toAnimationClip(clip, root = undefined, { scale = metresPerCm } = {}) {
  const times = Float32Array.from({ length: clip.frames }, (_, frame) => frame / clip.sampleRate);
  const frames = clip.decode();
  const stride = 7 * clip.joints.length;
  const bound = root ? bindJoints(root, clip.joints, scale) : unbound(clip.joints, scale);
  const rotation = new Quaternion();
  const origin = new Vector3();
  const tracks = [];
  for (const { number, bone, before, place } of bound) {
    const rotations = new Float32Array(4 * clip.frames);
    const origins = new Float32Array(3 * clip.frames);
    for (let frame = 0; frame < clip.frames; ++frame) {
      const [w, x, y, z, ...translation] = frames.subarray(stride * frame + 7 * number, stride * frame + 7 * number + 7);
      rotation.set(x, y, z, w);
      if (before) rotation.premultiply(before);
      rotation.toArray(rotations, 4 * frame);
      origin.fromArray(translation).applyMatrix4(place).toArray(origins, 3 * frame);
    }
    tracks.push(new QuaternionKeyframeTrack(`${bone.name}.quaternion`, times, rotations));
    const moves = origins.some((value, i) => Math.abs(value - origins[i % 3]) > 1e-6);
    tracks.push(
      new VectorKeyframeTrack(`${bone.name}.position`, moves ? times : [0], moves ? origins : origins.slice(0, 3)),
    );
  }
  const weights = root ? bindWeights(root, clip.tracks) : [];
  const values = weights.map(() => new Float32Array(clip.frames));
  for (let frame = 0; frame < clip.frames && weights.length > 0; ++frame) {
    const sampled = clip.sampleTracks(frame / clip.sampleRate);
    weights.forEach(({ number }, i) => (values[i][frame] = sampled[number]));
  }
  weights.forEach(({ mesh, target }, i) =>
    tracks.push(new NumberKeyframeTrack(`${mesh.uuid}.morphTargetInfluences[${target}]`, times, values[i])),
  );
  return new AnimationClip(clip.name, clip.duration, tracks);
}

/** The joints by their own names, for a character that is not known yet. */
function unbound(joints, scale) {
  const place = new Matrix4().makeScale(scale, scale, scale);
  return joints.map((joint, number) => ({
    number,
    bone: { name: PropertyBinding.sanitizeNodeName(joint.name) },
    before: undefined,
    place,
  }));
}

/**
 * Finds the bone of each joint, and what lies between a joint's parent and the parent of its bone: scales, and nodes
 * that do not move. `before` turns the joint's rotation, `place` moves its origin into the space of the bone's parent.
 */
function bindJoints(root, joints, scale = metresPerCm) {
  root.updateWorldMatrix(true, true);
  const named = nodesByName(root);
  const bones = joints.map((joint) => named(joint.name));
  const fromWorld = root.matrixWorld.clone().invert();
  const placeOf = (node) => fromWorld.clone().multiply(node.matrixWorld);
  const bound = [];
  joints.forEach((joint, number) => {
    const bone = bones[number];
    if (!bone) return;
    const above = bones[joint.parent];
    if (joint.parent >= 0 && !above)
      throw new MocapressError(`the character has no bone ${joints[joint.parent].name}, above ${joint.name}`);
    const parent = bone.parent && bone !== root ? placeOf(bone.parent) : new Matrix4();
    const space = above ? withoutScale(placeOf(above)) : new Matrix4();
    const place = parent.invert().multiply(space);
    const before = new Quaternion();
    place.decompose(new Vector3(), before, new Vector3());
    bound.push({
      number,
      bone,
      before: Math.abs(before.w) > 1 - 1e-9 ? undefined : before,
      place: place.scale(new Vector3(scale, scale, scale)),
    });
  });
  if (bound.length === 0) throw new MocapressError('the character has no bone with the name of a joint of the clip');
  return bound;
}

function bindWeights(root, tracks) {
  const named = nodesByName(root);
  const bound = [];
  tracks.forEach((track, number) => {
    if (track.kind !== 'morphWeight') return;
    named(track.node)?.traverse((mesh) => {
      // A target without a name is target_0 in the clip, and 0 in three.js.
      const targets = mesh.morphTargetDictionary ?? {};
      const target = targets[track.name] ?? targets[track.name.replace(/^target_/, '')];
      if (target !== undefined) bound.push({ number, mesh, target });
    });
  });
  return bound;
}

/** Looks nodes up by the names of their file, by those that three.js made of them, and without a namespace. */
function nodesByName(root) {
  const nodes = new Map();
  const add = (name, node) => nodes.has(name) || nodes.set(name, node);
  root.traverse((node) => add(node.userData.name ?? node.name, node));
  root.traverse((node) => add(node.name, node));
  root.traverse((node) => add((node.userData.name ?? node.name).replace(/^.*:/, ''), node));
  return (name) => nodes.get(name) ?? nodes.get(PropertyBinding.sanitizeNodeName(name));
}

function withoutScale(matrix) {
  const position = new Vector3();
  const rotation = new Quaternion();
  matrix.decompose(position, rotation, new Vector3());
  return matrix.compose(position, rotation, new Vector3(1, 1, 1));
}
