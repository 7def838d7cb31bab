#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

namespace fingerpad {

/// Quantities that were recorded together, on a clock of their own.
struct ClockedValues {
  std::string what;         ///< "forces of a.csv", for messages
  std::vector<double> t_s;  ///< n, increasing
  Eigen::MatrixXd values;   ///< k x n
};

/// Two recordings of one event, on one clock.
struct JoinedClocks {
  std::vector<double> t_s;        ///< of the quicker clock, while both were recorded
  Eigen::MatrixXd first, second;  ///< a column a time
  std::string note;               ///< what was done, for people
};

/// Joins two recordings whose times count from the same moment: the values of the slower clock are taken
/// straight between its samples at the times of the quicker one. Times before its first sample, after its
/// last, and within its gaps (over two of its steps) are left out and counted in the note: nothing is held,
/// and nothing carried on. So a joined value is never farther than one step of the slower clock from a
/// measured one.
/// Throws Error (refused, at `where`) where one has under two samples, times do not increase, or the two have
/// no time in common.
JoinedClocks join_clocks(const ClockedValues& first, const ClockedValues& second, const std::string& where);

/// The values straight between their samples at other times that count from the same moment; not numbers
/// before the first sample, after the last, and within gaps (over two steps). Throws Error as join_clocks.
Eigen::MatrixXd values_at(const ClockedValues& values, const std::vector<double>& t_s,
                          const std::string& where);

}  // namespace fingerpad
