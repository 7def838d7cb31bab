#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace fingerpad {

/// One job in the index that stands beside its traces.
struct JobIndexRow {
  int number = 0;  ///< 0 of a scene without a set
  std::string file, scene, mesh, motion;
  std::vector<std::pair<std::string, std::string>> values;  ///< set key and value as written
};

/// The index's name in the folder of the traces; a shard's is `jobs-2of8.csv`.
inline constexpr const char* job_index_name = "jobs.csv";

/// The index as CSV: number, file, scene, mesh, motion, then these set keys, but for `mesh` and `motion`.
std::string job_index_text(const std::vector<std::string>& keys, const std::vector<JobIndexRow>& rows);

/// What varies in a trace's job beside its mesh, by the indices in its folder: "mu_static 0.3, law dahl", and
/// before it the motion, where that varies: "rub.csv, mu_static 0.3".
/// Empty where there is no index, or none that knows the trace; an index that cannot be read is none.
std::string varied_in_job(const std::string& trace_path);

/// The same of every trace that the indices in a folder know, by its file name, with the mesh before it where
/// there is one: "plate.stl, mu_static 0.3". Each index is read once or twice.
std::map<std::string, std::string> jobs_in_folder(const std::string& folder);

}  // namespace fingerpad
