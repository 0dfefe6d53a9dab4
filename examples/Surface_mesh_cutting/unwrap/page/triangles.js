// The triangles: their colors, corners and shaders.

// ---- colors

// Light is good.
const ramp = facts.ramp;

// On the scale, which is proportional to the logarithm of the stretch; 1 is four times as long.
const place = energy => Math.min(1, Math.log(stretch(energy)) / Math.log(4));

// The color at a place of the scale, as three numbers up to 255.
function color(at) {
  const k = Math.min(ramp.length - 2, Math.floor(at * (ramp.length - 1))), share = at * (ramp.length - 1) - k;
  return ramp[k].map((value, c) => Math.round(value + share * (ramp[k + 1][c] - value)));
}

function showLegend() {
  element('ramp').style.background = 'linear-gradient(to right,' + ramp.map(c => `rgb(${c})`).join() + ')';
  for (const percent of [0, 25, 50, 100, 200, 300])
    append(element('ticks'), 'span', percent + ' %').style.left = 100 * Math.log(1 + percent / 100) / Math.log(4) + '%';
}

const variable = name => new THREE.Color(getComputedStyle(document.documentElement).getPropertyValue(name).trim());

// ---- geometry: one vertex per corner, so that each triangle has a color and a number of its own

function rampTexture() {
  const bytes = new Uint8Array(256 * 3);
  for (let i = 0; i < 256; ++i)
    bytes.set(color(i / 255), 3 * i);
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
