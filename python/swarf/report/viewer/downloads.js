// The data of each figure as a csv file.
function save(name, text) {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(new Blob([text], { type: "text/csv" }));
  link.download = name;
  link.click();
  URL.revokeObjectURL(link.href);
}

function table(columns) {
  const rows = [columns.map((one) => one.title).join(",")];
  for (let i = 0; i < columns[0].values.length; ++i) rows.push(columns.map((one) => one.values[i] ?? "").join(","));
  return rows.join("\n") + "\n";
}

export function makeDownloads(page) {
  for (const button of document.querySelectorAll("button[data-chart]")) {
    const chart = page.charts.find((one) => one.id === button.dataset.chart);
    button.addEventListener("click", () =>
      save(`${chart.id}.csv`, table([{ title: `"${chart.x.title}"`, values: chart.x.values },
        ...chart.curves.map((one) => ({ title: `"${one.label}"`, values: one.values }))])));
  }
  for (const button of document.querySelectorAll("button[data-table]"))
    button.addEventListener("click", () => {
      const rows = document.getElementById(button.dataset.table).querySelectorAll("tr");
      const text = [...rows].map((row) => [...row.cells].map((cell) => `"${cell.textContent.replaceAll('"', '""')}"`).join(","));
      save(`${button.dataset.table}.csv`, text.join("\n") + "\n");
    });
}
