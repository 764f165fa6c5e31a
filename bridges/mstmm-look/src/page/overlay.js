// The canvas of the view: grid and trails, the picture of the bodies, and names, axes and values above it. One canvas
// without transparency, because browsers that draw by the processor take long to put several above each other.

/** Returns a number with four digits and a prefix, and its unit. */
function measure(value, unit) {
  const prefixes = [[1e9, "G"], [1e6, "M"], [1e3, "k"], [1, ""], [1e-3, "m"], [1e-6, "µ"], [1e-9, "n"]];
  const text = unit.replace("*", "·").replace("^2", "²");
  if (value === 0 || !["N", "N*m", "J", "m"].includes(unit)) return digits(value) + (unit === "1" ? "" : " " + text);
  const [factor, prefix] = prefixes.find(([factor]) => Math.abs(value) >= 0.9995 * factor) ?? prefixes[prefixes.length - 1];
  return (value / factor).toPrecision(4) + " " + prefix + text;
}
/** Returns a number with five digits at most. */
function digits(value, count = 5) {
  if (value === 0) return "0";
  const size = Math.abs(value);
  return size >= 1e5 || size < 1e-3 ? value.toExponential(count - 2) : Number(value.toPrecision(count)).toString();
}

class Overlay {
  constructor(scene, canvas) {
    this.scene = scene;
    this.back = this.front = canvas.getContext("2d", { alpha: false, willReadFrequently: BY_SOFTWARE });
  }

  begin(camera, ratio, [sky, ground]) {
    this.camera = camera;
    const { back } = this, gradient = back.createLinearGradient(0, 0, 0, camera.height);
    gradient.addColorStop(0, sky); gradient.addColorStop(1, ground);
    back.setTransform(ratio, 0, 0, ratio, 0, 0);
    back.fillStyle = gradient;
    back.fillRect(0, 0, camera.width, camera.height);
    back.lineJoin = back.lineCap = "round";
    this.used = [];
  }

  /** Draws the picture of the bodies. */
  picture(canvas) { this.back.drawImage(canvas, 0, 0, this.camera.width, this.camera.height); }

  line(context, points) {
    context.beginPath();
    let isDown = false;
    for (const point of points) {
      const pixel = this.camera.project(point);
      if (pixel) isDown ? context.lineTo(pixel[0], pixel[1]) : context.moveTo(pixel[0], pixel[1]);
      isDown = Boolean(pixel);
    }
    context.stroke();
  }

  /** The floor below the motion; behind it in a plane. Its lines have a distance of 1, 2 or 5 times a power of ten. */
  grid(colour) {
    const { extent } = this.scene, { camera, back } = this, raw = extent.radius / 4;
    const power = 10 ** Math.floor(Math.log10(raw)), step = power * [1, 2, 5, 10].find(k => k * power >= raw);
    const n = camera.flat ? camera.front : camera.up, [a, b] = camera.flat ? [[1, 0, 0], [0, 1, 0]] : [camera.front, camera.side];
    const corners = [0, 1, 2, 3, 4, 5, 6, 7].map(k => [0, 1, 2].map(axis => (k >> axis & 1 ? extent.most : extent.least)[axis]));
    const floor = camera.flat ? extent.centre[2] : Math.min(...corners.map(corner => dot(corner, n)));
    const [u, v] = [a, b].map(axis => Math.round(dot(extent.centre, axis) / step)), count = 8;
    back.lineWidth = 1;
    for (let k = -count; k <= count; k++) {
      back.strokeStyle = colour;
      for (const [along, across, p, q] of [[a, b, u, v], [b, a, v, u]]) {
        // Lines fade towards the border.
        for (let s = -count; s < count; s++) {
          const far = Math.hypot(k, s + 0.5) / count;
          if (far >= 1) continue;
          back.globalAlpha = 1 - far;
          const at = m => add(add(scaled(along, (p + m) * step), scaled(across, (q + k) * step)), scaled(n, floor));
          this.line(back, [at(s), at(s + 1)]);
        }
      }
    }
    back.globalAlpha = 1;
    this.step = step;
  }

  /** The way of a place during the last part of the motion. */
  trail(placeAt, motion, frame, colour) {
    const { back } = this, length = Math.min(motion.end - motion.start, 3), first = motion.frameAt(motion.time(frame) - length);
    const count = Math.min(160, frame - first), parts = 8;
    if (count < 1) return;
    const points = Array.from({ length: count + 1 }, (_, k) => placeAt(Math.round(first + (frame - first) * k / count)));
    [back.strokeStyle, back.lineWidth] = [colour, 1.8];
    for (let part = 0; part < parts; part++) {
      const [from, to] = [part, part + 1].map(k => Math.floor(k * count / parts));
      back.globalAlpha = 0.85 * (part + 1) / parts;
      this.line(back, points.slice(from, to + 1));
    }
    back.globalAlpha = 1;
  }

  axes(at, turned, length, width = 1.6) {
    const { front } = this;
    ["#d64545", "#2f9e44", "#2f6fdf"].forEach((colour, k) => {
      const axis = [0, 0, 0]; axis[k] = length;
      [front.strokeStyle, front.lineWidth] = [colour, width];
      this.line(front, [at, add(at, rotate(turned, axis))]);
    });
  }

  /** An axis of a hinge: a line of dashes and dots on a halo; a cross if it points at the viewer. */
  axis(ends, ink, halo) {
    const { front } = this, [from, to] = ends.map(end => this.camera.project(end));
    if (from && to && Math.hypot(to[0] - from[0], to[1] - from[1]) < 8) return this.cross((from[0] + to[0]) / 2, (from[1] + to[1]) / 2, ink, halo);
    [front.strokeStyle, front.lineWidth] = [halo, 3.5];
    this.line(front, ends);
    [front.strokeStyle, front.lineWidth] = [ink, 1.4];
    front.setLineDash([9, 4, 1.5, 4]);
    this.line(front, ends);
    front.setLineDash([]);
  }

  cross(x, y, ink, halo) {
    const { front } = this;
    for (const [colour, width] of [[halo, 3.5], [ink, 1.4]]) {
      [front.strokeStyle, front.lineWidth] = [colour, width];
      front.beginPath();
      front.moveTo(x - 14, y); front.lineTo(x + 14, y); front.moveTo(x, y - 14); front.lineTo(x, y + 14);
      front.stroke();
    }
  }

  /** The inertial axes in the corner. */
  corner(ink) {
    const { front, camera } = this, from = [42, camera.height - 42];
    ["x", "y", "z"].forEach((name, k) => {
      const axis = [0, 0, 0]; axis[k] = 1;
      const [dx, dy] = [26 * dot(axis, camera.right), -26 * dot(axis, camera.above)];
      front.strokeStyle = ["#d64545", "#2f9e44", "#2f6fdf"][k];
      front.lineWidth = 2;
      front.beginPath(); front.moveTo(...from); front.lineTo(from[0] + dx, from[1] + dy); front.stroke();
      if (Math.hypot(dx, dy) > 6) this.text(name, from[0] + dx * 1.35, from[1] + dy * 1.35, ink, "center", true);
    });
  }

  /** A moment in a plane: an arc, counter-clockwise if the moment is positive. */
  moment(at, value, colour) {
    const pixel = this.camera.project(at), { front } = this, radius = 24;
    if (!pixel) return;
    const [x, y] = pixel, [from, to] = value > 0 ? [0.6, -4] : [Math.PI - 0.6, Math.PI + 4];
    [front.strokeStyle, front.fillStyle, front.lineWidth] = [colour, colour, 2.5];
    front.beginPath(); front.arc(x, y, radius, from, to, value > 0); front.stroke();
    const along = value > 0 ? -1 : 1, [c, s] = [Math.cos(to), Math.sin(to)], tip = [x + radius * c - 9 * along * s, y + radius * s + 9 * along * c];
    front.beginPath(); front.moveTo(...tip);
    front.lineTo(x + (radius - 5) * c, y + (radius - 5) * s); front.lineTo(x + (radius + 5) * c, y + (radius + 5) * s); front.fill();
  }

  /** The symbol of a centre of mass. */
  mass(at, radius, ink, paper) {
    const pixel = this.camera.project(at), { front } = this;
    if (!pixel) return;
    const [x, y] = pixel;
    if (radius < 2.5) {
      front.fillStyle = ink;
      front.fillRect(x - 1, y - 1, 2, 2);
      return;
    }
    front.fillStyle = paper;
    front.beginPath(); front.arc(x, y, radius, 0, 7); front.fill();
    front.fillStyle = ink;
    for (const turn of [0, Math.PI]) {
      front.beginPath(); front.moveTo(x, y); front.arc(x, y, radius, turn, turn + Math.PI / 2); front.fill();
    }
    [front.strokeStyle, front.lineWidth] = [ink, 1];
    front.beginPath(); front.arc(x, y, radius, 0, 7); front.stroke();
  }

  ring(at, radius, colour) {
    const pixel = this.camera.project(at), { front } = this;
    if (!pixel) return;
    [front.strokeStyle, front.lineWidth] = [colour, 2];
    front.beginPath(); front.arc(pixel[0], pixel[1], radius, 0, 7); front.stroke();
  }

  /** Text with a halo, unless it would cover other text. */
  text(text, x, y, colour, align = "left", always = false) {
    const { front } = this;
    front.font = "12px system-ui, sans-serif";
    front.textAlign = align; front.textBaseline = "middle";
    const width = front.measureText(text).width, left = align === "left" ? x : align === "right" ? x - width : x - width / 2;
    const box = [left - 2, y - 8, left + width + 2, y + 8];
    if (!always && this.used.some(it => box[0] < it[2] && it[0] < box[2] && box[1] < it[3] && it[1] < box[3])) return;
    this.used.push(box);
    if (BY_SOFTWARE) {
      // A halo takes as long as ten texts.
      front.globalAlpha = 0.6; front.fillStyle = this.halo;
      front.fillRect(box[0], box[1] + 1, box[2] - box[0], 14);
      front.globalAlpha = 1;
    } else {
      front.lineWidth = 3.5; front.strokeStyle = this.halo;
      front.strokeText(text, x, y);
    }
    front.fillStyle = colour;
    front.fillText(text, x, y);
  }

  label(text, at, colour, dx = 9, dy = -9) {
    const pixel = this.camera.project(at);
    if (pixel) this.text(text, pixel[0] + dx, pixel[1] + dy, colour);
  }
}
