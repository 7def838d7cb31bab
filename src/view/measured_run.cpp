#include "view/measured_run.hpp"

#include <algorithm>
#include <utility>

#include "base/error.hpp"
#include "trace/trace.hpp"
#include "view/run_title.hpp"

namespace fingerpad {

std::vector<ComparedRun> read_measured_and_model(const std::string& path, Over over, double from_s,
                                                 double to_s) {
  Trace trace = read_trace(path, TraceContents::rows);
  if (!trace.info.compared)
    throw refused(path,
                  "has no rfx_n, rfy_n, rfz_n: its motion named no measured force; name one in [motion], as "
                  "in columns = { fx = \"fx_n\", fy = \"fy_n\", fz = \"fz_n\" }, and replay it");
  refuse_no_rows(trace, path);
  std::string ends_early = early_end_words(trace);
  std::erase_if(trace.rows, [&](const TickRecord& row) { return row.t_s < from_s || row.t_s > to_s; });
  const std::string title = scene_title(trace.info, path);
  ComparedRun measured{"measured", title, title, path, "", false, abscissa(trace.rows, over), {}};
  refuse_standstill(measured.x, over, path);
  ComparedRun model = measured;
  model.name = "model";
  measured.ends_early = std::move(ends_early);  // once of the trace that both are of
  const char* names[] = {"fx_n", "fy_n", "fz_n"};
  for (int axis = 0; axis < 3; ++axis) {
    ComparedColumn of_measured{names[axis], "N", {}}, of_model{names[axis], "N", {}};
    for (const TickRecord& row : trace.rows) {
      of_model.values.push_back(row.force_W_n[axis]);
      of_measured.values.push_back(row.force_W_n[axis] - row.residual_W_n[axis]);
    }
    const auto is_zero = [](double force_n) { return force_n == 0; };
    if (std::all_of(of_model.values.begin(), of_model.values.end(), is_zero) &&
        std::all_of(of_measured.values.begin(), of_measured.values.end(), is_zero))
      continue;
    measured.columns.push_back(std::move(of_measured));
    model.columns.push_back(std::move(of_model));
  }
  return {std::move(measured), std::move(model)};
}

}  // namespace fingerpad
