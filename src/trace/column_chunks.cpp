#include "trace/column_chunks.hpp"

#include <algorithm>

namespace fingerpad {

std::uint64_t chunk_rows_for(std::uint64_t rows_to_come) noexcept {
  if (rows_to_come == 0) return open_chunk_rows;
  const std::uint64_t chunks = (rows_to_come + most_chunk_rows - 1) / most_chunk_rows;
  return (rows_to_come + chunks - 1) / chunks;
}

ColumnChunks::ColumnChunks(std::vector<TraceColumn> columns, std::uint64_t chunk_rows)
    : columns_(std::move(columns)), chunk_rows_(chunk_rows) {
  chunks_.reserve(columns_.size());
  for (const TraceColumn& column : columns_) chunks_.emplace_back(chunk_rows * kept_bytes(column.kind));
}

std::size_t ColumnChunks::add(std::span<const TickRecord> rows) {
  constexpr std::size_t at_a_time = 64;  // that stay in the processor's nearest memory for all columns
  const std::size_t count = std::min<std::size_t>(rows.size(), chunk_rows_ - rows_);
  for (std::size_t first = 0; first < count; first += at_a_time) {
    const std::span<const TickRecord> some = rows.subspan(first, std::min(at_a_time, count - first));
    for (std::size_t k = 0; k < columns_.size(); ++k)
      columns_[k].gather(some, chunks_[k].data() + rows_ * kept_bytes(columns_[k].kind));
    rows_ += some.size();
  }
  return count;
}

void ColumnChunks::clear_rest() noexcept {
  for (std::size_t k = 0; k < columns_.size(); ++k) {
    const auto rest = chunks_[k].begin() + static_cast<std::ptrdiff_t>(rows_ * kept_bytes(columns_[k].kind));
    std::fill(rest, chunks_[k].end(), std::byte{0});
  }
}

}  // namespace fingerpad
