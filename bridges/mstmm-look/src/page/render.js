// Draws instances of surfaces by WebGL.

const VERTEX = `#version 300 es
layout(location=0) in vec3 corner; layout(location=1) in vec3 normal;
layout(location=2) in vec3 ax; layout(location=3) in vec3 ay; layout(location=4) in vec3 az;
layout(location=5) in vec3 origin; layout(location=6) in vec4 tint;
uniform mat4 project;
out vec3 n; out vec3 p; out vec4 c;
void main() {
  p = origin + ax * corner.x + ay * corner.y + az * corner.z;
  // The axes are normal to each other.
  n = ax * (normal.x / dot(ax, ax)) + ay * (normal.y / dot(ay, ay)) + az * (normal.z / dot(az, az));
  c = tint;
  gl_Position = project * vec4(p, 1.0);
}`;
const FRAGMENT = `#version 300 es
precision highp float;
in vec3 n; in vec3 p; in vec4 c;
uniform vec3 eye; uniform vec3 sun; uniform vec3 up;
out vec4 colour;
void main() {
  vec3 to = normalize(eye - p), m = normalize(n);
  if (dot(m, to) < 0.0) m = -m;
  float sky = 0.5 + 0.5 * dot(m, up);
  float light = 0.50 + 0.22 * sky + 0.42 * max(0.0, dot(m, sun));
  float shine = 0.16 * pow(max(0.0, dot(m, normalize(sun + to))), 40.0);
  colour = vec4((c.rgb * light + shine) * c.a, c.a);
}`;

/** Whether the browser draws by the processor: then edges are not smoothed, which would take most of the time. */
const BY_SOFTWARE = (() => {
  const gl = document.createElement("canvas").getContext("webgl2"), info = gl?.getExtension("WEBGL_debug_renderer_info");
  const name = gl ? String(gl.getParameter(info ? info.UNMASKED_RENDERER_WEBGL : gl.RENDERER)) : "";
  gl?.getExtension("WEBGL_lose_context")?.loseContext();
  return /swiftshader|llvmpipe|software/i.test(name);
})();

/** The numbers of an instance: three axes, origin, colour. */
const STRIDE = 16;

class Renderer {
  constructor(canvas) {
    const gl = canvas.getContext("webgl2", { antialias: !BY_SOFTWARE, alpha: true, premultipliedAlpha: true, powerPreference: "low-power" });
    if (!gl) throw new Error("This page needs WebGL 2, which this browser does not offer.");
    this.gl = gl;
    const program = gl.createProgram();
    for (const [type, text] of [[gl.VERTEX_SHADER, VERTEX], [gl.FRAGMENT_SHADER, FRAGMENT]]) {
      const shader = gl.createShader(type);
      gl.shaderSource(shader, text); gl.compileShader(shader); gl.attachShader(program, shader);
    }
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(program));
    gl.useProgram(program);
    this.uniform = name => gl.getUniformLocation(program, name);
    [this.project, this.eye, this.sun, this.up] = ["project", "eye", "sun", "up"].map(this.uniform);
    gl.enable(gl.DEPTH_TEST); gl.enable(gl.BLEND); gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
    this.kinds = new Map();
  }

  /** Adds a surface under a name. */
  surface(name, surface) {
    const gl = this.gl, array = gl.createVertexArray();
    gl.bindVertexArray(array);
    const attribute = (data, location) => {
      gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
      gl.bufferData(gl.ARRAY_BUFFER, new Float32Array(data), gl.STATIC_DRAW);
      gl.enableVertexAttribArray(location); gl.vertexAttribPointer(location, 3, gl.FLOAT, false, 0, 0);
    };
    attribute(surface.corners, 0); attribute(surface.normals, 1);
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, gl.createBuffer());
    gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, new Uint32Array(surface.triangles), gl.STATIC_DRAW);
    const buffer = gl.createBuffer();
    gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
    for (let k = 0; k < 5; k++) {
      gl.enableVertexAttribArray(2 + k);
      gl.vertexAttribPointer(2 + k, k < 4 ? 3 : 4, gl.FLOAT, false, 4 * STRIDE, 12 * k);
      gl.vertexAttribDivisor(2 + k, 1);
    }
    this.kinds.set(name, { array, buffer, count: surface.triangles.length, instances: [] });
  }

  /** Adds an instance with axes `x`, `y`, `z` of a surface; small ones have fewer triangles. */
  add(kind, x, y, z, origin, [r, g, b, a]) {
    const isSmall = norm(x) < this.small && this.kinds.has(kind + " small");
    this.kinds.get(isSmall ? kind + " small" : kind).instances.push(...x, ...y, ...z, ...origin, r, g, b, a);
  }

  begin(camera, width, height) {
    const gl = this.gl;
    gl.viewport(0, 0, width, height);
    gl.clearColor(0, 0, 0, 0); gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    gl.uniformMatrix4fv(this.project, false, camera.matrix());
    gl.uniform3fv(this.eye, camera.eye);
    this.small = 7 * camera.pixel();
    gl.uniform3fv(this.up, camera.flat ? [0, 0.6, 0.8] : camera.up);
    const sun = add(add(scaled(camera.back, 0.55), scaled(camera.above, 0.7)), scaled(camera.right, -0.45));
    gl.uniform3fv(this.sun, unit(sun));
  }

  /** Draws all added instances; those `onTop` cover what was drawn before. */
  flush(onTop) {
    const gl = this.gl;
    if (onTop) gl.clear(gl.DEPTH_BUFFER_BIT);
    for (const kind of this.kinds.values()) {
      if (kind.instances.length === 0) continue;
      gl.bindVertexArray(kind.array);
      gl.bindBuffer(gl.ARRAY_BUFFER, kind.buffer);
      gl.bufferData(gl.ARRAY_BUFFER, new Float32Array(kind.instances), gl.DYNAMIC_DRAW);
      gl.drawElementsInstanced(gl.TRIANGLES, kind.count, gl.UNSIGNED_INT, 0, kind.instances.length / STRIDE);
      kind.instances.length = 0;
    }
  }
}
