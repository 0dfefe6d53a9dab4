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

// Attributes of what shows a value of the report; tests compare them with the report.
const keyed = (key, value) => ({'data-key': key, 'data-value': JSON.stringify(value)});
const show = (parent, name, key, text) => append(parent, name, text, keyed(key, report[key]));

function showFigures() {
  const pages = report.pages > 1
    ? 'from ' + percent(Math.min(...report.fill), 3) + ' to ' + percent(Math.max(...report.fill), 3) : '';
  const figures = [
    ['E_iso', 'Stretch', stretched, 'on average; energy ' + digits(report.E_iso)
      + (facts.bounds.mean === null ? '' : ', asked for ' + digits(facts.bounds.mean, 6))],
    ['E_max', 'Largest stretch', stretched, 'of a triangle; energy ' + digits(report.E_max)],
    ['cut_length', 'Length of the cut', digits, 'bounding box diagonals'], ['charts', 'Charts', digits, 'pieces of the layout'],
    ['fill', report.pages > 1 ? 'Pages filled' : 'Square filled', value => percent(mean(value), 3), pages || 'by the charts'],
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
  if (report.symmetry)
    texts.push('The surface is symmetric: a plane of reflection brings ' + percent(report.symmetry.matched, 4)
      + ' of its vertices to the surface.');
  if (report.stacked && report.stacked.length > 0)
    texts.push(plural(report.stacked.reduce((sum, parts) => sum + parts.length, 0), 'part lies', 'parts lie') + ' on '
      + plural(report.stacked.length, 'place', 'places') + ', since they are congruent or mirror images.');
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

// Measures that the report holds as parts of others: their key, label, format, and an explanation.
const number = value => digits(value, 6), share = value => percent(value, 3);
const partsOfMeasures = {
  distortion: [
    ['max_area_distortion', 'Largest area distortion', number], ['average_area_discrepancy', 'Average area discrepancy', number],
    ['max_angle_distortion', 'Largest angle distortion', number],
    ['average_angle_discrepancy', 'Average angle discrepancy', number],
    ['min_singular_value', 'Smallest singular value', number], ['max_singular_value', 'Largest singular value', number],
    ['resolution', 'Resolution needed', number, 'texels along a side for one per unit of length everywhere']],
  seams: [
    ['jaggedness', 'Jaggedness of the seams', number, 'turning per edge in radians, beyond that of the smoothest way nearby'],
    ['compactness', 'Compactness of charts', number, '1 for disks, less for long and winding charts'],
    ['convexity', 'Convexity of charts', share, 'share of their convex hulls'],
    ['on_hard_edges', 'Seam on hard edges', share, 'where normals turn by 30 degrees or more'],
    ['hidden', 'Seam hidden', share, 'light that the surface keeps from it']],
  symmetry: [
    ['normal', 'Normal of the plane of symmetry', normal => normal.map(x => digits(x, 3)).join(', ')],
    ['offset', 'Its distance from the origin', number], ['matched', 'Vertices that it brings to the surface', share]]};

function showMeasures() {
  const names = {
    status: 'Status', vertices: 'Vertices', faces: 'Faces', polygons: 'Faces that are no triangles', components: 'Components', genus: 'Handles', borders: 'Borders',
    candidates: 'Candidates', features: 'Feature points', auxiliary: 'Branch points added', cut_length: 'Length of the cut',
    cut_cost: 'Cost of the cut', cut_lower_bound: 'Lower bound on its length', optimal: 'Proven shortest', E_iso: 'Mean energy',
    E_max: 'Largest energy', flips: 'Flips', overlaps: 'Overlaps', charts: 'Charts', uv_scale: 'Scale of the UVs', fill: 'Fill of the square',
    pages: 'Pages', texels_per_unit: 'Texels per unit of length',
    effort: 'Effort', solver: 'Linear solver', seed: 'Seed', threads: 'Threads', peak_memory_mb: 'Memory in megabytes'};
  const add = (label, make, explanation) => {
    const row = append(element('measures'), 'div'), term = append(row, 'dt', label);
    if (explanation)
      append(term, 'small', explanation);
    make(row);
  };
  for (const key in names)
    if (report[key] !== null && report[key] !== undefined && !(key === 'polygons' && report[key] === 0))
      add(names[key], row => show(row, 'dd', key, typeof report[key] === 'boolean' ? (report[key] ? 'yes' : 'no') : digits(mean(report[key]), 6)));
  for (const outer in partsOfMeasures)
    for (const [key, label, format, explanation] of partsOfMeasures[outer])
      if (report[outer] && report[outer][key] !== null)
        add(label, row => append(row, 'dd', format(report[outer][key]), keyed(outer + '.' + key, report[outer][key])), explanation);
  add('Seconds in all', row => append(row, 'dd', digits(report.seconds.total), keyed('seconds.total', report.seconds.total)));
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

