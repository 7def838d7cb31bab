// The table of a study of a scene.
#include <fmt/format.h>

#include <algorithm>

#include "study/scene_study.hpp"

namespace fingerpad {
namespace {

/// "auto", "cheapest", both, or nothing.
std::string mark_of(const SceneStudyInput& input, const SceneStudy& study, const ChoicePrice& price) {
  const bool automatic = input.automatic && *input.automatic == price.choice;
  const bool is_cheapest = &price == &cheapest(study.prices);
  return fmt::format("{}{}{}", automatic ? "auto" : "", automatic && is_cheapest ? " " : "",
                     is_cheapest ? "cheapest" : "");
}

StudyTable table_of(const SceneStudyInput& input, const SceneStudy& study) {
  StudyTable table{"choices",
                   {"method",
                    "normals",
                    "rate_hz",
                    "events",
                    "force_rms_share",
                    "ns_per_tick",
                    "keeps",
                    "force_largest_share",
                    "contact_rms_share",
                    "contact_largest_share",
                    "contact_99_share",
                    "step_beyond_n",
                    "mean_mu",
                    "mu_error_share",
                    "held_mu_share",
                    "held_force_share",
                    "unseen_teeth_share",
                    "ruptures_missed",
                    "pop_throughs",
                    "ticks",
                    "late_ticks",
                    "load_share",
                    "mark",
                    "loses"},
                   {}};
  const auto count = [](long n) { return static_cast<double>(n); };
  for (const ChoicePrice& p : study.prices) {
    const ForceFigures& f = p.figures;
    table.rows.push_back({p.choice.method,
                          std::string(p.choice.normals->name),
                          p.choice.rate_hz,
                          std::string(events_word(p.choice.events)),
                          f.force_rms_share,
                          p.tick_ns,
                          std::string(p.keeps() ? "true" : "false"),
                          f.force_largest_share,
                          f.contact_rms_share,
                          f.contact_largest_share,
                          f.contact_99_share,
                          f.step_beyond_n,
                          f.mean_mu,
                          f.mu_error_share,
                          p.rate.held_mu_share,
                          p.rate.held_force_share,
                          p.rate.unseen_teeth_share,
                          count(f.ruptures_missed),
                          count(f.pop_throughs),
                          count(f.ticks),
                          count(p.late_ticks),
                          p.load(),
                          mark_of(input, study, p),
                          fmt::format("{}", fmt::join(p.broken, "; "))});
  }
  return table;
}

/// The model's own row, the last: what it costs, against itself.
void add_model(const SceneStudy& study, StudyTable& table) {
  std::vector<StudyTable::Cell> row(table.columns.size(), 0.0);
  const auto put = [&](std::string_view column, StudyTable::Cell value) {
    row[static_cast<std::size_t>(std::find(table.columns.begin(), table.columns.end(), column) -
                                 table.columns.begin())] = std::move(value);
  };
  put("method", study.model.method);
  put("normals", std::string(study.model.normals->name));
  put("rate_hz", study.model.rate_hz);
  put("events", std::string(events_word(study.model.events)));
  put("ns_per_tick", study.model_tick_ns);
  put("keeps", std::string("true"));
  put("mean_mu", study.prices.front().figures.model_mean_mu);
  put("ticks", static_cast<double>(study.model_ticks));
  put("load_share", 1e-9 * study.model_tick_ns * study.model.rate_hz);
  put("mark", std::string("model"));
  put("loses", std::string());
  table.rows.push_back(std::move(row));
}

}  // namespace

StudyTable choices_table(const SceneStudyInput& input, const SceneStudy& study) {
  StudyTable table = table_of(input, study);
  add_model(study, table);
  return table;
}

}  // namespace fingerpad
