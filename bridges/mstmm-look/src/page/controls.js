// Mouse, touch and keys of the view, and the controls of the panel.

const element = id => document.getElementById(id);

/** Lets pointers and keys move the camera. `picked` is called with the pixel of a click. */
function steer(canvas, camera, changed, picked) {
  const pointers = new Map();
  let travelled = 0, spread = 0;
  const middle = () => { const all = [...pointers.values()]; return [0, 1].map(k => all.reduce((sum, it) => sum + it[k], 0) / all.length); };
  const width = () => { const [a, b] = [...pointers.values()]; return b ? Math.hypot(a[0] - b[0], a[1] - b[1]) : 0; };
  canvas.addEventListener("pointerdown", event => {
    canvas.setPointerCapture(event.pointerId); canvas.focus({ preventScroll: true });
    pointers.set(event.pointerId, [event.clientX, event.clientY]);
    [travelled, spread] = [pointers.size > 1 ? 99 : 0, width()];
  });
  canvas.addEventListener("pointermove", event => {
    if (!pointers.has(event.pointerId)) return;
    const before = middle();
    pointers.set(event.pointerId, [event.clientX, event.clientY]);
    const after = middle(), [dx, dy] = [after[0] - before[0], after[1] - before[1]];
    travelled += Math.hypot(dx, dy);
    if (pointers.size > 1) {
      if (spread && width()) camera.zoom(spread / width());
      spread = width();
      camera.pan(dx, dy, canvas.clientHeight);
    } else if (event.shiftKey || event.ctrlKey || event.buttons & 6) camera.pan(dx, dy, canvas.clientHeight);
    else camera.orbit(dx * 0.008, dy * 0.008);
    changed();
  });
  const release = event => {
    if (!pointers.delete(event.pointerId)) return;
    spread = width();
    if (travelled < 5 && event.type === "pointerup") {
      const { left, top } = canvas.getBoundingClientRect();
      picked(event.clientX - left, event.clientY - top);
    }
  };
  for (const type of ["pointerup", "pointercancel"]) canvas.addEventListener(type, release);
  canvas.addEventListener("contextmenu", event => event.preventDefault());
  canvas.addEventListener("wheel", event => {
    event.preventDefault();
    camera.zoom(Math.exp(Math.max(-60, Math.min(60, event.deltaY)) * 0.0025));
    changed();
  }, { passive: false });
  canvas.addEventListener("keydown", event => {
    const step = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] }[event.key];
    if (step && event.shiftKey) camera.pan(-24 * step[0], -24 * step[1], canvas.clientHeight);
    else if (step) camera.orbit(0.08 * step[0], 0.08 * step[1]);
    else if (event.key === "+" || event.key === "=") camera.zoom(0.9);
    else if (event.key === "-") camera.zoom(1 / 0.9);
    else return;
    event.preventDefault();
    changed();
  });
}

/** Binds settings to the controls of the same id. */
function bind(settings, changed) {
  for (const id of Object.keys(settings)) {
    const control = element(id), isCheck = control.type === "checkbox";
    const read = () => {
      settings[id] = isCheck ? control.checked : typeof settings[id] === "number" ? Number(control.value) : control.value;
    };
    read();
    control.addEventListener("input", () => { read(); changed(); });
  }
}

/** Light and dark: that of the system until the button is used. */
function bindTheme(changed) {
  const system = matchMedia("(prefers-color-scheme: dark)");
  let chosen;
  const apply = () => {
    document.documentElement.dataset.theme = chosen ?? (system.matches ? "dark" : "light");
    changed();
  };
  system.addEventListener("change", apply);
  const toggle = () => {
    chosen = document.documentElement.dataset.theme === "dark" ? "light" : "dark";
    apply();
  };
  element("theme").addEventListener("click", toggle);
  apply();
  return toggle;
}

/** The list of connection points, and the table of force and moment at the chosen one. */
class Wrench {
  constructor(motion, settings) {
    [this.motion, this.settings] = [motion, settings];
    const select = element("point");
    select.replaceChildren(...model.points.map((point, index) => new Option(point.name, index)));
    const first = model.points.findIndex(point => point.body !== null && model.bodies[point.body].input === model.points.indexOf(point));
    select.value = Math.max(0, first);
    const rows = [["position", "position", "m"], ["force", "force", "N"], ["moment", "moment", "N*m"]];
    this.rows = rows.filter(([block]) => motion.blocks.has(block)).map(([block, name, unit]) => {
      const row = element("wrench").tBodies[0].insertRow(), head = document.createElement("th");
      row.className = block;
      head.textContent = name; head.scope = "row"; row.append(head);
      return { block, unit, head, name, cells: [0, 1, 2, 3].map(() => row.insertCell()) };
    });
    element("sign").textContent = motion.blocks.has("force")
      ? "Inertial axes. Force on the outboard element, moment on the inboard element, as the state vector z has them; the arrows show both on the outboard element."
      : "The recording has no forces and moments.";
  }
  update(frame) {
    for (const { block, unit, head, name, cells } of this.rows) {
      const vector = this.motion.position && this.motion[block](this.settings.point, frame);
      head.textContent = `${name} [${unit.replace("*", "·")}]`;
      [...vector, norm(vector)].forEach((value, k) => { cells[k].textContent = digits(value, 4); });
    }
  }
}
