#include "app/version_words.hpp"

#include <fmt/format.h>

#include <Eigen/Core>

#include "app/commands.hpp"
#include "base/build_identity.hpp"
#include "contact/packet_scene.hpp"
#include "part/openmesh_reader.hpp"
#include "replay/ranks.hpp"
#include "trace/hdf5_file.hpp"
#ifdef FINGERPAD_VIEW
#include "view/vtk_version.hpp"
#endif

namespace fingerpad {
namespace {

void add_library(std::string& words, const char* name, const std::string& version) {
  if (!version.empty()) words += fmt::format("\n  {:<9} {}", name, version);
}

}  // namespace

std::string version_words() {
  std::string words = fmt::format("fingerpad {}", program_version);
  add_library(words, "build", short_build_identity());
#ifdef FINGERPAD_VIEW
  add_library(words, "VTK", vtk_version());
#endif
  add_library(words, "Embree", embree_version());
  add_library(words, "OpenMesh", openmesh_version());
  add_library(words, "HDF5", hdf5::library_version());
  add_library(words, "MPI", mpi_version());
  add_library(words, "Eigen",
              fmt::format("{}.{}.{}", EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION));
  add_library(words, "fmt",
              fmt::format("{}.{}.{}", FMT_VERSION / 10000, FMT_VERSION / 100 % 100, FMT_VERSION % 100));
  return words;
}

}  // namespace fingerpad
