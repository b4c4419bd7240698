// SPDX-License-Identifier: MIT
// Uses every export of the npm package once. It is compiled strictly, and never runs.
import * as THREE from 'three';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { MocapressLoader, MocapressMixer, MocapressMotion, toAnimationClip, type MixerOptions, type ScaleOptions } from 'mocapress/three';
import { Bank, Clip, Mocapress, MocapressError, Player, StreamedClip, blendPose, createMocapress, defaultModule, stem, worldPositions,
  type Joint, type SampleOptions, type Tier, type Track, type Wrap, type WrapOptions } from 'mocapress';

export async function plain(): Promise<number> {
  const module: URL = defaultModule();
  const mocapress: Mocapress = await createMocapress(module);
  const bytes: ArrayBuffer = await (await fetch('walk.mcpr')).arrayBuffer();
  const clip: Clip = mocapress.openClip(new Uint8Array(bytes), stem('a/walk.mcpr'), 1);
  const tiers: Tier[] = mocapress.tiersOf(bytes);
  const wrap: Wrap = 'pingPong';
  const options: SampleOptions = { wrap, bandsLeftOut: 1, loop: false };
  const wrapOptions: WrapOptions = { wrap };
  const player: Player = clip.createPlayer();
  const pose: Float32Array = player.sample(0.5, options);
  const joints: Joint[] = player.clip.joints;
  const tracks: Track[] = clip.tracks;
  blendPose(pose, clip.sample(1), 0.5);
  const places: Float32Array = worldPositions(joints, pose, 8);
  const frames = clip.decode(0, 1);
  const values = clip.sampleTracks(0, wrapOptions);
  const bank: Bank = await mocapress.streamBank(new URL('https://x/y.mcpk'), { credentials: 'include' });
  await bank.load('run', 1);
  const run = bank.openClip('run', bank.tiersLoaded('run'));
  const streamed: StreamedClip = await mocapress.streamClip('run.mcpr');
  await streamed.load();
  const tier: Tier = streamed.tier(0);
  const again = streamed.openClip();
  for (const end of [clip, run, again, bank, streamed, player]) end.dispose();
  console.log(bank.isCooked, bank.tags('run'), streamed.isCooked, mocapress.openBank(bytes).names, clip.positions(1).length);
  return tiers.length + frames.length + values.length + tracks.length + places.length + tier.bytes;
}

export async function three(scene: THREE.Scene): Promise<void> {
  const { scene: character } = await new GLTFLoader().loadAsync('character.glb');
  const loader = new MocapressLoader(THREE.DefaultLoadingManager).setModule('x.wasm').setPath('x/').setRequestHeader({ a: 'b' }).setWithCredentials(true);
  const motion: MocapressMotion = await loader.loadAsync('walk.mcpr', (event) => console.log(event.loaded));
  loader.load('walk.mcpr', (loaded) => loaded.dispose(), undefined, (error) => { if (error instanceof MocapressError) console.log(error.message); });
  const scale: ScaleOptions = { scale: 0.01 };
  const options: MixerOptions = { ...scale, loop: true, wrap: 'loopBlend', bandsLeftOut: 1, timeScale: 2 };
  const mixer: MocapressMixer = new MocapressMixer(character, motion.clip(), options);
  mixer.update(0.1).setTime(1).refine(await motion.load('run', 2), 0.2);
  const animation: THREE.AnimationClip = toAnimationClip(motion.clip(), character, scale);
  const all: THREE.AnimationClip[] = motion.animations;
  const skeleton: THREE.Skeleton = motion.createSkeleton();
  scene.add(new THREE.SkeletonHelper(skeleton.bones[0]!));
  const streamed = await loader.streamAsync('moves.mcpk');
  const parsed = await loader.parse(await (await fetch('walk.mcpr')).arrayBuffer(), 'walk', 1);
  mixer.dispose();
  console.log(animation, all, streamed.names, parsed.animation('walk', character), mixer.time, mixer.clip, mixer.root);
}
