const stripPanels = [
  { title: "Force on the finger", label: "force [N]", curves: ["normal force", "friction"] },
  { title: "Coefficient of friction", label: "mu", curves: ["mu"] },
  { title: "Depth of the finger in the part", label: "depth [mm]", curves: ["depth"], scale: 1e3 },
  { title: "Speed of the finger", label: "speed [mm/s]", curves: ["speed"], scale: 1e3 }
];

/** Bands in the colours of the phases behind the curves. */
function paintPhases(canvas, area, plot, times, phases) {
  for (let begin = 0; begin < times.length;) {
    let end = begin + 1;
    while (end < times.length && phases[end] === phases[begin]) ++end;
    if (phases[begin] !== 0) {
      const left = plot.toDomXCoord(times[begin]), right = plot.toDomXCoord(times[Math.min(end, times.length - 1)]);
      canvas.fillStyle = report.colours.phases[phases[begin]] + "2e";
      canvas.fillRect(left, area.y, right - left, area.h);
    }
    begin = end;
  }
}

/** A row for each time at which any of the curves has a sample; null where another has none there. */
function chartRows(curves, scale) {
  const rows = curves.flatMap((curve, c) => curve.times.map((time, i) => {
    const row = [time, ...curves.map(() => null)];
    row[c + 1] = curve.values[i] * scale;
    return row;
  })).sort((a, b) => a[0] - b[0]);
  const joined = [];
  for (const row of rows) {
    const last = joined[joined.length - 1];
    const fits = last && last[0] === row[0] && row.every((value, c) => c === 0 || value === null || last[c] === null);
    if (!fits) joined.push(row);
    else row.forEach((value, c) => { if (value !== null) last[c] = value; });
  }
  return joined;
}

/** All panels zoom together. */
function showStrips(holder, data) {
  holder.replaceChildren();
  holder.append(element("h2", {}, "Over time"), phaseLegend("behind the curves: ", ["stick", "slip"]));
  holder.append(element("p", { class: "unit" },
    "Drag over a chart to zoom all of them, double-click for the whole run. Samples are the least and greatest of their ticks."));
  const plots = [];
  let busy = false;
  const zoomAll = from => {
    if (busy) return;
    busy = true;
    for (const plot of plots) if (plot !== from) plot.updateOptions({ dateWindow: from.xAxisRange() });
    busy = false;
  };
  stripPanels.forEach((panel, p) => {
    const curves = panel.curves.map(name => data.curves.find(curve => curve.name === name));
    const rows = chartRows(curves, panel.scale || 1);
    const plot = element("div", { class: "plot" }), names = element("div", { class: "labels" });
    holder.append(element("div", { class: "strip" }, element("h3", {}, panel.title), names, plot));
    plots.push(new Dygraph(plot, rows, {
      labels: ["t [s]", ...panel.curves], ylabel: panel.label, xlabel: "time [s]", connectSeparatedPoints: true,
      colors: report.colours.palette, strokeWidth: 1.4, legend: "always", labelsDiv: names, includeZero: true,
      dateWindow: [data.times[0], data.times[data.times.length - 1]], yRangePad: 4, axisLabelWidth: 64, highlightCircleSize: 3, digitsAfterDecimal: 4, maxNumberWidth: 9,
      axisLabelFontSize: 12, xLabelHeight: 18, yLabelWidth: 18, gridLineColor: "#e3e6ea", labelsKMB: false,
      underlayCallback: (canvas, area, plot) => paintPhases(canvas, area, plot, data.times, data.seriesPhases),
      zoomCallback: () => zoomAll(plots[p]), drawCallback: (plot, initial) => { if (!initial) zoomAll(plot); }
    }));
  });
  return plots;
}

function phaseLegend(before, shown = ["free", "stick", "slip"]) {
  const legend = element("div", { class: "legend" }, before);
  ["free", "stick", "slip"].forEach((name, i) => {
    if (shown.includes(name)) legend.append(element("span", {}, element("i", { style: "background:" + report.colours.phases[i] }), name));
  });
  return legend;
}
