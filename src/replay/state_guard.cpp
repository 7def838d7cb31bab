#include "replay/state_guard.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <thread>
#include <tuple>

#include "base/output_place.hpp"
#include "base/path_words.hpp"

namespace fingerpad {
namespace {

namespace fs = std::filesystem;
using std::chrono::steady_clock;

constexpr const char* guard_name = "guard";
/// Whoever has it holds it for milliseconds, or while it waits for the last processes of a run.
constexpr std::chrono::seconds guard_patience{60};
constexpr std::chrono::milliseconds between_looks{20};

Error cannot_write(const std::string& path) {
  const int problem = errno;
  return {problem == ENOENT ? ErrorKind::fault : output_fault(problem), path,
          "cannot be written: " + path_words(path, problem)};
}

std::size_t made_folders(int guard) {
  char text[24] = {};
  return pread(guard, text, sizeof(text) - 1, 0) > 0 ? std::strtoul(text, nullptr, 10) : 0;
}

}  // namespace

Error cannot_write_into(const std::string& folder) {
  const int problem = errno;
  const bool is_gone = problem == ENOENT || problem == ENOTDIR;
  return {is_gone ? ErrorKind::fault : output_fault(problem), folder,
          "cannot be written: " + path_words(is_gone ? folder + "/" : folder, problem)};
}

std::optional<OpenFile> take_guard(const std::string& state, const std::string& folder, std::size_t* made) {
  const std::string path = state + "/" + guard_name;
  for (const auto end = steady_clock::now() + guard_patience; steady_clock::now() < end;) {
    const bool is_there = mkdir(state.c_str(), 0777) == 0 || errno == EEXIST;
    if (!is_there && (made == nullptr || errno != ENOENT)) throw cannot_write_into(folder);
    if (!is_there) *made = std::max(*made, make_folder(folder).size());
    OpenFile guard(open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666));
    if (guard.number() < 0 && errno == ENOENT) continue;
    if (guard.number() < 0) throw cannot_write(path);
    const Locking locking = try_lock(guard.number(), LOCK_EX);
    if (locking == Locking::impossible) return std::nullopt;
    if (locking == Locking::got && is_at(guard.number(), path)) return guard;
    if (locking == Locking::busy) std::this_thread::sleep_for(between_looks);
  }
  throw refused(folder, fmt::format("another run holds {} and does not let go", path));
}

void note_made_folders(int guard, std::size_t made) {
  if (made <= made_folders(guard)) return;
  const std::string text = fmt::format("{}\n", made);
  std::ignore = pwrite(guard, text.data(), text.size(), 0);  // on a full disk they stay
}

void remove_if_unused(const std::string& state, int guard) {
  std::error_code failure;
  bool is_alone = true, others_run = false;
  for (const auto& entry : fs::directory_iterator(state, failure)) {
    is_alone &= entry.path().filename() == guard_name;
    others_run |= entry.path().extension() == lock_ending;
  }
  if (failure || others_run) return;
  if (!is_alone) {  // the folder stays, and its files do not tell who has made it
    if (made_folders(guard) > 0) std::ignore = ftruncate(guard, 0);
    return;
  }
  const std::size_t made = made_folders(guard);
  fs::path folder = fs::canonical(state, failure);  // where a link leads, not where its name stands
  unlink((state + "/" + guard_name).c_str());
  rmdir(state.c_str());
  if (failure) return;
  for (std::size_t i = 0; i < made; ++i) {
    folder = folder.parent_path();
    if (rmdir(folder.c_str()) != 0) return;
  }
}

}  // namespace fingerpad
