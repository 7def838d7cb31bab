function figureTable(job) {
  const table = element("table", { class: "plain" });
  const line = (name, value, title, number) =>
    table.append(element("tr", { title: title || "" }, element("td", {}, breakable(name)), element("td", number ? { class: "number" } : {}, breakable(value))));
  if (job.mesh) line("mesh", fileName(job.mesh), job.mesh);
  for (const [key, value] of variedOf(job)) line(key, value, "a key of the set");
  if (job.motion && !report.setKeys.includes("motion")) line("motion", fileName(job.motion), job.motion);
  if (job.method) line("contact", job.method + ", " + job.normals + " normals");
  if (job.status === "ok") report.columns.forEach((column, i) => line(words(column), si(job.figures[i], unitOf(column) || "1"), column.doc, true));
  if (job.trace) line("trace", job.trace);
  return table;
}

/** Jobs as the table has them at the moment, for "previous" and "next". */
function neighbour(job, step) {
  const shown = jobTable.rows({ order: "current", search: "applied" }).data().toArray();
  return shown[shown.indexOf(job) + step];
}

function jobHead(job) {
  const head = document.getElementById("job-head");
  const go = (label, step) => {
    const button = element("button", { type: "button" }, label), other = neighbour(job, step);
    button.disabled = !other;
    button.addEventListener("click", () => { location.hash = "job-" + (report.jobs.indexOf(other) + 1); });
    return button;
  };
  head.replaceChildren(element("h2", {}, jobTitle(job)),
    element("div", { class: "choices" }, go("‹ previous", -1), go("next ›", 1), element("a", { href: "#jobs" }, "all jobs"),
      element("span", {}, `worst no. ${job.rank} of ${report.jobs.length}`), element("span", { class: "trouble" }, job.trouble || "")));
  const varied = variedOf(job).map(pair => pair.join(" ")).join(", ");
  if (varied) head.append(element("p", { class: "unit" }, varied));
  if (job.status !== "ok") head.append(element("p", { class: "note" }, "Failed: " + job.status));
  if (job.note) head.append(element("p", { class: "note" }, job.note));
  if (job.run && job.run.notice) head.append(element("p", { class: "note" }, job.run.notice));
}

function forceLegend(run) {
  return element("span", {}, "force on the finger: 0",
    element("span", { class: "ramp", style: `background:linear-gradient(to right,${report.colours.ramp.join(",")})` }), si(run.maxForce, "N"));
}

function showShape(job, data) {
  const holder = document.getElementById("shape");
  const view = element("div", { class: "view" }), legend = element("div", { class: "legend" });
  const colouring = choice("path coloured by", ["force", "phase"], 0, k => {
    shapeView.colourBy(["force", "phase"][k]);
    legend.replaceChildren(k === 0 ? forceLegend(job.run) : phaseLegend("path: "));
  });
  const looks = ["contact", "whole", "front", "right", "top"].map(name => {
    const button = element("button", { type: "button", "data-look": name }, name);
    button.addEventListener("click", () => shapeView.lookFrom(name));
    return button;
  });
  holder.replaceChildren(element("div", { class: "choices" }, colouring, element("span", {}, "from: ", ...looks)), view, legend);
  legend.append(forceLegend(job.run));
  try {
    shapeView = new ShapeView(job.run, data, view);
    const size = shapeView.size.map(mm => +mm.toPrecision(3)).join(" × ");
    holder.append(element("p", { class: "unit" }, (job.run.shape < 0 ? "path alone, " : "") + size +
      " mm along x, y, z; drag to turn, wheel for nearer, right button to move. The part is drawn with few triangles, " +
      "so the path may lie a little off it; where it is hidden it is pale."));
  } catch (error) {
    view.replaceChildren(element("p", { class: "note" }, "This browser shows no WebGL, so the view cannot be turned."));
    if (job.run.thumbnail) view.append(element("img", { alt: "", src: "data:image/jpeg;base64," + job.run.thumbnail }));
  }
}

function leaveJob() {
  if (shapeView) shapeView.end();
  shapeView = null;
}

function showJob(job) {
  leaveJob();
  jobHead(job);
  document.getElementById("figures").replaceChildren(figureTable(job));
  document.getElementById("strips").replaceChildren();
  document.getElementById("shape").replaceChildren();
  document.getElementById("shape").hidden = !job.run;
  if (!job.run) return;
  const data = unpackedRun(job.run);
  showShape(job, data);
  if (data.shares.count > 1) showStrips(document.getElementById("strips"), data);
}
