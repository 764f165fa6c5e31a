// The camera: orbit about a target, with a perspective.

const FIELD = 0.6; // rad, of the smaller side of the view

class Camera {
  /** `up` is a unit vector; `flat` mechanisms are viewed along −z. */
  constructor(up, flat) {
    this.flat = flat;
    this.up = flat ? [0, 1, 0] : up;
    // Yaw zero looks from `front`.
    this.front = flat ? [0, 0, 1] : Math.abs(up[0]) > 0.9 ? [0, 0, 1] : unit(subtract([1, 0, 0], scaled(up, up[0])));
    this.side = cross(this.up, this.front);
    this.target = [0, 0, 0];
    this.distance = 5;
    this.home();
  }
  home() { [this.yaw, this.pitch] = this.flat ? [0, 0] : [0.75, 0.35]; }
  /** Looks along an axis. */
  along(axis) {
    const from = { x: [1, 0, 0], y: [0, -1, 0], z: [0, 0, 1] }[axis];
    const height = Math.max(-1, Math.min(1, dot(from, this.up)));
    this.pitch = Math.max(-1.55, Math.min(1.55, Math.asin(height)));
    if (Math.abs(height) < 0.99) this.yaw = Math.atan2(dot(from, this.side), dot(from, this.front));
    else this.yaw = this.flat ? 0 : -Math.PI / 2;
  }
  orbit(dx, dy) {
    this.yaw -= dx;
    this.pitch = Math.max(-1.55, Math.min(1.55, this.pitch + dy));
  }
  /** Pans by pixels. */
  pan(dx, dy, height) {
    const metres = 2 * this.distance * Math.tan(FIELD / 2) / height;
    this.update(1, 1);
    this.target = add(this.target, add(scaled(this.right, -dx * metres), scaled(this.above, dy * metres)));
  }
  zoom(factor) { this.distance = Math.max(1e-6, this.distance * factor); }
  /** Moves so that a sphere is in the view. */
  fit(centre, radius, width, height) {
    this.target = centre;
    this.distance = 1.12 * radius / Math.sin(FIELD / 2) * Math.max(1, height / Math.max(1, width));
  }
  /** Computes axes and matrix for a view of this size in pixels. */
  update(width, height) {
    [this.width, this.height] = [width, height];
    const [cy, sy, cp, sp] = [Math.cos(this.yaw), Math.sin(this.yaw), Math.cos(this.pitch), Math.sin(this.pitch)];
    const level = add(scaled(this.front, cy), scaled(this.side, sy));
    this.back = add(scaled(level, cp), scaled(this.up, sp));
    this.right = add(scaled(this.side, cy), scaled(this.front, -sy));
    this.above = cross(this.back, this.right);
    this.eye = add(this.target, scaled(this.back, this.distance));
    this.focal = 1 / Math.tan(FIELD / 2);
  }
  /** Returns the matrix that takes positions to clip space, column by column. */
  matrix() {
    const [r, a, b, e, f] = [this.right, this.above, this.back, this.eye, this.focal];
    const fx = f * this.height / this.width, near = this.distance * 0.02, far = this.distance * 60;
    const A = -(far + near) / (far - near), B = -2 * far * near / (far - near);
    const out = new Float32Array(16);
    for (let k = 0; k < 3; k++) out.set([fx * r[k], f * a[k], A * b[k], -b[k]], 4 * k);
    out.set([-fx * dot(r, e), -f * dot(a, e), -A * dot(b, e) + B, dot(b, e)], 12);
    return out;
  }
  /** Returns pixel and distance of a position; undefined behind the eye. */
  project(position) {
    const from = subtract(position, this.eye), depth = -dot(from, this.back);
    if (depth < this.distance * 0.02) return undefined;
    const pixels = this.focal * this.height / 2 / depth;
    return [this.width / 2 + pixels * dot(from, this.right), this.height / 2 - pixels * dot(from, this.above), depth];
  }
  /** Returns the size in m of a pixel at the target. */
  pixel() { return 2 * this.distance / this.focal / this.height; }
}
