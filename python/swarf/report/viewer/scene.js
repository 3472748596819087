// Particles, hexes and tool of each frame in a view that turns, by vtk.js; colours by a field, a slider over time.
import "@kitware/vtk.js/Rendering/Profiles/Geometry.js";
import "@kitware/vtk.js/Rendering/Profiles/Molecule.js"; // the spheres
import vtkActor from "@kitware/vtk.js/Rendering/Core/Actor.js";
import vtkColorTransferFunction from "@kitware/vtk.js/Rendering/Core/ColorTransferFunction.js";
import vtkDataArray from "@kitware/vtk.js/Common/Core/DataArray.js";
import vtkGenericRenderWindow from "@kitware/vtk.js/Rendering/Misc/GenericRenderWindow.js";
import vtkMapper from "@kitware/vtk.js/Rendering/Core/Mapper.js";
import vtkPolyData from "@kitware/vtk.js/Common/DataModel/PolyData.js";
import vtkSphereMapper from "@kitware/vtk.js/Rendering/Core/SphereMapper.js";
import { readFrames } from "./frames.js";

// Viridis, which grows evenly in lightness (van der Walt & Smith 2015).
const viridis = [[0.267, 0.005, 0.329], [0.283, 0.141, 0.458], [0.254, 0.265, 0.530], [0.207, 0.372, 0.553],
  [0.164, 0.471, 0.558], [0.128, 0.567, 0.551], [0.135, 0.659, 0.518], [0.267, 0.749, 0.441], [0.478, 0.821, 0.318],
  [0.741, 0.873, 0.150], [0.993, 0.906, 0.144]];

function colours(low, high) {
  const map = vtkColorTransferFunction.newInstance();
  viridis.forEach((rgb, k) => map.addRGBPoint(low + ((high - low) * k) / (viridis.length - 1), ...rgb));
  return map;
}

function make(mapper, data) {
  const actor = vtkActor.newInstance();
  mapper.setInputData(data);
  actor.setMapper(mapper);
  return { actor, mapper, data };
}

function colourBy(part, values, field) {
  if (!values) { part.mapper.setScalarVisibility(false); return; }
  part.data.getPointData().setScalars(vtkDataArray.newInstance({ name: field.name, values, numberOfComponents: 1 }));
  part.mapper.setScalarVisibility(true);
  part.mapper.setLookupTable(colours(field.low, field.high));
  part.mapper.setUseLookupTableScalarRange(true);
  part.data.modified();
}

function bar(scene, field) {
  const round = (v) => Number(v.toPrecision(3)).toString();
  document.getElementById(`${scene.id}-bar`).style.background =
    `linear-gradient(to right, ${viridis.map((c) => `rgb(${c.map((v) => Math.round(255 * v))})`).join(",")})`;
  document.getElementById(`${scene.id}-low`).textContent = round(field.low);
  document.getElementById(`${scene.id}-high`).textContent = `${round(field.high)} ${field.unit}`;
}

export async function showScene(scene) {
  const frames = await readFrames(scene);
  const place = document.getElementById(scene.id);
  const view = vtkGenericRenderWindow.newInstance({ background: [1, 1, 1] });
  view.setContainer(place);
  const renderer = view.getRenderer(), window_ = view.getRenderWindow();
  const canvas = place.querySelector("canvas");
  canvas.tabIndex = 0;
  canvas.setAttribute("role", "img");
  canvas.setAttribute("aria-label", scene.summary);

  const spheres = vtkSphereMapper.newInstance();
  spheres.setRadius(scene.radius);
  const parts = { particles: make(spheres, vtkPolyData.newInstance()), hexes: make(vtkMapper.newInstance(), vtkPolyData.newInstance()),
    tool: make(vtkMapper.newInstance(), vtkPolyData.newInstance()) };
  parts.hexes.actor.getProperty().setEdgeVisibility(true);
  parts.hexes.actor.getProperty().setEdgeColor(0.35, 0.35, 0.35);
  parts.tool.actor.getProperty().setColor(0.72, 0.72, 0.75);
  parts.tool.actor.getProperty().setOpacity(0.55);
  parts.tool.mapper.setScalarVisibility(false);
  for (const part of Object.values(parts)) renderer.addActor(part.actor);

  const get = (name) => document.getElementById(`${scene.id}-${name}`);
  const slider = get("time"), choice = get("field");
  function show() {
    const frame = frames[Number(slider.value)], field = scene.fields[choice.selectedIndex];
    for (const name of ["particles", "hexes"]) {
      const part = parts[name], has = frame[name] !== null;
      part.actor.setVisibility(has && get(name).checked);
      if (!has) continue;
      part.data.getPoints().setData(frame[name].points, 3);
      if (name === "hexes") part.data.getPolys().setData(frame.hexes.faces);
      else part.data.getVerts().setData(Uint32Array.from([frame.particles.count, ...Array(frame.particles.count).keys()]));
      colourBy(part, frame[name].fields[field.name], field);
      part.data.modified();
    }
    parts.tool.actor.setVisibility(frame.tool !== null && get("tool").checked);
    if (frame.tool) parts.tool.actor.setUserMatrix(frame.tool);
    bar(scene, field);
    slider.setAttribute("aria-valuetext", frame.title);
    get("now").textContent = frame.title;
    window_.render();
  }
  if (scene.tool) {
    parts.tool.data.getPoints().setData(frames.toolPoints, 3);
    const corners = frames.toolPoints.length / 3, polys = new Uint32Array((corners / 3) * 4);
    for (let k = 0; k < corners / 3; ++k) polys.set([3, 3 * k, 3 * k + 1, 3 * k + 2], 4 * k);
    parts.tool.data.getPolys().setData(polys);
  }

  for (const name of ["time", "field", "particles", "hexes", "tool"]) get(name).addEventListener("input", show);
  let playing = null;
  get("play").addEventListener("click", () => {
    if (playing) { clearInterval(playing); playing = null; } else
      playing = setInterval(() => { slider.value = (Number(slider.value) + 1) % frames.length; show(); }, 200);
    get("play").textContent = playing ? "Pause" : "Play";
  });
  const camera = renderer.getActiveCamera();
  function look() { // along the picture's direction, at the particles
    camera.setFocalPoint(...scene.focus);
    camera.setPosition(...scene.focus.map((v, k) => v + scene.distance * scene.view[k]));
    camera.setViewUp(...scene.up);
    camera.setParallelProjection(true);
    camera.setParallelScale(scene.scale);
    renderer.resetCameraClippingRange();
  }
  const turn = { ArrowLeft: () => camera.azimuth(10), ArrowRight: () => camera.azimuth(-10), ArrowUp: () => camera.elevation(-10),
    ArrowDown: () => camera.elevation(10), "+": () => camera.zoom(1.2), "-": () => camera.zoom(1 / 1.2), Home: look };
  canvas.addEventListener("keydown", (event) => {
    if (!turn[event.key]) return;
    event.preventDefault();
    turn[event.key]();
    camera.orthogonalizeViewUp();
    renderer.resetCameraClippingRange();
    window_.render();
  });
  get("home").addEventListener("click", () => { look(); window_.render(); });
  show();
  view.resize();
  look();
  window_.render();
  new ResizeObserver(() => view.resize()).observe(place);
  get("state").textContent = scene.note;
  place.dataset.ready = "true";
}
