#include "replay/ranks.hpp"

#include <fmt/format.h>

#ifdef FINGERPAD_MPI
#include <mpi.h>
#endif

#include <poll.h>
#include <unistd.h>

#include <charconv>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string_view>

#include "base/error.hpp"

namespace fingerpad {

std::optional<std::chrono::system_clock::time_point> launch_time(const Ranks& ranks) {
  using std::chrono::system_clock;
  // proc(5): behind the command in brackets the 20th is when it began, in clock ticks since the boot.
  constexpr int words_before = 19;
  std::ifstream process(fmt::format("/proc/{}/stat", ranks.launcher));
  std::string words{std::istreambuf_iterator<char>(process), {}};
  const std::size_t behind_command = words.rfind(')');
  if (behind_command == std::string::npos) return std::nullopt;
  std::istringstream fields(words.substr(behind_command + 1));
  for (int i = 0; i < words_before; ++i) fields >> words;
  double begun_ticks = 0, since_boot_s = 0;
  std::ifstream uptime("/proc/uptime");
  if (!(fields >> begun_ticks) || !(uptime >> since_boot_s)) return std::nullopt;
  const std::chrono::duration<double> age(since_boot_s -
                                          begun_ticks / static_cast<double>(sysconf(_SC_CLK_TCK)));
  return system_clock::now() - std::chrono::duration_cast<system_clock::duration>(age);
}

bool launcher_is_gone(const Ranks& ranks) noexcept {
  if (getppid() != ranks.launcher) return true;
  pollfd error_stream{STDERR_FILENO, 0, 0};
  return poll(&error_stream, 1, 0) == 1 && (error_stream.revents & (POLLERR | POLLHUP)) != 0;
}

#ifdef FINGERPAD_MPI
namespace {

/// Where a launcher says which rank a process is, of how many, and of which start.
struct Launcher {
  const char *rank, *count, *run, *step;
};

// An MPI of its own may run inside a Slurm step, so it comes first. A Slurm script that is not itself a step
// has no SLURM_STEP_NUM_TASKS, and what it calls is alone.
constexpr Launcher launchers[] = {
    {"OMPI_COMM_WORLD_RANK", "OMPI_COMM_WORLD_SIZE", "PMIX_NAMESPACE", "OMPI_MCA_ess_base_jobid"},
    {"SLURM_PROCID", "SLURM_STEP_NUM_TASKS", "SLURM_JOB_ID", "SLURM_STEP_ID"},
    {"PMI_RANK", "PMI_SIZE", "PMI_JOBID", ""},  // Hydra (MPICH) gives no PMI_JOBID: then it is refused
};

std::string_view variable(const char* name) noexcept {
  const char* value = std::getenv(name);
  return value == nullptr ? std::string_view() : value;
}

int number_in(const char* name) noexcept {
  const std::string_view text = variable(name);
  int number = -1;
  const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), number);
  return status == std::errc{} && end == text.data() + text.size() ? number : -1;
}

}  // namespace

Ranks launched_ranks() {
  for (const Launcher& launcher : launchers) {
    const int rank = number_in(launcher.rank);
    const int count = number_in(launcher.count);
    if (rank < 0 || count <= rank) continue;
    if (count == 1) break;  // alone, whatever started it
    if (variable(launcher.run).empty() && variable(launcher.step).empty())
      throw Error(
          ErrorKind::usage, launcher.rank,
          fmt::format("says that this is rank {} of {}, but {} does not say of which run; start it with "
                      "Open MPI's mpirun or with srun, or without ranks, each with a --shard K/N",
                      rank, count, launcher.run));
    return {rank, count, fmt::format("{}.{}", variable(launcher.run), variable(launcher.step)), getppid()};
  }
  return {};
}

std::string mpi_version() {
  char words[MPI_MAX_LIBRARY_VERSION_STRING];
  int length = 0;
  MPI_Get_library_version(words, &length);  // one of the calls that may come before MPI_Init
  const std::string text(words, static_cast<std::size_t>(length));
  return text.substr(0, text.find_first_of(",\n"));  // "Open MPI v4.1.4", not who built it
}
#else
Ranks launched_ranks() {
  return {};
}
std::string mpi_version() {
  return "";
}
#endif

}  // namespace fingerpad
