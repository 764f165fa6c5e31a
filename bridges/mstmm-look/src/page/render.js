// Draws surfaces by WebGL.

// Browsers that draw by the processor take about as long for an instance as for a whole buffer of triangles. Surfaces with few
// triangles are therefore put into one buffer in each frame; only meshes from files stay in their own buffers.

const FEW = `#version 300 es
layout(location=0) in vec3 corner; layout(location=1) in vec3 normal; layout(location=2) in vec3 tint; layout(location=3) in float layer;
uniform mat4 project;
out vec3 n; out vec3 p; out vec3 c;
void main() {
  p = corner; n = normal; c = tint;
  gl_Position = project * vec4(p, 1.0);
  // The near half of all depths is for arrows, the far half for bodies.
  gl_Position.z = 0.5 * gl_Position.z + layer * gl_Position.w;
}`;
const MANY = `#version 300 es
layout(location=0) in vec3 corner; layout(location=1) in vec3 normal;
uniform mat3 axes; uniform vec3 origin; uniform vec3 tint;
uniform mat4 project;
out vec3 n; out vec3 p; out vec3 c;
void main() {
  // The axes of a mesh have equal lengths.
  p = origin + axes * corner; n = axes * normal; c = tint;
  gl_Position = project * vec4(p, 1.0);
  gl_Position.z = 0.5 * (gl_Position.z + gl_Position.w);
}`;
const FRAGMENT = `#version 300 es
precision highp float;
in vec3 n; in vec3 p; in vec3 c;
uniform vec3 eye; uniform vec3 sun; uniform vec3 up;
out vec4 colour;
void main() {
  vec3 to = normalize(eye - p), m = normalize(n);
  if (dot(m, to) < 0.0) m = -m;
  float sky = 0.5 + 0.5 * dot(m, up);
  float light = 0.50 + 0.22 * sky + 0.42 * max(0.0, dot(m, sun));
  // The power 32 of the cosine.
  float shine = max(0.0, dot(m, normalize(sun + to)));
  shine *= shine; shine *= shine; shine *= shine; shine *= shine; shine *= shine;
  colour = vec4(c * light + 0.16 * shine, 1.0);
}`;

/** Whether the browser draws by the processor: then edges are not smoothed, which would take most of the time. */
const BY_SOFTWARE = (() => {
  const gl = document.createElement("canvas").getContext("webgl2"), info = gl?.getExtension("WEBGL_debug_renderer_info");
  const name = gl ? String(gl.getParameter(info ? info.UNMASKED_RENDERER_WEBGL : gl.RENDERER)) : "";
  gl?.getExtension("WEBGL_lose_context")?.loseContext();
  return /swiftshader|llvmpipe|software/i.test(name);
})();

/** The numbers of a vertex: place, normal, colour, layer. */
const STRIDE = 10, BODIES = 0.5, ARROWS = -0.5;

/** A typed array that grows. */
class Buffer {
  constructor(type) { this.array = new type(1 << 12); this.used = 0; }
  reserve(count) {
    if (this.used + count <= this.array.length) return;
    const longer = new this.array.constructor(2 * (this.used + count));
    longer.set(this.array);
    this.array = longer;
  }
  get all() { return this.array.subarray(0, this.used); }
}

class Renderer {
  constructor(canvas) {
    const gl = canvas.getContext("webgl2", { antialias: !BY_SOFTWARE, alpha: true, premultipliedAlpha: true, powerPreference: "low-power" });
    if (!gl) throw new Error("This page needs WebGL 2, which this browser does not offer.");
    this.gl = gl;
    [this.few, this.many] = [this.program(FEW), this.program(MANY)];
    gl.enable(gl.DEPTH_TEST);
    [this.surfaces, this.meshes] = [new Map(), new Map()];
    [this.vertices, this.indices] = [new Buffer(Float32Array), new Buffer(Uint32Array)];
    this.array = gl.createVertexArray();
    gl.bindVertexArray(this.array);
    [this.vertexBuffer, this.indexBuffer] = [gl.createBuffer(), gl.createBuffer()];
    gl.bindBuffer(gl.ARRAY_BUFFER, this.vertexBuffer);
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, this.indexBuffer);
    for (let k = 0; k < 4; k++) {
      gl.enableVertexAttribArray(k);
      gl.vertexAttribPointer(k, k < 3 ? 3 : 1, gl.FLOAT, false, 4 * STRIDE, 12 * k);
    }
  }

  /** Returns a program with the places of its uniforms. */
  program(vertex) {
    const gl = this.gl, program = gl.createProgram();
    for (const [type, text] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, FRAGMENT]]) {
      const shader = gl.createShader(type);
      gl.shaderSource(shader, text); gl.compileShader(shader); gl.attachShader(program, shader);
    }
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(program));
    const names = ["project", "eye", "sun", "up", "axes", "origin", "tint"];
    return { program, ...Object.fromEntries(names.map(name => [name, gl.getUniformLocation(program, name)])) };
  }

  /** Adds a surface with few triangles under a name. */
  surface(name, surface) { this.surfaces.set(name, surface); }

  /** Adds a mesh under a name. */
  mesh(name, surface) {
    const gl = this.gl, array = gl.createVertexArray();
    gl.bindVertexArray(array);
    [surface.corners, surface.normals].forEach((data, location) => {
      gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
      gl.bufferData(gl.ARRAY_BUFFER, new Float32Array(data), gl.STATIC_DRAW);
      gl.enableVertexAttribArray(location); gl.vertexAttribPointer(location, 3, gl.FLOAT, false, 0, 0);
    });
    this.meshes.set(name, { array, count: surface.corners.length / 3, places: [] });
  }

  /** Adds a surface with axes `x`, `y`, `z`, which are normal to each other; small ones have fewer triangles. */
  add(kind, x, y, z, origin, tint, layer = BODIES) {
    const mesh = this.meshes.get(kind);
    if (mesh) { mesh.places.push([x, y, z, origin, tint]); return; }
    const surface = (norm(x) < this.small && this.surfaces.get(kind + " small")) || this.surfaces.get(kind);
    const { vertices, indices } = this, { corners, normals, triangles } = surface, first = vertices.used / STRIDE;
    vertices.reserve(corners.length / 3 * STRIDE); indices.reserve(triangles.length);
    const v = vertices.array, [a, b, c] = [x, y, z].map(axis => 1 / dot(axis, axis)), [r, g, blue] = tint;
    let place = vertices.used;
    for (let k = 0; k < corners.length; k += 3) {
      const i = corners[k], j = corners[k + 1], l = corners[k + 2];
      const m = a * normals[k], n = b * normals[k + 1], o = c * normals[k + 2];
      for (let axis = 0; axis < 3; axis++) {
        v[place + axis] = origin[axis] + x[axis] * i + y[axis] * j + z[axis] * l;
        v[place + 3 + axis] = x[axis] * m + y[axis] * n + z[axis] * o;
      }
      v[place + 6] = r; v[place + 7] = g; v[place + 8] = blue; v[place + 9] = layer;
      place += STRIDE;
    }
    vertices.used = place;
    for (let k = 0; k < triangles.length; k++) indices.array[indices.used++] = first + triangles[k];
  }

  begin(camera, width, height) {
    const gl = this.gl;
    gl.viewport(0, 0, width, height);
    gl.clearColor(0, 0, 0, 0); gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    this.small = 7 * camera.pixel();
    const sun = add(add(scaled(camera.back, 0.55), scaled(camera.above, 0.7)), scaled(camera.right, -0.45));
    for (const it of [this.few, this.many]) {
      gl.useProgram(it.program);
      gl.uniformMatrix4fv(it.project, false, camera.matrix());
      gl.uniform3fv(it.eye, camera.eye);
      gl.uniform3fv(it.up, camera.flat ? [0, 0.6, 0.8] : camera.up);
      gl.uniform3fv(it.sun, unit(sun));
    }
  }

  /** Draws all that was added. */
  flush() {
    const { gl, vertices, indices } = this;
    if (indices.used > 0) {
      gl.useProgram(this.few.program);
      gl.bindVertexArray(this.array);
      gl.bindBuffer(gl.ARRAY_BUFFER, this.vertexBuffer);
      gl.bufferData(gl.ARRAY_BUFFER, vertices.all, gl.DYNAMIC_DRAW);
      gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, indices.all, gl.DYNAMIC_DRAW);
      // The inner side of a closed surface is never seen.
      gl.enable(gl.CULL_FACE);
      gl.drawElements(gl.TRIANGLES, indices.used, gl.UNSIGNED_INT, 0);
      gl.disable(gl.CULL_FACE);
      vertices.used = indices.used = 0;
    }
    gl.useProgram(this.many.program);
    for (const { array, count, places } of this.meshes.values()) {
      if (places.length > 0) gl.bindVertexArray(array);
      for (const [x, y, z, origin, tint] of places.splice(0)) {
        gl.uniformMatrix3fv(this.many.axes, false, [...x, ...y, ...z]);
        gl.uniform3fv(this.many.origin, origin); gl.uniform3fv(this.many.tint, tint);
        gl.drawArrays(gl.TRIANGLES, 0, count);
      }
    }
  }
}
