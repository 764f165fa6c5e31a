// Vectors, quaternions w x y z, and the surfaces that are drawn.

const add = (a, b) => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
const subtract = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const scaled = (a, k) => [a[0] * k, a[1] * k, a[2] * k];
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const norm = a => Math.hypot(a[0], a[1], a[2]);
const unit = a => { const n = Math.hypot(...a) || 1; return a.map(x => x / n); };

const multiply = ([a, b, c, d], [w, x, y, z]) => [
  a * w - b * x - c * y - d * z, a * x + b * w + c * z - d * y,
  a * y - b * z + c * w + d * x, a * z + b * y - c * x + d * w,
];
/** Rotates a vector by a unit quaternion. */
function rotate([w, x, y, z], v) {
  const t = scaled(cross([x, y, z], v), 2);
  return add(add(v, scaled(t, w)), cross([x, y, z], t));
}
/** Returns two unit vectors that are normal to a unit vector and to each other. */
function normals(n) {
  const other = Math.abs(n[0]) < 0.6 ? [1, 0, 0] : [0, 1, 0];
  const a = unit(cross(other, n));
  return [a, cross(n, a)];
}

/** A surface: corners, normals and triangles. Those of closed surfaces are counter-clockwise from outside. */
class Surface {
  constructor() { this.corners = []; this.normals = []; this.triangles = []; }
  vertex(corner, normal) { this.corners.push(...corner); this.normals.push(...normal); return this.corners.length / 3 - 1; }
}

/** Returns a surface of revolution about z from [radius, z, normal's radius, normal's z] of each ring. */
function revolved(rings, sides) {
  const surface = new Surface();
  for (const [radius, z, across, along] of rings) {
    for (let k = 0; k <= sides; k++) {
      const [c, s] = [Math.cos(2 * Math.PI * k / sides), Math.sin(2 * Math.PI * k / sides)];
      surface.vertex([radius * c, radius * s, z], [across * c, across * s, along]);
    }
  }
  for (let ring = 0; ring + 1 < rings.length; ring++) {
    for (let k = 0; k < sides; k++) {
      const a = ring * (sides + 1) + k, b = a + sides + 1;
      surface.triangles.push(a, a + 1, b, b, a + 1, b + 1);
    }
  }
  return surface;
}

/** A sphere of radius 1. */
function sphere(sides, rows) {
  const rings = [];
  for (let k = 0; k <= rows; k++) {
    const [r, z] = [Math.sin(Math.PI * k / rows), -Math.cos(Math.PI * k / rows)];
    rings.push([r, z, r, z]);
  }
  return revolved(rings, sides);
}
/** A cylinder of radius 1 from z = −½ to ½. */
const cylinder = sides => revolved([
  [0, -0.5, 0, -1], [1, -0.5, 0, -1], [1, -0.5, 1, 0], [1, 0.5, 1, 0], [1, 0.5, 0, 1], [0, 0.5, 0, 1],
], sides);
/** A cone of radius 1 from z = 0 to its tip at 1. */
const cone = sides => revolved([[0, 0, 0, -1], [1, 0, 0, -1], [1, 0, 0.7, 0.7], [0, 1, 0.7, 0.7]], sides);
/** A cube with edges of length 1. */
function cube() {
  const surface = new Surface();
  for (let axis = 0; axis < 3; axis++) {
    for (const side of [-1, 1]) {
      const at = (u, v) => {
        const corner = [0, 0, 0], normal = [0, 0, 0];
        corner[axis] = side / 2; corner[(axis + 1) % 3] = u / 2; corner[(axis + 2) % 3] = v / 2; normal[axis] = side;
        return surface.vertex(corner, normal);
      };
      const [a, b, c, d] = [at(-1, -1), at(1, -1), at(1, 1), at(-1, 1)];
      surface.triangles.push(...side > 0 ? [a, b, c, a, c, d] : [a, c, b, a, d, c]);
    }
  }
  return surface;
}
/** The triangles of a mesh, each with its own corners and normal. */
function mesh(bytes) {
  const numbers = new Float32Array(bytes.buffer, 0, bytes.length >> 2), surface = new Surface();
  for (let k = 0; k + 8 < numbers.length; k += 9) {
    const [a, b, c] = [0, 3, 6].map(n => Array.from(numbers.subarray(k + n, k + n + 3)));
    const normal = unit(cross(subtract(b, a), subtract(c, a)));
    for (const corner of [a, b, c]) surface.vertex(corner, normal);
  }
  return surface;
}
