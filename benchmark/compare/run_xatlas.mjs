// Charts and packs a mesh by xatlas with its default options, and tells the processor seconds without reading and writing:
//   node run_xatlas.mjs .../watlas.js INPUT.obj OUTPUT.obj
import {readFileSync, writeFileSync} from "node:fs";
import {pathToFileURL} from "node:url";

const [library, input, output] = process.argv.slice(2);
const watlas = await import(pathToFileURL(library));
await watlas.Initialize();

const lines = readFileSync(input, "ascii").split("\n");
const numbers = key => lines.filter(line => line.startsWith(key + " ")).flatMap(line => line.split(" ").slice(1, 4).map(Number));
const positions = new Float32Array(numbers("v"));
const indices = new Uint32Array(numbers("f").map(number => number - 1));

const atlas = new watlas.Atlas();
atlas.addMesh({vertexPositionData: positions, vertexCount: positions.length / 3, vertexPositionStride: 12,
               indexData: indices, indexCount: indices.length});
const start = process.cpuUsage();
atlas.generate({}, {});
const used = process.cpuUsage(start);
console.log(`seconds ${(used.user + used.system) / 1e6}`);
if (atlas.atlasCount !== 1)
  throw new Error(`${atlas.atlasCount} pages`);

// Texels, at one scale in both directions.
const mesh = atlas.getMesh(0);
const size = Math.max(atlas.width, atlas.height);
const corners = new Uint32Array(mesh.indexCount);
mesh.getIndexArray(corners);
const original = [];
const uvs = [];
for (let i = 0; i < mesh.vertexCount; ++i) {
  const vertex = mesh.getVertex(i);
  original.push(vertex.xref + 1);
  uvs.push(`vt ${vertex.uv[0] / size} ${vertex.uv[1] / size}`);
}
const faces = [];
for (let i = 0; i < corners.length; i += 3)
  faces.push("f " + [...corners.slice(i, i + 3)].map(c => `${original[c]}/${c + 1}`).join(" "));
writeFileSync(output, [...lines.filter(line => line.startsWith("v ")), ...uvs, ...faces, ""].join("\n"));
