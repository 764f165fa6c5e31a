// Plots of quantities against time.

const LINES = ["#1f77d0", "#d9730d", "#2f9e62", "#b3408f", "#8a6d1b", "#5a67d8"];

class Plots {
  constructor(motion, seek) {
    [this.motion, this.seek, this.all] = [motion, seek, []];
    this.root = document.getElementById("plots");
    new ResizeObserver(() => this.redraw()).observe(this.root);
  }

  /** Adds a quantity: to the last plot if that has the same unit and place, else to a new one. */
  add(column) {
    const { unit } = this.motion.columns[column];
    let plot = this.all[this.all.length - 1];
    if (this.all.some(it => it.columns.includes(column))) return;
    if (!plot || plot.unit !== unit || plot.columns.length === LINES.length) {
      plot = this.create(unit);
      this.all.push(plot);
    }
    plot.columns.push(column);
    this.fill(plot);
  }

  create(unit) {
    const figure = document.createElement("figure"), area = document.createElement("div");
    const plot = { unit, columns: [], figure, area, caption: document.createElement("figcaption") };
    figure.className = "plot"; area.className = "area";
    plot.canvas = document.createElement("canvas"); plot.cursor = document.createElement("div");
    plot.cursor.className = "cursor";
    area.append(plot.canvas, plot.cursor); figure.append(plot.caption, area); this.root.append(figure);
    const seek = event => {
      const { left, width } = area.getBoundingClientRect(), [a, b] = this.sides(width);
      const share = Math.max(0, Math.min(1, (event.clientX - left - a) / (b - a)));
      this.seek(this.motion.start + share * (this.motion.end - this.motion.start));
    };
    area.addEventListener("pointerdown", event => { area.setPointerCapture(event.pointerId); seek(event); });
    area.addEventListener("pointermove", event => { if (event.buttons) seek(event); });
    return plot;
  }

  sides(width) { return [58, width - 8]; }

  fill(plot) {
    plot.values = plot.columns.map((column, index) => {
      const { name, unit } = this.motion.columns[column], key = document.createElement("button");
      key.type = "button"; key.className = "key"; key.dataset.name = name;
      const off = this.motion.uncertainty(column);
      key.title = `Remove ${name}` + (off ? `; its values are exact to ± ${digits(off)} ${unit}` : "");
      const line = document.createElement("i"), value = document.createElement("b");
      line.style.background = LINES[index];
      key.append(line, name + " ", value);
      key.addEventListener("click", () => this.remove(plot, column));
      return [key, value];
    });
    plot.caption.replaceChildren(...plot.values.map(([key]) => key));
    this.draw(plot);
    this.update(this.frame ?? 0);
  }

  remove(plot, column) {
    plot.columns = plot.columns.filter(it => it !== column);
    if (plot.columns.length) return this.fill(plot);
    plot.figure.remove();
    this.all = this.all.filter(it => it !== plot);
  }

  redraw() { this.all.forEach(plot => this.draw(plot)); this.update(this.frame ?? 0); }

  /** Draws the curves: least and largest value of the frames within each pixel. */
  draw(plot) {
    const { motion } = this, width = plot.area.clientWidth, height = plot.area.clientHeight, ratio = devicePixelRatio;
    if (!width) return;
    plot.width = width;
    [plot.canvas.width, plot.canvas.height] = [width * ratio, height * ratio];
    const context = plot.canvas.getContext("2d"), style = getComputedStyle(document.documentElement);
    const soft = style.getPropertyValue("--soft"), faint = style.getPropertyValue("--line");
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    const [left, right] = this.sides(width), [top, bottom] = [6, height - 20], pixels = Math.max(1, Math.floor(right - left));
    const perPixel = Math.max(1, Math.ceil(motion.frames / (2 * pixels)));
    const curves = plot.columns.map(column => {
      const points = [];
      for (let from = 0; from < motion.frames; from += perPixel) {
        let [low, high] = [Infinity, -Infinity];
        const to = Math.min(motion.frames, from + perPixel);
        for (let frame = from; frame < to; frame++) {
          const value = motion.value(column, frame);
          if (value < low) low = value;
          if (value > high) high = value;
        }
        points.push([motion.time(from), low, high]);
      }
      return points;
    });
    let low = Math.min(...curves.flat().map(it => it[1])), high = Math.max(...curves.flat().map(it => it[2]));
    if (high - low < 1e-12 * Math.max(Math.abs(low), Math.abs(high), 1e-300)) {
      const pad = Math.abs(high) * 0.1 || 1; [low, high] = [low - pad, high + pad];
    }
    const pad = 0.06 * (high - low); [low, high] = [low - pad, high + pad];
    const span = motion.end - motion.start || 1;
    const x = time => left + (time - motion.start) / span * (right - left), y = value => bottom - (value - low) / (high - low) * (bottom - top);
    context.font = "11px system-ui, sans-serif"; context.fillStyle = soft; context.strokeStyle = faint; context.lineWidth = 1;
    context.textAlign = "right"; context.textBaseline = "middle";
    for (const tick of ticks(low, high, 4)) {
      context.beginPath(); context.moveTo(left, y(tick)); context.lineTo(right, y(tick)); context.stroke();
      context.fillText(digits(tick), left - 6, y(tick));
    }
    context.textAlign = "center"; context.textBaseline = "top";
    for (const tick of ticks(motion.start, motion.end, Math.max(2, Math.floor(pixels / 90)))) {
      context.fillText(digits(tick) + " s", Math.min(right - 12, Math.max(left + 8, x(tick))), bottom + 5);
    }
    context.save(); context.translate(10, (top + bottom) / 2); context.rotate(-Math.PI / 2); context.textBaseline = "middle";
    context.fillText(plot.unit === "1" ? "" : plot.unit.replace("*", "·").replace("^2", "²"), 0, 0); context.restore();
    context.lineJoin = "round"; context.lineWidth = 1.6;
    curves.forEach((points, index) => {
      context.strokeStyle = LINES[index];
      context.beginPath();
      points.forEach(([time, least, most], k) => {
        k ? context.lineTo(x(time), y(least)) : context.moveTo(x(time), y(least));
        if (most !== least) context.lineTo(x(time), y(most));
      });
      context.stroke();
    });
  }

  /** Moves the cursors and shows the values of a frame. */
  update(frame) {
    this.frame = frame;
    const { motion } = this, share = (motion.time(frame) - motion.start) / (motion.end - motion.start || 1);
    for (const plot of this.all) {
      const [left, right] = this.sides(plot.width ?? plot.area.clientWidth);
      plot.cursor.style.transform = `translateX(${left + share * (right - left)}px)`;
      plot.columns.forEach((column, index) => {
        const value = motion.value(column, frame), isZero = Math.abs(value) <= 1.01 * motion.uncertainty(column);
        plot.values[index][1].textContent = measure(isZero ? 0 : value, plot.unit);
      });
    }
  }
}

/** Returns round values between two bounds. */
function ticks(low, high, count) {
  const raw = (high - low) / Math.max(1, count), power = 10 ** Math.floor(Math.log10(raw || 1));
  const step = power * [1, 2, 5, 10].find(k => k * power >= raw), found = [];
  for (let k = Math.ceil(low / step); k * step <= high && found.length < 20; k++) found.push(k * step);
  return found;
}
