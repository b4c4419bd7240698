// SPDX-License-Identifier: MIT
// The viewer of review pages: original and compressed motion of one clip, in three dimensions. `build` bundles it with
// three.js and the runtime's WebAssembly; pages call mocapressViewer.show().
import * as THREE from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { createMocapress, worldPositions } from '../../runtime/web/mocapress.js';
import wasm from 'mocapress.wasm.gz';
import { errorColour, errorGradient, findWorstFrames, measure } from './errors.js';
import { Figure } from './figure.js';

const modes = ['Overlay', 'Side by side', 'Wipe']; // passed to say()
const grey = new THREE.Color(0x9aa3ad);
const accent = new THREE.Color(0xd8543f);
const noteColour = '#2a69ad';

const unpacked = (bytes) =>
  new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream('gzip'))).arrayBuffer();
const bytesOf = (base64) => Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
let mocapress;

/** Joints and ends of bones over all frames, in metres. */
async function load(base64) {
  mocapress ??= unpacked(wasm).then(createMocapress);
  const clip = (await mocapress).openClip(bytesOf(base64));
  const ends = clip.joints.flatMap(({ name, endSite }, parent) => (endSite ? [{ name, parent, endSite }] : []));
  const points = [...clip.joints, ...ends];
  const frames = clip.decode();
  const stride = 7 * clip.joints.length;
  const pose = new Float32Array(7 * points.length);
  ends.forEach(({ endSite }, i) => pose.set([1, 0, 0, 0, ...endSite], stride + 7 * i));
  const positions = Array.from({ length: clip.frames }, (_, frame) => {
    pose.set(frames.subarray(stride * frame, stride * (frame + 1)));
    return worldPositions(points, pose).map((cm) => cm / 100);
  });
  const { sampleRate, duration } = clip;
  clip.dispose();
  return { points, positions, sampleRate, duration, frames: positions.length };
}

function element(name, properties = {}, ...children) {
  const made = Object.assign(document.createElement(name), properties);
  made.append(...children);
  return made;
}

/** A grid of metres. Each of its lines is a metre long: software renderers drop lines that begin behind the camera. */
function floorOf(reach, color) {
  const ends = [];
  for (let a = -reach; a <= reach; ++a)
    for (let b = -reach; b < reach; ++b) ends.push(a, 0, b, a, 0, b + 1, b, 0, a, b + 1, 0, a);
  const lines = new THREE.BufferGeometry();
  lines.setAttribute('position', new THREE.Float32BufferAttribute(ends, 3));
  return new THREE.LineSegments(lines, new THREE.LineBasicMaterial({ color }));
}

class Viewer {
  #original;
  #compressed;
  #errors;
  #worst;
  #frame = 0;
  #mode = 0;
  #colours = true;
  #follows = true;
  #swapped = false;
  #divider = 0.5; // share of the view's width left of the wipe's divider
  #notes = [];
  #playing = false;
  #before = 0;
  #drawn = false;
  #switches = [];  // show whether they are on
  #centre = new THREE.Vector3();
  #loading; // the clips of the last show()

  constructor(container, say) {
    this.say = say;
    this.canvas = element('canvas', { tabIndex: 0 });
    this.strip = element('canvas', { className: 'strip', height: 44 });
    this.time = element('input', { type: 'range', min: 0, step: 1, value: 0 });
    this.time.setAttribute('aria-label', say('Frame'));
    this.title = element('h2');
    this.facts = element('p', { className: 'muted' });
    this.status = element('p', { className: 'status' });
    this.buttons = element('div', { className: 'buttons' });
    this.notes = element('div', { className: 'notes' });
    this.names = ['Original', 'Compressed'].map((text) => element('span', { textContent: say(text) }));
    this.divider = element('div', { className: 'divider' });
    this.stage = element('div', { className: 'stage' }, this.canvas, this.divider, element('div', { className: 'names' }, ...this.names));
    container.replaceChildren(this.title, this.facts, this.stage, this.strip, this.time, this.buttons, this.status, this.notes);

    this.renderer = new THREE.WebGLRenderer({ canvas: this.canvas, antialias: true, preserveDrawingBuffer: true });
    this.renderer.setPixelRatio(devicePixelRatio);
    this.camera = new THREE.PerspectiveCamera(38, 1, 0.05, 200);
    this.controls = new OrbitControls(this.camera, this.canvas);
    this.controls.addEventListener('change', () => this.#ask());
    this.scene = new THREE.Scene();
    const isDark = matchMedia('(prefers-color-scheme: dark)').matches;
    this.scene.background = new THREE.Color(isDark ? 0x34393f : 0xeceef0); // the darkest error colour is told from it
    this.scene.add(new THREE.HemisphereLight(0xffffff, 0x8a8378, 2.2));
    const sun = new THREE.DirectionalLight(0xffffff, 1.8);
    sun.position.set(3, 6, 4);
    this.floor = floorOf(20, isDark ? 0x555b63 : 0xbac0c5);
    this.scene.add(sun, this.floor);

    this.#addButtons();
    for (const part of [this.divider, this.strip])
      part.onmousedown = (event) => {
        event.preventDefault();
        this.canvas.focus({ preventScroll: true }); // keys go on where the mouse was used
      };
    this.divider.onpointerdown = (event) => this.divider.setPointerCapture(event.pointerId);
    this.divider.onpointermove = (event) => this.divider.hasPointerCapture(event.pointerId) && this.#drag(event.clientX);
    this.time.oninput = () => this.seek(Number(this.time.value));
    this.strip.onpointerdown = (event) =>
      this.seek(Math.round((event.offsetX / this.strip.clientWidth) * (this.#original.frames - 1)));
    container.onkeydown = (event) => this.#press(event);
    new ResizeObserver(() => this.#resize()).observe(this.canvas);
  }

  async show({ name, original, compressed, facts = [], notes = [] }) {
    this.#play(false);
    this.title.textContent = name;
    this.facts.textContent = facts.join(' · ');
    this.status.textContent = this.say('Loading');
    this.#notes = notes;
    this.notes.replaceChildren(
      ...notes.map(({ frame, text }) => element('button', { textContent: text, onclick: () => this.#stopAt(frame) })),
    );
    const loading = (this.#loading = Promise.all([load(original), load(compressed)]));
    const loaded = await loading;
    if (loading !== this.#loading) return; // another clip was asked for meanwhile
    [this.#original, this.#compressed] = loaded;
    for (const figure of [this.before, this.after]) figure?.remove();
    const { points, positions } = this.#original; // both bodies have the shape of the original
    this.before = new Figure(this.scene, points, positions[0]);
    this.after = new Figure(this.scene, points, positions[0]);
    this.#errors = measure(this.#original, this.#compressed);
    this.#worst = findWorstFrames(this.#errors.ofFrames, this.#original.sampleRate);
    this.time.max = this.#original.frames - 1;
    this.#drawStrip();
    this.#frame = this.#worst[0] ?? 0;
    this.resetCamera();
    this.seek(this.#frame);
  }

  seek(frame) {
    this.#frame = Math.min(Math.max(frame, 0), this.#original.frames - 1);
    const whole = Math.round(this.#frame);
    this.time.value = whole;
    this.time.setAttribute('aria-valuetext', whole + 1);
    const { ofPoints, ofFrames, largest } = this.#errors;
    const count = this.#original.points.length;
    const errors = ofPoints.subarray(count * whole, count * (whole + 1));
    const worst = errors.indexOf(Math.max(...errors));
    const moved = this.#follow();
    this.floor.position.set(Math.round(this.#centre.x), 0, Math.round(this.#centre.z));
    const apart = this.#mode === 1 ? (this.#swapped ? -0.55 : 0.55) : 0;
    const sideways = new THREE.Vector3(1, 0, 0).applyQuaternion(this.camera.quaternion).setY(0).normalize();
    this.before.pose(this.#original.positions[whole], sideways.clone().multiplyScalar(-apart));
    this.after.pose(this.#compressed.positions[whole], sideways.clone().multiplyScalar(apart));
    this.before.colour(() => grey);
    this.after.colour((point) => (this.#colours ? errorColour(errors[point] / largest) : accent));
    const [behind, front] = this.#swapped ? [this.after, this.before] : [this.before, this.after];
    behind.setOpacity(this.#mode === 0 ? 0.35 : 1);
    front.setOpacity(1);
    this.divider.hidden = this.#mode !== 2;
    this.names[0].style.setProperty('--colour', grey.getStyle());
    this.names[1].style.setProperty('--colour', this.#colours ? errorGradient : accent.getStyle());
    this.stage.classList.toggle('swapped', this.#swapped);
    const { frames, sampleRate, points } = this.#original;
    this.status.textContent = [
      this.say('Frame %1 of %2, %3 s.', whole + 1, frames, (whole / sampleRate).toFixed(2)),
      this.say('On the bones, %1 is %2 cm off.', points[worst].name, (100 * ofFrames[whole]).toFixed(3)),
      this.say('The lightest colour is %1 cm.', (100 * largest).toFixed(2)),
    ].join(' ');
    this.#drawStrip();
    for (const show of this.#switches) show();
    if (moved) this.controls.update();
    this.#ask();
  }

  resetCamera() {
    const box = new THREE.Box3();
    const point = new THREE.Vector3();
    const positions = this.#original.positions[Math.round(this.#frame)];
    for (let i = 0; i < positions.length; i += 3) box.expandByPoint(point.fromArray(positions, i));
    const size = Math.max(box.getSize(point).length(), 0.1);
    box.getCenter(this.#centre);
    this.controls.target.copy(this.#centre);
    this.camera.position.copy(this.#centre).add(point.set(0.9, 0.35, 1.1).multiplyScalar(1.3 * size));
    this.controls.update();
  }

  #addButtons() {
    const add = (text, key, act, isOn) => {
      const title = this.say('Key: %1', key);
      const button = element('button', { textContent: this.say(text), title, onclick: act });
      if (isOn) this.#switches.push(() => button.setAttribute('aria-pressed', isOn()));
      this.buttons.append(button);
    };
    add('Play', 'space', () => this.#play(!this.#playing));
    modes.forEach((text, mode) => add(text, mode + 1, () => this.#setMode(mode), () => this.#mode === mode));
    add('Swap', 'X', () => this.#swap(), () => this.#swapped);
    add('Colour by error', 'E', () => this.#toggleColours(), () => this.#colours);
    add('Follow', 'Shift+F', () => this.#toggleFollow(), () => this.#follows);
    add('Worst frame before', 'Shift+N', () => this.#toWorst(-1));
    add('Next worst frame', 'N', () => this.#toWorst(1));
    add('Reset camera', 'R', () => this.resetCamera());
  }

  /** The keys of the studio. */
  #press(event) {
    if (event.ctrlKey || event.metaKey || event.altKey || !this.#original) return;
    const step = event.shiftKey ? 10 : 1;
    const actions = {
      ' ': () => this.#play(!this.#playing),
      1: () => this.#setMode(0),
      2: () => this.#setMode(1),
      3: () => this.#setMode(2),
      x: () => this.#swap(),
      e: () => this.#toggleColours(),
      f: () => event.shiftKey && this.#toggleFollow(),
      m: () => event.shiftKey && this.#toNextNote(),
      n: () => this.#toWorst(event.shiftKey ? -1 : 1),
      r: () => this.resetCamera(),
      arrowleft: () => this.#stopAt(Math.round(this.#frame) - step),
      arrowright: () => this.#stopAt(Math.round(this.#frame) + step),
      home: () => this.#stopAt(0),
      end: () => this.#stopAt(this.#original.frames - 1),
    };
    const act = actions[event.key.toLowerCase()];
    if (!act) return;
    event.preventDefault();
    act();
  }

  #setMode(mode) {
    this.#mode = mode;
    this.seek(this.#frame);
  }

  #swap() {
    this.#swapped = !this.#swapped;
    this.seek(this.#frame);
  }

  #toggleColours() {
    this.#colours = !this.#colours;
    this.seek(this.#frame);
  }

  #toggleFollow() {
    this.#follows = !this.#follows;
    this.seek(this.#frame);
  }

  #drag(x) {
    const { left, width } = this.stage.getBoundingClientRect();
    this.#divider = Math.min(Math.max((x - left) / width, 0), 1);
    this.divider.style.left = `${100 * this.#divider}%`;
    this.#ask();
  }

  #stopAt(frame) {
    this.#play(false);
    this.seek(frame);
  }

  #play(playing) {
    this.#playing = playing;
    this.buttons.firstChild.textContent = this.say(playing ? 'Pause' : 'Play');
    this.#before = performance.now();
    this.#ask();
  }

  #toNextNote() {
    const frames = this.#notes.map(({ frame }) => frame).sort((a, b) => a - b);
    if (frames.length > 0) this.#stopAt(frames.find((frame) => frame > Math.round(this.#frame)) ?? frames[0]);
  }

  /** Worst frames are in the order of their error. */
  #toWorst(step) {
    const at = this.#worst.indexOf(Math.round(this.#frame));
    const next = at < 0 ? 0 : (at + step + this.#worst.length) % this.#worst.length;
    this.#stopAt(this.#worst[next] ?? 0);
  }

  /** Moves camera and target with the body. */
  #follow() {
    if (!this.#follows) return false;
    const positions = this.#original.positions[Math.round(this.#frame)];
    const centre = new THREE.Vector3(positions[0], this.#centre.y, positions[2]);
    const way = centre.clone().sub(this.#centre);
    if (way.lengthSq() === 0) return false;
    this.#centre.copy(centre);
    this.camera.position.add(way);
    this.controls.target.add(way);
    return true;
  }

  #resize() {
    const { clientWidth: width, clientHeight: height } = this.canvas;
    if (width === 0 || height === 0) return;
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    if (this.#errors) this.#drawStrip();
    this.#ask();
  }

  /** The error of each frame, with the shown one marked. */
  #drawStrip() {
    const { strip } = this;
    const { ofFrames } = this.#errors;
    strip.width = Math.max(strip.clientWidth, 1);
    const context = strip.getContext('2d');
    const most = Math.max(...ofFrames, 1e-6);
    for (let x = 0; x < strip.width; ++x) {
      const first = Math.floor((x / strip.width) * ofFrames.length);
      const last = Math.max(first + 1, Math.floor(((x + 1) / strip.width) * ofFrames.length));
      const error = Math.max(...ofFrames.subarray(first, last));
      context.fillStyle = errorColour(error / this.#errors.largest).getStyle();
      const height = (error / most) * (strip.height - 4);
      context.fillRect(x, strip.height - height, 1, height);
    }
    context.fillStyle = noteColour;
    for (const { frame } of this.#notes)
      context.fillRect((frame / Math.max(ofFrames.length - 1, 1)) * (strip.width - 6), 0, 6, 6);
    context.fillStyle = accent.getStyle();
    context.fillRect((this.#frame / Math.max(ofFrames.length - 1, 1)) * (strip.width - 2), 0, 2, strip.height);
  }

  #ask() {
    if (this.#drawn) return;
    this.#drawn = true;
    requestAnimationFrame((now) => {
      this.#drawn = false;
      if (!this.#errors) return;
      if (this.#playing) {
        const next = this.#frame + ((now - this.#before) / 1000) * this.#original.sampleRate;
        this.#before = now;
        const last = this.#original.frames - 1;
        this.seek(next > last ? next % Math.max(last, 1) : next); // goes round, also where drawing is slow
      }
      this.#draw();
    });
  }

  #draw() {
    const { renderer, scene, camera } = this;
    const [first, second] = this.#swapped ? [this.after, this.before] : [this.before, this.after];
    renderer.setScissorTest(this.#mode === 2);
    if (this.#mode !== 2) {
      first.visible = second.visible = true;
      renderer.render(scene, camera);
      return;
    }
    const { clientWidth: width, clientHeight: height } = this.canvas;
    [first, second].forEach((figure, side) => {
      first.visible = figure === first;
      second.visible = figure === second;
      const at = Math.round(this.#divider * width);
      renderer.setScissor(side * at, 0, side === 0 ? at : width - at, height);
      renderer.render(scene, camera);
    });
  }
}

let viewer;

/** Shows a clip in `container`: base64 of two .mcpr files, facts about it, notes on its
 * frames, and say(), which translates the viewer. */
export async function show(container, { say, ...clip }) {
  if (viewer?.title.parentNode !== container) viewer = new Viewer(container, say);
  await viewer.show(clip);
  viewer.canvas.focus();
}
