#include "replay/run_lock.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <set>
#include <sstream>
#include <thread>
#include <utility>

#include "base/error.hpp"
#include "base/input_file.hpp"
#include "base/output_place.hpp"
#include "base/path_words.hpp"
#include "base/printable_text.hpp"
#include "replay/state_guard.hpp"

namespace fingerpad {
namespace {

namespace fs = std::filesystem;
using std::chrono::steady_clock;

/// For the last processes of a run whose first is gone.
constexpr std::chrono::seconds patience{10};
constexpr std::chrono::milliseconds between_tries{20};

/// What a registration says: who and where it is, and the names.
struct Registration {
  long process = 0;
  std::string host, command;
  std::set<std::string> names;

  std::string words() const {
    return fmt::format("process {} on {}{}", process, host, command.empty() ? "" : " (" + command + ")");
  }
};

/// How this process was started, on one line.
std::string own_command() {
  constexpr std::size_t most = 200;
  std::ifstream file("/proc/self/cmdline", std::ios::binary);
  std::string command{std::istreambuf_iterator<char>(file), {}};
  while (!command.empty() && command.back() == '\0') command.pop_back();
  std::replace(command.begin(), command.end(), '\0', ' ');
  if (command.size() > most) command = command.substr(0, most) + " ...";
  return printable(command);
}

std::string registration_text(const std::vector<std::string>& names, const std::string& run) {
  std::string text = fmt::format("{}\n{}\n{}\n{}\n", getpid(), host_name(), own_command(), run);
  for (const std::string& name : names) text += name + "\n";
  return text;
}

Registration read_registration(const std::string& path) {
  constexpr InputKind registration_file{"a registration", std::uint64_t{64} << 20};
  Registration found;
  std::istringstream file;
  try {
    file.str(read_whole_file(path, registration_file));
  } catch (const Error&) {
    return found;
  }
  std::string line;
  if (std::getline(file, line)) found.process = std::atol(line.c_str());
  std::getline(file, found.host);
  std::getline(file, found.command);
  std::getline(file, line);  // the run (run_of)
  while (std::getline(file, line)) found.names.insert(line);
  return found;
}

/// Whether the run of a registration is under way. Where its first process is gone, the others of it (ranks)
/// are about to end, and are waited for.
bool is_held(const std::string& path, const Registration& registration) {
  const OpenFile file(open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC));
  if (file.number() < 0) return errno != ENOENT;  // what cannot be looked at may well be held
  const bool here = registration.process > 0 && registration.host == host_name();
  for (const auto end = steady_clock::now() + patience;;) {
    if (try_lock(file.number(), LOCK_EX) != Locking::busy) return false;
    const bool gone = here && kill(static_cast<pid_t>(registration.process), 0) != 0 && errno == ESRCH;
    if (!gone || steady_clock::now() > end) return true;
    std::this_thread::sleep_for(between_tries);
  }
}

/// Of which run a registration is, without its names, which may be a million.
std::string run_of(const std::string& path) {
  constexpr InputKind head_of_registration{"a registration", std::uint64_t{1} << 30};
  constexpr int lines_before = 3;
  try {
    InputFile file(path, head_of_registration);
    std::string head(4096, '\0');
    head.resize(file.read(head.data(), head.size()));
    std::istringstream lines(head);
    std::string line;
    for (int i = 0; i <= lines_before; ++i) std::getline(lines, line);
    return line;
  } catch (const Error&) {
    return "";
  }
}

std::vector<std::string> registrations_in(const std::string& state) {
  std::vector<std::string> paths;
  std::error_code failure;
  for (const auto& entry : fs::directory_iterator(state, failure)) {
    if (entry.path().extension() == lock_ending) paths.push_back(entry.path().string());
  }
  std::sort(paths.begin(), paths.end());
  return paths;
}

/// A new file with this text, locked; nothing half written is left.
OpenFile write_registration(const std::string& path, const std::string& text, const std::string& folder) {
  OpenFile file(open(path.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
  if (file.number() < 0) throw cannot_write_into(folder);
  if (!write_all(file.number(), text.data(), text.size())) {
    const Error error = cannot_write_into(folder);
    unlink(path.c_str());
    throw error;
  }
  try_lock(file.number(), LOCK_SH);
  return file;
}

/// Removes the registrations of runs that have ended, and lists them.
void end_unfinished(const std::string& state, std::vector<std::string>& unfinished) {
  for (const std::string& path : registrations_in(state)) {
    const Registration other = read_registration(path);
    if (is_held(path, other)) continue;
    if (other.process > 0) unfinished.push_back(other.words());
    unlink(path.c_str());
  }
}

void refuse_overlap(const std::string& registration, const std::string& folder,
                    const std::vector<std::string>& names) {
  const Registration other = read_registration(registration);
  for (const std::string& name : names) {
    if (!other.names.contains(name)) continue;
    throw refused(folder, fmt::format("{} is being written by {}; wait for it, or write into another folder",
                                      name, other.words()));
  }
}

}  // namespace

RunLock::RunLock(const std::string& folder, const std::vector<std::string>& names, const std::string& run,
                 const std::function<void(const RunLock&)>& when_first, std::size_t made)
    : folder_(folder + "/" + state_folder), others_stay_(!run.empty()) {
  const auto guard = take_guard(folder_, folder, &made);
  if (!guard) {  // a file system without locks: nothing is left there
    remove_if_unused(folder_, -1);
    if (!run.empty())
      throw refused(
          folder,
          "is on a file system without locks, by which ranks share a batch; without ranks, --shard K/N "
          "does a share");
    if (when_first) when_first(*this);
    return;
  }
  note_made_folders(guard->number(), made);
  try {
    if (!run.empty() && join(run)) return;
    end_unfinished(folder_, unfinished_);
    for (const std::string& path : registrations_in(folder_)) refuse_overlap(path, folder, names);
    int number = 1;
    do path_ = fmt::format("{}/run-{}{}", folder_, number++, lock_ending);
    while (access(path_.c_str(), F_OK) == 0);
    file_ = write_registration(path_, registration_text(names, run), folder);
    try {
      if (when_first) when_first(*this);
    } catch (...) {
      unlink(path_.c_str());
      throw;
    }
  } catch (...) {
    remove_if_unused(folder_, guard->number());
    throw;
  }
}

RunLock::~RunLock() {
  if (file_.number() < 0 || others_stay_) return;
  try {
    const auto guard = take_guard(folder_, folder_, nullptr);
    unlink(path_.c_str());
    remove_if_unused(folder_, guard ? guard->number() : -1);
  } catch (const std::exception&) {
    unlink(path_.c_str());  // the folder is gone, or nobody may write there any more
  }
}

bool RunLock::join(const std::string& run) {
  for (const std::string& path : registrations_in(folder_)) {
    if (run_of(path) != run) continue;
    OpenFile file(open(path.c_str(), O_RDWR | O_CLOEXEC));
    // What nobody holds is an earlier run's that had the same number.
    if (file.number() < 0 || try_lock(file.number(), LOCK_EX) != Locking::busy) continue;
    if (!wait_for_lock(file.number(), LOCK_SH)) continue;
    file_ = std::move(file);
    path_ = path;
    return true;
  }
  return false;
}

bool RunLock::is_older_than(const std::string& path) const noexcept {
  struct stat own {
  }, other{};
  if (fstat(file_.number(), &own) != 0 || stat(path.c_str(), &other) != 0) return false;
  return std::pair(own.st_mtim.tv_sec, own.st_mtim.tv_nsec) <
         std::pair(other.st_mtim.tv_sec, other.st_mtim.tv_nsec);
}

bool RunLock::is_registered(const std::string& folder, const std::string& run) {
  const std::vector<std::string> paths = registrations_in(folder + "/" + state_folder);
  return std::any_of(paths.begin(), paths.end(), [&](const auto& path) { return run_of(path) == run; });
}

}  // namespace fingerpad
