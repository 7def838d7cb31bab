const stripPanels = [
  { title: "Force on the finger", label: "force [N]", curves: ["normal force", "friction"] },
  { title: "Coefficient of friction", label: "mu", curves: ["mu"] },
  { title: "Depth of the finger in the part", label: "depth [mm]", curves: ["depth"], scale: 1e3 },
  { title: "Speed of the finger", label: "speed [mm/s]", curves: ["speed"], scale: 1e3 }
];

/** How long [px] a stroke is where stick gives way. It has the upper edge to itself: no curve comes so near. */
const ruptureHeight = 7;

/** How high [px] the colours of slip and stick stand behind a stretch: each as its share of the ticks, where there is any at
 *  least as high as can be seen. */
function phaseHeights(slip, stick, height) {
  const least = 3, free = slip + stick < 254;  // two shares that are rounded
  const high = share => share > 0 ? Math.max(least, share / 255 * height) : 0;
  const slips = Math.min(high(slip), stick > 0 ? height - least : height);
  return [slips, free ? Math.min(high(stick), height - slips) : stick > 0 ? height - slips : 0];
}

/** Bands in the colours of the phases behind the curves: slip from below, stick on it, what is left is free. A stroke at the
 *  upper edge where stick gives way. */
function paintPhases(canvas, area, plot, shares) {
  const at = time => Math.min(Math.max(plot.toDomXCoord(time), area.x), area.x + area.w);
  for (let begin = 0; begin < shares.count;) {
    let end = begin + 1;
    while (end < shares.count && shares.slip[end] === shares.slip[begin] && shares.stick[end] === shares.stick[begin]) ++end;
    const left = at(shares.begin + begin * shares.step), right = at(shares.begin + end * shares.step);
    const [slip, stick] = phaseHeights(shares.slip[begin], shares.stick[begin], area.h);
    const bottom = area.y + area.h;
    canvas.fillStyle = report.colours.phases[2] + "58";
    canvas.fillRect(left, bottom - slip, right - left, slip);
    canvas.fillStyle = report.colours.phases[1] + "2e";
    canvas.fillRect(left, bottom - slip - stick, right - left, stick);
    begin = end;
  }
  canvas.fillStyle = report.colours.phases[2];
  for (let k = 0; k < shares.count; ++k) {
    const middle = plot.toDomXCoord(shares.begin + (k + 0.5) * shares.step);
    if (shares.ruptures[k] > 0 && middle >= area.x && middle <= area.x + area.w) canvas.fillRect(middle - 0.75, area.y, 1.5, ruptureHeight);
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

/** Of each pair of samples, the least and the greatest of a stretch, whether the curve goes up and down between them:
 *  the stretches beside it span most of what it spans. A rise spans what they do not. */
function denseStretches(curve) {
  if (!curve.inPairs) return [];
  const spans = [];
  for (let i = 0; i + 1 < curve.values.length; i += 2) spans.push([Math.min(curve.values[i], curve.values[i + 1]), Math.max(curve.values[i], curve.values[i + 1])]);
  const whole = Math.max(...spans.map(span => span[1])) - Math.min(...spans.map(span => span[0]));
  const shares = (span, beside) => !beside || Math.min(span[1], beside[1]) - Math.max(span[0], beside[0]) > 0.5 * (span[1] - span[0]);
  const up = spans.map((span, k) => span[1] - span[0] > 0.02 * whole && shares(span, spans[k - 1]) && shares(span, spans[k + 1]));
  const dense = up.map((here, k) => here && Boolean(up[k - 1] || up[k + 1]));
  // A few of another kind between such stretches are no line of their own.
  const few = [1, 2, 3, 4, 5, 6], isNear = (k, step) => few.some(i => dense[k + step * i]);
  return dense.map((here, k) => here || (isNear(k, -1) && isNear(k, 1) && spans[k][1] - spans[k][0] > 0.02 * whole));
}

/** A band between the least and the greatest, from the first sample to the last. */
function drawBand(canvas, stretches, color) {
  const first = stretches[0], last = stretches[stretches.length - 1];
  const edge = side => [[first.from, side(first)], ...stretches.map(one => [(one.from + one.to) / 2, side(one)]), [last.to, side(last)]];
  const above = edge(one => one.above), below = edge(one => one.below);
  const trace = points => points.forEach(([x, y], i) => i === 0 ? canvas.moveTo(x, y) : canvas.lineTo(x, y));
  canvas.save();
  canvas.beginPath();
  trace([...above, ...below.slice().reverse()]);
  canvas.globalAlpha = 0.35;
  canvas.fillStyle = color;
  canvas.fill();
  canvas.beginPath();
  trace(above);
  trace(below);
  canvas.globalAlpha = 1;
  canvas.lineWidth = 1;
  canvas.strokeStyle = color;
  canvas.stroke();
  canvas.restore();
}

function drawLine(canvas, points, color, width) {
  canvas.save();
  canvas.beginPath();
  points.forEach((point, i) => i === 0 ? canvas.moveTo(point.canvasx, point.canvasy) : canvas.lineTo(point.canvasx, point.canvasy));
  canvas.strokeStyle = color;
  canvas.lineWidth = width;
  canvas.stroke();
  canvas.restore();
}

/** Draws a curve as a line, and as a band where it goes up and down faster than its samples follow. */
function curvePlotter(curve) {
  const dense = denseStretches(curve), stretchAt = new Map();
  curve.times.forEach((time, i) => { if (dense[i >> 1]) stretchAt.set(time, i >> 1); });
  return drawn => {
    const points = drawn.points.filter(point => point.yval !== null && Number.isFinite(point.canvasy));
    const isDense = i => i < points.length && stretchAt.has(points[i].xval);
    for (let i = 0; i < points.length;) {
      if (!isDense(i)) {
        const begin = Math.max(0, i - 1);
        while (i < points.length && !isDense(i)) ++i;
        drawLine(drawn.drawingContext, points.slice(begin, i + 1), drawn.color, drawn.strokeWidth);
        continue;
      }
      const stretches = [];
      for (let last = -1; isDense(i); ++i) {
        const { canvasx: x, canvasy: y, xval } = points[i], stretch = stretchAt.get(xval);
        if (stretch !== last) stretches.push({ from: x, to: x, above: y, below: y });
        const one = stretches[stretches.length - 1];
        Object.assign(one, { to: x, above: Math.min(one.above, y), below: Math.max(one.below, y) });
        last = stretch;
      }
      drawBand(drawn.drawingContext, stretches, drawn.color);
    }
  };
}

/** All panels zoom together. */
function showStrips(holder, data) {
  holder.replaceChildren();
  holder.append(element("h2", {}, "Over time"), phaseLegend("behind the curves, as high as its share of the ticks: ", ["slip", "stick"], "stick gave way (at the upper edge)"));
  holder.append(element("p", { class: "unit" },
    "Drag over a chart to zoom all of them, double-click for the whole run. Samples are the least and greatest of their ticks; " +
    "where a curve goes up and down faster than they follow, a band spans all that it takes. " +
    `Shares are of ${si(data.shares.step, "s")} each: what repeats within a few of these may look slower than it is. White: free.`));
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
      series: Object.fromEntries(curves.map(curve => [curve.name, { plotter: curvePlotter(curve) }])),
      labels: ["t [s]", ...panel.curves], ylabel: panel.label, xlabel: "time [s]", connectSeparatedPoints: true,
      colors: report.colours.palette, strokeWidth: 1.4, legend: "always", labelsDiv: names, includeZero: true,
      dateWindow: [...data.span], yRangePad: ruptureHeight + 3, axisLabelWidth: 64, highlightCircleSize: 3, digitsAfterDecimal: 4, maxNumberWidth: 9,
      axisLabelFontSize: 12, xLabelHeight: 18, yLabelWidth: 18, gridLineColor: "#e3e6ea", labelsKMB: false,
      underlayCallback: (canvas, area, plot) => paintPhases(canvas, area, plot, data.shares),
      zoomCallback: () => zoomAll(plots[p]), drawCallback: (plot, initial) => { if (!initial) zoomAll(plot); }
    }));
  });
  return plots;
}

function phaseLegend(before, shown = ["free", "stick", "slip"], stroke = "") {
  const legend = element("div", { class: "legend" }, before);
  for (const name of shown)
    legend.append(element("span", {}, element("i", { style: "background:" + report.colours.phases[["free", "stick", "slip"].indexOf(name)] }), name));
  if (stroke) legend.append(element("span", {}, element("i", { class: "stroke", style: "background:" + report.colours.phases[2] }), stroke));
  return legend;
}
