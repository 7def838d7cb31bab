#include "trace/trace_column.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>

namespace fingerpad {
namespace {

bool is_index(double value) noexcept {
  return value >= -1 && value <= 2147483647.0 && value == std::floor(value);
}

std::string_view damage(ColumnKind kind, double value) noexcept {
  switch (kind) {
    case ColumnKind::place:
      return std::isfinite(value) ? "" : "a time or position is not finite";
    case ColumnKind::phase:
      return value == 0 || value == 1 || value == 2 ? ""
                                                    : "the phase is none of 0 (free), 1 (stick), 2 (slip)";
    case ColumnKind::index:
      return is_index(value) ? "" : "a part or triangle is no whole number from -1";
    case ColumnKind::number:
      break;
  }
  return "";
}

}  // namespace

std::string_view read_value(const TraceColumn& column, double value, TickRecord& record) noexcept {
  const std::string_view wrong = damage(column.kind, value);
  if (wrong.empty()) column.set(record, value);
  return wrong;
}

std::size_t kept_bytes(ColumnKind kind) noexcept {
  if (kind == ColumnKind::phase) return sizeof(std::uint8_t);
  return kind == ColumnKind::index ? sizeof(std::int32_t) : sizeof(double);
}

std::string trace_columns_text() {
  std::string text = "| columns | unit | meaning |\n|---|---|---|\n";
  const auto columns = trace_columns();
  for (std::size_t k = 0; k < columns.size(); ++k) {
    const bool goes_on =
        k > 0 && columns[k - 1].doc == columns[k].doc && columns[k - 1].unit == columns[k].unit;
    const bool ends = k + 1 == columns.size() || columns[k + 1].doc != columns[k].doc ||
                      columns[k + 1].unit != columns[k].unit;
    text += fmt::format("{}`{}`", goes_on ? " " : "| ", columns[k].name);
    if (ends) text += fmt::format(" | {} | {} |\n", columns[k].unit, columns[k].doc);
  }
  return text + "| `every` | 1 | in CSV alone, of `replay --every N`: N, where that is not 1 |\n";
}

}  // namespace fingerpad
