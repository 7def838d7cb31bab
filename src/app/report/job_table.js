/** Seen at first where they are not 0 throughout; the rest of the figures on request. */
const mainFigures = ["pop_throughs", "unsettled_ticks", "energy_made_j", "max_normal_force_n", "max_friction_n", "mean_slip_mu"];

let jobTable = null;
const bound = { figure: -1, sense: 0, value: NaN };

function escaped(text) {
  const span = document.createElement("span");
  span.textContent = text;
  return span.innerHTML.replace(/"/g, "&quot;");
}
function escapedBreakable(text) {
  const span = document.createElement("span");
  span.append(breakable(text));
  return span.innerHTML;
}

/** What the figures and warnings tell; of a failed job with the reason: "failed: why". Without the folders of whole paths. */
function troubleOf(job) {
  const words = job.status === "ok" ? job.trouble : "failed: " + job.status + job.trouble.slice("failed".length);
  return words.replace(/(^|[\s'"(])(\/[^\/\s:]+)+\//g, "$1");
}

/** Whether a part has several motions; where each has its own, its name tells nothing. */
function motionsVaryOverPart() {
  const meshes = new Set(report.jobs.map(job => job.mesh));
  return meshes.size !== new Set(report.jobs.map(job => job.mesh + "\n" + job.motion)).size;
}

const seenAtFirst = (name, i) => mainFigures.includes(name) && report.jobs.some(job => job.figures[i]);

/** The columns of the table, each with its heading and what a job shows in it. What tells nothing is left out, so that the
    others have room: what is empty or 0 in all jobs, scene and contact where all have the same, motions that go with the part. */
function tableColumns() {
  const text = (title, of, extra) => ({ title: escapedBreakable(title), data: null, render: (job, kind) => kind === "display" ? escapedBreakable(of(job)) : of(job), ...extra });
  const columns = [
    { title: "worst", data: "rank", className: "number", type: "num" },
    { title: "part and path", data: null, orderable: false, render: job => job.run && job.run.thumbnail
      ? `<img alt="${escaped(jobTitle(job))}" src="data:image/jpeg;base64,${job.run.thumbnail}">` : "" },
    { title: "trouble", data: null, className: "trouble", visible: report.jobs.some(job => troubleOf(job)), render: (job, kind) => kind === "display"
      ? `<div title="${escaped(troubleOf(job))}">${escapedBreakable(troubleOf(job))}</div>` : troubleOf(job) }];
  if (new Set(report.jobs.map(job => job.scene)).size > 1) columns.push(text("scene", job => job.scene));
  columns.push({ title: "job", data: "number", className: "number", type: "num" });
  if (!report.setKeys.includes("mesh") && report.jobs.some(job => job.mesh)) columns.push(text("mesh", job => fileName(job.mesh), { className: "name" }));
  report.setKeys.forEach((key, i) => columns.push(text(key, job => key === "mesh" || key === "motion" ? fileName(job.values[i]) : job.values[i],
    { visible: key !== "motion" || motionsVaryOverPart(), className: key === "mesh" ? "name" : "" })));
  columns.push(text("status", job => job.status === "ok" ? "ok" : "failed", { visible: false }));
  report.columns.forEach((column, i) => {
    const unit = unitOf(column);
    columns.push({ title: `<span title="${escaped(column.doc)}">${escaped(words(column))}</span>`,
      data: null, className: "number", type: "num", visible: seenAtFirst(column.name, i), figure: i,
      render: (job, kind) => kind === "display" ? escaped(si(job.figures[i], unit || "1")) : job.figures[i] === null ? -Infinity : job.figures[i] });
  });
  const contactOf = job => (job.method + " " + job.normals).trim();
  columns.push(text("contact", contactOf, { visible: new Set(report.jobs.map(contactOf).filter(Boolean)).size > 1 }));
  return columns;
}

/** A select of the values of each category, and a bound on a figure. */
function showFilters(columns) {
  const holder = document.getElementById("filters");
  columns.forEach((column, i) => {
    if (!column.render || column.figure !== undefined || column.orderable === false || column.className === "trouble") return;
    const values = sorted(new Set(report.jobs.map(job => column.render(job, "filter"))));
    if (values.length < 2 || values.length > 60) return;
    const title = element("span", {});
    title.innerHTML = column.title;
    const name = title.textContent;
    const short = values.map(value => value === "" ? "(none)" : value.length > 60 ? value.slice(0, 59) + "…" : value);
    const label = choice(name, ["all", ...short], 0, k => {
      const pattern = k === 0 ? "" : "^" + $.fn.dataTable.util.escapeRegex(values[k - 1]) + "$";
      jobTable.column(i).search(pattern, true, false).draw();
    });
    label.querySelector("select").setAttribute("data-filter", name);
    holder.append(label);
  });
  const value = element("input", { type: "number", step: "any", size: "8", "aria-label": "bound", placeholder: "number", style: "width:110px" });
  value.addEventListener("input", () => { bound.value = parseFloat(value.value); jobTable.draw(); });
  const names = report.columns.map(column => words(column) + (unitOf(column) ? " [" + unitOf(column) + "]" : ""));
  holder.append(element("span", {}, choice("only", ["any figure", ...names], 0, k => { bound.figure = k - 1; jobTable.draw(); }), " ",
    choice("", ["at least", "at most"], 0, k => { bound.sense = k; jobTable.draw(); }), " ", value));
  const all = element("input", { type: "checkbox", id: "all-figures" });
  all.addEventListener("change", () => columns.forEach((column, i) => {
    if (column.figure !== undefined && !seenAtFirst(report.columns[column.figure].name, column.figure)) jobTable.column(i).visible(all.checked, false);
  }) || jobTable.columns.adjust() && showWidth());
  holder.append(element("label", {}, all, " all figures"));
}

/** The traces that are cut short or cannot be read, the first of them by name, and what mends them. */
function damageWords() {
  const damaged = report.jobs.filter(job => job.damage).map(job => job.damage);
  if (damaged.length === 0) return "";
  const more = damaged.length > 5 ? ` and ${damaged.length - 5} more` : "";
  return ` Damaged traces: ${damaged.slice(0, 5).join("; ")}${more}. fingerpad replay --resume makes them again.`;
}

function showCounts() {
  const failed = report.jobs.filter(job => job.status !== "ok").length;
  const troubled = report.jobs.filter(job => job.trouble && job.status === "ok").length;
  document.getElementById("counts").textContent =
    `${report.jobs.length} ${report.jobs.length === 1 ? "job" : "jobs"}: ${report.jobs.length - failed} ok, ${failed} failed; of those that are ok, ${troubled} with trouble. ` +
    "The worst stand first: failed, then by forces that are not finite, pop-throughs, unsettled ticks, energy made " +
    "(where it is over 1 % of greatest force times depth), and last by the greatest normal force. Click a row for the job's own page." +
    damageWords();
}

/** Says so where the window is narrower than the table. */
function showWidth() {
  const wrapper = document.getElementById("job-table_wrapper");
  document.getElementById("wide").hidden = wrapper.scrollWidth <= wrapper.clientWidth + 1;
}

function showJobTable() {
  showCounts();
  const columns = tableColumns();
  $.fn.dataTable.ext.search.push((settings, data, index, job) => {
    if (bound.figure < 0 || Number.isNaN(bound.value)) return true;
    const value = job.figures[bound.figure];
    return value !== null && (bound.sense === 0 ? value >= bound.value : value <= bound.value);
  });
  $.fn.dataTable.ext.errMode = "throw";
  jobTable = $("#job-table").DataTable({ data: report.jobs, columns, order: [[0, "asc"]], deferRender: true, pageLength: 25,
    lengthMenu: [[10, 25, 100, -1], [10, 25, 100, "all"]], autoWidth: false,
    language: { search: "find:", lengthMenu: "show _MENU_ jobs", info: "_START_ to _END_ of _TOTAL_ jobs", infoEmpty: "no jobs",
      infoFiltered: "(of _MAX_)", zeroRecords: "No job is left by these filters." },
    createdRow: (row, job) => {
      if (job.status !== "ok") row.classList.add("failed");
      row.tabIndex = 0;
    } });
  const open = row => { location.hash = "job-" + (report.jobs.indexOf(jobTable.row(row).data()) + 1); };
  $("#job-table tbody").on("click", "tr", event => { if (jobTable.row(event.currentTarget).data()) open(event.currentTarget); });
  $("#job-table tbody").on("keydown", "tr", event => { if (event.key === "Enter") open(event.currentTarget); });
  showFilters(columns);
  jobTable.on("draw", showWidth);
  window.addEventListener("resize", showWidth);
}
