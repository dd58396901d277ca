import { Vector3 } from "three";
import { expect, it } from "vitest";
import { ViewCamera } from "./view-camera";

function createCamera(isFlat: boolean) {
  const camera = new ViewCamera(32, 1.5, 0.05, 200);
  camera.position.set(0, 1, 4);
  camera.updateMatrixWorld();
  camera.targetDistance = 4;
  camera.isFlat = isFlat;
  camera.setViewOffset(900, 600, -40, 20, 900, 600);
  camera.updateProjectionMatrix();
  return camera;
}

it("shows the same at the distance of the target, with or without perspective", () => {
  const point = new Vector3(0.7, 1.4, 0);
  const flat = point.clone().project(createCamera(true));
  const perspective = point.clone().project(createCamera(false));
  expect(flat.x).toBeCloseTo(perspective.x);
  expect(flat.y).toBeCloseTo(perspective.y);
});

it("has no perspective in a flat view", () => {
  const camera = createCamera(true);
  const near = new Vector3(0.7, 1.4, 1).project(camera);
  const far = new Vector3(0.7, 1.4, -8).project(camera);
  expect(near.x).toBeCloseTo(far.x);
  expect(near.y).toBeCloseTo(far.y);
  expect(near.z).toBeLessThan(far.z);
});
