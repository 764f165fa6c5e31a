// What is drawn: parts of bodies in their frames, arrows and the ground.

const PALETTE = [
  [0.25, 0.50, 0.80], [0.16, 0.62, 0.56], [0.83, 0.52, 0.26], [0.58, 0.45, 0.76],
  [0.80, 0.40, 0.45], [0.47, 0.58, 0.24], [0.36, 0.56, 0.66], [0.70, 0.45, 0.62],
];
const STEEL = [0.56, 0.60, 0.66], GROUND = [0.45, 0.49, 0.55];

const colourOf = (() => {
  const types = [...new Set(model.bodies.map(body => body.type))];
  return new Map(types.map((type, index) => [type, PALETTE[index % PALETTE.length]]));
})();

/** Places and sizes of a motion. */
class Extent {
  constructor(motion) {
    const frames = Math.min(motion.frames, 60), least = [Infinity, Infinity, Infinity], most = least.map(x => -x);
    // The largest distance between points of the first frame: the size of the mechanism.
    this.size = 0;
    for (let k = 0; k < frames; k++) {
      const frame = Math.round(k * (motion.frames - 1) / Math.max(1, frames - 1));
      for (const place of places(motion, frame)) {
        for (let axis = 0; axis < 3; axis++) {
          least[axis] = Math.min(least[axis], place[axis]); most[axis] = Math.max(most[axis], place[axis]);
        }
      }
      if (k === 0) this.size = norm(subtract(most, least));
    }
    if (!(this.size > 0)) this.size = norm(subtract(most, least)) || 1;
    [this.least, this.most] = [least, most];
    this.centre = scaled(add(least, most), 0.5);
    this.radius = Math.max(norm(subtract(most, least)) / 2, this.size * 0.3) * 1.08;
  }
}

/** Returns the place of an end of a spring. */
function placeOf({ body, position }, motion, frame) {
  if (body === null) return position;
  const input = model.bodies[body].input;
  return add(motion.position(input, frame), rotate(motion.orientation(input, frame), position));
}

/** Returns the places that a picture must contain: points, ends of springs, centres of mass and corners of shapes. */
function places(motion, frame) {
  const found = model.points.map((_, point) => motion.position(point, frame));
  for (const { ends } of model.springs) found.push(...ends.map(end => placeOf(end, motion, frame)));
  for (const body of model.bodies) {
    if (body.input === null) continue;
    const at = motion.position(body.input, frame), turned = motion.orientation(body.input, frame);
    const within = local => found.push(add(at, rotate(turned, local)));
    within(body.com);
    for (const { geometry, position, orientation } of body.shapes) {
      const half = geometry.box ? scaled(geometry.box, 0.5)
        : geometry.cylinder ? [geometry.cylinder[0], geometry.cylinder[0], geometry.cylinder[1] / 2]
        : geometry.capsule ? [geometry.capsule[0], geometry.capsule[0], geometry.capsule[1] / 2 + geometry.capsule[0]]
        : geometry.sphere ? [geometry.sphere, geometry.sphere, geometry.sphere] : [0, 0, 0];
      for (const s of [-1, 1]) for (const axis of [0, 1, 2]) {
        const corner = [0, 0, 0]; corner[axis] = s * half[axis];
        within(add(position, rotate(orientation, corner)));
      }
    }
  }
  return found;
}

class Scene {
  constructor(motion, renderer, settings) {
    [this.motion, this.renderer, this.settings] = [motion, renderer, settings];
    this.extent = new Extent(motion);
    const surfaces = {
      sphere: BY_SOFTWARE ? sphere(14, 8) : sphere(20, 12), cylinder: cylinder(20), cone: cone(18), box: cube(),
      "sphere small": sphere(8, 5), "cylinder small": cylinder(8), "cone small": cone(8),
    };
    for (const [name, surface] of Object.entries(surfaces)) renderer.surface(name, surface);
    this.notes = [];
    for (const [path, it] of Object.entries(model.meshes)) {
      if (it.corners) renderer.mesh("mesh " + path, mesh(bytesOf(it.corners)));
      else this.notes.push(`mesh ${path}: ${it.note}; it is not drawn`);
    }
    this.shaped = model.bodies.map(body => this.partsOfShapes(body));
    this.plain = model.bodies.map(body => this.partsOfPoints(body));
    this.lengths = model.bodies.map(body => Math.max(norm(body.com), ...body.points.map(it => it.offset ? norm(it.offset) : 0)));
    this.ends = this.findEnds();
    this.inputs = model.points.map((_, point) => point).filter(point => {
      const body = model.points[point].body;
      return body !== null && model.bodies[body].input === point;
    });
    this.largest = { force: this.typical("force"), moment: this.typical("moment") };
    this.uniform = Math.max(this.extent.size, 1e-9);
  }

  /** Returns the length that nearly all vectors of a block stay below, for the scale of its arrows. */
  typical(block) {
    if (!this.motion.blocks.has(block)) return 0;
    const lengths = [];
    for (let k = 0; k < 80; k++) {
      const frame = Math.round(k * (this.motion.frames - 1) / 79);
      for (const point of this.inputs) lengths.push(norm(this.motion[block](point, frame)));
    }
    lengths.sort((a, b) => a - b);
    return lengths[Math.floor(0.97 * (lengths.length - 1))] || lengths[lengths.length - 1] || 0;
  }

  /** Parts are [kind, axes and origin in the body frame, colour]. */
  partsOfShapes(body) {
    const parts = [], colour = colourOf.get(body.type);
    for (const { geometry, position, orientation } of body.shapes) {
      const axis = (k, length) => { const a = [0, 0, 0]; a[k] = length; return rotate(orientation, a); };
      const part = (kind, [x, y, z], at = position, tint = colour) =>
        parts.push({ kind, x: axis(0, x), y: axis(1, y), z: axis(2, z), origin: at, tint });
      if (geometry.box) part("box", geometry.box);
      else if (geometry.cylinder) part("cylinder", [geometry.cylinder[0], geometry.cylinder[0], geometry.cylinder[1]]);
      else if (geometry.sphere) part("sphere", [geometry.sphere, geometry.sphere, geometry.sphere]);
      else if (geometry.capsule) {
        const [radius, length] = geometry.capsule;
        part("cylinder", [radius, radius, length]);
        for (const s of [-0.5, 0.5]) part("sphere", [radius, radius, radius], add(position, axis(2, s * length)));
      } else if (model.meshes[geometry.mesh].corners) part("mesh " + geometry.mesh, [1, 1, 1]);
    }
    return parts;
  }

  /** Returns the offsets of a body's points that are not at its input; an output that is not written is there. */
  endsOf(body) {
    return body.points.map(it => it.offset).filter(offset => offset && norm(offset) > 1e-6 * this.extent.size);
  }

  /** A body without shapes: capsules from its input to its other points, to its centre of mass if there are none. */
  partsOfPoints(body) {
    const parts = [], colour = colourOf.get(body.type), size = this.extent.size;
    let ends = this.endsOf(body);
    const isFree = ends.length === 0;
    if (isFree && norm(body.com) > 1e-6 * size) ends = [body.com];
    const longest = Math.max(...ends.map(norm), 0);
    const radius = Math.min(0.022 * size, Math.max(0.008 * size, 0.085 * longest));
    for (const end of ends) parts.push(...this.capsule([0, 0, 0], end, radius, colour));
    if (isFree && ends.length > 0) {
      // A free end: a ball at the centre of mass, larger for a larger share of the mass.
      const total = model.bodies.reduce((sum, it) => sum + it.mass, 0) || 1;
      const ball = Math.max(1.3 * radius, 0.05 * size * Math.cbrt(body.mass / total));
      parts.push({ kind: "sphere", x: [ball, 0, 0], y: [0, ball, 0], z: [0, 0, ball], origin: body.com, tint: colour });
    } else if (ends.length === 0) {
      const edge = 0.045 * size;
      parts.push({ kind: "box", x: [edge, 0, 0], y: [0, edge, 0], z: [0, 0, edge], origin: body.com, tint: colour });
    }
    const joint = 1.3 * radius;
    parts.push({ kind: "sphere", x: [joint, 0, 0], y: [0, joint, 0], z: [0, 0, joint], origin: [0, 0, 0], tint: STEEL });
    return parts;
  }

  capsule(from, to, radius, tint) {
    const along = subtract(to, from), length = norm(along), n = scaled(along, 1 / length), [a, b] = normals(n);
    const ball = origin => ({ kind: "sphere", x: [radius, 0, 0], y: [0, radius, 0], z: [0, 0, radius], origin, tint });
    // The joint at the input covers the other end.
    return [
      { kind: "cylinder", x: scaled(a, radius), y: scaled(b, radius), z: along, origin: scaled(add(from, to), 0.5), tint },
      ball(to),
    ];
  }

  /** Returns body-fixed places whose trails are drawn: the far ends of bodies that no other body follows. */
  findEnds() {
    const { motion } = this, size = this.extent.size, inputs = model.bodies.map(body => body.input).filter(it => it !== null);
    const starts = inputs.map(point => motion.position(point, 0));
    return model.bodies.flatMap((body, index) => {
      if (body.input === null) return [];
      const at = starts[inputs.indexOf(body.input)], turned = motion.orientation(body.input, 0);
      const written = this.endsOf(body), offsets = written.length ? written : [body.com];
      const taken = offset => {
        const place = add(at, rotate(turned, offset));
        return starts.some((start, k) => inputs[k] !== body.input && norm(subtract(start, place)) < 1e-3 * size);
      };
      return written.length && offsets.some(taken) ? [] : offsets.slice(-1).map(offset => ({ body: index, offset }));
    });
  }

  pose(body, frame) {
    const input = model.bodies[body].input;
    return [this.motion.position(input, frame), this.motion.orientation(input, frame)];
  }

  /** Adds all bodies and the ground. */
  addBodies(frame) {
    const { settings, renderer } = this;
    model.bodies.forEach((body, index) => {
      if (body.input === null) return;
      const [at, turned] = this.pose(index, frame);
      const hasShapes = settings.shapes && this.shaped[index].length > 0;
      for (const { kind, x, y, z, origin, tint } of hasShapes ? this.shaped[index] : this.plain[index]) {
        renderer.add(kind, rotate(turned, x), rotate(turned, y), rotate(turned, z), add(at, rotate(turned, origin)), tint);
      }
    });
    const edge = 0.05 * this.extent.size;
    model.points.forEach((point, index) => {
      if (point.body !== null) return;
      const at = this.motion.position(index, frame), turned = this.motion.orientation(index, frame);
      const axis = (k, length) => { const a = [0, 0, 0]; a[k] = length; return rotate(turned, a); };
      renderer.add("box", axis(0, edge), axis(1, edge), axis(2, edge), at, GROUND);
    });
  }

  springEnds(index, frame) { return model.springs[index].ends.map(end => placeOf(end, this.motion, frame)); }

  /** Adds springs: coils, in a plane zig-zags, of a fixed number of turns between two straight ends. */
  addSprings(frame, camera) {
    const size = this.extent.size, { flat } = camera, few = model.springs.length > 12 || BY_SOFTWARE;
    const wire = Math.max(0.0035 * size, 0.9 * camera.pixel());
    model.springs.forEach((_, index) => {
      const [from, to] = this.springEnds(index, frame), along = subtract(to, from), length = norm(along);
      if (!(length > 1e-6 * size)) return;
      const n = scaled(along, 1 / length), [a, b] = flat ? [cross([0, 0, 1], n), [0, 0, 0]] : normals(n);
      const radius = Math.min(0.018 * size, 0.12 * length), turns = 8, parts = flat ? 2 : few ? 6 : 12, count = turns * parts;
      const at = k => {
        const angle = 2 * Math.PI * k / parts, across = add(scaled(a, radius * Math.cos(angle)), scaled(b, radius * Math.sin(angle)));
        return add(add(from, scaled(along, 0.12 + 0.76 * k / count)), across);
      };
      const path = [from, add(from, scaled(along, 0.12)), ...Array.from({ length: count + 1 }, (_, k) => at(k)), add(from, scaled(along, 0.88)), to];
      for (let k = 0; k + 1 < path.length; k++) this.addWire(path[k], path[k + 1], wire);
    });
  }

  addWire(from, to, radius) {
    const along = subtract(to, from), length = norm(along);
    if (!(length > 0)) return;
    const [a, b] = normals(scaled(along, 1 / length));
    this.renderer.add("cylinder", scaled(a, radius), scaled(b, radius), along, scaled(add(from, to), 0.5), STEEL);
  }

  /** Returns the ends of the lines that show the axes of hinges. */
  axes(frame) {
    const half = 0.07 * this.extent.size;
    return model.axes.map(({ point, direction }) => {
      const at = this.motion.position(point, frame), along = scaled(rotate(this.motion.orientation(point, frame), direction), half);
      return [subtract(at, along), add(at, along)];
    });
  }

  /** Returns the arrows of a frame: force and moment on the body outboard of a point, and weights. */
  arrows(frame) {
    const { settings, motion } = this, out = [];
    const size = 0.3 * this.extent.size * 10 ** settings.scale;
    for (const [kind, shown] of [["force", settings.forces], ["moment", settings.moments]]) {
      if (!motion.blocks.has(kind) || shown === "none") continue;
      const points = shown === "all" ? this.inputs : [settings.point];
      const scale = this.largest[kind] > 0 ? size / this.largest[kind] : 0;
      for (const point of points) {
        const vector = motion[kind](point, frame);
        // The moment z acts on the inboard element; shown is that on the outboard one, as the force is.
        const value = kind === "force" ? vector : scaled(vector, -1);
        if (norm(value) * scale > 0.004 * this.extent.size) {
          out.push({ kind, point, at: motion.position(point, frame), vector: scaled(value, scale), size: norm(value) });
        }
      }
    }
    if (settings.weights && norm(model.gravity) > 0 && this.largest.force > 0) {
      model.bodies.forEach((body, index) => {
        const [at, turned] = this.pose(index, frame), weight = scaled(model.gravity, body.mass);
        out.push({ kind: "weight", at: add(at, rotate(turned, body.com)), vector: scaled(weight, size / this.largest.force), size: norm(weight) });
      });
    }
    return out;
  }

  addArrows(arrows, camera, colours) {
    const thin = Math.max(0.005 * this.extent.size, 1.6 * camera.pixel());
    for (const { kind, at, vector } of arrows) {
      // In a plane moments are arcs, which the overlay draws.
      if (kind === "moment" && camera.flat) continue;
      const length = norm(vector), n = scaled(vector, 1 / length), [a, b] = normals(n);
      const tip = Math.min(5.5 * thin, 0.6 * length), tint = colours[kind], heads = kind === "moment" ? [0, 0.75 * tip] : [0];
      const shaft = length - tip;
      if (shaft > 0) {
        this.renderer.add("cylinder", scaled(a, thin), scaled(b, thin), scaled(n, shaft), add(at, scaled(n, shaft / 2)), tint, ARROWS);
      }
      for (const back of heads) {
        this.renderer.add("cone", scaled(a, 2.4 * thin), scaled(b, 2.4 * thin), scaled(n, tip), add(at, scaled(n, length - tip - back)), tint, ARROWS);
      }
    }
  }
}
