// Frames of a page: base64 of deflated little-endian blocks, positions and fields in 16 bits between two values.
async function inflate(id) {
  const text = document.getElementById(id).textContent.trim();
  const packed = Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Response(stream).arrayBuffer();
}

function unpack(data, one) {
  const raw = new Uint16Array(data, one.at, one.count * one.width);
  const values = new Float32Array(raw.length);
  for (let i = 0; i < raw.length; ++i) {
    const k = one.width === 1 ? 0 : i % one.width;
    values[i] = one.low[k] + ((one.high[k] - one.low[k]) * raw[i]) / 65535;
  }
  return values;
}

function facesOf(data, one) { // quads as vtk.js lists them
  const corners = new Uint32Array(data, one.at, one.count * 4);
  const polys = new Uint32Array(one.count * 5);
  for (let k = 0; k < one.count; ++k) {
    polys[5 * k] = 4;
    for (let c = 0; c < 4; ++c) polys[5 * k + 1 + c] = corners[4 * k + c];
  }
  return polys;
}

export async function readFrames(scene) {
  const data = await inflate(`${scene.id}-data`);
  const part = (one) => one && {
    count: one.points.count, points: unpack(data, one.points), faces: one.faces && facesOf(data, one.faces),
    fields: Object.fromEntries(Object.entries(one.fields).map(([name, field]) => [name, unpack(data, field)])),
  };
  const frames = scene.frames.map((one) => ({
    title: one.title, particles: part(one.particles ?? null), hexes: part(one.hexes ?? null), tool: one.tool ?? null,
  }));
  frames.toolPoints = scene.tool ? unpack(data, scene.tool) : null;
  return frames;
}
