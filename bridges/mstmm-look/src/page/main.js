// Puts the page together, and runs the time.

const settings = {
  point: 0, forces: "all", moments: "one", scale: 0, trails: "ends", shapes: true, names: false, axes: false, hinges: false, springs: true,
  masses: true, weights: false, numbers: true, grid: true, follow: false,
};

/** Returns the direction against gravity; without gravity z, in a plane y. */
function upwards() {
  const gravity = norm(model.gravity);
  if (gravity > 0) return scaled(model.gravity, -1 / gravity);
  return model.dimensions === 3 ? [0, 0, 1] : [0, 1, 0];
}

/** Returns a colour of the style sheet as components from 0 to 1. */
function tint(name) {
  const text = getComputedStyle(document.documentElement).getPropertyValue(name).trim();
  return [1, 3, 5].map(k => parseInt(text.slice(k, k + 2), 16) / 255);
}

class Page {
  constructor(motion) {
    this.motion = motion;
    this.canvas = element("view");
    this.renderer = new Renderer(document.createElement("canvas"));
    this.scene = new Scene(motion, this.renderer, settings);
    this.camera = new Camera(upwards(), model.dimensions < 3);
    this.overlay = new Overlay(this.scene, this.canvas);
    this.plots = new Plots(motion, time => this.seek(motion.frameAt(time + 1e-9 * Math.abs(time))));
    this.wrench = new Wrench(motion, settings);
    [this.frame, this.time, this.isPlaying, this.isStale] = [0, motion.start, false, true];
    [this.drawn, this.rate, this.counted] = [0, 0, performance.now()];
    bind(settings, () => { this.wrench.update(this.frame); this.changed(); });
    this.toggleTheme = bindTheme(() => { this.colours = undefined; this.plots.redraw(); this.changed(); });
    steer(this.canvas, this.camera, () => this.changed(), (x, y) => this.pick(x, y));
    this.bindTime(); this.bindKeys(); this.describe();
    new ResizeObserver(() => { this.resize(); this.changed(); }).observe(element("stage"));
    this.resize(); this.fit(); this.seek(0); this.defaultPlots();
    element("message").textContent = "";
    requestAnimationFrame(now => this.tick(now));
  }

  changed() { this.isStale = true; }

  resize() {
    const { clientWidth: width, clientHeight: height } = element("stage"), ratio = BY_SOFTWARE ? 1 : Math.min(devicePixelRatio, 2);
    for (const canvas of [this.canvas, this.renderer.gl.canvas]) {
      if (canvas.width !== Math.round(width * ratio)) canvas.width = Math.round(width * ratio);
      if (canvas.height !== Math.round(height * ratio)) canvas.height = Math.round(height * ratio);
    }
    [this.ratio, this.width, this.height] = [ratio, width, height];
    this.camera.update(width, height);
  }

  fit() {
    const { centre, radius } = this.scene.extent;
    this.camera.fit(centre, radius, this.camera.width, this.camera.height);
    this.changed();
  }

  describe() {
    const { motion } = this, duration = digits(motion.end - motion.start);
    element("title").textContent = model.title;
    element("summary").textContent = `${model.bodies.length} ${model.bodies.length === 1 ? "body" : "bodies"}, ${motion.frames} frames in ${duration} s`;
    element("docs").textContent = model.docs;
    element("notes").replaceChildren(...this.scene.notes.map(note => Object.assign(document.createElement("li"), { textContent: note })));
    element("accuracy").textContent = "Values on this page have 16 bits over the range of each quantity: they are exact to half a step, 1/131 070 of the range. CSV and NPZ files of the recording are exact.";
    element("quantities").replaceChildren(...motion.columns.slice(1).map(column => new Option(column.name)));
    element("add").addEventListener("submit", event => {
      event.preventDefault();
      const name = element("quantity").value.trim(), column = motion.byName.get(name);
      element("wrong").textContent = column === undefined && name ? `There is no quantity ${name}.` : "";
      if (column === undefined) return;
      this.plots.add(column);
      element("quantity").value = "";
    });
    element("quantity").addEventListener("change", () => element("add").requestSubmit());
    for (const id of ["springs", "hinges"]) element(id).parentElement.hidden = model[id === "hinges" ? "axes" : id].length === 0;
    for (const [kind, unit] of [["force", "N"], ["moment", "N*m"]]) {
      if (!motion.blocks.has(kind)) document.querySelector(`#legend .${kind}`).remove();
    }
  }

  /** The first coordinates of the mechanism and, if it has none, the first point. */
  defaultPlots() {
    const block = this.motion.blocks.get("coordinates");
    if (!block) return;
    const columns = Array.from({ length: block.shape[0] }, (_, k) => block.first + k).filter(column => this.motion.columns[column].unit !== "1");
    columns.slice(0, 3).forEach(column => this.plots.add(column));
  }

  bindTime() {
    const slider = element("slider"), step = by => { this.pause(); this.seek(this.frame + by); };
    slider.max = this.motion.frames - 1;
    slider.addEventListener("input", () => this.seek(Number(slider.value)));
    element("play").addEventListener("click", () => this.isPlaying ? this.pause() : this.play());
    element("first").addEventListener("click", () => this.seek(0));
    element("back-one").addEventListener("click", () => step(-1));
    element("forward-one").addEventListener("click", () => step(1));
    element("fit").addEventListener("click", () => { this.camera.home(); this.fit(); });
    for (const button of document.querySelectorAll(".side")) {
      button.addEventListener("click", () => { this.camera.along(button.dataset.side); this.changed(); });
    }
    element("help").addEventListener("click", () => this.help());
  }

  help() {
    const keys = element("keys");
    keys.hidden = !keys.hidden;
    element("help").setAttribute("aria-expanded", String(!keys.hidden));
  }

  bindKeys() {
    const actions = {
      " ": () => this.isPlaying ? this.pause() : this.play(),
      ",": () => { this.pause(); this.seek(this.frame - 1); }, ".": () => { this.pause(); this.seek(this.frame + 1); },
      Home: () => this.seek(0), End: () => this.seek(this.motion.frames - 1),
      f: () => { this.camera.home(); this.fit(); }, t: () => this.toggleTheme(), "?": () => this.help(),
    };
    document.addEventListener("keydown", event => {
      const isTyping = event.target.matches("input:not([type=checkbox]), select, button, summary");
      const action = actions[event.key.length === 1 ? event.key.toLowerCase() : event.key];
      if (!action || isTyping || event.ctrlKey || event.metaKey || event.altKey) return;
      event.preventDefault();
      action();
    });
  }

  play() {
    if (this.frame === this.motion.frames - 1) this.seek(0);
    [this.isPlaying, this.before] = [true, undefined];
    this.time = this.motion.time(this.frame);
    this.showPlaying();
  }
  pause() { this.isPlaying = false; this.showPlaying(); }
  showPlaying() {
    const button = element("play");
    button.textContent = this.isPlaying ? "❚❚" : "▶";
    button.setAttribute("aria-label", this.isPlaying ? "Pause" : "Play");
  }

  seek(frame) {
    this.show(Math.max(0, Math.min(this.motion.frames - 1, frame)));
    this.time = this.motion.time(this.frame);
  }

  show(frame) {
    const { motion } = this, slider = element("slider"), text = `${motion.time(frame).toFixed(3)} s`;
    this.frame = frame;
    slider.value = frame;
    slider.setAttribute("aria-valuetext", text);
    element("clock").textContent = `${text} / ${motion.end.toFixed(2)} s`;
    this.wrench.update(frame);
    this.plots.update(frame);
    this.changed();
  }

  tick(now) {
    if (this.isPlaying) {
      const passed = this.before === undefined ? 0 : Math.min(0.25, (now - this.before) / 1000);
      this.before = now;
      this.time += passed * Number(element("speed").value);
      if (this.time > this.motion.end) {
        if (element("loop").checked) this.time = this.motion.start;
        else { this.time = this.motion.end; this.pause(); }
      }
      const frame = this.motion.frameAt(this.time);
      if (frame !== this.frame) this.show(frame);
    }
    if (this.isStale) { this.isStale = false; this.draw(); }
    requestAnimationFrame(now => this.tick(now));
  }

  draw() {
    const { camera, scene, overlay, frame, motion } = this;
    if (settings.follow) this.follow();
    this.colours ??= { force: tint("--force"), moment: tint("--moment"), weight: tint("--weight"), css: new Map() };
    const css = name => this.css(name);
    camera.update(this.width, this.height);
    overlay.begin(camera, this.ratio, [css("--sky"), css("--ground")]);
    overlay.halo = css("--halo");
    if (settings.grid) overlay.grid(css("--grid"));
    for (const [placeAt, colour] of this.trails(css("--accent"))) overlay.trail(placeAt, motion, frame, colour);
    this.renderer.begin(camera, this.canvas.width, this.canvas.height);
    scene.addBodies(frame);
    if (settings.springs) scene.addSprings(frame, camera);
    const arrows = scene.arrows(frame);
    scene.addArrows(arrows, camera, this.colours);
    this.renderer.flush();
    overlay.picture(this.renderer.gl.canvas);
    this.annotate(arrows, css);
    this.drawn++;
    const now = performance.now();
    if (now - this.counted > 1000) [this.rate, this.drawn, this.counted] = [1000 * this.drawn / (now - this.counted), 0, now];
  }

  /** Returns a value of the style sheet; the browser takes long to look it up. */
  css(name) {
    const { css } = this.colours;
    if (!css.has(name)) css.set(name, getComputedStyle(document.documentElement).getPropertyValue(name).trim());
    return css.get(name);
  }

  /** Moves the camera with the bodies. */
  follow() {
    const inputs = model.bodies.map(body => body.input).filter(it => it !== null);
    const centre = scaled(inputs.map(point => this.motion.position(point, this.frame)).reduce(add), 1 / inputs.length);
    if (this.followed) this.camera.target = add(this.camera.target, subtract(centre, this.followed));
    this.followed = centre;
  }

  trails(colour) {
    const { scene, motion } = this, within = ({ body, offset }) => frame => {
      const [at, turned] = scene.pose(body, frame);
      return add(at, rotate(turned, offset));
    };
    const hue = body => `rgb(${colourOf.get(model.bodies[body].type).map(x => Math.round(255 * x))})`;
    switch (settings.trails) {
      case "ends": return scene.ends.slice(0, 12).map(end => [within(end), hue(end.body)]);
      case "one": return [[frame => motion.position(settings.point, frame), colour]];
      case "bodies": return model.bodies.slice(0, 60).map((body, index) => [within({ body: index, offset: body.com }), hue(index)]);
      default: return [];
    }
  }

  /** Draws symbols, axes, names and values over the picture. */
  annotate(arrows, css) {
    const { scene, overlay, motion, frame, camera } = this, size = scene.extent.size, ink = css("--ink");
    model.bodies.forEach((body, index) => {
      if (body.input === null) return;
      const [at, turned] = scene.pose(index, frame), com = add(at, rotate(turned, body.com));
      if (settings.masses) overlay.mass(com, Math.min(4.5, 0.16 * scene.lengths[index] / camera.pixel()), ink, css("--halo"));
      if (settings.axes) overlay.axes(at, turned, 0.07 * size);
    });
    if (settings.hinges) scene.axes(frame).forEach(ends => overlay.axis(ends, ink, css("--halo")));
    overlay.ring(motion.position(settings.point, frame), 8, css("--accent"));
    overlay.corner(ink);
    for (const { kind, at, vector } of arrows) {
      if (kind === "moment" && camera.flat) overlay.moment(at, vector[2], css("--moment"));
    }
    if (settings.numbers) {
      const labelled = [...arrows].sort((a, b) => (b.point === settings.point) - (a.point === settings.point) || b.size - a.size);
      for (const { kind, at, vector, size } of labelled.slice(0, 24)) {
        const isArc = kind === "moment" && camera.flat;
        overlay.label(measure(size, kind === "moment" ? "N*m" : "N"), isArc ? at : add(at, vector), css("--" + kind), isArc ? 30 : 7, isArc ? 16 : 0);
      }
    }
    if (settings.names) {
      model.bodies.forEach((body, index) => {
        if (body.input === null) return;
        const [at, turned] = scene.pose(index, frame);
        overlay.label(body.name, add(at, rotate(turned, body.com)), ink);
      });
      if (settings.springs) model.springs.forEach((spring, index) => overlay.label(spring.name, scaled(add(...scene.springEnds(index, frame)), 0.5), ink));
    }
    overlay.label(model.points[settings.point].name, motion.position(settings.point, frame), css("--accent"), 12, -22);
    const scale = scene.largest.force ? measure(scene.largest.force / (0.3 * size * 10 ** settings.scale) * 100 * camera.pixel(), "N") : "";
    element("scales").textContent = [settings.grid && `grid ${measure(overlay.step, "m")}`, scale && `100 px = ${scale}`].filter(it => it).join(" · ");
  }

  /** Selects the connection point at a pixel; among points that coincide the input of a body. */
  pick(x, y) {
    let best = [16, undefined];
    model.points.forEach((point, index) => {
      const pixel = this.camera.project(this.motion.position(index, this.frame));
      if (!pixel) return;
      const isInput = point.body !== null && model.bodies[point.body].input === index;
      const distance = Math.hypot(pixel[0] - x, pixel[1] - y) - (isInput ? 0.5 : 0);
      if (distance < best[0]) best = [distance, index];
    });
    if (best[1] === undefined) return;
    element("point").value = best[1];
    element("point").dispatchEvent(new Event("input"));
  }
}

(async () => {
  try {
    const planes = await inflate(bytesOf(document.getElementById("values").textContent));
    const page = new Page(new Motion(planes));
    // For the console and for tests.
    window.recording = {
      columns: model.columns.map(({ name, unit }) => ({ name, unit })),
      get frame() { return page.frame; },
      get rate() { return page.rate; },
      get camera() { return { yaw: page.camera.yaw, pitch: page.camera.pitch, distance: page.camera.distance, target: page.camera.target }; },
      value: (name, frame = page.frame) => page.motion.value(page.motion.byName.get(name), frame),
      uncertainty: name => page.motion.uncertainty(page.motion.byName.get(name)),
      seek: frame => page.seek(frame),
      project: point => page.camera.project(page.motion.position(model.points.findIndex(it => it.name === point), page.frame)),
      springEnds: name => page.scene.springEnds(model.springs.findIndex(it => it.name === name), page.frame),
      axes: hinge => page.scene.axes(page.frame).filter((_, index) => model.axes[index].hinge === hinge),
      pixel: place => page.camera.project(place),
    };
  } catch (error) {
    element("message").textContent = error.message;
    throw error;
  }
})();
