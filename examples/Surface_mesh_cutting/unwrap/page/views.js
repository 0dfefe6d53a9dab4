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
    const quarter = Math.PI / 2, upright = {x: [0, 0, quarter], y: [0, 0, 0], z: [-quarter, 0, 0]}[element('up').value];
    this.rotation = new THREE.Quaternion().setFromEuler(new THREE.Euler(0.35, -0.6, 0))
      .multiply(new THREE.Quaternion().setFromEuler(new THREE.Euler(...upright)));
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
    Object.assign(this, layoutBox());
    if (report.fill !== null) { // the squares themselves
      const sides = [0, 0, 1, 0, 1, 0, 1, 1, 1, 1, 0, 1, 0, 1, 0, 0], square = [];
      for (let page = 0; page < numberOfPages; ++page)
        for (let i = 0; i < sides.length; i += 2)
          square.push(sides[i] + page % 10, sides[i + 1] + Math.floor(page / 10), 0);
      this.square = new THREE.LineSegments(new THREE.BufferGeometry().setAttribute('position', new THREE.BufferAttribute(new Float32Array(square), 3)), new THREE.LineBasicMaterial());
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
