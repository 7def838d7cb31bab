#include "replay/disk_room.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <system_error>

#include "base/error.hpp"
#include "base/input_file.hpp"
#include "trace/trace_column.hpp"

namespace fingerpad {
namespace {

/// Of a row; text and deflated numbers take more than this in any run that touches something.
double least_row_bytes(TraceFormat format, const TraceInfo& info) {
  constexpr double least_cell_bytes = 4, most_deflated = 10;
  if (format == TraceFormat::csv) return least_cell_bytes * static_cast<double>(csv_columns(info).size());
  double bytes = 0;
  for (const TraceColumn& column : trace_columns(info)) bytes += static_cast<double>(kept_bytes(column.kind));
  return info.deflated ? bytes / most_deflated : bytes;
}

/// In whole mebibytes, for people; in kibibytes where there is none.
std::string whole_bytes_text(double bytes) {
  const int bits = bytes < 1 << 20 ? 10 : 20;
  return bytes_text(static_cast<std::uint64_t>(bytes) >> bits << bits);
}

}  // namespace

void refuse_full_disk(const std::string& path, TraceFormat format, const TraceInfo& info,
                      std::uint64_t rows) {
  std::error_code unknown;
  const auto room = std::filesystem::space(std::filesystem::absolute(path).parent_path(), unknown);
  const double bytes = static_cast<double>(rows) * least_row_bytes(format, info);
  if (unknown || bytes <= static_cast<double>(room.available)) return;
  throw Error(
      ErrorKind::fault, path,
      fmt::format("its {} rows take at least {}, and the disk has room for {}: write fewer with --every "
                  "N or --columns LIST, or none with --format none",
                  rows, whole_bytes_text(bytes), whole_bytes_text(static_cast<double>(room.available))));
}

}  // namespace fingerpad
