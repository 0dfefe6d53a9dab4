// The layout, and a picture of it that needs no WebGL.

function gathered(source, size, indices) {
  const result = new Float32Array(size * indices.length);
  for (let i = 0; i < indices.length; ++i)
    for (let k = 0; k < size; ++k)
      result[size * i + k] = source[size * indices[i] + k];
  return result;
}

// Pages lie side by side, ten in a row.
const numberOfPages = report.pages || 1;

// The part of the plane to show: the pages, or all charts at the scale of the surface.
function layoutBox() {
  if (report.fill !== null)
    return {low: [0, 0], high: [Math.min(numberOfPages, 10), Math.ceil(numberOfPages / 10)]};
  const low = [Infinity, Infinity], high = [-Infinity, -Infinity];
  for (let i = 0; i < uvs.length; ++i) {
    low[i % 2] = Math.min(low[i % 2], uvs[i]);
    high[i % 2] = Math.max(high[i % 2], uvs[i]);
  }
  return {low, high};
}

const layoutHint = () => report.fill === null ? 'at the scale of the surface'
  : numberOfPages === 1 ? 'the unit square' : `${numberOfPages} pages`;

// Squares per unit of the layout.
const checkerFrequency = () => 40 / facts.diagonal / (report.uv_scale || 1);

function hasWebGL() {
  const canvas = document.createElement('canvas');
  return Boolean(canvas.getContext('webgl2') || canvas.getContext('webgl'));
}

class FlatLayout {
  constructor(canvas, marks) {
    this.canvas = canvas;
    this.marks = marks; // UV vertices, and whether they are round
    this.box = layoutBox();
  }

  resize() {
    const ratio = Math.min(2, devicePixelRatio), {clientWidth: width, clientHeight: height} = this.canvas;
    this.canvas.width = width * ratio;
    this.canvas.height = height * ratio;
    this.ratio = ratio;
    const {low, high} = this.box, room = 1.16; // for the text above
    this.scale = ratio * Math.min(width / (high[0] - low[0]), height / (high[1] - low[1])) / room;
    this.origin = [this.canvas.width / 2 - this.scale * (low[0] + high[0]) / 2,
                   this.canvas.height * 0.52 + this.scale * (low[1] + high[1]) / 2];
  }

  // In pixels of the canvas.
  at(v) { return [this.origin[0] + this.scale * uvs[2 * v], this.origin[1] - this.scale * uvs[2 * v + 1]]; }

  addTriangle(path, f) {
    for (let k = 0; k < 3; ++k)
      path[k ? 'lineTo' : 'moveTo'](...this.at(uvTriangles[3 * f + k]));
    path.closePath();
  }

  draw({shading, hasCut, hasPoints}) {
    const css = getComputedStyle(document.documentElement), variable = name => css.getPropertyValue(name).trim();
    const context = this.canvas.getContext('2d');
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.clearRect(0, 0, this.canvas.width, this.canvas.height);
    context.lineJoin = context.lineCap = 'round';
    this.drawTriangles(context, shading, variable);
    if (hasCut)
      this.drawBorders(context, variable('--cut'));
    if (report.fill !== null)
      this.drawSquare(context, variable('--muted'));
    if (hasPoints)
      this.drawMarks(context, variable('--panel'), variable('--point'));
  }

  // Each a little larger than it is, by which no gaps are seen between them.
  drawTriangles(context, shading, variable) {
    context.lineWidth = 0.7 * this.ratio;
    if (shading === 0)
      for (let f = 0; f < numberOfFaces; ++f) {
        context.fillStyle = context.strokeStyle = `rgb(${color(place(energies[f]))})`;
        context.beginPath();
        this.addTriangle(context, f);
        context.fill();
        context.stroke();
      }
    else {
      const path = new Path2D();
      for (let f = 0; f < numberOfFaces; ++f)
        this.addTriangle(path, f);
      context.fillStyle = context.strokeStyle = shading === 1 ? '#f0f0eb' : variable('--surface');
      context.fill(path);
      context.stroke(path);
      if (shading === 1)
        this.drawSquares(context, path);
    }
  }

  drawSquares(context, path) {
    const side = 1 / checkerFrequency(), {low, high} = this.box;
    context.save();
    context.clip(path);
    context.fillStyle = '#29547d';
    for (let i = Math.floor(low[0] / side); i * side < high[0]; ++i)
      for (let j = Math.floor(low[1] / side); j * side < high[1]; ++j)
        if ((i + j) % 2)
          context.fillRect(this.origin[0] + this.scale * i * side, this.origin[1] - this.scale * (j + 1) * side, this.scale * side, this.scale * side);
    context.restore();
  }

  drawBorders(context, stroke) {
    context.beginPath();
    for (let i = 0; i < borders.length; i += 2) {
      context.moveTo(...this.at(borders[i]));
      context.lineTo(...this.at(borders[i + 1]));
    }
    context.lineWidth = 2 * this.ratio;
    context.strokeStyle = stroke;
    context.stroke();
  }

  drawSquare(context, stroke) {
    context.lineWidth = this.ratio;
    context.strokeStyle = stroke;
    for (let page = 0; page < numberOfPages; ++page)
      context.strokeRect(this.origin[0] + page % 10 * this.scale, this.origin[1] - (Math.floor(page / 10) + 1) * this.scale,
                         this.scale, this.scale);
  }

  drawMarks(context, fill, stroke) {
    const radius = 4.5 * this.ratio;
    for (const [vertices, isRound] of this.marks)
      for (const v of vertices) {
        const [x, y] = this.at(v);
        context.beginPath();
        if (isRound)
          context.arc(x, y, radius, 0, 7);
        else
          [[0, -1], [1, 0], [0, 1], [-1, 0]].forEach(([dx, dy]) => context.lineTo(x + radius * dx, y + radius * dy));
        context.closePath();
        context.fillStyle = isRound ? fill : stroke;
        context.strokeStyle = stroke;
        context.lineWidth = 2.5 * this.ratio;
        context.fill();
        context.stroke();
      }
  }
}
