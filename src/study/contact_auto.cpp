#include <algorithm>
#include <cmath>

#include "study/auto_judged.hpp"
#include "study/contact_parts.hpp"

namespace fingerpad {
namespace {

constexpr int judged_turns = 3, judged_strokes = 24;

std::string variant_word(std::size_t v, bool normals) {
  if (v >= contact_variants().size()) return "none";
  return normals ? contact_variants()[v].normals_name : contact_variants()[v].method_name;
}

void tell_judged(StudyReport& report, const std::vector<JudgedRow>& rows) {
  StudyTable words{"auto_judged",
                   {"case",
                    "triangles",
                    "finger_radius_m",
                    "reference",
                    "method",
                    "normals",
                    "ticks",
                    "force_99_share",
                    "trial_99_share",
                    "promised_share",
                    "pop_throughs",
                    "complete_pop_throughs",
                    "word",
                    "cheapest_method",
                    "cheapest_normals",
                    "cost_ratio",
                    "motion_word",
                    "motion_cheapest_method",
                    "motion_cheapest_normals",
                    "motion_cost_ratio",
                    "said"},
                   {}};
  StudyTable times{"auto_judged_measured",
                   {"case", "triangles", "method", "normals", "force_99_share", "trial_99_share", "tick_ns",
                    "is_chosen", "is_cheapest"},
                   {}};
  for (const JudgedRow& r : rows) {
    const std::size_t best = r.cheapest(r.cost, true), of_motion = r.cheapest(r.cost, false),
                      quickest = r.cheapest(r.tick_ns, true);
    words.rows.push_back({r.name,
                          r.triangles,
                          r.radius_m,
                          r.is_exact ? "exact surface" : "curved patches",
                          variant_word(r.chosen, false),
                          variant_word(r.chosen, true),
                          static_cast<double>(r.ticks),
                          r.error_99[r.chosen],
                          r.trial_99[r.chosen],
                          r.promised,
                          static_cast<double>(r.pop_throughs[r.chosen] + r.trial_pop_throughs[r.chosen]),
                          static_cast<double>(r.pop_throughs.back() + r.trial_pop_throughs.back()),
                          to_string(r.word()),
                          variant_word(best, false),
                          variant_word(best, true),
                          r.price_ratio(r.cost, true),
                          to_string(r.word_of_motion()),
                          variant_word(of_motion, false),
                          variant_word(of_motion, true),
                          r.price_ratio(r.cost, false),
                          r.said});
    for (std::size_t v = 0; v < r.tick_ns.size(); ++v)
      times.rows.push_back({r.name, r.triangles, variant_word(v, false), variant_word(v, true), r.error_99[v],
                            r.trial_99[v], r.tick_ns[v], v == r.chosen ? "yes" : "no",
                            v == quickest ? "yes" : "no"});
  }
  report.tables.push_back(std::move(words));
  report.tables.push_back(std::move(times));
}

/// What it came to, over all cases: by the promise, and by the cases' own motions.
void count_judged(StudyReport& report, const std::vector<JudgedRow>& rows) {
  StudyTable counts{
      "auto_judged_counts",
      {"judged_by", "cases", "kept", "said", "needless", "broken", "kept_at_most_1.2_of_cheapest"},
      {}};
  for (const bool of_promise : {true, false}) {
    const JudgedCount count = count_words(rows, of_promise);
    std::vector<StudyTable::Cell> row{of_promise ? "motion and trials" : "motion"};
    for (const int number :
         {count.cases, count.kept, count.said, count.needless, count.broken, count.near_cheapest})
      row.emplace_back(static_cast<double>(number));
    counts.rows.push_back(std::move(row));
  }
  report.tables.push_back(std::move(counts));
}

/// A panel of one number of every case, by what became of auto's word.
template <typename Number>
ChartPanel panel_of(const std::vector<JudgedRow>& rows, const std::string& title, const std::string& y_label,
                    Number number) {
  ChartPanel panel{title, "triangles", y_label, true, true, {}, {}};
  const std::pair<JudgedWord, CurveStyle> words[] = {
      {JudgedWord::kept, {0, Dash::none, Marker::ring, 1.2}},
      {JudgedWord::said, {2, Dash::none, Marker::diamond, 1.2}},
      {JudgedWord::needless, {6, Dash::none, Marker::square, 1.2}},
      {JudgedWord::broken, {1, Dash::none, Marker::cross, 1.6}}};
  for (const auto& [word, style] : words) {
    ChartCurve curve{to_string(word), style, {}, {}};
    for (const JudgedRow& row : rows) {
      if (row.word() != word || !std::isfinite(number(row))) continue;
      curve.x.push_back(row.triangles);
      curve.y.push_back(std::max(1e-5, number(row)));
    }
    if (!curve.x.empty()) panel.curves.push_back(std::move(curve));
  }
  return panel;
}

void draw_judged(StudyReport& report, const std::vector<JudgedRow>& rows) {
  Chart chart{
      "auto_judged_measured",
      "What auto promises, keeps and costs",
      {"Every case of auto_judged.csv: a finger goes over a part with what auto chose, without friction, "
       "against the exact surface,",
       "or the curved patch of the wall that a proxy finds. Costs were measured on the machine that drew "
       "this."},
      2,
      {}};
  ChartPanel errors = panel_of(
      rows, "error of the force on 99 % of ticks", "of the force, or of a tenth of the greatest",
      [](const JudgedRow& row) { return std::max(row.error_99[row.chosen], row.trial_99[row.chosen]); });
  errors.levels.push_back({"force_tolerance", 0.03});
  ChartPanel costs =
      panel_of(rows, "measured time of a tick of the motion", "of the quickest that keeps the promise",
               [](const JudgedRow& row) { return row.price_ratio(row.tick_ns, true); });
  costs.levels.push_back({"1.2", 1.2});
  chart.panels = {std::move(errors), std::move(costs)};
  report.charts.push_back(std::move(chart));
}

}  // namespace

void study_contact_auto(StudyReport& report, const ContactExtent& extent, const StudyProgress& progress) {
  std::vector<JudgedRow> rows;
  const TakeCase take = [&](const JudgedCase& one) {
    progress("what auto promises, and keeps: " + one.name);
    rows.push_back(judged(one, judged_turns));
  };
  take_exact_cases(take, "", extent.most_levels);
  if (!extent.scenes.empty()) take_scene_cases(extent.scenes, take);
  if (!extent.parts.empty()) {
    for (const std::string& file :
         files_of(extent.parts, [](const std::string& ending) { return !ending.empty(); }))
      take_part_cases(file, judged_strokes, take);
  }
  tell_judged(report, rows);
  count_judged(report, rows);
  draw_judged(report, rows);
}

}  // namespace fingerpad
