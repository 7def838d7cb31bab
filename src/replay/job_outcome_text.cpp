#include "replay/job_outcome_text.hpp"

#include <bit>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <utility>

namespace fingerpad {

std::string outcome_text(const BatchJob& job, std::size_t index) {
  // Figures as bits: JSON has no numbers that are not finite.
  std::vector<std::uint64_t> figures;
  for (const double figure : job.figures) figures.push_back(std::bit_cast<std::uint64_t>(figure));
  const nlohmann::json outcome = {index,
                                  job.status,
                                  job.exit_code,
                                  job.seconds,
                                  figures,
                                  job.contact_method,
                                  job.contact_normals,
                                  job.contact_reasons,
                                  job.kept,
                                  job.left_behind,
                                  job.motion_notes,
                                  job.warnings,
                                  job.kept_warnings,
                                  job.made_again.why,
                                  job.made_again.of_other_build,
                                  job.wrote_nothing};
  return outcome.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

void take_outcome(std::vector<BatchJob>& jobs, const std::string& text) {
  const auto outcome = nlohmann::json::parse(text, nullptr, false);
  constexpr std::size_t fields = 16;
  if (!outcome.is_array() || outcome.size() != fields) return;
  try {
    const auto index = outcome[0].get<std::size_t>();
    if (index >= jobs.size()) return;
    BatchJob told;  // taken as a whole or not at all
    told.status = outcome[1];
    told.exit_code = outcome[2];
    told.seconds = outcome[3];
    for (const std::uint64_t bits : outcome[4]) told.figures.push_back(std::bit_cast<double>(bits));
    told.contact_method = outcome[5];
    told.contact_normals = outcome[6];
    told.contact_reasons = outcome[7].get<std::vector<std::string>>();
    told.kept = outcome[8];
    told.left_behind = outcome[9];
    told.motion_notes = outcome[10].get<std::vector<std::string>>();
    told.warnings = outcome[11].get<std::vector<std::string>>();
    told.kept_warnings = outcome[12].get<std::vector<std::string>>();
    told.made_again.why = outcome[13];
    told.made_again.of_other_build = outcome[14];
    told.wrote_nothing = outcome[15];
    told.job = std::move(jobs[index].job);
    jobs[index] = std::move(told);
  } catch (
      const nlohmann::json::exception&) {  // NOLINT(bugprone-empty-catch): what is no outcome tells nothing
  }
}

}  // namespace fingerpad
