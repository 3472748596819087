// What a report does in the browser: curves, downloads, the turning view. The page works without it as text and tables.
import { drawCharts } from "./charts.js";
import { makeDownloads } from "./downloads.js";
import { showScene } from "./scene.js";

const page = JSON.parse(document.getElementById("page-data").textContent);
drawCharts(page.charts);
makeDownloads(page);
for (const scene of page.scenes)
  showScene(scene).catch((error) => {
    document.getElementById(`${scene.id}-state`).textContent = `No 3D view in this browser: ${error.message}.`;
  });
