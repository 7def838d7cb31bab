function showColumns() {
  const table = document.getElementById("column-table");
  table.append(element("tr", {}, ...["column", "unit", "what it is"].map(name => element("th", {}, name))));
  for (const column of report.columns)
    table.append(element("tr", {}, element("td", {}, element("code", {}, column.name)), element("td", {}, unitOf(column)), element("td", {}, column.doc)));
}

/** The part of the page that the address names: #jobs, #charts, #job-12. */
function showPlace() {
  const place = location.hash.slice(1) || "jobs";
  const asked = /^job-(\d+)$/.exec(place);
  const job = asked && report.jobs[Number(asked[1]) - 1];
  const name = job ? "job" : document.querySelector(`main#${CSS.escape(place)}`) && place !== "job" ? place : "jobs";
  for (const main of document.querySelectorAll("main")) main.classList.toggle("here", main.id === name);
  for (const link of document.querySelectorAll("nav a"))
    link.classList.toggle("here", link.hash === "#" + name || (name === "job" && link.hash === "#jobs"));
  if (name === "jobs") showWidth();
  if (name !== "job") leaveJob();
  if (job) showJob(job);
  if (name === "charts") showCharts();
  window.scrollTo(0, 0);
}

showJobTable();
showColumns();
window.addEventListener("hashchange", showPlace);
showPlace();
document.documentElement.setAttribute("data-ready", "yes");
