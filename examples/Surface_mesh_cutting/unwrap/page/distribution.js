// How distortion is distributed over the area and over the charts, and the bounds that were asked for.

const limitlessly = energy => energy === null ? '∞' : stretched(energy);

// A table with a row of texts for each of `rows`, which may have a key and a value of the report.
function addTable(parent, head, rows) {
  const table = append(parent, 'table'), line = append(append(table, 'thead'), 'tr'), body = append(table, 'tbody');
  head.forEach(text => append(line, 'th', text, {scope: 'col'}));
  for (const {texts, key, value, isBound} of rows) {
    const row = append(body, 'tr', undefined, isBound ? {'class': 'bound'} : {});
    texts.forEach((text, i) => append(row, 'td', text, key && i === 0 ? keyed(key, value) : {}));
  }
}

function showQuantiles(parent) {
  const quantiles = Object.entries(report.E_quantiles).sort((a, b) => a[0] - b[0]);
  const texts = (share, energy) => [share, limitlessly(energy), energy === null ? '∞' : digits(energy, 5)];
  const rows = quantiles.map(([share, value]) => ({texts: texts(percent(share, 4), value), key: 'E_quantiles.' + share, value}));
  const {faces, face_quantile: share} = facts.bounds;
  if (faces !== null)
    rows.push({texts: texts('asked for: ' + percent(share, 5), faces), isBound: true});
  addTable(parent, ['Share of the area', 'Stretched by at most', 'Energy at most'], rows);
}

// The worst charts come first.
function showCharts(parent) {
  const most = 8, size = value => value === null ? Infinity : value;
  const charts = report.charts_distortion.map((chart, i) => ({chart, name: digits(i + 1)}));
  charts.sort((a, b) => size(b.chart.mean) > size(a.chart.mean) ? 1 : size(b.chart.mean) < size(a.chart.mean) ? -1 : 0);
  const rows = charts.slice(0, most).map(({chart, name}) => ({
    texts: [name, digits(chart.faces), limitlessly(chart.mean), limitlessly(chart.max)], key: 'charts_distortion', value: chart}));
  const bound = facts.bounds.charts;
  if (bound !== null)
    rows.push({texts: ['asked for', '', stretched(bound), ''], isBound: true});
  addTable(parent, ['Chart', 'Triangles', 'Stretched on average', 'Largest stretch'], rows);
  if (charts.length > most)
    append(parent, 'p', 'These are the worst; the mean of each of the other ' + digits(charts.length - most) + ' charts is at most '
      + limitlessly(charts[most].chart.mean) + '.');
}

function showDistribution() {
  const parent = element('distribution');
  if (Object.keys(report.E_quantiles).length === 0) {
    element('distribution-section').remove();
    return;
  }
  showQuantiles(parent);
  if (report.charts_distortion.length > 1 || facts.bounds.charts !== null)
    showCharts(parent);
}
