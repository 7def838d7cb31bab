const svgSpace = "http://www.w3.org/2000/svg";
function svg(tag, attributes, ...children) {
  const made = document.createElementNS(svgSpace, tag);
  for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, value);
  for (const child of children) made.append(child);
  return made;
}

/** The width of a label in a picture [px]. */
function textWidth(text) {
  if (!textWidth.pen) {
    const label = svg("text", {}), picture = svg("svg", {}, label);
    document.body.append(picture);
    const style = getComputedStyle(label);
    textWidth.pen = document.createElement("canvas").getContext("2d");
    textWidth.pen.font = `${style.fontWeight} ${style.fontSize} ${style.fontFamily}`;
    picture.remove();
  }
  return textWidth.pen.measureText(text).width;
}

/** A label, cut to a width [px] where it is wider. */
function cutTo(width, text) {
  if (textWidth(text) <= width) return text;
  const letters = [...text];
  while (letters.length > 1 && textWidth(letters.join("") + "…") > width) letters.pop();
  return letters.join("") + "…";
}

/** Round places of ticks between two values. */
function axisTicks(low, high, most) {
  const rough = (high - low) / most;
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 5, 10].map(k => k * power).find(s => s >= rough * (1 - 1e-9));
  const ticks = [];
  for (let tick = Math.ceil(low / step - 1e-9) * step; tick <= high + step * 1e-6; tick += step) ticks.push(Math.abs(tick) < step * 1e-6 ? 0 : tick);
  return ticks;
}

/** Bounds of an axis that end at ticks, so that both ends have their number. */
function axisEnds(low, high, most) {
  for (let round = 0; round < 2; ++round) {  // wider bounds may ask for wider steps
    const ticks = axisTicks(low, high, most), step = ticks.length > 1 ? ticks[1] - ticks[0] : high - low;
    low = Math.floor(low / step + 1e-9) * step;
    high = Math.ceil(high / step - 1e-9) * step;
  }
  return [low, high];
}

/** Where values stand between their least and greatest, 0 to 1: by size, or by powers where none is below 0 and they are far apart.
 *  Those that differ by less than a hundredth stand together in the middle; among powers 0 stands apart, below the least. */
function colourScale(values) {
  const least = Math.min(...values), most = Math.max(...values);
  if (!(most - least > 0.01 * Math.max(Math.abs(least), Math.abs(most)))) return { name: "alike to a hundredth, and so of one colour", share: () => 0.5 };
  const leastPower = Math.min(...values.filter(value => value > 0));
  const from = least > 0 ? 0 : 0.15;
  if (least >= 0 && most / leastPower > 50) return { name: "coloured by powers of ten", share: value => value > 0 ? from + (1 - from) * Math.log(value / leastPower) / Math.log(most / leastPower) : 0 };
  return { name: "coloured by size", share: value => (value - least) / (most - least) };
}

function middle(values) {
  const inOrder = values.filter(Number.isFinite).sort((a, b) => a - b);
  if (inOrder.length === 0) return NaN;
  const half = inOrder.length >> 1;
  return inOrder.length % 2 ? inOrder[half] : (inOrder[half - 1] + inOrder[half]) / 2;
}

const chosen = { figure: figureIndex.max_friction_n, log: false, across: 0, colour: 0, rows: 0, columns: 1, matrix: figureIndex.max_friction_n };

/** A dot a job: the figure upwards, one strip for each value of a category. */
function drawDots() {
  const holder = document.getElementById("chart");
  const kinds = categories();
  const across = kinds[chosen.across], colour = kinds[chosen.colour] || { name: "", of: () => "" }, column = report.columns[chosen.figure];
  const ended = report.jobs.filter(job => Number.isFinite(job.figures[chosen.figure]) && job.status === "ok");
  const jobs = ended.filter(job => !chosen.log || job.figures[chosen.figure] > 0);
  const names = sorted(new Set(jobs.map(across.of))), colours = sorted(new Set(jobs.map(colour.of)));
  holder.replaceChildren();
  if (jobs.length === 0) return holder.append(element("p", { class: "note" }, "No job has this figure."));
  const room = Math.max(700, holder.clientWidth || 1100);
  const top = 14, height = 300;
  const values = jobs.map(job => job.figures[chosen.figure]);
  const scale = value => chosen.log ? Math.log10(value) : value;
  const least = Math.min(...values), most = Math.max(...values);
  const powers = [Math.floor(scale(least) + 1e-9), Math.ceil(scale(most) - 1e-9)];
  const [low, high] = chosen.log ? [powers[0], Math.max(powers[1], powers[0] + 1)] : axisEnds(Math.min(0, least), Math.max(most, Math.min(0, least) + 1e-12), 6);
  const y = value => top + height * (1 - (scale(value) - low) / (high - low));
  const ticks = chosen.log ? axisTicks(low, high, 8).filter(Number.isInteger).map(power => 10 ** power) : axisTicks(low, high, 6);
  // Names that are wider than their band hang at a slant, cut where they would take more than half of the plot's height.
  const left = Math.max(92, 38 + Math.max(...ticks.map(tick => textWidth(si(tick, unitOf(column))))));
  const band = (room - left - 20) / names.length;
  const whole = names.map(name => name === "" ? "(none)" : name), slanted = Math.max(...whole.map(textWidth)) > band - 8;
  const degrees = 35, slant = degrees * Math.PI / 180;
  const labels = slanted ? whole.map(name => cutTo(height / 2 / Math.sin(slant), name)) : whole;
  const bottom = slanted ? 24 + Math.max(...labels.map(textWidth)) * Math.sin(slant) : 46;
  const picture = svg("svg", { width: room, height: top + height + bottom + 10, role: "img", "aria-label": words(column) + " across " + across.name });
  for (const tick of ticks) {
    picture.append(svg("line", { x1: left, x2: room - 20, y1: y(tick), y2: y(tick), stroke: "#e3e6ea" }));
    picture.append(svg("text", { x: left - 8, y: y(tick) + 4, "text-anchor": "end" }, si(tick, unitOf(column))));
  }
  picture.append(svg("text", { x: 14, y: top + height / 2, "text-anchor": "middle", transform: `rotate(-90 14 ${top + height / 2})` },
    words(column) + (unitOf(column) ? " [" + unitOf(column) + "]" : "")));
  names.forEach((name, i) => {
    const x = left + band * (i + 0.5);
    // The first ones have less room to their left.
    const label = slanted ? cutTo((x - 4) / Math.cos(slant), labels[i]) : labels[i];
    picture.append(svg("text", slanted ? { x, y: top + height + 16, "text-anchor": "end", transform: `rotate(-${degrees} ${x} ${top + height + 16})` }
      : { x, y: top + height + 18, "text-anchor": "middle" },
      label, ...(label === whole[i] ? [] : [svg("title", {}, whole[i])])));
    const here = jobs.filter(job => across.of(job) === name);
    const mid = y(middle(here.map(job => job.figures[chosen.figure])));
    here.forEach((job, k) => {
      const spread = Math.min(band * 0.7, 60) * (((k * 0.61803) % 1) - 0.5);
      const dot = svg("circle", { class: "dot", cx: x + (here.length > 1 ? spread : 0), cy: y(job.figures[chosen.figure]), r: 4,
        fill: report.colours.palette[colours.indexOf(colour.of(job)) % report.colours.palette.length], "fill-opacity": 0.8 });
      dot.append(svg("title", {}, `${jobTitle(job)}\n${variedOf(job).map(pair => pair.join(": ")).join("\n")}\n${si(job.figures[chosen.figure], column.unit)}`));
      dot.addEventListener("click", () => { location.hash = "job-" + (report.jobs.indexOf(job) + 1); });
      picture.append(dot);
    });
    picture.append(svg("line", { x1: x - Math.min(band * 0.4, 34), x2: x + Math.min(band * 0.4, 34), y1: mid, y2: mid, stroke: "#22262c", "stroke-width": 2 }));
  });
  picture.append(svg("line", { x1: left, x2: room - 20, y1: top + height, y2: top + height, stroke: "#5f666f" }));
  const legend = element("div", { class: "legend" }, colour.name ? colour.name + ": " : "");
  if (colour.name) colours.slice(0, 24).forEach((name, i) => legend.append(element("span", {},
    element("i", { style: "background:" + report.colours.palette[i % report.colours.palette.length] }), name || "(none)")));
  if (colours.length > 24) legend.append(`and ${colours.length - 24} more`);
  holder.append(legend, picture, element("p", { class: "unit" },
    `${column.doc[0].toUpperCase() + column.doc.slice(1)}. A dot is a job (click it), a bar the median.` +
    (colours.length > report.colours.palette.length ? " Colours repeat." : "") +
    (jobs.length < ended.length ? ` ${ended.length - jobs.length} jobs of 0 or less are not on a logarithmic axis.` : "")));
}

/** Medians of a figure in a table of two categories, coloured by size. */
function drawMatrix() {
  const kinds = categories(), holder = document.getElementById("matrix");
  const rows = kinds[chosen.rows], columns = kinds.length > 1 ? kinds[chosen.columns] : { name: "", of: () => "all jobs" }, column = report.columns[chosen.matrix];
  const jobs = report.jobs.filter(job => job.status === "ok");
  const cells = new Map();
  for (const job of jobs) {
    const key = JSON.stringify([rows.of(job), columns.of(job)]);
    cells.set(key, [...(cells.get(key) || []), job.figures[chosen.matrix]]);
  }
  const medians = [...cells.values()].map(middle).filter(Number.isFinite);
  const scale = colourScale(medians);
  const across = sorted(new Set(jobs.map(columns.of)));
  const table = element("table", { class: "matrix" });
  table.append(element("tr", {}, element("th", {}, rows.name), ...across.map(name => element("th", {}, name || "(none)"))));
  for (const name of sorted(new Set(jobs.map(rows.of)))) {
    const line = element("tr", {}, element("th", {}, name || "(none)"));
    for (const other of across) {
      const values = cells.get(JSON.stringify([name, other])) || [];
      const value = middle(values);
      const share = scale.share(value);
      const cell = element("td", {}, Number.isFinite(value) ? si(value, unitOf(column) || "1") : "–");
      if (Number.isFinite(value)) {
        cell.style.background = report.colours.ramp[Math.round(share * (report.colours.ramp.length - 1))];
        cell.style.color = share < 0.55 ? "#fff" : "#000";
        cell.title = `median of ${values.length} jobs`;
      }
      line.append(cell);
    }
    table.append(line);
  }
  holder.replaceChildren(table, element("p", { class: "unit" },
    `Median of ${words(column)}${unitOf(column) ? " [" + unitOf(column) + "]" : ""} of the jobs that ended ok, ${scale.name}${scale.share(NaN) === 0.5 ? "." : ": the darkest is the least, the brightest the greatest."}`));
}

function logarithmic() {
  const box = element("input", { type: "checkbox", id: "logarithmic" });
  box.checked = chosen.log;
  box.addEventListener("change", () => { chosen.log = box.checked; drawDots(); });
  return element("label", {}, box, " logarithmic");
}

function showCharts() {
  const kinds = categories().map(one => one.name), figures = report.columns.map(words);
  chosen.across = Math.min(chosen.across, kinds.length - 1);
  const law = kinds.findIndex(name => name.endsWith("law"));
  if (!showCharts.done) {
    if (law >= 0) chosen.across = law;
    chosen.colour = categories().findIndex((one, i) => i !== chosen.across && new Set(report.jobs.map(one.of)).size <= report.colours.palette.length);
    if (chosen.colour < 0) chosen.colour = kinds.length;
    chosen.rows = Math.max(0, kinds.indexOf("mesh"));
    chosen.columns = law >= 0 && law !== chosen.rows ? law : Math.max(0, kinds.findIndex((name, i) => i !== chosen.rows));
    showCharts.done = true;
  }
  document.getElementById("chart-choice").replaceChildren(
    choice("figure", figures, chosen.figure, i => { chosen.figure = i; drawDots(); }),
    choice("across", kinds, chosen.across, i => { chosen.across = i; drawDots(); }),
    choice("colour by", [...kinds, "nothing"], chosen.colour, i => { chosen.colour = i; drawDots(); }), logarithmic());
  document.getElementById("matrix-choice").replaceChildren(
    choice("figure", figures, chosen.matrix, i => { chosen.matrix = i; drawMatrix(); }),
    choice("rows", kinds, chosen.rows, i => { chosen.rows = i; drawMatrix(); }),
    choice("columns", kinds, chosen.columns, i => { chosen.columns = i; drawMatrix(); }));
  drawDots();
  drawMatrix();
}
