#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "app/report_libraries.hpp"
#include "replay/batch_results.hpp"

namespace fingerpad {

/// A text for the inside of an HTML element.
std::string html_text(std::string_view text);

/// The page of these results, in one text.
/// @param title  of the page
/// @param results  as report_results() has them
std::string report_page(const std::string& title, const ReportLibraries& libraries,
                        const nlohmann::ordered_json& results);

/// What the page's own scripts show: columns, jobs in the order of the batch, colours. A job's `run` and
/// `note`, and `shapes`, are for the caller to add.
nlohmann::ordered_json report_results(const BatchResults& batch, const std::vector<JobTrouble>& order);

/// A file of src/app/report/, as it was when the program was built.
/// @pre it is one
std::string_view report_template(std::string_view name);

}  // namespace fingerpad
