#include "replay/summary_column.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "replay/run_totals.hpp"

namespace fingerpad {
namespace {

using Kind = SummaryColumn::Kind;
using T = RunTotals;

template <long T::*member>
double count(const T& run) {
  return static_cast<double>(run.*member);
}

template <double T::*member>
double number(const T& run) {
  return run.*member;
}

/// nan where nothing was summed up.
double mean(double sum, long count) {
  return count > 0 ? sum / static_cast<double>(count) : TickRecord::nan;
}

constexpr SummaryColumn job_columns[] = {
    {"scene", "", "the scene's name", nullptr, Kind::text},
    {"job", "1", "the job's number within its scene, from 1; 0 of a scene without a set", nullptr,
     Kind::count},
};

constexpr SummaryColumn status_column = {"status", "", "`ok`, or why the job failed", nullptr, Kind::text};

constexpr SummaryColumn figure_columns[] = {
    {"ticks", "1", "ticks of the run", count<&T::ticks>, Kind::count},
    {"contact_ticks", "1", "ticks on which the finger touched", count<&T::contact_ticks>, Kind::count},
    {"stick_ticks", "1", "ticks in stick", count<&T::stick_ticks>, Kind::count},
    {"slip_ticks", "1", "ticks in slip", count<&T::slip_ticks>, Kind::count},
    {"ruptures", "1", "how often stick gave way to slip", count<&T::ruptures>, Kind::count},
    {"coarse_teeth", "1", "teeth of stick and slip shorter than two ticks, which no sampling shows",
     count<&T::coarse_teeth>, Kind::count},
    {"max_depth_m", "m", "the greatest depth of the finger in a part", number<&T::max_depth_m>},
    {"mean_normal_force_n", "N", "the mean normal force while it touched",
     [](const T& run) { return run.contact_ticks > 0 ? mean(run.sum_normal_n, run.contact_ticks) : 0.0; }},
    {"max_normal_force_n", "N", "the greatest normal force", number<&T::max_normal_n>},
    {"max_friction_n", "N", "the greatest friction force", number<&T::max_friction_n>},
    {"mean_slip_mu", "1",
     "the mean coefficient of friction of the ticks in slip that have a normal force; nan where there are "
     "none",
     [](const T& run) { return mean(run.sum_slip_mu, run.pressed_slip_ticks); }, Kind::number, true},
    {"max_mu", "1", "the greatest coefficient of friction", number<&T::max_mu>},
    {"friction_work_j", "J",
     "the work of friction on the finger, its turning included, each tick's force held until the next; below "
     "0 where it takes energy, as it should",
     number<&T::friction_work_j>},
    {"remedied_ticks", "1", "ticks on which a remedy against a stiff stick spring acted",
     count<&T::remedied_ticks>, Kind::count},
    {"energy_made_j", "J",
     "the most that the forces, held likewise, have given to the finger on balance since the start, less "
     "what "
     "was stored there: energy that the contact has made; 0 for a passive one",
     number<&T::energy_made_j>},
    {"inside_starts", "1", "how often the finger began inside of a part, or where a proxy does not fit",
     count<&T::inside_starts>, Kind::count},
    {"pop_throughs", "1", "how often the finger went through a wall, or was pushed out on its far side",
     [](const T& run) { return static_cast<double>(run.pop_throughs.count()); }, Kind::count},
    {"max_force_step_n", "N", "the greatest change of the whole force from one tick to the next",
     number<&T::max_step_n>},
    {"max_apparent_stiffness_n_per_m", "N/m",
     "the greatest change of the normal force in a tick per metre that the finger moved in it; a stiffness "
     "alone gives at most its own number",
     number<&T::max_step_n_per_m>},
    {"nonfinite_ticks", "1", "ticks whose force was not a finite number; 0 is promised",
     count<&T::nonfinite_ticks>, Kind::count},
    {"unsettled_ticks", "1",
     "ticks on which the proxy stopped before it was at rest, because a tick's work is bounded, and that "
     "followed until it was",
     count<&T::unsettled_ticks>, Kind::count},
    {"residual_rms_n", "N",
     "of a motion with a measured force: the root mean square of the model's whole force less the measured "
     "one; "
     "else nan",
     [](const T& run) { return run.residual.rms_n(); }, Kind::number, true},
    {"residual_scale", "1",
     "of a motion with a measured force: how many times as hard as the model the measurement presses along "
     "the normal, on average in contact; below 0 the other way, as the force on the plate does; else nan",
     [](const T& run) { return run.residual.scale(); }, Kind::number, true},
    {"residual_bias_n", "N",
     "of a motion with a measured force: the length of what is left of it on average, without contact where "
     "the finger is ever free (what a sensor that was not tared shows), else over the whole run; else nan",
     [](const T& run) { return run.residual.bias_n(); }, Kind::number, true},
    {"residual_lag_s", "s",
     "of a motion with a measured force: how much later than the model's the measured force comes, where "
     "that makes both fit better: by a late recorder, or by a finger that is softer than the model's; 0 "
     "where nothing does, nan where it cannot be told",
     [](const T& run) { return run.residual.lag_s(); }, Kind::number, true},
};

constexpr SummaryColumn contact_columns[] = {
    {"contact_method", "", "the contact method that served", nullptr, Kind::text},
    {"contact_normals", "", "the normals that served", nullptr, Kind::text},
    {"warnings", "",
     "what was told of the job that no figure says: an unlikely unit of its mesh, a press of over three "
     "times "
     "the force asked for, a motion that never touches or whose clock is odd; parted by ` / `, mostly empty",
     nullptr, Kind::text},
};

constexpr std::string_view set_key_doc = "a key of the set, as the scene has it";

nlohmann::ordered_json field(std::string_view name, const SummaryColumn& column) {
  constexpr const char* types[] = {"string", "integer", "number"};
  nlohmann::ordered_json json = {{"name", std::string(name)}, {"type", types[static_cast<int>(column.kind)]}};
  if (!column.unit.empty()) json["unit"] = std::string(column.unit);
  json["description"] = std::string(column.doc);
  return json;
}

/// Calls `take(name, column)` for every column in order.
template <typename Take>
void each_column(const std::vector<std::string>& set_keys, Take take) {
  for (const SummaryColumn& column : job_columns) take(column.name, column);
  for (const std::string& key : set_keys) take(key, SummaryColumn{key, "", set_key_doc, nullptr, Kind::text});
  take(status_column.name, status_column);
  for (const SummaryColumn& column : figure_columns) take(column.name, column);
  for (const SummaryColumn& column : contact_columns) take(column.name, column);
}

}  // namespace

std::span<const SummaryColumn> summary_job_columns() noexcept {
  return job_columns;
}

const SummaryColumn& summary_status_column() noexcept {
  return status_column;
}

std::span<const SummaryColumn> summary_figure_columns() noexcept {
  return figure_columns;
}

std::span<const SummaryColumn> summary_contact_columns() noexcept {
  return contact_columns;
}

std::vector<std::string> summary_header(const std::vector<std::string>& set_keys) {
  std::vector<std::string> names;
  each_column(set_keys, [&](std::string_view name, const SummaryColumn&) { names.emplace_back(name); });
  return names;
}

std::string summary_schema_text(const std::vector<std::string>& set_keys) {
  nlohmann::ordered_json fields = nlohmann::ordered_json::array();
  each_column(set_keys, [&](std::string_view name, const SummaryColumn& column) {
    fields.push_back(field(name, column));
  });
  const nlohmann::ordered_json schema = {
      {"title", "summary.csv of fingerpad replay"},
      {"description", "A row a job. Units are SI; a unit of 1 is a count or a pure number."},
      {"fields", fields},
      {"missingValues", {"", "nan"}}};
  return schema.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

std::string summary_columns_text() {
  std::string text = "| column | unit | what it is |\n|---|---|---|\n";
  each_column({}, [&](std::string_view name, const SummaryColumn& column) {
    text += fmt::format("| `{}` | {} | {} |\n", name, column.unit == "1" ? "" : column.unit, column.doc);
  });
  return text;
}

}  // namespace fingerpad
