import { Mesh, MeshBasicMaterial, RingGeometry } from "three";
import type { Clip } from "../model/types";
import type { Palette } from "./palette";

/** A ring around one joint that faces the camera and is drawn over the skeleton. */
export class JointMarker {
  readonly mesh: Mesh<RingGeometry, MeshBasicMaterial>;

  /** `size` is the height of the character, in metres. */
  constructor(
    readonly clip: Clip,
    readonly joint: number,
    size: number,
    palette: Palette,
  ) {
    const material = new MeshBasicMaterial({
      color: palette.accent,
      depthTest: false,
      transparent: true,
    });
    this.mesh = new Mesh(new RingGeometry(0.032 * size, 0.044 * size, 40), material);
    this.mesh.renderOrder = 10;
    this.mesh.onBeforeRender = (_renderer, _scene, camera) => {
      this.mesh.quaternion.copy(camera.quaternion);
      this.mesh.updateMatrixWorld();
      this.mesh.modelViewMatrix.multiplyMatrices(camera.matrixWorldInverse, this.mesh.matrixWorld);
    };
  }

  /** Moves to the position of the joint in the pose that is shown: coordinates of all joints. */
  update(pose: Float32Array) {
    const at = 3 * this.joint;
    this.mesh.position.set(pose[at] ?? 0, pose[at + 1] ?? 0, pose[at + 2] ?? 0);
  }

  dispose() {
    this.mesh.geometry.dispose();
    this.mesh.material.dispose();
  }
}
