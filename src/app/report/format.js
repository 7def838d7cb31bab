"use strict";
const report = JSON.parse(document.getElementById("results").textContent);

/** Elements from data: what a file or a scene says becomes text, never markup. */
function element(tag, attributes, ...children) {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes || {})) made.setAttribute(name, value);
  for (const child of children) made.append(child);
  return made;
}

/** "0.51 mm": a number with its unit, thousands as the unit's prefix. */
function si(value, unit, digits = 3) {
  if (value === null || !Number.isFinite(value)) return "–";
  if (unit === "1" || !unit) {
    if (Number.isInteger(value) && Math.abs(value) < 1e9) return String(value);
    return String(+value.toPrecision(digits));
  }
  if (value === 0) return "0 " + unit;
  const prefixes = { "-12": "p", "-9": "n", "-6": "µ", "-3": "m", "0": "", "3": "k", "6": "M", "9": "G" };
  const power = Math.max(-12, Math.min(9, 3 * Math.floor(Math.log10(Math.abs(value)) / 3 + 1e-9)));
  const shown = +(value / 10 ** power).toPrecision(digits);
  return shown + " " + prefixes[power] + unit;
}

/** "max normal force" of max_normal_force_n: the unit is told beside it. */
function words(column) {
  return column.name.replace(/_(n_per_m|m|n|j|s)$/, "").replace(/_/g, " ");
}
function unitOf(column) {
  return column.unit === "1" ? "" : column.unit;
}

/** Text that breaks its lines where names do: behind their dots, strokes and hyphens, never within a word, a number or
 *  an option, nor before a file's ending. */
function breakable(text) {
  const broken = document.createDocumentFragment();
  String(text).split(/((?<=^|[\s(`])--[a-z][a-z-]*)/).forEach((part, i) => {
    if (i % 2 === 1) return broken.append(element("span", { class: "option" }, part));
    part.split(/(?<=[_.\/-])(?<!\d\.(?=\d))(?=[^_.\/\s-]{2})(?!(?<=\.)\w{1,4}(?![\w.-]))/).forEach((piece, k) => {
      if (k > 0) broken.append(document.createElement("wbr"));
      broken.append(piece);
    });
  });
  return broken;
}

/** The last part of a path. */
function fileName(path) {
  return path.split("/").pop();
}

function jobTitle(job) {
  const number = job.number > 0 ? " job " + job.number : "";
  const part = job.mesh ? " · " + fileName(job.mesh) : "";
  return job.scene + number + part;
}

/** "friction.law: dahl" and so on, of what varies but the mesh. */
function variedOf(job) {
  const told = [];
  report.setKeys.forEach((key, i) => {
    if (key !== "mesh" && key !== "part.mesh" && job.values[i] !== "") told.push([key, key === "motion" ? fileName(job.values[i]) : job.values[i]]);
  });
  return told;
}

const figureIndex = Object.fromEntries(report.columns.map((column, i) => [column.name, i]));

/** What jobs can be told apart by: name and the value of a job. */
function categories() {
  const all = report.setKeys.map((key, i) => ({
    name: key, of: job => key === "mesh" || key === "motion" ? fileName(job.values[i]) : job.values[i] }));
  if (!report.setKeys.includes("mesh")) all.push({ name: "mesh", of: job => fileName(job.mesh) });
  all.push({ name: "scene", of: job => job.scene }, { name: "contact method", of: job => job.method },
    { name: "normals", of: job => job.normals });
  const ended = report.jobs.filter(job => job.status === "ok");
  const varies = all.filter(one => new Set(ended.map(one.of)).size > 1);
  return varies.length > 0 ? varies : [all[all.length - 3]];
}

/** Values in their natural order: 0.3 before 0.25 never, "law-2" before "law-10". */
function sorted(values) {
  return [...values].sort((a, b) => {
    const x = Number(a), y = Number(b);
    return Number.isFinite(x) && Number.isFinite(y) ? x - y : String(a).localeCompare(String(b), "en", { numeric: true });
  });
}

/** A choice among named things: a label with a select. */
function choice(label, names, chosen, changed) {
  const select = element("select", { "aria-label": label });
  names.forEach((name, i) => select.append(element("option", { value: i }, name)));
  select.value = chosen;
  select.addEventListener("change", () => changed(Number(select.value)));
  return element("label", {}, label + " ", select);
}

function bytesOf(text) {
  return Uint8Array.from(atob(text), letter => letter.charCodeAt(0));
}
