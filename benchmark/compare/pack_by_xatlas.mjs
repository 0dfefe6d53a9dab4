// Packs the charts of a flat layout by xatlas, and tells the number of pages:
//   node pack_by_xatlas.mjs .../watlas.js LAYOUT.obj TEXELS_PER_UNIT TEXTURE_SIZE MARGIN
// It turns charts, as it does by default; it leaves no texel for bilinear filtering in addition to the margin.
import {readFileSync} from "node:fs";
import {pathToFileURL} from "node:url";

const [library, input, ...numbers] = process.argv.slice(2);
const [texelsPerUnit, resolution, padding] = numbers.map(Number);
const watlas = await import(pathToFileURL(library));
await watlas.Initialize();

const uvs = [];
const indices = [];
for (const words of readFileSync(input, "ascii").split("\n").map(line => line.split(" ")))
  if (words[0] === "v")
    uvs.push(Number(words[1]), Number(words[2]));
  else if (words[0] === "f")
    indices.push(...words.slice(1).map(word => Number.parseInt(word) - 1)); // the number before the slash

const atlas = new watlas.Atlas();
atlas.addUvMesh({vertexUvData: new Float32Array(uvs), vertexCount: uvs.length / 2, vertexStride: 8,
                 indexData: new Uint32Array(indices), indexCount: indices.length});
atlas.computeCharts({});
atlas.packCharts({texelsPerUnit, resolution, padding, bilinear: false});
console.log(atlas.atlasCount);
