// What the program has written into the page, and what it says in words. All numbers come from the report, all shapes
// from the buffers.

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
  const columns = {
    max_area_distortion: 'Largest area distortion', average_area_discrepancy: 'Average area discrepancy',
    max_angle_distortion: 'Largest angle distortion', average_angle_discrepancy: 'Average angle discrepancy',
    min_singular_value: 'Smallest singular value', max_singular_value: 'Largest singular value', resolution: 'Texels per unit of length'};
  for (const key in columns)
    if (report.distortion && report.distortion[key] !== null)
      add(columns[key], row => append(row, 'dd', digits(report.distortion[key], 6),
                                      {'data-key': 'distortion.' + key, 'data-value': JSON.stringify(report.distortion[key])}));
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
