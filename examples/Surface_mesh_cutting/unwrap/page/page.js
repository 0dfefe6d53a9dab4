// Shows the surface and its layout. All numbers come from the report, all shapes from the buffers.
'use strict';
(() => {

const element = id => document.getElementById(id);
const report = JSON.parse(element('report').textContent);
const facts = JSON.parse(element('facts').textContent);

function buffer(id, Type) {
  const text = atob(element(id).textContent);
  const bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i)
    bytes[i] = text.charCodeAt(i);
  element(id).remove();
  return new Type(bytes.buffer);
}

const points = buffer('points', Float32Array), uvs = buffer('uvs', Float32Array);
const triangles = buffer('triangles', Uint32Array), uvTriangles = buffer('uv-triangles', Uint32Array);
const energies = buffer('energies', Float32Array);
const cut = buffer('cut', Uint32Array), borders = buffer('borders', Uint32Array), features = buffer('features', Uint32Array);
const numberOfFaces = triangles.length / 3;

// ---- numbers and words

const digits = (value, precision = 4) => typeof value !== 'number' ? String(value)
  : Number.isInteger(value) ? value.toLocaleString('en') : String(Number(value.toPrecision(precision)));
const plural = (count, one, many) => digits(count) + ' ' + (count === 1 ? one : many);

function append(parent, name, text, attributes = {}) {
  const child = document.createElement(name);
  if (text !== undefined)
    child.textContent = text;
  for (const key in attributes)
    child.setAttribute(key, attributes[key]);
  parent.appendChild(child);
  return child;
}

// What a value of the report is shown as; tests compare the attribute with the report.
function show(parent, name, key, text) {
  return append(parent, name, text, {'data-key': key, 'data-value': JSON.stringify(report[key])});
}

function showFigures() {
  const figures = [
    ['E_iso', 'Mean distortion', digits, '4 is none'], ['E_max', 'Largest distortion', digits, 'of any triangle'],
    ['cut_length', 'Length of the cut', digits, 'bounding box diagonals'], ['charts', 'Charts', digits, 'pieces of the layout'],
    ['fill', 'Square filled', value => digits(100 * value, 3) + ' %', 'area of the charts'],
    ['overlaps', 'Overlaps', digits, 'decided exactly'], ['flips', 'Flips', digits, 'decided exactly']];
  for (const [key, label, format, unit] of figures) {
    if (report[key] === null || report[key] === undefined)
      continue;
    const box = append(element('figures'), 'div');
    append(box, 'dt', label);
    append(show(box, 'dd', key, format(report[key])), 'small', unit);
  }
}

function verdict() {
  const excess = report.E_iso - 4;
  const words = excess < 0.01 ? 'practically none' : excess < 0.1 ? 'barely visible' : excess < 0.5 ? 'moderate' : 'strong';
  return 'Distortion: ' + words + '. ' + (report.overlaps === 0 ? 'No two triangles overlap.' : 'No triangle is flipped.');
}

function sentences() {
  const texts = [];
  texts.push('The surface has ' + plural(report.faces, 'face', 'faces') + ' and ' + plural(report.vertices, 'vertex', 'vertices')
    + ' in ' + plural(report.components, 'component', 'components') + ', with ' + plural(report.genus, 'handle', 'handles')
    + ' and ' + plural(report.borders, 'border', 'borders') + '.');
  texts.push('The cut runs through ' + plural(report.features, 'feature point', 'feature points') + ' and is '
    + digits(report.cut_length) + ' bounding box diagonals long'
    + (report.cut_lower_bound === null ? '.' : report.optimal ? ', which is proven to be the shortest through these points.'
      : '; no cut through these points is shorter than ' + digits(report.cut_lower_bound) + '.'));
  if (report.cut_cost !== null && report.cut_cost !== undefined)
    texts.push('Edges had weights: the cut costs ' + digits(report.cut_cost) + ' in the same unit.');
  if (report.uv_scale && report.fill !== null)
    texts.push('One unit of length on the surface is ' + digits(report.uv_scale) + ' units of the unit square, the same for all charts, which are at least '
      + digits(facts.margin) + ' texels of ' + digits(facts.texture_size) + ' apart.');
  texts.push(report.message.charAt(0).toUpperCase() + report.message.slice(1) + '.');
  return texts;
}

function showWords() {
  document.title = facts.name + ' – unwrapped';
  element('name').textContent = facts.name;
  element('verdict').textContent = verdict();
  for (const text of sentences())
    append(element('words'), 'p', text);
  const notes = report.warnings.map(text => 'Warning: ' + text);
  for (const item of report.interpreted || [])
    notes.push('Read as it was meant: ' + digits(item.count) + ' ' + item.what.replace(/_/g, ' '));
  if (notes.length > 0) {
    const list = append(element('words'), 'ul', undefined, {'class': 'warning'});
    for (const note of notes)
      append(list, 'li', note);
  }
}

function showMeasures() {
  const names = {
    status: 'Status', vertices: 'Vertices', faces: 'Faces', polygons: 'Polygons', components: 'Components', genus: 'Handles', borders: 'Borders',
    candidates: 'Candidates', features: 'Feature points', auxiliary: 'Branch points added', cut_length: 'Length of the cut',
    cut_cost: 'Cost of the cut', cut_lower_bound: 'Lower bound on its length', optimal: 'Proven shortest', E_iso: 'Mean energy',
    E_max: 'Largest energy', flips: 'Flips', overlaps: 'Overlaps', charts: 'Charts', uv_scale: 'Scale of the UVs', fill: 'Fill of the square',
    effort: 'Effort', solver: 'Linear solver', seed: 'Seed', threads: 'Threads', peak_memory_mb: 'Memory in megabytes'};
  const add = (label, make) => {
    const row = append(element('measures'), 'div');
    append(row, 'dt', label);
    make(row);
  };
  for (const key in names)
    if (report[key] !== null && report[key] !== undefined)
      add(names[key], row => show(row, 'dd', key, typeof report[key] === 'boolean' ? (report[key] ? 'yes' : 'no') : digits(report[key], 6)));
  add('Seconds in all', row => append(row, 'dd', digits(report.seconds.total), {'data-key': 'seconds.total', 'data-value': JSON.stringify(report.seconds.total)}));
}

function svg(parent, name, attributes, text) {
  const child = document.createElementNS('http://www.w3.org/2000/svg', name);
  for (const key in attributes)
    child.setAttribute(key, attributes[key]);
  if (text !== undefined)
    child.textContent = text;
  parent.appendChild(child);
  return child;
}

// The cuts that the run considered; the energy above 4 on a logarithmic scale.
function showTradeOffs() {
  const tried = report.tradeoff.filter(([, energy]) => energy > 4);
  if (tried.length < 2) {
    element('tradeoff-section').remove();
    return;
  }
  const width = 420, height = 250, left = 52, right = 12, top = 10, bottom = 44;
  const longest = Math.max(...tried.map(t => t[0]), report.cut_length) * 1.05;
  const logs = tried.map(t => Math.log(t[1] - 4));
  const low = Math.min(...logs) - 0.15, high = Math.max(...logs) + 0.15;
  const x = length => left + (width - left - right) * length / longest;
  const y = energy => top + (height - top - bottom) * (high - Math.log(energy - 4)) / (high - low);
  const plot = svg(element('tradeoff'), 'svg', {viewBox: `0 0 ${width} ${height}`, role: 'img',
    'aria-label': 'Mean energy of the cuts that were tried, by their length'});
  let last = Infinity;
  for (const label of ['4.0001', '4.001', '4.002', '4.005', '4.01', '4.02', '4.05', '4.1', '4.2', '4.5', '5', '6', '8', '12', '20', '40', '100', '1000', '10000']) {
    const at = y(Number(label));
    if (!(at >= top && at <= height - bottom && last - at > 16))
      continue;
    last = at;
    svg(plot, 'line', {x1: left, x2: width - right, y1: at, y2: at, stroke: 'var(--line)'});
    svg(plot, 'text', {x: left - 8, y: at + 4, 'text-anchor': 'end'}, label);
  }
  const power = Math.pow(10, Math.floor(Math.log10(longest / 5)));
  const step = [1, 2, 5, 10].map(f => f * power).find(s => longest / s <= 6);
  for (let i = 0; i * step <= longest; ++i)
    svg(plot, 'text', {x: x(i * step), y: height - bottom + 18, 'text-anchor': 'middle'}, String(Number((i * step).toPrecision(6))));
  svg(plot, 'text', {x: (left + width - right) / 2, y: height - 6, 'text-anchor': 'middle'}, 'length of the cut in bounding box diagonals');
  svg(plot, 'polyline', {points: tried.map(t => x(t[0]) + ',' + y(t[1])).join(' '), fill: 'none', stroke: 'var(--accent)', 'stroke-width': 2, 'stroke-linejoin': 'round'});
  for (const t of tried) {
    const dot = svg(plot, 'circle', {cx: x(t[0]), cy: y(t[1]), r: 3, fill: 'var(--accent)', 'data-key': 'tradeoff', 'data-value': JSON.stringify(t)});
    svg(dot, 'title', {}, 'length ' + digits(t[0]) + ', mean energy ' + digits(t[1], 5));
  }
  if (report.E_iso > 4)
    svg(plot, 'circle', {cx: x(report.cut_length), cy: y(report.E_iso), r: 6, fill: 'var(--panel)', stroke: 'var(--cut)', 'stroke-width': 3});
  append(element('tradeoff'), 'p', 'Mean energy of the cuts that were tried on the way; the ring is the result.');
}

// ---- colors

// From cream over yellow to blue, darker at each step, after cividis (Nuñez, Anderton, Renslow 2018): read alike with and
// without color vision deficiency. Light is good.
const ramp = [[251, 247, 233], [243, 228, 176], [226, 203, 106], [181, 167, 112], [138, 135, 120], [98, 103, 114], [64, 78, 112], [20, 54, 114], [0, 32, 76]];
// Of the logarithm of the stretch s for which a map with singular values s and 1/s has this energy; 1 is s = 4.
function place(energy) {
  const a = Math.max(1, energy / 4);
  return Math.min(1, Math.log(a + Math.sqrt(a * a - 1)) / 2 / Math.log(4));
}

function showLegend() {
  element('ramp').style.background = 'linear-gradient(to right,' + ramp.map(c => `rgb(${c})`).join() + ')';
  for (const label of ['4', '4.1', '4.5', '5', '6', '8', '12', '20', '32'])
    append(element('ticks'), 'span', label).style.left = 100 * place(Number(label)) + '%';
}

const variable = name => new THREE.Color(getComputedStyle(document.documentElement).getPropertyValue(name).trim());

// ---- geometry: one vertex per corner, so that each triangle has a color and a number of its own

function rampTexture() {
  const bytes = new Uint8Array(256 * 3);
  for (let i = 0; i < 256; ++i) {
    const at = i / 255 * (ramp.length - 1), k = Math.min(ramp.length - 2, Math.floor(at));
    for (let c = 0; c < 3; ++c)
      bytes[3 * i + c] = Math.round(ramp[k][c] + (at - k) * (ramp[k + 1][c] - ramp[k][c]));
  }
  const texture = new THREE.DataTexture(bytes, 256, 1, THREE.RGBFormat);
  texture.needsUpdate = true;
  return texture;
}

function vertexNormals() {
  const normals = new Float32Array(points.length);
  for (let f = 0; f < numberOfFaces; ++f) {
    const a = 3 * triangles[3 * f], b = 3 * triangles[3 * f + 1], c = 3 * triangles[3 * f + 2];
    const ux = points[b] - points[a], uy = points[b + 1] - points[a + 1], uz = points[b + 2] - points[a + 2];
    const vx = points[c] - points[a], vy = points[c + 1] - points[a + 1], vz = points[c + 2] - points[a + 2];
    const n = [uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx];
    for (const v of [a, b, c])
      for (let k = 0; k < 3; ++k)
        normals[v + k] += n[k];
  }
  return normals;
}

function gathered(source, size, indices) {
  const result = new Float32Array(size * indices.length);
  for (let i = 0; i < indices.length; ++i)
    for (let k = 0; k < size; ++k)
      result[size * i + k] = source[size * indices[i] + k];
  return result;
}

const flat = new Float32Array(uvs.length / 2 * 3);
for (let v = 0; v < uvs.length / 2; ++v) {
  flat[3 * v] = uvs[2 * v];
  flat[3 * v + 1] = uvs[2 * v + 1];
}

function makeGeometry(isLayout, corners) {
  const geometry = new THREE.BufferGeometry();
  const add = (name, array, size, isNormalized) => geometry.setAttribute(name, new THREE.BufferAttribute(array, size, isNormalized));
  add('position', isLayout ? gathered(flat, 3, uvTriangles) : gathered(points, 3, triangles), 3);
  if (!isLayout)
    add('normal', gathered(vertexNormals(), 3, triangles), 3);
  add('uv', corners.uv, 2);
  add('shade', corners.shade, 1);
  add('number', corners.number, 4, true);
  return geometry;
}

function makeCorners() {
  const shade = new Float32Array(3 * numberOfFaces), number = new Uint8Array(12 * numberOfFaces);
  for (let i = 0; i < shade.length; ++i) {
    const f = Math.floor(i / 3);
    shade[i] = place(energies[f]);
    number.set([f + 1 & 255, f + 1 >> 8 & 255, f + 1 >> 16 & 255, 255], 4 * i);
  }
  return {uv: gathered(uvs, 2, uvTriangles), shade, number};
}

const vertexShader = `
attribute float shade; attribute vec4 number;
varying vec2 at; varying float energy; varying vec3 direction; varying vec3 place; varying vec4 label;
void main() {
  at = uv; energy = shade; label = number;
  direction = normalMatrix * normal;
  vec4 seen = modelViewMatrix * vec4(position, 1.);
  place = seen.xyz;
  gl_Position = projectionMatrix * seen;
}`;
const fragmentShader = `
uniform sampler2D ramp; uniform int shading; uniform float squares; uniform bool isLit; uniform vec3 plain;
varying vec2 at; varying float energy; varying vec3 direction; varying vec3 place;
void main() {
  vec3 color = plain;
  if(shading == 0)
    color = texture2D(ramp, vec2(energy * 255. / 256. + .5 / 256., .5)).rgb;
  else if(shading == 1) {
    vec2 cell = floor(at * squares), block = floor(at * squares / 8.);
    float odd = mod(cell.x + cell.y, 2.), far = mod(block.x + block.y, 2.);
    color = odd > .5 ? mix(vec3(.16, .33, .49), vec3(.1, .45, .42), far) : mix(vec3(.95, .95, .92), vec3(.86, .9, .86), far);
  }
  if(isLit) {
    vec3 n = normalize(direction);
    if(!gl_FrontFacing) n = -n;
    float light = .5 + .38 * max(0., dot(n, normalize(vec3(.35, .6, .8)))) + .2 * max(0., n.z);
    color *= light;
    if(!gl_FrontFacing) color = mix(color, vec3(.5), .5);
  }
  gl_FragColor = vec4(color, 1.);
}`;
const lineShader = `
attribute vec3 to; attribute vec2 corner;
uniform float halfWidth; uniform vec2 size;
void main() {
  vec4 a = projectionMatrix * modelViewMatrix * vec4(position, 1.), b = projectionMatrix * modelViewMatrix * vec4(to, 1.);
  vec2 along = (b.xy / b.w - a.xy / a.w) * size;
  along = length(along) > 0. ? normalize(along) : vec2(1., 0.);
  vec4 end = corner.x > .5 ? b : a;
  vec2 outward = vec2(-along.y, along.x) * corner.y + along * (2. * corner.x - 1.) * .5;
  end.xy += outward * halfWidth * 2. / size * end.w;
  end.z -= 1e-4 * end.w;
  gl_Position = end;
}`;
const pickShader = 'varying vec4 label; void main() { gl_FragColor = label; }';

// ---- a view: a canvas with a camera, the triangles, and what lies on them

const lineGeometry = (positions, pairs) =>
  new THREE.BufferGeometry().setAttribute('position', new THREE.BufferAttribute(gathered(positions, 3, pairs), 3));

function dot(isRound) {
  const canvas = document.createElement('canvas');
  canvas.width = canvas.height = 64;
  const context = canvas.getContext('2d');
  const css = getComputedStyle(document.documentElement);
  context.fillStyle = css.getPropertyValue(isRound ? '--panel' : '--point');
  context.strokeStyle = css.getPropertyValue(isRound ? '--point' : '--panel');
  context.lineWidth = isRound ? 14 : 5;
  context.beginPath();
  if (isRound)
    context.arc(32, 32, 22, 0, 7);
  else
    [[32, 4], [60, 32], [32, 60], [4, 32]].forEach(p => context.lineTo(...p));
  context.closePath();
  context.fill();
  context.stroke();
  return new THREE.CanvasTexture(canvas);
}

const uniforms = {ramp: {value: null}, shading: {value: 0}, squares: {value: 1}, plain: {value: new THREE.Color()}};
const views = [];
let isDue = false;

function redraw() {
  if (isDue)
    return;
  isDue = true;
  requestAnimationFrame(() => {
    isDue = false;
    views.forEach(view => view.draw());
  });
}

class View {
  constructor(canvas, geometry, isLayout, positions, corners) {
    this.canvas = canvas;
    this.positions = positions;
    this.corners = corners;
    this.renderer = new THREE.WebGLRenderer({canvas, antialias: true, alpha: true, preserveDrawingBuffer: true});
    this.scene = new THREE.Scene();
    const material = new THREE.ShaderMaterial({vertexShader, fragmentShader, side: THREE.DoubleSide, polygonOffset: true,
      polygonOffsetFactor: 1, polygonOffsetUnits: 2, uniforms: Object.assign({isLit: {value: !isLayout}}, uniforms)});
    this.surface = new THREE.Mesh(geometry, material);
    this.surface.frustumCulled = false;
    this.pickMaterial = new THREE.ShaderMaterial({vertexShader, fragmentShader: pickShader, side: THREE.DoubleSide, blending: THREE.NoBlending});
    this.pixel = new THREE.WebGLRenderTarget(1, 1, {minFilter: THREE.NearestFilter, magFilter: THREE.NearestFilter});
    this.pickScene = new THREE.Scene();
    this.scene.add(this.surface);
    const highlight = new THREE.BufferGeometry().setAttribute('position', new THREE.BufferAttribute(new Float32Array(9), 3));
    this.fill = new THREE.Mesh(highlight, new THREE.MeshBasicMaterial({side: THREE.DoubleSide, color: 0xff2d95, depthTest: false, transparent: true, opacity: 0.75}));
    this.frame = new THREE.LineLoop(highlight, new THREE.LineBasicMaterial({color: 0xff2d95, depthTest: false}));
    this.mark = new THREE.Points(new THREE.BufferGeometry().setAttribute('position', new THREE.BufferAttribute(new Float32Array(3), 3)),
      new THREE.PointsMaterial({size: 26, sizeAttenuation: false, transparent: true, depthTest: false, map: View.ring()}));
    for (const [order, object] of [[5, this.fill], [6, this.frame], [7, this.mark]]) {
      object.renderOrder = order;
      object.visible = object.frustumCulled = false;
      this.scene.add(object);
    }
  }

  static ring() {
    const canvas = document.createElement('canvas');
    canvas.width = canvas.height = 64;
    const context = canvas.getContext('2d');
    context.lineWidth = 6;
    context.strokeStyle = '#ff2d95';
    context.arc(32, 32, 27, 0, 7);
    context.stroke();
    return new THREE.CanvasTexture(canvas);
  }

  // WebGL draws lines one pixel wide only: each is a rectangle of constant width on the screen.
  addLines(pairs) {
    const number = pairs.length / 2, ends = gathered(this.positions, 3, pairs);
    const from = new Float32Array(12 * number), to = new Float32Array(12 * number), corner = new Float32Array(8 * number);
    const index = new Uint32Array(6 * number);
    for (let i = 0; i < number; ++i) {
      for (let k = 0; k < 4; ++k) {
        from.set(ends.subarray(6 * i, 6 * i + 3), 12 * i + 3 * k);
        to.set(ends.subarray(6 * i + 3, 6 * i + 6), 12 * i + 3 * k);
        corner.set([k < 2 ? 0 : 1, k % 2 ? 1 : -1], 8 * i + 2 * k);
      }
      index.set([0, 1, 2, 2, 1, 3].map(k => 4 * i + k), 6 * i);
    }
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute('position', new THREE.BufferAttribute(from, 3));
    geometry.setAttribute('to', new THREE.BufferAttribute(to, 3));
    geometry.setAttribute('corner', new THREE.BufferAttribute(corner, 2));
    geometry.setIndex(new THREE.BufferAttribute(index, 1));
    this.lineUniforms = {color: {value: new THREE.Color()}, halfWidth: {value: 1.4}, size: {value: new THREE.Vector2(1, 1)}};
    this.cut = new THREE.Mesh(geometry, new THREE.ShaderMaterial({vertexShader: lineShader, side: THREE.DoubleSide, uniforms: this.lineUniforms,
      fragmentShader: 'uniform vec3 color; void main() { gl_FragColor = vec4(color, 1.); }'}));
    this.cut.frustumCulled = false;
    this.cut.renderOrder = 2;
    this.scene.add(this.cut);
  }

  addPoints(indices, isRound) {
    const object = new THREE.Points(lineGeometry(this.positions, indices),
      new THREE.PointsMaterial({size: isRound ? 12 : 13, sizeAttenuation: false, transparent: true, alphaTest: 0.3}));
    // Before the lines that end there.
    object.material.onBeforeCompile = shader => {
      shader.vertexShader = shader.vertexShader.replace('#include <project_vertex>', '#include <project_vertex>\n  gl_Position.z -= 4e-4 * gl_Position.w;');
    };
    object.renderOrder = 3;
    object.isRound = isRound;
    this.scene.add(object);
    (this.points = this.points || []).push(object);
  }

  // Colors follow the scheme of the page.
  recolor() {
    if (this.cut)
      this.lineUniforms.color.value = variable('--cut');
    for (const object of this.points || []) {
      object.material.map = dot(object.isRound);
      object.material.needsUpdate = true;
    }
  }

  resize() {
    const {clientWidth: width, clientHeight: height} = this.canvas;
    this.renderer.setPixelRatio(Math.min(2, devicePixelRatio));
    this.renderer.setSize(width, height, false);
    this.aspect = width / Math.max(1, height);
    if (this.cut)
      this.lineUniforms.size.value.set(width, height);
  }

  draw() {
    this.place();
    this.renderer.setRenderTarget(null);
    this.renderer.render(this.scene, this.camera);
  }

  // The triangle at a place of the canvas, -1 if there is none: its number is what one pixel shows.
  pick(x, y) {
    this.place();
    const {clientWidth: width, clientHeight: height} = this.canvas;
    this.camera.setViewOffset(width, height, x, y, 1, 1);
    this.pickScene.add(this.surface);
    const material = this.surface.material;
    this.surface.material = this.pickMaterial;
    this.renderer.setRenderTarget(this.pixel);
    this.renderer.setClearColor(0, 0);
    this.renderer.clear();
    this.renderer.render(this.pickScene, this.camera);
    const bytes = new Uint8Array(4);
    this.renderer.readRenderTargetPixels(this.pixel, 0, 0, 1, 1, bytes);
    this.renderer.setRenderTarget(null);
    this.camera.clearViewOffset();
    this.surface.material = material;
    this.scene.add(this.surface);
    return bytes[0] + 256 * bytes[1] + 65536 * bytes[2] - 1;
  }

  light(face) {
    for (const object of [this.fill, this.frame, this.mark])
      object.visible = face >= 0;
    if (face < 0)
      return;
    const triangle = gathered(this.positions, 3, this.corners.subarray(3 * face, 3 * face + 3));
    const put = (object, values) => {
      object.geometry.attributes.position.array.set(values);
      object.geometry.attributes.position.needsUpdate = true;
    };
    put(this.fill, triangle);
    put(this.mark, [0, 1, 2].map(k => (triangle[k] + triangle[3 + k] + triangle[6 + k]) / 3));
  }

  // Where a point is on the canvas.
  project(point) {
    this.place();
    const p = new THREE.Vector3(...point).project(this.camera);
    return [(p.x + 1) / 2 * this.canvas.clientWidth, (1 - p.y) / 2 * this.canvas.clientHeight];
  }
}

class SurfaceView extends View {
  constructor(...rest) {
    super(...rest);
    this.camera = new THREE.PerspectiveCamera(32, 1, 0.01, 100);
    this.surface.geometry.computeBoundingSphere();
    const sphere = this.surface.geometry.boundingSphere;
    this.middle = sphere.center.clone();
    this.radius = sphere.radius || 1;
    this.reset();
  }

  reset() {
    this.rotation = new THREE.Quaternion().setFromEuler(new THREE.Euler(0.35, -0.6, 0));
    this.zoom = 1;
    this.shift = new THREE.Vector2();
  }

  place() {
    const half = this.camera.fov * Math.PI / 360;
    const fit = Math.atan(Math.tan(half) * Math.min(1, this.aspect));
    const distance = 1.04 * this.radius / Math.sin(fit) / this.zoom;
    const turn = this.rotation.clone().inverse();
    this.camera.quaternion.copy(turn);
    this.camera.position.set(-this.shift.x, -this.shift.y, distance / this.radius).multiplyScalar(this.radius)
      .applyQuaternion(turn).add(this.middle);
    this.camera.aspect = this.aspect;
    this.camera.near = Math.max(distance - 3 * this.radius, distance / 100);
    this.camera.far = distance + 3 * this.radius;
    this.camera.updateProjectionMatrix();
    this.camera.updateMatrixWorld();
    this.unit = 2 * distance / this.radius * Math.tan(half) / this.canvas.clientHeight;
  }

  drag(dx, dy, isMove) {
    if (isMove)
      this.shift.add(new THREE.Vector2(dx * this.unit, -dy * this.unit));
    else {
      const turn = new THREE.Quaternion().setFromAxisAngle(new THREE.Vector3(dy, dx, 0).normalize(), Math.hypot(dx, dy) * 0.008);
      this.rotation.premultiply(turn);
    }
  }

  scale(factor) { this.zoom = Math.min(200, Math.max(0.2, this.zoom * factor)); }
}

class LayoutView extends View {
  constructor(...rest) {
    super(...rest);
    this.camera = new THREE.OrthographicCamera(-1, 1, 1, -1, 0.1, 10);
    this.low = [Infinity, Infinity];
    this.high = [-Infinity, -Infinity];
    for (let i = 0; i < uvs.length; ++i) {
      this.low[i % 2] = Math.min(this.low[i % 2], uvs[i]);
      this.high[i % 2] = Math.max(this.high[i % 2], uvs[i]);
    }
    if (report.fill !== null) { // the square itself
      this.low = [0, 0];
      this.high = [1, 1];
      const square = new Float32Array([0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0]);
      this.square = new THREE.LineLoop(new THREE.BufferGeometry().setAttribute('position', new THREE.BufferAttribute(square, 3)), new THREE.LineBasicMaterial());
      this.scene.add(this.square);
    }
    this.reset();
  }

  recolor() {
    super.recolor();
    if (this.square)
      this.square.material.color = variable('--muted');
  }

  reset() {
    this.zoom = 1;
    this.middle = new THREE.Vector2((this.low[0] + this.high[0]) / 2, (this.low[1] + this.high[1]) / 2);
  }

  place() {
    const caption = 1.16; // some room for the text above
    const half = caption * Math.max((this.high[1] - this.low[1]) / 2, (this.high[0] - this.low[0]) / 2 / this.aspect) / this.zoom;
    this.unit = 2 * half / this.canvas.clientHeight;
    Object.assign(this.camera, {left: -half * this.aspect, right: half * this.aspect, top: half, bottom: -half});
    this.camera.position.set(this.middle.x, this.middle.y + 0.04 * half * this.zoom / this.zoom, 1);
    this.camera.updateProjectionMatrix();
    this.camera.updateMatrixWorld();
  }

  drag(dx, dy) {
    this.middle.add(new THREE.Vector2(-dx * this.unit, dy * this.unit));
  }

  // The place under the pointer stays where it is.
  scale(factor, x = this.canvas.clientWidth / 2, y = this.canvas.clientHeight / 2) {
    const zoom = Math.min(1000, Math.max(0.2, this.zoom * factor)), change = (1 - this.zoom / zoom) * this.unit;
    this.middle.add(new THREE.Vector2((x - this.canvas.clientWidth / 2) * change, -(y - this.canvas.clientHeight / 2) * change));
    this.zoom = zoom;
  }
}

// ---- what the user does

function hover(face) {
  if (document.body.dataset.hovered === String(face))
    return;
  document.body.dataset.hovered = face;
  views.forEach(view => view.light(face));
  element('hovered').textContent = face < 0 ? 'Point at a triangle to find it in both views.'
    : 'Triangle ' + digits(face) + ': energy ' + digits(energies[face], 5) + ', vertices '
      + Array.from(triangles.subarray(3 * face, 3 * face + 3)).join(', ');
  redraw();
}

function control(view) {
  const {canvas} = view;
  const pointers = new Map();
  let hoverAt = null;
  const spread = () => {
    const [a, b] = [...pointers.values()];
    return Math.hypot(a.x - b.x, a.y - b.y);
  };
  const local = event => {
    const box = canvas.getBoundingClientRect();
    return [event.clientX - box.left, event.clientY - box.top];
  };
  const pickSoon = event => {
    const isWaiting = hoverAt !== null;
    hoverAt = local(event);
    if (!isWaiting)
      requestAnimationFrame(() => {
        const at = hoverAt;
        hoverAt = null;
        hover(view.pick(...at));
      });
  };
  canvas.addEventListener('pointerdown', event => {
    canvas.setPointerCapture(event.pointerId);
    pointers.set(event.pointerId, {x: event.clientX, y: event.clientY});
    pickSoon(event);
  });
  canvas.addEventListener('pointermove', event => {
    const former = pointers.get(event.pointerId);
    if (!former) {
      pickSoon(event);
      return;
    }
    const before = pointers.size === 2 ? spread() : 0;
    const dx = event.clientX - former.x, dy = event.clientY - former.y;
    pointers.set(event.pointerId, {x: event.clientX, y: event.clientY});
    if (pointers.size === 2) {
      view.scale(spread() / Math.max(1, before));
      view.drag(dx / 2, dy / 2, true);
    } else
      view.drag(dx, dy, event.shiftKey || event.buttons === 2);
    redraw();
  });
  for (const name of ['pointerup', 'pointercancel'])
    canvas.addEventListener(name, event => pointers.delete(event.pointerId));
  canvas.addEventListener('pointerleave', () => hover(-1));
  canvas.addEventListener('contextmenu', event => event.preventDefault());
  canvas.addEventListener('wheel', event => {
    event.preventDefault();
    view.scale(Math.exp(-event.deltaY * 0.0015), ...local(event));
    redraw();
  }, {passive: false});
  canvas.addEventListener('keydown', event => {
    const step = 24, moves = {ArrowLeft: [-step, 0], ArrowRight: [step, 0], ArrowUp: [0, -step], ArrowDown: [0, step]};
    if (moves[event.key])
      view.drag(...moves[event.key], event.shiftKey);
    else if (event.key === '+' || event.key === '=')
      view.scale(1.2);
    else if (event.key === '-')
      view.scale(1 / 1.2);
    else if (event.key === '0' || event.key === 'Home')
      view.reset();
    else
      return;
    event.preventDefault();
    redraw();
  });
}

// Vertices at which three or more cut edges meet, but for the feature points.
function branchPoints() {
  const degree = new Uint32Array(points.length / 3);
  for (const v of cut)
    ++degree[v];
  const isFeature = new Set(features);
  return Uint32Array.from(Array.from(degree.keys()).filter(v => degree[v] > 2 && !isFeature.has(v)));
}

// All copies of vertices in the layout.
function copies(vertices) {
  const wanted = new Set(vertices), found = new Set();
  for (let i = 0; i < triangles.length; ++i)
    if (wanted.has(triangles[i]))
      found.add(uvTriangles[i]);
  return Uint32Array.from(found);
}

function showViews() {
  uniforms.ramp.value = rampTexture();
  uniforms.squares.value = 40 / facts.diagonal / (report.uv_scale || 1);
  const corners = makeCorners();
  const surface = new SurfaceView(element('surface'), makeGeometry(false, corners), false, points, triangles);
  const layout = new LayoutView(element('layout'), makeGeometry(true, corners), true, flat, uvTriangles);
  surface.addLines(cut);
  layout.addLines(borders);
  const branches = branchPoints();
  for (const [indices, isRound] of [[branches, false], [features, true]]) {
    surface.addPoints(indices, isRound);
    layout.addPoints(copies(indices), isRound);
  }
  views.push(surface, layout);
  views.forEach(control);

  const recolor = () => {
    uniforms.plain.value = variable('--surface');
    views.forEach(view => view.recolor());
    redraw();
  };
  matchMedia('(prefers-color-scheme: dark)').addEventListener('change', recolor);
  const resize = () => {
    views.forEach(view => view.resize());
    redraw();
  };
  new ResizeObserver(resize).observe(element('surface'));
  resize();
  recolor();

  for (const input of document.querySelectorAll('input[name=shading]'))
    input.addEventListener('change', () => {
      uniforms.shading.value = Number(input.value);
      element('legend').classList.toggle('hidden', input.value !== '0');
      redraw();
    });
  const toggle = (id, change) => element(id).addEventListener('change', event => {
    views.forEach(view => change(view, event.target.checked));
    redraw();
  });
  toggle('show-cut', (view, isShown) => { view.cut.visible = isShown; });
  toggle('show-points', (view, isShown) => view.points.forEach(object => { object.visible = isShown; }));
  element('reset').addEventListener('click', () => {
    views.forEach(view => view.reset());
    redraw();
  });
  element('layout-hint').textContent = report.fill === null ? 'at the scale of the surface' : 'the unit square';
  // For tests: where a UV is on the page.
  window.pixelOfUV = (u, v) => {
    const box = element('layout').getBoundingClientRect(), [x, y] = layout.project([u, v, 0]);
    return [box.left + x, box.top + y];
  };
  views.forEach(view => view.draw());
}

showFigures();
showWords();
showMeasures();
showTradeOffs();
showLegend();
showViews();
document.body.dataset.ready = Math.round(performance.now());

})();
