#pragma once

#include <chrono>
#include <optional>
#include <string>

namespace fingerpad {

/// This process's place among those that a launcher (mpirun, srun) has started to share a batch; alone
/// without one, and in a build with FINGERPAD_MPI=OFF. Ranks send one another no messages: what they agree on
/// lies in the output folder (shared_batch.hpp), so that one that dies takes nobody with it.
struct Ranks {
  int rank = 0;
  int count = 1;
  std::string run;   ///< what all ranks of one start have in common, and those of another have not
  int launcher = 0;  ///< the process that started this one

  bool are_many() const noexcept { return count > 1; }
  bool is_root() const noexcept { return rank == 0; }
};

/// As the launcher's environment says. Throws Error (usage) where that tells ranks, but not of which run:
/// those of two runs would be taken for one.
Ranks launched_ranks();

/// When what started a rank began; none where this system does not tell.
std::optional<std::chrono::system_clock::time_point> launch_time(const Ranks& ranks);

/// Whether what started a rank has ended, so that nobody waits for it any more: it is no longer the parent,
/// or nobody reads the standard error that it gave (it may have ended before this process could look).
bool launcher_is_gone(const Ranks& ranks) noexcept;

/// What the MPI that mpirun and HDF5 are of calls itself, as "Open MPI v4.1.4"; empty in a build without it.
std::string mpi_version();

}  // namespace fingerpad
