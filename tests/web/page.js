// SPDX-License-Identifier: MIT
// Runs in the page: what web_test.mjs calls by name.
const globalsBefore = Object.getOwnPropertyNames(globalThis).sort().join();
const { createMocapress } = await import('mocapress');
const { MocapressLoader, MocapressMixer } = await import('mocapress/three');
const globalsAfter = Object.getOwnPropertyNames(globalThis).sort().join();
import * as THREE from 'three';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { MeshoptDecoder } from 'three/addons/libs/meshopt_decoder.module.js';
import { clone } from 'three/addons/utils/SkeletonUtils.js';

const loadCharacter = async (url) => (await new GLTFLoader().setMeshoptDecoder(MeshoptDecoder).loadAsync(url)).scene;
const bytesOf = async (url) => (await fetch(url)).arrayBuffer();

function bonesOf(character, names) {
  const bones = new Map();
  character.traverse((node) => bones.set(node.userData.name ?? node.name, node));
  return names.map((name) => bones.get(name));
}

/** World positions of bones in centimetres, relative to the character. */
function positionsOf(character, bones) {
  character.updateMatrixWorld(true);
  const toCharacter = character.matrixWorld.clone().invert();
  const origin = new THREE.Vector3();
  return bones.flatMap((bone) =>
    origin.setFromMatrixPosition(bone.matrixWorld).applyMatrix4(toCharacter).multiplyScalar(100).toArray(),
  );
}

const page = {
  leavesNoGlobals: () => globalsBefore === globalsAfter,

  /** Poses and times of a clip, by one of the modules. */
  async poses(module, url, seconds) {
    const mocapress = await createMocapress(module ? new URL(module, location) : undefined);
    const clip = mocapress.openClip(await bytesOf(url));
    const poses = seconds.flatMap((second) => [...clip.sample(second)]);
    const timed = (instant) => {
      let least = Infinity; // of many rounds, for other programs may run
      for (let round = 0; round < 100; ++round) {
        const start = performance.now();
        for (let i = 0; i < 1200; ++i) clip.sample(instant(i));
        least = Math.min(least, ((performance.now() - start) * 1000) / 1200);
      }
      return least;
    };
    return {
      poses,
      usPlaying: timed((i) => ((i % 600) / 599) * clip.duration),
      usRandom: timed(() => Math.random() * clip.duration),
    };
  },

  async posesOfBank(module, url, name, seconds) {
    const mocapress = await createMocapress(module ? new URL(module, location) : undefined);
    const bank = mocapress.openBank(await bytesOf(url));
    const clip = bank.openClip(name);
    return { names: bank.names, poses: seconds.flatMap((second) => [...clip.sample(second)]) };
  },

  /** Poses of a file of which only the first tiers are there, and the refusal of one byte less. */
  async posesOfTiers(url, seconds) {
    const mocapress = await createMocapress();
    const bytes = new Uint8Array(await bytesOf(url));
    const tiers = mocapress.tiersOf(bytes.subarray(0, 133));
    return tiers.map((tier, t) => {
      const clip = mocapress.openClip(bytes.subarray(0, tier.bytes), 'clip', t + 1);
      const poses = seconds.flatMap((second) => [...clip.sample(second)]);
      clip.dispose();
      let refusal = '';
      try {
        mocapress.openClip(bytes.subarray(0, tier.bytes - 1), 'clip', t + 1);
      } catch (error) {
        refusal = `${error.name}: ${error.message}`;
      }
      return { tier, poses, refusal };
    });
  },

  async posesOfStream(url, name, seconds, twice = true) {
    const bank = await (await createMocapress()).streamBank(url, { cache: 'no-store' });
    const loads = !bank.isLoaded(name);
    let early = '';
    try {
      bank.openClip(name);
    } catch (error) {
      early = `${error.name}: ${error.message}`;
    }
    await Promise.all([bank.load(name), bank.load(name)]);
    const posesOf = (clip) => seconds.flatMap((second) => [...clip.sample(second)]);
    const poses = posesOf(bank.openClip(name));
    if (!twice) return { loads, poses };
    const motion = await new MocapressLoader().streamAsync(url);
    return { loads, poses, again: posesOf(await motion.load(name)), early };
  },

  async refusalOfStream(url, name) {
    let call = 'streamBank';
    try {
      const bank = await (await createMocapress()).streamBank(url, { cache: 'no-store' });
      call = 'load';
      await bank.load(name);
      return 'nothing was refused';
    } catch (error) {
      return `${call}: ${error.name}: ${error.message}`;
    }
  },

  /** Names and poses of a file that MocapressLoader opens in each of its ways. */
  async posesByLoader(url, seconds) {
    const loader = new MocapressLoader();
    const motions = [
      await new Promise((onLoad, onError) => loader.load(url, onLoad, undefined, onError)),
      await loader.loadAsync(url),
      await loader.parse(await bytesOf(url), 'parsed'),
    ];
    return motions.map((motion) => ({
      names: motion.names,
      poses: seconds.flatMap((second) => [...motion.clip().sample(second)]),
      tracks: motion.animations[0].tracks.length,
    }));
  },

  /** The refusal of a file by MocapressLoader, which loads or streams it. */
  async refusalOfLoader(call, url) {
    try {
      const motion = await new MocapressLoader()[`${call}Async`](url);
      await motion.load();
      return 'nothing was refused';
    } catch (error) {
      return `${error.name}: ${error.message}`;
    }
  },

  /** Refusals of files that are not WebAssembly. */
  async refusalsOfModules(urls) {
    const refusals = [];
    for (const url of urls)
      await new MocapressLoader().setModule(url).loadAsync('files/human_walk.mcpr').catch((error) => refusals.push(`${error.name}: ${error.message}`));
    return refusals;
  },

  async refusal(bytes) {
    const mocapress = await createMocapress();
    try {
      mocapress.openClip(new Uint8Array(bytes));
      return 'nothing was refused';
    } catch (error) {
      return `${error.name}: ${error.message}`;
    }
  },

  posesInWorker(url, seconds) {
    const worker = new Worker('worker.js', { type: 'module' });
    return new Promise((resolve, reject) => {
      worker.onmessage = (event) => resolve(event.data);
      worker.onerror = reject;
      worker.postMessage({ url, seconds });
    });
  },

  /** Where the bones of a character are, by a MocapressMixer, and by three.js playing an AnimationClip. */
  async positions(characterUrl, motionUrl, names, seconds) {
    const character = await loadCharacter(characterUrl);
    character.position.set(3, 1, 2);
    character.scale.setScalar(1.5);
    const motion = await new MocapressLoader().loadAsync(motionUrl);
    const bones = bonesOf(character, names);
    const sampling = new MocapressMixer(character, motion.clip(), { loop: false });
    const sampled = seconds.flatMap((second) => {
      sampling.setTime(second);
      return positionsOf(character, bones);
    });
    const playing = new THREE.AnimationMixer(character);
    const action = playing.clipAction(motion.animation(undefined, character));
    action.setLoop(THREE.LoopOnce);
    action.clampWhenFinished = true;
    action.play();
    const keyframes = seconds.flatMap((second) => {
      playing.setTime(second);
      return positionsOf(character, bones);
    });
    return { sampled, keyframes };
  },

  /** Where the bones of a character are by a MocapressMixer at some instants, each with its wrap. */
  async wrapped(characterUrl, motionUrl, names, instants) {
    const character = await loadCharacter(characterUrl);
    const motion = await new MocapressLoader().loadAsync(motionUrl);
    const bones = bonesOf(character, names);
    return instants.map(({ seconds, options }) => {
      new MocapressMixer(character, motion.clip(), options).setTime(seconds).dispose();
      return positionsOf(character, bones);
    });
  },

  /** Plays a streamed clip by its first tier, then goes over to all: positions as shown, by the first tier and by all. */
  async refined(characterUrl, bankUrl, name, names, frames, seconds) {
    const character = await loadCharacter(characterUrl);
    const bones = bonesOf(character, names);
    const motion = await new MocapressLoader().streamAsync(bankUrl);
    const coarse = await motion.load(name, 1);
    const all = await motion.load(name);
    const [shown, ofCoarse, ofAll] = [coarse, coarse, all].map((clip) => new MocapressMixer(character, clip));
    const poses = [];
    for (let frame = 0; frame < frames; ++frame) {
      if (frame === 1) shown.refine(all, seconds);
      poses.push([ofCoarse, ofAll, shown].map((mixer) => (mixer.update(1 / 60), positionsOf(character, bones))));
    }
    return poses;
  },

  /** Weights of morph targets, by a MocapressMixer, and by three.js playing an AnimationClip. */
  async morphs(modelUrl, motionUrl, seconds) {
    const model = await loadCharacter(modelUrl);
    const motion = await new MocapressLoader().loadAsync(motionUrl);
    const weights = () => {
      const all = [];
      model.traverse((mesh) => all.push(...(mesh.morphTargetInfluences ?? [])));
      return all;
    };
    const sampling = new MocapressMixer(model, motion.clip(), { loop: false });
    const sampled = seconds.flatMap((second) => {
      sampling.setTime(second);
      return weights();
    });
    const playing = new THREE.AnimationMixer(model);
    playing.clipAction(motion.animation(undefined, model)).play();
    const keyframes = seconds.flatMap((second) => {
      playing.setTime(second);
      return weights();
    });
    return { sampled, keyframes };
  },

  /**
   * Shows a crowd for some seconds; returns frames a second and milliseconds of sampling a frame. Without drawing it is
   * posed to the last bone, but not rendered: by a processor alone that takes far longer than all else.
   */
  async crowd(characterUrl, motionUrl, count, seconds, draws = true) {
    const character = await loadCharacter(characterUrl);
    const motion = await new MocapressLoader().loadAsync(motionUrl);
    const renderer = new THREE.WebGLRenderer({ antialias: true, preserveDrawingBuffer: true });
    renderer.setSize(innerWidth, innerHeight);
    document.body.append(renderer.domElement);
    const scene = new THREE.Scene();
    scene.background = new THREE.Color(0xdfe3e6);
    scene.add(new THREE.HemisphereLight(0xffffff, 0x777066, 2.5));
    const sun = new THREE.DirectionalLight(0xffffff, 2);
    sun.position.set(4, 8, 6);
    scene.add(sun, new THREE.GridHelper(60, 30, 0xaaaaaa, 0xcccccc));
    const camera = new THREE.PerspectiveCamera(45, innerWidth / innerHeight, 0.1, 200);
    const across = Math.ceil(Math.sqrt(count));
    const mixers = Array.from({ length: count }, (_, i) => {
      const one = clone(character);
      one.position.set(((i % across) - across / 2) * 1.6, 0, -Math.floor(i / across) * 1.6);
      scene.add(one);
      const mixer = new MocapressMixer(one, motion.clip(motion.names[i % motion.names.length]));
      return mixer.update(i * 0.137);
    });
    if (count === 1) camera.position.set(2.2, 1.6, 1);
    else camera.position.set(0, 6, 9);
    camera.lookAt(count === 1 ? new THREE.Vector3(0.3, 0.9, -1.5) : new THREE.Vector3(0, 0, -8));
    let sampling = 0;
    let least = Infinity;
    let frames = 0;
    const start = performance.now();
    await new Promise((resolve) =>
      renderer.setAnimationLoop(() => {
        const before = performance.now();
        for (const mixer of mixers) mixer.update(1 / 60);
        const taken = performance.now() - before;
        sampling += taken;
        least = Math.min(least, taken);
        if (draws) renderer.render(scene, camera);
        else scene.updateMatrixWorld();
        ++frames;
        if (performance.now() - start >= seconds * 1000) {
          renderer.setAnimationLoop(null);
          resolve();
        }
      }),
    );
    return {
      framesASecond: (frames * 1000) / (performance.now() - start),
      msOfSampling: sampling / frames,
      msAtLeast: least,
      triangles: renderer.info.render.triangles,
    };
  },
};

globalThis.page = page;
