#include "replay/missing_inputs.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "base/error.hpp"
#include "base/input_file.hpp"
#include "base/path_words.hpp"

namespace fingerpad {
namespace {

void refuse_missing(const Scene& scene, const std::string& path, const char* named_by) {
  std::error_code failure;
  if (path.empty() || stream_descriptor(path)) return;
  if (std::filesystem::status(path, failure).type() != std::filesystem::file_type::not_found) return;
  throw refused(scene.path,
                fmt::format("{} names {}, which cannot be read: {}", named_by, path,
                            path_words(path, static_cast<int>(std::errc::no_such_file_or_directory))));
}

}  // namespace

void refuse_missing_inputs(const Scene& scene) {
  if (scene.path.empty()) return;
  for (const PartEntry& part : scene.parts) refuse_missing(scene, part.mesh_path, "[[part]] mesh");
  if (scene.motion.format.name.empty()) refuse_missing(scene, scene.motion.file_path, "[motion] file");
}

}  // namespace fingerpad
