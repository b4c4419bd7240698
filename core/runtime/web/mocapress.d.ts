// SPDX-License-Identifier: MIT
// Plays .mcpr files and .mcpk banks. Lengths are in centimetres, times in seconds; right-handed, y up.

/** A file or a call that cannot be used. The message is one sentence. */
export class MocapressError extends Error {}

/** The address of the WebAssembly file for this machine: with SIMD, or without. */
export function defaultModule(): URL;

/**
 * Makes an instance. Instances share nothing; a worker makes its own. `mocapress_cooked.wasm` is less than half as
 * large and plays cooked banks only.
 */
export function createMocapress(
  source?: URL | string | BufferSource | WebAssembly.Module,
): Promise<Mocapress>;

export class Mocapress {
  private constructor();
  /**
   * Opens the bytes of a .mcpr file, which are not needed afterwards; or only its first tiers, after which the bytes may
   * end.
   */
  openClip(bytes: ArrayBuffer | ArrayBufferView, name?: string, tiers?: number): Clip;
  /** The tiers of a .mcpr file, of which the first 133 bytes are enough. Empty if it was made without `--tiers`. */
  tiersOf(bytes: ArrayBuffer | ArrayBufferView): Tier[];
  /**
   * Opens a .mcpr file on a server: StreamedClip.load() gets its tiers by HTTP ranges. A file without tiers, or from a
   * server without ranges, comes as a whole. `options` are those of fetch().
   */
  streamClip(url: string | URL, options?: RequestInit): Promise<StreamedClip>;
  /** Opens the bytes of a .mcpk bank, and checks all of them. */
  openBank(bytes: ArrayBuffer | ArrayBufferView): Bank;
  /**
   * Opens a bank on a server without loading its clips: Bank.load() gets them by HTTP ranges. A server without ranges
   * sends the whole bank. `options` are those of fetch().
   */
  streamBank(url: string | URL, options?: RequestInit): Promise<Bank>;
}

/** A part of a .mcpr file, from its start, that holds a coarser motion. The last tier is the whole motion. */
export interface Tier {
  /** The file's first bytes, which are enough for this tier. */
  bytes: number;
  /** Centimetres, RMS and largest, against the original when encoded; 0: not known, and in the last tier. */
  error: number;
  maxError: number;
}

export class Bank {
  private constructor();
  /** The clips' names, sorted by bytes. */
  readonly names: string[];
  /** Cooked clips are sampled as they lie; those of packed banks are decoded when opened. */
  readonly isCooked: boolean;
  /** The tiers that the bank has: 1 unless its clips were compressed with `--tiers`. */
  readonly tiers: number;
  /** Loads the first tiers of a clip of a streamed bank that are not there yet, all by default, so
      that it is safe to use; otherwise does nothing. Of packed clips the structure is checked, not
      each bit: they have no checksum of their own. */
  load(name: string, tiers?: number): Promise<void>;
  /** The tiers of a clip that were loaded: `tiers` if the bank is not streamed. */
  tiersLoaded(name: string): number;
  /** Whether at least the first tier was loaded. */
  isLoaded(name: string): boolean;
  /** Opens a clip by its first tiers, which were loaded before; by default all of these. */
  openClip(name: string, tiers?: number): Clip;
  tags(name: string): string[];
  /** Frees the bank. Dispose of clips of a cooked bank before it. */
  dispose(): void;
}

/** A .mcpr file on a server, loaded tier by tier. It is used as a bank with one clip is. */
export class StreamedClip {
  private constructor();
  /** The name of the file, without its extension. */
  readonly names: [string];
  readonly isCooked: false;
  /** The tiers of the file; 1: it comes as a whole. */
  readonly tiers: number;
  tier(number: number): Tier;
  /** Loads the first tiers that are not there yet, all by default. */
  load(name?: string, tiers?: number): Promise<void>;
  tiersLoaded(name?: string): number;
  isLoaded(name?: string): boolean;
  /** Opens the clip by its first tiers, which were loaded before; by default all of these. */
  openClip(name?: string, tiers?: number): Clip;
  tags(name: string): string[];
  /** Frees the bytes that have come. Clips stay. */
  dispose(): void;
}

export interface Joint {
  name: string;
  /** Index of the parent, which comes before its children; -1: a root. */
  parent: number;
  offset: number[];
  /** The tip of a joint without children; undefined where the clip has none. */
  endSite: number[] | undefined;
}

export interface Track {
  kind: 'property' | 'morphWeight' | 'scaleX' | 'scaleY' | 'scaleZ';
  /** The joint or mesh node that the track belongs to; empty: the clip. */
  node: string;
  name: string;
  /** Holds the value of the earlier frame between two frames. */
  steps: boolean;
}

/**
 * The pose before the first frame and after the last: that frame; another cycle of a clip with `loopFrames`; forwards,
 * then backwards; or any clip as a loop, whose last frame stands for the first, is blended to it, or is held.
 */
export type Wrap = 'clamp' | 'loop' | 'pingPong' | 'loopJump' | 'loopBlend' | 'loopHold';

export interface WrapOptions {
  /** Goes on in the next cycle after the end, as the wrap 'loop'. Only for clips with `loopFrames`. */
  loop?: boolean;
  /** By default 'loop' with `loop`, else 'clamp'. */
  wrap?: Wrap;
}

export interface SampleOptions extends WrapOptions {
  /** Finest bands of detail to leave out, 0 to 4, for characters far away. */
  bandsLeftOut?: number;
}

/** Samples one clip for one character; it is fastest when time goes on steadily. */
export class Player {
  private constructor();
  readonly clip: Clip;
  /**
   * The pose at an instant: eight floats a joint, the quaternion w x y z to its parent's space, its origin x y z in
   * that space, and 0. A view that the next call of this module may change.
   */
  sample(seconds: number, options?: SampleOptions): Float32Array;
  /** World positions of all joints, three floats each. */
  positions(seconds: number, options?: SampleOptions): Float32Array;
  dispose(): void;
}

export class Clip {
  private constructor();
  readonly name: string;
  readonly sampleRate: number;
  readonly frames: number;
  /** Frames in a cycle of a loop; 0: the clip is no loop. */
  readonly loopFrames: number;
  /** Seconds from the first frame to the last. */
  readonly duration: number;
  readonly joints: Joint[];
  readonly tracks: Track[];
  /** A player for another character. */
  createPlayer(): Player;
  /**
   * As Player.sample(), with a player of the clip's own. Where inverse kinematics hold feet or hands, joints are within
   * the error that the file tells of what decode() gives.
   */
  sample(seconds: number, options?: SampleOptions): Float32Array;
  positions(seconds: number, options?: SampleOptions): Float32Array;
  /**
   * Whole frames: seven floats a joint, frame after frame, as sample() without the 0. They are the motion that was
   * measured when the file was written; frames of a cooked bank are sampled.
   */
  decode(first?: number, count?: number): Float32Array;
  /** One value a track. A view that the next call may change. */
  sampleTracks(seconds: number, options?: WrapOptions): Float32Array;
  /** Frees the clip and its players. */
  dispose(): void;
}

/**
 * Blends a pose of Player.sample() towards another, in place: share 0 leaves it as it is, 1 makes it the other.
 * Rotations go the shorter way.
 */
export function blendPose(pose: Float32Array, other: Float32Array, share: number): Float32Array;

/** The name that a clip of this address gets: without folders and extension. */
export function stem(url: string | URL): string;

/** World positions of a pose with `stride` floats a joint. */
export function worldPositions(joints: Joint[], pose: Float32Array, stride?: number): Float32Array;
