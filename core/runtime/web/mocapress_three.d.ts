// SPDX-License-Identifier: MIT
// Plays clips of Mocapress on characters of three.js. Joints find bones by name: the character is the one that the
// motion was made for, or has its bones with the same rest poses. `scale` is in units of the scene for a centimetre;
// 0.01, the default, is for glTF's metres.
import type { AnimationClip, Loader, LoadingManager, Object3D, Skeleton } from 'three';
import type { Clip, Wrap } from './mocapress.js';

export interface ScaleOptions {
  scale?: number;
}

/** Loads .mcpr files and .mcpk banks. */
export class MocapressLoader extends Loader<MocapressMotion> {
  constructor(manager?: LoadingManager);
  /** Where the WebAssembly is, or what it is; without a call, beside the module. */
  setModule(source: URL | string | BufferSource | WebAssembly.Module): this;
  load(
    url: string,
    onLoad: (motion: MocapressMotion) => void,
    onProgress?: (event: ProgressEvent) => void,
    onError?: (error: unknown) => void,
  ): void;
  /**
   * Opens a file on a server without its clips, which MocapressMotion.load() gets one by one: a bank, or a .mcpr whose
   * tiers come one after the other.
   */
  streamAsync(url: string): Promise<MocapressMotion>;
  /** WebAssembly is compiled in the background, so the first call takes a moment. */
  parse(bytes: ArrayBuffer, name?: string, tiers?: number): Promise<MocapressMotion>;
}

/** The clips of a file or a bank. Clips are opened when first asked for; no name is the first clip's. */
export class MocapressMotion {
  private constructor();
  readonly names: string[];
  clip(name?: string): Clip;
  /**
   * The clip, after it was loaded from the server if the file is streamed: all of it, or its first tiers. The clip of
   * finer tiers is another one, for MocapressMixer.refine().
   */
  load(name?: string, tiers?: number): Promise<Clip>;
  /** The clip as keyframes: for the bones of `root`, or for bones named as its joints. */
  animation(name?: string, root?: Object3D, options?: ScaleOptions): AnimationClip;
  /** All clips as keyframes, made anew at each call. For large banks, ask for single ones. */
  readonly animations: AnimationClip[];
  /** Bones for a clip without a character. */
  createSkeleton(name?: string, options?: ScaleOptions): Skeleton;
  /** Frees the file. AnimationClips stay. */
  dispose(): void;
}

export interface MixerOptions extends ScaleOptions {
  /** Begins again after the end: 'loop' for a clip that is a loop, 'loopJump' for others. True by default. */
  loop?: boolean;
  /** The motion after the end, in place of `loop`; 'loop' is for clips with `loopFrames`. */
  wrap?: Wrap;
  bandsLeftOut?: number;
  timeScale?: number;
}

/** Poses one character by a clip at any instant, without keyframes. It takes a few KB beside the clip. */
export class MocapressMixer {
  constructor(root: Object3D, clip: Clip, options?: MixerOptions);
  readonly root: Object3D;
  readonly clip: Clip;
  readonly time: number;
  timeScale: number;
  wrap: Wrap;
  bandsLeftOut: number;
  /**
   * Goes over to a finer clip of the same motion, whose poses are blended in within some seconds of update(), 0.2 by
   * default, so that nothing jumps. The coarser clip has to stay until then.
   */
  refine(clip: Clip, seconds?: number): this;
  /** Goes on by so many seconds times `timeScale`, and poses the character. */
  update(seconds: number): this;
  setTime(seconds: number): this;
  dispose(): void;
}

/** A clip as keyframes, one a frame, as decoded. */
export function toAnimationClip(clip: Clip, root?: Object3D, options?: ScaleOptions): AnimationClip;
