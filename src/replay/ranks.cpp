#include "replay/ranks.hpp"

#ifdef FINGERPAD_MPI
#include <mpi.h>

#include <cstdlib>
#include <numeric>
#endif

namespace fingerpad {

#ifdef FINGERPAD_MPI
namespace {

bool launched_with_ranks() {
  // Open MPI's, PMIx's and the older PMI launchers' marks; a plain start must not pay for MPI_Init.
  for (const char* name : {"OMPI_COMM_WORLD_SIZE", "PMIX_RANK", "PMI_RANK", "PMI_SIZE"}) {
    if (std::getenv(name) != nullptr) return true;
  }
  return false;
}

}  // namespace

Ranks::Ranks() {
  if (!launched_with_ranks()) return;
  int provided = 0;
  MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &provided);
  MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
  MPI_Comm_size(MPI_COMM_WORLD, &count_);
}

Ranks::~Ranks() {
  int started = 0;
  int ended = 0;
  MPI_Initialized(&started);
  MPI_Finalized(&ended);
  if (started != 0 && ended == 0) MPI_Finalize();
}

std::vector<std::string> Ranks::gather(const std::string& text) const {
  if (count_ == 1) return {text};
  const auto ranks = static_cast<std::size_t>(count_);
  const int length = static_cast<int>(text.size());
  std::vector<int> lengths(ranks), starts(ranks);
  MPI_Gather(&length, 1, MPI_INT, lengths.data(), 1, MPI_INT, 0, MPI_COMM_WORLD);
  std::exclusive_scan(lengths.begin(), lengths.end(), starts.begin(), 0);
  std::string all(is_root() ? static_cast<std::size_t>(starts.back() + lengths.back()) : 0, '\0');
  MPI_Gatherv(text.data(), length, MPI_CHAR, all.data(), lengths.data(), starts.data(), MPI_CHAR, 0,
              MPI_COMM_WORLD);
  std::vector<std::string> texts;
  for (std::size_t i = 0; is_root() && i < ranks; ++i) {
    texts.push_back(all.substr(static_cast<std::size_t>(starts[i]), static_cast<std::size_t>(lengths[i])));
  }
  return texts;
}

std::string Ranks::broadcast(std::string text) const {
  if (count_ == 1) return text;
  int length = static_cast<int>(text.size());
  MPI_Bcast(&length, 1, MPI_INT, 0, MPI_COMM_WORLD);
  text.resize(static_cast<std::size_t>(length));
  MPI_Bcast(text.data(), length, MPI_CHAR, 0, MPI_COMM_WORLD);
  return text;
}

std::string mpi_version() {
  char words[MPI_MAX_LIBRARY_VERSION_STRING];
  int length = 0;
  MPI_Get_library_version(words, &length);  // one of the calls that may come before MPI_Init
  const std::string text(words, static_cast<std::size_t>(length));
  return text.substr(0, text.find_first_of(",\n"));  // "Open MPI v4.1.4", not who built it
}
#else
Ranks::Ranks() = default;
Ranks::~Ranks() = default;
std::vector<std::string> Ranks::gather(const std::string& text) const {
  return {text};
}
std::string Ranks::broadcast(std::string text) const {
  return text;
}
std::string mpi_version() {
  return "";
}
#endif

}  // namespace fingerpad
