#include "app/report_page.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "app/commands.hpp"
#include "replay/summary_column.hpp"
#include "view/colours.hpp"
#include "view/overlay.hpp"

namespace fingerpad {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* page_scripts[] = {"format.js",    "shape_view.js", "strip_charts.js", "charts.js",
                                        "job_table.js", "job_page.js",   "page.js"};

std::string css_colour(const Colour& colour) {
  return fmt::format("#{:02x}{:02x}{:02x}", colour.red, colour.green, colour.blue);
}

Json colours_json() {
  Json json;
  constexpr int curves = 8, ramp_cells = 32;
  for (int i = 0; i < curves; ++i) json["palette"].push_back(css_colour(palette::colour(i)));
  for (const Phase phase : {Phase::free, Phase::stick, Phase::slip})
    json["phases"].push_back(css_colour(phase_colour(phase)));
  for (int i = 0; i < ramp_cells; ++i)
    json["ramp"].push_back(css_colour(ramp_colour(i / (ramp_cells - 1.0))));
  return json;
}

Json columns_json() {
  Json json = Json::array();
  for (const SummaryColumn& column : summary_figure_columns()) {
    json.push_back({{"name", std::string(column.name)},
                    {"unit", std::string(column.unit)},
                    {"doc", std::string(column.doc)},
                    {"count", column.kind == SummaryColumn::Kind::count}});
  }
  return json;
}

Json job_json(const JobOutcome& job, const std::vector<std::string>& keys) {
  Json json = {{"scene", job.scene},
               {"number", job.number},
               {"mesh", job.mesh},
               {"motion", job.motion},
               {"status", job.status},
               {"figures", job.figures},
               {"method", job.contact_method},
               {"normals", job.contact_normals},
               {"trace", std::filesystem::path(job.trace).filename().string()}};
  json["values"] = Json::array();
  for (const std::string& key : keys) {
    std::string value;
    for (const auto& [name, text] : job.values) value = name == key ? text : value;
    json["values"].push_back(value);
  }
  return json;
}

/// Each `{{name}}` of a template by what belongs there; what is put in is not looked at again.
std::string filled(std::string_view text,
                   const std::vector<std::pair<std::string_view, std::string>>& parts) {
  std::string page;
  for (std::size_t at = 0;;) {
    const std::size_t begin = text.find("{{", at);
    const std::size_t end = begin == std::string_view::npos ? begin : text.find("}}", begin);
    page += text.substr(at, begin == std::string_view::npos ? begin : begin - at);
    if (end == std::string_view::npos) return page;
    const std::string_view name = text.substr(begin + 2, end - begin - 2);
    for (const auto& [key, value] : parts) {
      if (key == name) page += value;
    }
    at = end + 2;
  }
}

/// JSON that may stand in a script element: no `</script>` in a name ends it.
std::string json_in_html(const Json& json) {
  std::string text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
  std::string safe;
  safe.reserve(text.size());
  for (const char letter : text) {
    if (letter == '<') {
      safe += "\\u003c";
    } else {
      safe += letter;
    }
  }
  return safe;
}

std::string licences_html(const std::vector<ReportLibraries::Licence>& licences) {
  std::string html;
  for (const auto& [package, text] : licences) {
    html += fmt::format("<details><summary>{}</summary><pre>{}</pre></details>\n", html_text(package),
                        html_text(text));
  }
  return html;
}

}  // namespace

std::string html_text(std::string_view text) {
  std::string html;
  for (const char letter : text) {
    switch (letter) {
      case '&':
        html += "&amp;";
        break;
      case '<':
        html += "&lt;";
        break;
      case '>':
        html += "&gt;";
        break;
      case '"':
        html += "&quot;";
        break;
      default:
        html += letter;
    }
  }
  return html;
}

nlohmann::ordered_json report_results(const BatchResults& batch, const std::vector<JobTrouble>& order) {
  Json json = {{"setKeys", batch.set_keys}, {"columns", columns_json()}, {"colours", colours_json()}};
  json["jobs"] = Json::array();
  for (const JobOutcome& job : batch.jobs) json["jobs"].push_back(job_json(job, batch.set_keys));
  for (std::size_t rank = 0; rank < order.size(); ++rank) {
    Json& job = json["jobs"][order[rank].job];
    job["rank"] = rank + 1;
    job["trouble"] = order[rank].words;
  }
  return json;
}

std::string report_page(const std::string& title, const ReportLibraries& libraries,
                        const nlohmann::ordered_json& results) {
  std::string scripts;
  for (const char* name : page_scripts) scripts += report_template(name);
  return filled(report_template("page.html"), {{"title", html_text(title)},
                                               {"version", html_text(program_version)},
                                               {"library_styles", libraries.styles},
                                               {"library_scripts", libraries.scripts},
                                               {"styles", std::string(report_template("page.css"))},
                                               {"results", json_in_html(results)},
                                               {"licences", licences_html(libraries.licences)},
                                               {"scripts", scripts}});
}

}  // namespace fingerpad
