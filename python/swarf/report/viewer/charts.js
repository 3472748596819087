// Curves that one can hover and zoom (drag; double click for all), by uPlot.
import uPlot from "uplot";

const height = (width) => Math.max(260, Math.min(440, Math.round(0.5 * width)));

function options(chart, width) {
  const series = [{ label: chart.x.title, value: (_, v) => (v == null ? "" : v.toPrecision(5)) }];
  for (const curve of chart.curves)
    series.push({
      label: curve.label, stroke: curve.colour, width: curve.width ?? 2, dash: curve.dash, show: curve.show ?? true,
      spanGaps: true, points: { show: false }, value: (_, v) => (v == null ? "" : v.toPrecision(4)),
    });
  const scales = { x: { time: false } };
  if (chart.y.range) scales.y = { range: (_, low, high) => (chart.zoomed ? [low, high] : chart.y.range) };
  return {
    width, height: height(width), series, scales,
    axes: [{ label: chart.x.title, size: 44 }, { label: chart.y.title, size: 64 }],
    cursor: { drag: { x: true, y: true, uni: 30 } },
    legend: { live: true },
    hooks: {
      setSelect: [() => { chart.zoomed = true; }],
    },
  };
}

export function drawCharts(charts) {
  for (const chart of charts) {
    const place = document.getElementById(chart.id);
    const data = [chart.x.values, ...chart.curves.map((curve) => curve.values)];
    const drawn = new uPlot(options(chart, place.clientWidth || 600), data, place);
    place.addEventListener("dblclick", () => { chart.zoomed = false; drawn.setData(data); });
    const canvas = place.querySelector("canvas");
    canvas.setAttribute("role", "img");
    canvas.setAttribute("aria-label", chart.summary);
    const again = () => drawn.setSize({ width: place.clientWidth, height: height(place.clientWidth) });
    new ResizeObserver(again).observe(place);
  }
}
