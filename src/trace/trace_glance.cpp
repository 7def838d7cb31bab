#include "trace/trace_glance.hpp"

#include <fstream>

#include "trace/file_seal.hpp"
#include "trace/trace.hpp"

namespace fingerpad {

bool looks_whole(const std::string& path) {
  if (is_hdf5(path)) return ends_with_seal(path);
  if (!is_csv_trace(path) && !is_partial_csv_trace(path)) return false;
  std::ifstream file(path, std::ios::binary);  // InputFile, which takes streams too, cannot seek
  file.seekg(-1, std::ios::end);
  return file.get() == '\n';
}

}  // namespace fingerpad
