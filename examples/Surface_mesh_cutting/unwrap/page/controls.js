// What the user does, and how all begins.

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
