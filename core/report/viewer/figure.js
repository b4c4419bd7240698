// SPDX-License-Identifier: MIT
// A body as bones: a tapered cylinder from each joint's parent to the joint, with a ball at both ends, and a head. Bones
// are as thick as the length of everything they carry (Leonardo's rule), as in the pictures of reports (core/report/picture.cpp).
import * as THREE from 'three';

const up = new THREE.Vector3(0, 1, 0);
const taper = 0.75; // a bone's end radius, per start radius
const cylinder = new THREE.CylinderGeometry(taper, 1, 1, 16, 1, true).translate(0, 0.5, 0);
const ball = new THREE.SphereGeometry(1, 16, 12);
const metresPerCm = 0.01;

/** Radius of each bone, and whether it ends in a head, by the pose of one frame. `points` have parents before children. */
function shapeOf(points, positions) {
  const at = (i) => new THREE.Vector3().fromArray(positions, 3 * i);
  const lengths = points.map(({ parent }, i) => (parent < 0 ? 0 : at(i).distanceTo(at(parent)) / metresPerCm));
  const carried = points.map(() => 0); // length of all that is below, cm
  for (let i = points.length - 1; i > 0; --i)
    if (points[i].parent >= 0) carried[points[i].parent] += carried[i] + lengths[i];
  const isHead = (i) => /head/i.test(points[i]?.name ?? '');
  return points.map(({ parent }, i) => ({
    radius: metresPerCm * Math.max(0.9, 0.42 * Math.sqrt(carried[i] + lengths[i])),
    holdsHead: carried[i] < 0.1 && isHead(parent), // it reaches from the head's joint to its top
    isHead: carried[i] < 0.1 && isHead(i) && !isHead(parent), // nothing says where the top is
  }));
}

export class Figure {
  constructor(scene, points, positions) {
    this.points = points;
    this.shape = shapeOf(points, positions);
    this.material = new THREE.MeshLambertMaterial();
    this.bones = new THREE.InstancedMesh(cylinder, this.material, points.length);
    this.balls = new THREE.InstancedMesh(ball, this.material, 2 * points.length);
    this.group = new THREE.Group();
    this.group.add(this.bones, this.balls);
    // The body moves out of the bounds of its first pose.
    this.bones.frustumCulled = this.balls.frustumCulled = false;
    scene.add(this.group);
  }

  remove() {
    this.group.removeFromParent();
    this.material.dispose();
    this.bones.dispose();
    this.balls.dispose();
  }

  set visible(visible) {
    this.group.visible = visible;
  }

  setOpacity(opacity) {
    this.material.opacity = opacity;
    this.material.transparent = opacity < 1;
    this.material.depthWrite = opacity === 1;
    // Where both bodies have the same surface, the one that is not transparent is seen.
    this.material.polygonOffset = opacity < 1;
    this.material.polygonOffsetFactor = this.material.polygonOffsetUnits = 4;
  }

  pose(positions, offset) {
    this.group.position.copy(offset);
    const matrix = new THREE.Matrix4();
    const from = new THREE.Vector3();
    const to = new THREE.Vector3();
    const size = new THREE.Vector3();
    const turn = new THREE.Quaternion();
    this.points.forEach(({ parent }, i) => {
      to.fromArray(positions, 3 * i);
      from.fromArray(positions, 3 * Math.max(parent, 0));
      const along = to.clone().sub(from);
      const length = parent < 0 ? 0 : along.length();
      const { radius, holdsHead, isHead } = this.shape[i];
      turn.setFromUnitVectors(up, length > 0 ? along.normalize() : up);
      this.bones.setMatrixAt(i, matrix.compose(from, turn, size.set(radius, length, radius)));
      this.balls.setMatrixAt(2 * i, matrix.makeScale(radius, radius, radius).setPosition(from));
      if (holdsHead) {
        const broad = Math.min(Math.max(0.45 * length, 0.055), 0.075);
        to.lerp(from, 0.45);
        this.balls.setMatrixAt(2 * i + 1, matrix.compose(to, turn, size.set(broad, Math.max(0.6 * length, broad), broad)));
      } else if (isHead) {
        this.balls.setMatrixAt(2 * i + 1, matrix.compose(to.addScaledVector(along, 0.09), turn, size.set(0.07, 0.1, 0.07)));
      } else {
        const end = taper * radius;
        this.balls.setMatrixAt(2 * i + 1, matrix.makeScale(end, end, end).setPosition(to));
      }
    });
    this.bones.instanceMatrix.needsUpdate = this.balls.instanceMatrix.needsUpdate = true;
  }

  colour(colourOf) {
    this.points.forEach((_, i) => {
      const colour = colourOf(i);
      this.bones.setColorAt(i, colour);
      this.balls.setColorAt(2 * i, colour);
      this.balls.setColorAt(2 * i + 1, colour);
    });
    this.bones.instanceColor.needsUpdate = this.balls.instanceColor.needsUpdate = true;
  }
}
