// SPDX-License-Identifier: MIT
// A body as bones: a cylinder from each joint to its parent, and a ball at each joint.
import * as THREE from 'three';

const up = new THREE.Vector3(0, 1, 0);
const cylinder = new THREE.CylinderGeometry(0.75, 1, 1, 12, 1, true).translate(0, 0.5, 0);
const ball = new THREE.SphereGeometry(1, 14, 10);

export class Figure {
  constructor(scene, points) {
    this.points = points;
    this.material = new THREE.MeshLambertMaterial();
    this.bones = new THREE.InstancedMesh(cylinder, this.material, points.length);
    this.balls = new THREE.InstancedMesh(ball, this.material, points.length);
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
    const turn = new THREE.Quaternion();
    this.points.forEach(({ parent }, i) => {
      to.fromArray(positions, 3 * i);
      from.fromArray(positions, 3 * Math.max(parent, 0));
      const along = to.clone().sub(from);
      const length = parent < 0 ? 0 : along.length();
      const radius = Math.min(0.008 + 0.11 * length, 0.04);
      turn.setFromUnitVectors(up, length > 0 ? along.normalize() : up);
      this.bones.setMatrixAt(i, matrix.compose(from, turn, new THREE.Vector3(radius, length, radius)));
      this.balls.setMatrixAt(i, matrix.makeScale(radius, radius, radius).setPosition(to));
    });
    this.bones.instanceMatrix.needsUpdate = this.balls.instanceMatrix.needsUpdate = true;
  }

  colour(colourOf) {
    this.points.forEach((_, i) => {
      this.bones.setColorAt(i, colourOf(i));
      this.balls.setColorAt(i, colourOf(i));
    });
    this.bones.instanceColor.needsUpdate = this.balls.instanceColor.needsUpdate = true;
  }
}
