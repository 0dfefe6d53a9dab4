// What the user does, and how all begins.

function hover(face) {
  if (document.body.dataset.hovered === String(face))
    return;
  document.body.dataset.hovered = face;
  views.forEach(view => view.light(face));
  element('hovered').textContent = face < 0 ? 'Point at a triangle to find it in both views.'
    : 'Triangle ' + digits(face) + ': stretched by ' + stretched(energies[face]) + ', energy ' + digits(energies[face], 5) + ', vertices '
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

// What is drawn, by what the user chose.
const chosen = () => ({
  shading: Number(document.querySelector('input[name=shading]:checked').value),
  hasCut: element('show-cut').checked,
  hasPoints: element('show-points').checked});

// Calls `change()` when the user chooses something, and `recolor()` when the page becomes dark or light.
function listen(change, recolor, resize) {
  for (const input of document.querySelectorAll('input'))
    input.addEventListener('change', () => {
      element('legend').classList.toggle('hidden', chosen().shading !== 0);
      change();
    });
  matchMedia('(prefers-color-scheme: dark)').addEventListener('change', recolor);
  new ResizeObserver(resize).observe(element('layout'));
}

// For tests: where a UV is on the page. `project` says where it is on the canvas.
function tellPlaces(project) {
  window.pixelOfUV = (u, v) => {
    const box = element('layout').getBoundingClientRect(), [x, y] = project(u, v);
    return [box.left + x, box.top + y];
  };
}

function showViews() {
  uniforms.ramp.value = rampTexture();
  uniforms.squares.value = checkerFrequency();
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

  const change = () => {
    const {shading, hasCut, hasPoints} = chosen();
    uniforms.shading.value = shading;
    for (const view of views) {
      view.cut.visible = hasCut;
      view.points.forEach(object => { object.visible = hasPoints; });
    }
    redraw();
  };
  const recolor = () => {
    uniforms.plain.value = variable('--surface');
    views.forEach(view => view.recolor());
    redraw();
  };
  const resize = () => {
    views.forEach(view => view.resize());
    redraw();
  };
  listen(change, recolor, resize);
  resize();
  recolor();
  change();
  const reset = () => {
    views.forEach(view => view.reset());
    redraw();
  };
  element('reset').addEventListener('click', reset);
  element('up').addEventListener('change', reset);
  tellPlaces((u, v) => layout.project([u, v, 0]));
  views.forEach(view => view.draw());
}

function showLayoutAlone() {
  document.body.classList.add('flat');
  element('no-surface').hidden = false;
  const layout = new FlatLayout(element('layout'), [[copies(branchPoints()), false], [copies(features), true]]);
  const draw = () => layout.draw(chosen());
  const resize = () => {
    layout.resize();
    draw();
  };
  listen(draw, draw, resize);
  resize();
  element('layout').setAttribute('aria-label', 'The layout in the plane.');
}

element('up').value = facts.up;
element('layout-hint').textContent = layoutHint();
showFigures();
showWords();
showMeasures();
showTradeOffs();
showDistribution();
showLegend();
if (hasWebGL())
  showViews();
else
  showLayoutAlone();
document.body.dataset.ready = Math.round(performance.now());
