#include "replay/missing_inputs.hpp"

#include <fmt/format.h>
#include <sys/stat.h>

#include <cerrno>

#include "base/error.hpp"
#include "base/input_file.hpp"
#include "base/path_words.hpp"

namespace fingerpad {
namespace {

void refuse_missing(const Scene& scene, const std::string& path, const char* named_by) {
  struct stat status;
  if (path.empty() || stream_descriptor(path) || stat(path.c_str(), &status) == 0) return;
  const int problem = errno;
  if (problem != ENOENT && problem != ENOTDIR) return;
  throw refused(scene.path, fmt::format("{} names {}, which cannot be read: {}", named_by, path,
                                        path_words(path, problem)));
}

}  // namespace

void refuse_missing_inputs(const Scene& scene) {
  if (scene.path.empty()) return;
  for (const PartEntry& part : scene.parts) refuse_missing(scene, part.mesh_path, "[[part]] mesh");
  if (scene.motion.format.name.empty()) refuse_missing(scene, scene.motion.file_path, "[motion] file");
}

}  // namespace fingerpad
