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
// The s of 1 or more for which a map that stretches by s one way and by 1/s the other way has this energy.
function stretch(energy) {
  const a = Math.max(1, energy / 4);
  return Math.sqrt(a + Math.sqrt(a * a - 1));
}
const percent = (share, precision = 2) => digits(100 * share, precision) + ' %';
const stretched = energy => percent(stretch(energy) - 1);
const mean = value => Array.isArray(value) ? value.reduce((a, b) => a + b) / value.length : value;
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
    ['E_iso', 'Stretch', stretched, 'on average; energy ' + digits(report.E_iso)],
    ['E_max', 'Largest stretch', stretched, 'of a triangle; energy ' + digits(report.E_max)],
    ['cut_length', 'Length of the cut', digits, 'bounding box diagonals'], ['charts', 'Charts', digits, 'pieces of the layout'],
    ['fill', report.pages > 1 ? 'Pages filled' : 'Square filled', value => percent(mean(value), 3), 'by the charts'],
    ['overlaps', 'Overlaps', digits, 'proven'], ['flips', 'Flips', digits, 'proven']];
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
    texts.push('One unit of length on the surface is ' + digits(report.uv_scale) + (report.pages > 1 ? ' sides of a page' : ' units of the unit square') + ', the same for all charts, which are at least '
      + digits(facts.margin) + ' texels of ' + digits(facts.texture_size) + ' apart.');
  if (report.status !== 'done')
    texts.push(report.message.charAt(0).toUpperCase() + report.message.slice(1) + '.');
  return texts;
}

// What the report calls "interpreted".
const interpretations = {
  non_manifold_edges: n => n + ' edges with more than two faces, of which pairs stay connected',
  non_manifold_vertices: n => n + ' vertices where parts of the surface only touch, which count once for each part',
  reoriented_faces: n => n + ' faces that look to the other side than their neighbors, read backward',
  non_orientable_edges: n => n + ' edges opened, since the surface has only one side',
  degenerate_faces: n => n + ' faces with fewer than three different corners, which get the coordinates of their place',
  duplicate_faces: n => n + ' faces given again, which get the same coordinates',
  welded_vertices: n => n + ' vertices that count as one with another one at the same point'};

function showWords() {
  document.title = facts.name + ' – unwrapped';
  element('name').textContent = facts.name;
  element('verdict').textContent = verdict();
  for (const text of sentences())
    append(element('words'), 'p', text);
  const notes = report.warnings.map(text => 'Warning: ' + text);
  for (const item of report.interpreted || [])
    notes.push('In the input: ' + (interpretations[item.what] || (() => item.what.replace(/_/g, ' ')))(digits(item.count)) + '.');
  if (notes.length > 0) {
    const list = append(element('words'), 'ul', undefined, {'class': 'warning'});
    for (const note of notes)
      append(list, 'li', note);
  }
}

function showMeasures() {
  const names = {
    status: 'Status', vertices: 'Vertices', faces: 'Faces', polygons: 'Faces that are no triangles', components: 'Components', genus: 'Handles', borders: 'Borders',
    candidates: 'Candidates', features: 'Feature points', auxiliary: 'Branch points added', cut_length: 'Length of the cut',
    cut_cost: 'Cost of the cut', cut_lower_bound: 'Lower bound on its length', optimal: 'Proven shortest', E_iso: 'Mean energy',
    E_max: 'Largest energy', flips: 'Flips', overlaps: 'Overlaps', charts: 'Charts', uv_scale: 'Scale of the UVs', fill: 'Fill of the square',
    pages: 'Pages', texels_per_unit: 'Texels per unit of length',
    effort: 'Effort', solver: 'Linear solver', seed: 'Seed', threads: 'Threads', peak_memory_mb: 'Memory in megabytes'};
  const add = (label, make) => {
    const row = append(element('measures'), 'div');
    append(row, 'dt', label);
    make(row);
  };
  for (const key in names)
    if (report[key] !== null && report[key] !== undefined && !(key === 'polygons' && report[key] === 0))
      add(names[key], row => show(row, 'dd', key, typeof report[key] === 'boolean' ? (report[key] ? 'yes' : 'no') : digits(mean(report[key]), 6)));
  const columns = {
    max_area_distortion: 'Largest area distortion', average_area_discrepancy: 'Average area discrepancy',
    max_angle_distortion: 'Largest angle distortion', average_angle_discrepancy: 'Average angle discrepancy',
    min_singular_value: 'Smallest singular value', max_singular_value: 'Largest singular value', resolution: 'Texels per unit of length'};
  for (const key in columns)
    if (report.distortion && report.distortion[key] !== null)
      add(columns[key], row => append(row, 'dd', digits(report.distortion[key], 6),
                                      {'data-key': 'distortion.' + key, 'data-value': JSON.stringify(report.distortion[key])}));
  const seamColumns = {
    jaggedness: 'Jaggedness of the seams', compactness: 'Compactness of charts', convexity: 'Convexity of charts',
    on_hard_edges: 'Seam on hard edges', hidden: 'Seam hidden'};
  for (const key in seamColumns)
    if (report.seams && report.seams[key] !== null)
      add(seamColumns[key], row => append(row, 'dd', key === 'on_hard_edges' || key === 'hidden' ? percent(report.seams[key], 3) : digits(report.seams[key], 4),
                                          {'data-key': 'seams.' + key, 'data-value': JSON.stringify(report.seams[key])}));
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

