"use strict";
const $ = id => document.getElementById(id);
const models = [...document.querySelectorAll("script[id^=model-]")];
const names = models.map(model => model.id.slice(6));
const viewer = $("viewer"), canvas = $("canvas");
const calm = matchMedia("(prefers-reduced-motion: reduce)");

// The grid.
$("count").textContent = names.length + (names.length === 1 ? " scene" : " scenes") + ", to look at, turn and take away";
$("filter").addEventListener("input", () => {
  const words = $("filter").value.toLowerCase().split(/\s+/).filter(Boolean);
  let shown = 0;
  for (const card of document.querySelectorAll(".card")) {
    const text = card.textContent.toLowerCase();
    card.hidden = !words.every(word => text.includes(word));
    if (!card.hidden) shown += 1;
  }
  $("none").hidden = shown > 0;
});

// Column-major 4 × 4 matrices.
const multiply = (a, b) => {
  const c = new Float32Array(16);
  for (let j = 0; j < 4; j++) for (let i = 0; i < 4; i++) {
    for (let k = 0; k < 4; k++) c[4 * j + i] += a[4 * k + i] * b[4 * j + k];
  }
  return c;
};
const placement = node => {
  const [x, y, z, w] = node.rotation || [0, 0, 0, 1], [a, b, c] = node.scale || [1, 1, 1], t = node.translation || [0, 0, 0];
  return new Float32Array([
    a * (1 - 2 * (y * y + z * z)), a * 2 * (x * y + z * w), a * 2 * (x * z - y * w), 0,
    b * 2 * (x * y - z * w), b * (1 - 2 * (x * x + z * z)), b * 2 * (y * z + x * w), 0,
    c * 2 * (x * z + y * w), c * 2 * (y * z - x * w), c * (1 - 2 * (x * x + y * y)), 0,
    t[0], t[1], t[2], 1]);
};
const transform = (m, p) => [0, 1, 2].map(i => m[i] * p[0] + m[4 + i] * p[1] + m[8 + i] * p[2] + m[12 + i]);
const minus = (a, b) => a.map((x, i) => x - b[i]);
const plus = (a, b, s) => a.map((x, i) => x + s * b[i]);
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const unit = a => { const n = Math.hypot(...a) || 1; return a.map(x => x / n); };

// GLB: a header of twelve bytes, then the JSON and the binary chunk, each behind eight.
const read = text => {
  const bytes = Uint8Array.from(atob(text), c => c.charCodeAt(0));
  const length = new DataView(bytes.buffer).getUint32(12, true);
  return { json: JSON.parse(new TextDecoder().decode(bytes.subarray(20, 20 + length))), binary: bytes.subarray(28 + length) };
};

const surfaceVertex = `#version 300 es
layout(location=0) in vec3 position; layout(location=1) in vec3 normal;
uniform mat4 world, view; uniform mat3 turn; out vec3 n; out vec3 p;
void main() { vec4 q = world * vec4(position, 1.0); p = q.xyz; n = turn * normal; gl_Position = view * q; }`;
const surfaceFragment = `#version 300 es
precision highp float;
in vec3 n; in vec3 p; uniform vec3 eye, key, fill; uniform vec4 color; uniform vec2 finish; out vec4 shown;
vec3 sky(float up) { return mix(vec3(.25, .24, .23), vec3(.44, .46, .49), .5 + .5 * up); }
vec3 screen(vec3 c) { c = mix(c, 1.0 - .2 * exp((.8 - c) / .2), step(.8, c)); return mix(12.92 * c, 1.055 * pow(max(c, 0.0), vec3(1.0 / 2.4)) - .055, step(.0031308, c)); }
void main() {
  vec3 e = normalize(eye - p), m = normalize(n); if (dot(m, e) < 0.0) m = -m;
  float metal = finish.x, rough = finish.y, facing = max(dot(m, key), 0.0), up = max(dot(m, e), 0.0);
  vec3 diffuse = color.rgb * (1.0 - metal) * (vec3(.74 * facing + .16 * max(dot(m, fill), 0.0)) + sky(m.y));
  vec3 straight = mix(vec3(.04), color.rgb, metal);
  vec3 mirrored = straight + (max(vec3(.5 * (1.0 - rough)), straight) - straight) * pow(1.0 - up, 5.0);
  float a = pow(max(rough, .18), 4.0), h = max(dot(m, normalize(key + e)), 0.0), f = h * h * (a - 1.0) + 1.0;
  vec3 r = reflect(-e, m);
  vec3 light = diffuse + mirrored * (vec3(min(a / (3.14159 * f * f), 12.0) * facing * .74) + sky(r.y * (1.0 - .6 * rough)) * 1.8);
  float opacity = color.a < 1.0 ? color.a + (1.0 - color.a) * .35 * pow(1.0 - up, 3.0) : 1.0;
  shown = vec4(screen(light) * opacity, opacity);
}`;
// Each segment of a line is a rectangle of fixed width on the screen.
const lineVertex = `#version 300 es
layout(location=0) in vec3 a; layout(location=1) in vec3 b;
uniform mat4 world, view; uniform vec3 eye; uniform vec2 size; uniform float width;
// A little nearer to the eye along its own ray, so that a surface does not swallow a line that lies on it.
vec4 place(vec3 x) { return view * vec4(mix((world * vec4(x, 1.0)).xyz, eye, .005), 1.0); }
void main() {
  vec4 p = place(a), q = place(b);
  vec2 along = (q.xy / q.w - p.xy / p.w) * size; float n = length(along);
  along = n > 1e-6 ? along / n : vec2(1.0, 0.0);
  float end = float(gl_VertexID / 2), side = float(gl_VertexID % 2) * 2.0 - 1.0;
  vec4 c = mix(p, q, end);
  c.xy += (vec2(-along.y, along.x) * side + along * (end * 2.0 - 1.0) * .6) * width / size * c.w;
  gl_Position = c;
}`;
const lineFragment = `#version 300 es
precision highp float; uniform vec4 color; out vec4 shown;
void main() { vec3 c = color.rgb; c = mix(12.92 * c, 1.055 * pow(c, vec3(1.0 / 2.4)) - .055, step(.0031308, c)); shown = vec4(c * color.a, color.a); }`;

let gl = null, programs = null, scene = null, camera = null, home = null, current = -1, turning = false, touched = false, queued = false, last = 0;

const start = () => {
  gl = canvas.getContext("webgl2", { antialias: true, alpha: true, premultipliedAlpha: true });
  if (!gl) return false;
  const program = (vertex, fragment) => {
    const made = gl.createProgram();
    for (const [kind, text] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]]) {
      const shader = gl.createShader(kind);
      gl.shaderSource(shader, text); gl.compileShader(shader); gl.attachShader(made, shader);
    }
    gl.linkProgram(made);
    if (!gl.getProgramParameter(made, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(made));
    const places = {};
    for (let i = 0; i < gl.getProgramParameter(made, gl.ACTIVE_UNIFORMS); i++) {
      const name = gl.getActiveUniform(made, i).name;
      places[name] = gl.getUniformLocation(made, name);
    }
    return { made, places };
  };
  programs = { surface: program(surfaceVertex, surfaceFragment), line: program(lineVertex, lineFragment) };
  canvas.addEventListener("webglcontextlost", event => { event.preventDefault(); gl = null; });
  canvas.addEventListener("webglcontextrestored", () => { gl = null; show(current); });
  return true;
};

const load = text => {
  const { json, binary } = read(text);
  const arrays = { 5123: Uint16Array, 5125: Uint32Array, 5126: Float32Array };
  const values = number => {
    const accessor = json.accessors[number], view = json.bufferViews[accessor.bufferView];
    const parts = accessor.type === "VEC3" ? 3 : 1;
    return new arrays[accessor.componentType](binary.slice(view.byteOffset || 0).buffer, 0, accessor.count * parts);
  };
  const buffers = [], lists = [];
  const buffer = (kind, data) => { const made = gl.createBuffer(); buffers.push(made); gl.bindBuffer(kind, made); gl.bufferData(kind, data, gl.STATIC_DRAW); };
  const kept = new Map();
  const geometry = primitive => {
    const key = JSON.stringify([primitive.attributes, primitive.indices, primitive.mode]);
    if (kept.has(key)) return kept.get(key);
    const list = gl.createVertexArray(); lists.push(list); gl.bindVertexArray(list);
    let points = values(primitive.attributes.POSITION), made;
    if (primitive.mode === 4) {
      buffer(gl.ARRAY_BUFFER, points); gl.enableVertexAttribArray(0); gl.vertexAttribPointer(0, 3, gl.FLOAT, false, 0, 0);
      buffer(gl.ARRAY_BUFFER, values(primitive.attributes.NORMAL)); gl.enableVertexAttribArray(1); gl.vertexAttribPointer(1, 3, gl.FLOAT, false, 0, 0);
      const indices = values(primitive.indices);
      buffer(gl.ELEMENT_ARRAY_BUFFER, indices);
      made = { list, line: false, count: indices.length, kind: indices.BYTES_PER_ELEMENT === 2 ? gl.UNSIGNED_SHORT : gl.UNSIGNED_INT };
    } else {
      if (primitive.mode === 2) points = Float32Array.of(...points, ...points.slice(0, 3));
      buffer(gl.ARRAY_BUFFER, points);
      for (const end of [0, 1]) { gl.enableVertexAttribArray(end); gl.vertexAttribPointer(end, 3, gl.FLOAT, false, 12, 12 * end); gl.vertexAttribDivisor(end, 1); }
      made = { list, line: true, count: points.length / 3 - 1 };
    }
    made.points = points;
    kept.set(key, made);
    return made;
  };
  const items = [], low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
  const visit = (number, above) => {
    const node = json.nodes[number], world = multiply(above, placement(node));
    for (const primitive of node.mesh === undefined ? [] : json.meshes[node.mesh].primitives) {
      const material = json.materials[primitive.material], look = material.pbrMetallicRoughness;
      const { min, max } = json.accessors[primitive.attributes.POSITION];
      for (let corner = 0; corner < 8; corner++) {
        const p = transform(world, [0, 1, 2].map(i => corner >> i & 1 ? max[i] : min[i]));
        for (let i = 0; i < 3; i++) { low[i] = Math.min(low[i], p[i]); high[i] = Math.max(high[i], p[i]); }
      }
      const [a, b, c] = [0, 4, 8].map(i => [world[i], world[i + 1], world[i + 2]]);
      const turn = [cross(b, c), cross(c, a), cross(a, b)].flatMap(unit);
      // The inverse transpose, up to a factor that differs by column: divide by the column's own scale.
      const sizes = [a, b, c].map(column => Math.hypot(...column));
      for (let i = 0; i < 9; i++) turn[i] *= Math.min(...sizes) / sizes[Math.floor(i / 3)];
      items.push({ geometry: geometry(primitive), world, turn, color: look.baseColorFactor, finish: [look.metallicFactor, look.roughnessFactor],
        middle: transform(world, [0, 1, 2].map(i => (min[i] + max[i]) / 2)) });
    }
    for (const child of node.children || []) visit(child, world);
  };
  for (const number of json.scenes[0].nodes) visit(number, placement({}));
  const middle = low.map((x, i) => (x + high[i]) / 2), radius = Math.hypot(...minus(high, low)) / 2 || 1;
  return { items, buffers, lists, middle, radius };
};

const unload = () => {
  if (gl && scene) { scene.buffers.forEach(b => gl.deleteBuffer(b)); scene.lists.forEach(l => gl.deleteVertexArray(l)); }
  scene = null;
};

const axes = () => {
  const c = Math.cos(camera.elevation), toward = [c * Math.cos(camera.azimuth), Math.sin(camera.elevation), -c * Math.sin(camera.azimuth)];
  const right = [-Math.sin(camera.azimuth), 0, -Math.cos(camera.azimuth)];
  return { toward, right, up: cross(toward, right) };
};

const draw = time => {
  queued = false;
  if (!gl || !scene || !viewer.open) return;
  if (turning) { camera.azimuth += Math.min(time - last, 50) * 3e-4; queue(); }
  last = time;
  const ratio = Math.min(devicePixelRatio || 1, 2), w = Math.max(1, Math.round(canvas.clientWidth * ratio)), h = Math.max(1, Math.round(canvas.clientHeight * ratio));
  if (canvas.width !== w || canvas.height !== h) { canvas.width = w; canvas.height = h; }
  gl.viewport(0, 0, w, h); gl.clearColor(0, 0, 0, 0);
  gl.depthMask(true); gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
  gl.enable(gl.DEPTH_TEST); gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
  const { toward, right, up } = axes(), r = scene.radius;
  const eye = plus(camera.target, toward, camera.distance);
  const slope = .26 / Math.min(1, w / h), far = camera.distance + Math.hypot(...minus(camera.target, scene.middle)) + 2 * r, near = Math.max(camera.distance - 3 * r, camera.distance / 50, far / 5000);
  const look = new Float32Array(16);
  [right, up, toward].forEach((axis, i) => { axis.forEach((x, j) => look[4 * j + i] = x); look[12 + i] = -dot(axis, eye); });
  look[15] = 1;
  const lens = new Float32Array(16);
  lens[0] = h / w / slope; lens[5] = 1 / slope; lens[10] = (near + far) / (near - far); lens[11] = -1; lens[14] = 2 * near * far / (near - far);
  const view = multiply(lens, look);
  const key = unit(plus(plus(plus([0, .55, 0], toward, .55), right, -.5), up, .25)), fill = unit(plus(plus(toward.map(x => x * .5), right, .8), up, .1));
  const { surface, line } = programs;
  gl.useProgram(line.made);
  gl.uniformMatrix4fv(line.places.view, false, view); gl.uniform3fv(line.places.eye, eye); gl.uniform2f(line.places.size, w, h); gl.uniform1f(line.places.width, 2.2 * ratio);
  gl.useProgram(surface.made);
  gl.uniformMatrix4fv(surface.places.view, false, view); gl.uniform3fv(surface.places.eye, eye); gl.uniform3fv(surface.places.key, key); gl.uniform3fv(surface.places.fill, fill);
  const one = item => {
    const { places, made } = item.geometry.line ? line : surface;
    gl.useProgram(made); gl.bindVertexArray(item.geometry.list);
    gl.uniformMatrix4fv(places.world, false, item.world); gl.uniform4fv(places.color, item.color);
    if (item.geometry.line) { gl.drawArraysInstanced(gl.TRIANGLE_STRIP, 0, 4, item.geometry.count); return; }
    gl.uniformMatrix3fv(places.turn, false, item.turn); gl.uniform2fv(places.finish, item.finish);
    gl.drawElements(gl.TRIANGLES, item.geometry.count, item.geometry.kind, 0);
  };
  gl.disable(gl.BLEND);
  scene.items.filter(item => item.color[3] >= 1).forEach(one);
  // See-through things last, the farthest first, the inner side of each before its outer side.
  gl.enable(gl.BLEND); gl.depthMask(false); gl.enable(gl.CULL_FACE);
  const clear = scene.items.filter(item => item.color[3] < 1).map(item => [dot(minus(item.middle, eye), toward), item]).sort((a, b) => a[0] - b[0]);
  for (const [, item] of clear) {
    if (item.geometry.line) gl.disable(gl.CULL_FACE); else gl.enable(gl.CULL_FACE);
    gl.cullFace(gl.FRONT); one(item);
    if (!item.geometry.line) { gl.cullFace(gl.BACK); one(item); }
  }
  gl.disable(gl.CULL_FACE); gl.bindVertexArray(null);
};
const queue = () => { if (!queued) { queued = true; requestAnimationFrame(draw); } };

// As near as everything fits: each drawn point is asked how far away the eye must be for it.
const fit = () => {
  camera = { azimuth: home.azimuth, elevation: home.elevation, target: scene.middle.slice(), distance: scene.radius };
  const { toward, right, up } = axes(), aspect = (canvas.clientWidth || 4) / (canvas.clientHeight || 3);
  const slope = .86 * .26 / Math.min(1, aspect), sides = [slope * aspect, slope];
  const each = use => { for (const { geometry, world } of scene.items) {
    const step = 3 * Math.max(1, Math.floor(geometry.points.length / 3000));
    for (let i = 0; i + 2 < geometry.points.length; i += step) {
      const p = minus(transform(world, geometry.points.subarray(i, i + 3)), camera.target);
      use(dot(p, right), dot(p, up), dot(p, toward));
    }
  } };
  for (let round = 0; round < 3; round++) {
    let distance = scene.radius * .1, low = [Infinity, Infinity], high = [-Infinity, -Infinity];
    each((a, b, c) => { distance = Math.max(distance, c + Math.max(Math.abs(a) / sides[0], Math.abs(b) / sides[1])); });
    each((a, b, c) => [a, b].forEach((x, i) => { const at = x / (distance - c + 1e-30); low[i] = Math.min(low[i], at); high[i] = Math.max(high[i], at); }));
    camera.distance = distance;
    if (round < 2) [right, up].forEach((axis, i) => { camera.target = plus(camera.target, axis, (low[i] + high[i]) / 2 * distance); });
  }
};

const setTurning = on => { turning = on; if (on) touched = true; $("turn").setAttribute("aria-pressed", String(on)); $("turn").textContent = on ? "Stop" : "Turn"; last = performance.now(); queue(); };

const show = number => {
  const model = models[number], name = names[number], card = $("card-" + name);
  const title = card.querySelector("h2").textContent;
  unload();
  current = number;
  $("viewer-title").textContent = title;
  $("viewer-caption").textContent = card.querySelector(".caption").textContent;
  canvas.setAttribute("aria-label", title + ", a model to turn");
  $("glb").href = name + ".glb"; $("png").href = name + ".png";
  if (!viewer.open) viewer.showModal();
  const works = (gl !== null && !gl.isContextLost()) || start();
  canvas.hidden = !works; $("still").hidden = works;
  if (!works) { $("still").src = card.querySelector("img").src; $("still").alt = title + " (this browser has no WebGL 2)"; return; }
  scene = load(model.textContent);
  home = { azimuth: Number(model.dataset.azimuth), elevation: Number(model.dataset.elevation) };
  touched = false;
  fit();
  setTurning(false);
};

const follow = () => {
  const number = names.indexOf(decodeURIComponent(location.hash.slice(1)));
  if (number >= 0) show(number); else if (viewer.open) viewer.close();
};
const step = by => { location.hash = names[(current + by + names.length) % names.length]; };
addEventListener("hashchange", follow);
viewer.addEventListener("close", () => {
  setTurning(false); unload();
  const card = current >= 0 ? $("card-" + names[current]) : null;
  if (location.hash) history.replaceState(null, "", location.pathname + location.search);
  if (card) card.querySelector(".open").focus();
});
viewer.addEventListener("click", event => { if (event.target === viewer) viewer.close(); });
$("close").addEventListener("click", () => viewer.close());
$("previous").addEventListener("click", () => step(-1));
$("next").addEventListener("click", () => step(1));
$("reset").addEventListener("click", () => { if (scene) { touched = false; setTurning(false); fit(); queue(); } });
$("turn").addEventListener("click", () => setTurning(!turning));

const orbit = (dx, dy) => {
  touched = true;
  camera.azimuth -= dx;
  camera.elevation = Math.max(-1.5707, Math.min(1.5707, camera.elevation + dy));
  queue();
};
const zoom = by => { touched = true; camera.distance = Math.max(scene.radius * .05, Math.min(scene.radius * 60, camera.distance * by)); queue(); };
const move = (dx, dy) => {
  touched = true;
  const { right, up } = axes(), size = camera.distance * .52 / canvas.clientHeight;
  camera.target = plus(plus(camera.target, right, -dx * size), up, dy * size); queue();
};
const pointers = new Map();
canvas.addEventListener("pointerdown", event => { canvas.setPointerCapture(event.pointerId); pointers.set(event.pointerId, [event.clientX, event.clientY]); setTurning(false); });
for (const kind of ["pointerup", "pointercancel"]) canvas.addEventListener(kind, event => pointers.delete(event.pointerId));
canvas.addEventListener("pointermove", event => {
  const before = pointers.get(event.pointerId);
  if (!before || !scene) return;
  const now = [event.clientX, event.clientY], [dx, dy] = minus(now, before);
  if (pointers.size === 2) {
    const other = [...pointers].find(([id]) => id !== event.pointerId)[1];
    zoom(Math.hypot(...minus(before, other)) / Math.max(1, Math.hypot(...minus(now, other))));
    move(dx / 2, dy / 2);
  } else if (event.buttons & 6 || event.shiftKey) move(dx, dy); else orbit(dx * .008, dy * .008);
  pointers.set(event.pointerId, now);
});
canvas.addEventListener("contextmenu", event => event.preventDefault());
canvas.addEventListener("wheel", event => { event.preventDefault(); if (scene) zoom(Math.exp(Math.max(-60, Math.min(60, event.deltaY)) * .004)); }, { passive: false });
viewer.addEventListener("keydown", event => {
  const keys = { ArrowLeft: () => orbit(-.1, 0), ArrowRight: () => orbit(.1, 0), ArrowUp: () => orbit(0, .1), ArrowDown: () => orbit(0, -.1), "+": () => zoom(.88), "=": () => zoom(.88), "-": () => zoom(1.14) };
  if (scene && keys[event.key] && !event.ctrlKey && !event.metaKey && !event.altKey) { event.preventDefault(); setTurning(false); keys[event.key](); }
});
// Drawn at once: a frame later the old picture would be seen stretched.
new ResizeObserver(() => { if (scene && !touched) fit(); draw(performance.now()); }).observe($("stage"));
calm.addEventListener("change", () => { if (calm.matches) setTurning(false); });
follow();
