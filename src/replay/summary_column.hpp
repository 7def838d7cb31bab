#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace fingerpad {

struct RunTotals;

/// One column of `summary.csv`: all that is known of it. Figures, the writer, the schema beside the table,
/// the report and the README go by these rows.
struct SummaryColumn {
  enum class Kind { text, count, number };
  std::string_view name;
  std::string_view unit;  ///< "m", "N", "J", "N/m", "1" (a count or a pure number), "" (a text)
  std::string_view doc;
  double (*get)(const RunTotals& run) = nullptr;  ///< of a figure: from what a run has come to
  Kind kind = Kind::number;
  bool may_lack = false;  ///< nan where a run has none, and is whole all the same
};

/// What stands before the set keys: scene and job.
std::span<const SummaryColumn> summary_job_columns() noexcept;
/// Between the set keys and the figures.
const SummaryColumn& summary_status_column() noexcept;
/// What a run comes to, in the order of Figures::values(); nan for a job that failed.
std::span<const SummaryColumn> summary_figure_columns() noexcept;
/// After the figures; what the job warns of is the last.
std::span<const SummaryColumn> summary_contact_columns() noexcept;

/// The header of `summary.csv` for a batch with these set keys.
std::vector<std::string> summary_header(const std::vector<std::string>& set_keys);

/// A Table Schema (Frictionless) of a batch's `summary.csv`: a field for each column with its type, unit and
/// meaning.
std::string summary_schema_text(const std::vector<std::string>& set_keys);

/// The table of columns as the README has it, in Markdown.
std::string summary_columns_text();

}  // namespace fingerpad
