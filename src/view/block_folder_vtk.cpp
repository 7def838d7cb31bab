#include <fmt/format.h>
#include <unistd.h>
#include <vtkErrorCode.h>

#include "base/error.hpp"
#include "base/output_place.hpp"
#include "view/block_folder.hpp"

namespace fingerpad {
namespace {

namespace fs = std::filesystem;

/// Throws where a folder holds what an export has not put there.
void refuse_others_files(const fs::path& blocks) {
  std::error_code none;
  if (!fs::exists(blocks, none)) return;
  if (!fs::is_directory(blocks, none))
    throw Error(ErrorKind::usage, blocks.string(), "stands where the folder of the blocks would be; move it");
  for (const fs::directory_entry& entry : fs::directory_iterator(blocks)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with(blocks.filename().string() + "_") && name.ends_with(".vtp")) continue;
    throw Error(ErrorKind::usage, blocks.string(),
                fmt::format("is where the blocks would be, but it holds {}; choose another name", name));
  }
}

}  // namespace

BlockFolder::BlockFolder(const std::string& path)
    : path_(path), blocks_(fs::path(path).replace_extension()), hidden_(path_.parent_path()) {
  refuse_unwritable(path);
  refuse_others_files(blocks_);
  hidden_ /= fmt::format(".{}.{}.part", path_.filename().string(), getpid());
  std::error_code failure;
  fs::create_directories(hidden_, failure);
  if (failure) throw Error(ErrorKind::usage, path, "cannot be written: " + failure.message());
}

BlockFolder::~BlockFolder() {
  std::error_code ignored;
  fs::remove_all(hidden_, ignored);
}

std::string BlockFolder::reason(unsigned long vtk_error) const {
  if (vtk_error == vtkErrorCode::OutOfDiskSpaceError) return "no space is left on the disk";
  std::error_code none;
  const fs::space_info space = fs::space(hidden_, none);
  return !none && space.available < 4096 ? "no space is left on the disk"
                                         : vtkErrorCode::GetStringFromErrorCode(vtk_error);
}

void BlockFolder::commit() {
  try {
    fs::remove_all(blocks_);
    fs::rename(hidden_ / blocks_.filename(), blocks_);
    fs::rename(hidden_ / path_.filename(), path_);
  } catch (const fs::filesystem_error& error) {
    throw Error(ErrorKind::fault, path_.string(), "cannot be put in place: " + error.code().message());
  }
}

}  // namespace fingerpad
