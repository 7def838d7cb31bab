#include "app/columns_option.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "base/error.hpp"
#include "trace/trace_column.hpp"

namespace fingerpad {

void refuse_columns_as_inputs(const std::vector<std::string>& inputs, const std::string& columns) {
  if (columns.empty()) return;
  const auto known = trace_columns();
  for (const std::string& input : inputs) {
    const auto is_it = [&](const TraceColumn& column) { return column.name == input; };
    std::error_code none;
    if (std::ranges::none_of(known, is_it) || std::filesystem::exists(input, none)) continue;
    throw Error(
        ErrorKind::usage, "--columns",
        fmt::format("'{}' stands apart from {}, and so for a file; commas part columns, without blanks: "
                    "{}{}{}",
                    input, columns, columns, columns.ends_with(',') ? "" : ",", input));
  }
}

}  // namespace fingerpad
