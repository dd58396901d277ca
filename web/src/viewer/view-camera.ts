import { MathUtils, PerspectiveCamera } from "three";

/**
 * A perspective camera that can project orthographically. Both projections show the same at the distance of
 * the target, so that controls for perspective cameras zoom and pan either.
 */
export class ViewCamera extends PerspectiveCamera {
  isFlat = false;
  /** Distance from the target, in metres. */
  targetDistance = 1;

  override updateProjectionMatrix() {
    super.updateProjectionMatrix();
    // Called by the constructor of the base class, before the fields exist.
    if (!this.isFlat) return;
    let top = this.targetDistance * Math.tan((this.fov / 2) * MathUtils.DEG2RAD);
    let height = 2 * top;
    let width = this.aspect * height;
    let left = -width / 2;
    if (this.view?.enabled) {
      const { fullWidth, fullHeight, offsetX, offsetY } = this.view;
      left += (offsetX * width) / fullWidth;
      top -= (offsetY * height) / fullHeight;
      width *= this.view.width / fullWidth;
      height *= this.view.height / fullHeight;
    }
    this.projectionMatrix.makeOrthographic(
      left,
      left + width,
      top,
      top - height,
      this.near,
      this.far,
      this.coordinateSystem,
    );
    this.projectionMatrixInverse.copy(this.projectionMatrix).invert();
  }
}
