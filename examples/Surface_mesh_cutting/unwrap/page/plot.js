// The plot of the cuts that the run considered.

// 1, 2 or 5 times a power of ten, of which at most `most` fit into `extent`.
function tickDistance(extent, most) {
  const power = Math.pow(10, Math.floor(Math.log10(extent / most)));
  return [1, 2, 5, 10].map(factor => factor * power).find(step => extent / step <= most);
}

// Multiples of such a distance from `low` to `high`.
function ticks(low, high, most) {
  const step = tickDistance(high - low, most), numbers = [];
  for (let i = Math.ceil(low / step); i * step <= high; ++i)
    numbers.push(Number((i * step).toPrecision(8)));
  return numbers;
}

// From the smallest to the largest number, and some room.
function range(numbers, room) {
  const low = Math.min(...numbers), high = Math.max(...numbers), more = room * ((high - low) || Math.abs(high) || 1);
  return [low - more, high + more];
}

// Length to the right, upward the logarithm of the energy above 4; both from the least to the most that there is.
function showTradeOffs() {
  const tried = report.tradeoff.filter(([, energy]) => energy > 4);
  if (tried.length < 2) {
    element('tradeoff-section').remove();
    return;
  }
  const width = 460, height = 290, left = 66, right = 16, top = 10, bottom = 44;
  const [shortest, longest] = range([...tried.map(t => t[0]), report.cut_length], 0.06);
  const energiesShown = [...tried.map(t => t[1]), report.E_iso, facts.bounds.mean].filter(energy => energy > 4);
  const [low, high] = range(energiesShown.map(energy => Math.log(energy - 4)), 0.08);
  const x = length => left + (width - left - right) * (length - shortest) / (longest - shortest);
  const y = energy => top + (height - top - bottom) * (high - Math.log(energy - 4)) / (high - low);
  const plot = svg(element('tradeoff'), 'svg', {viewBox: `0 0 ${width} ${height}`, role: 'img',
    'aria-label': 'Mean energy of the cuts that were tried, by their length'});
  // Round numbers where they are few enough; over several decades, those that are round above 4.
  const decades = [1, 2, 5].flatMap(f => [...Array(12).keys()].map(k => 4 + f * Math.pow(10, k - 6)));
  const energyTicks = high - low < Math.log(6) ? ticks(4 + Math.exp(low), 4 + Math.exp(high), 6) : decades.sort((a, b) => a - b);
  let last = Infinity;
  for (const energy of energyTicks) {
    const at = y(energy);
    if (!(at >= top && at <= height - bottom && last - at > 16))
      continue;
    last = at;
    svg(plot, 'line', {x1: left, x2: width - right, y1: at, y2: at, stroke: 'var(--line)'});
    svg(plot, 'text', {x: left - 8, y: at + 4, 'text-anchor': 'end', class: 'energy'}, String(Number(energy.toPrecision(8))));
  }
  for (const length of ticks(shortest, longest, 6)) {
    svg(plot, 'line', {x1: x(length), x2: x(length), y1: top, y2: height - bottom, stroke: 'var(--line)'});
    svg(plot, 'text', {x: x(length), y: height - bottom + 18, 'text-anchor': 'middle', class: 'length'}, String(length));
  }
  svg(plot, 'text', {x: (left + width - right) / 2, y: height - 6, 'text-anchor': 'middle'}, 'length of the cut in bounding box diagonals');
  svg(plot, 'text', {x: 0, y: 0, 'text-anchor': 'middle', transform: `translate(12 ${(top + height - bottom) / 2}) rotate(-90)`}, 'mean energy');
  if (facts.bounds.mean !== null) {
    const at = y(facts.bounds.mean);
    svg(plot, 'line', {x1: left, x2: width - right, y1: at, y2: at, stroke: 'var(--cut)', 'stroke-dasharray': '6 4'});
    svg(plot, 'text', {x: left + 6, y: at - 5, class: 'bound'}, 'asked for');
  }
  svg(plot, 'polyline', {points: tried.map(t => x(t[0]) + ',' + y(t[1])).join(' '), fill: 'none', stroke: 'var(--accent)', 'stroke-width': 2, 'stroke-linejoin': 'round'});
  for (const t of tried) {
    const dot = svg(plot, 'circle', {cx: x(t[0]), cy: y(t[1]), r: 3, fill: 'var(--accent)', 'data-key': 'tradeoff', 'data-value': JSON.stringify(t)});
    svg(dot, 'title', {}, 'length ' + digits(t[0]) + ', mean energy ' + digits(t[1], 5) + ', stretch ' + stretched(t[1]));
  }
  if (report.E_iso > 4)
    svg(plot, 'circle', {cx: x(report.cut_length), cy: y(report.E_iso), r: 6, fill: 'var(--panel)', stroke: 'var(--cut)', 'stroke-width': 3});
  append(element('tradeoff'), 'p', 'The cuts that were tried on the way, with the mean energy of their maps; '
    + 'the ring is the result. An energy of 4 is no distortion; ' + digits(report.E_iso) + ' is a stretch of ' + stretched(report.E_iso) + ' on average.'
    + (facts.bounds.faces === null && facts.bounds.charts === null ? '' : ' Bounds on triangles and charts are not in this plot.'));
}
