#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "trace/trace_column.hpp"

namespace fingerpad {

/// A recording whose end is not known is written in chunks of so many rows. None has more than the most.
inline constexpr std::uint64_t open_chunk_rows = 1024, most_chunk_rows = 16384;

/// The rows of a chunk of a trace that will have so many, 0 where that is not known: few large chunks, of
/// which the last is nearly full too. (A call of HDF5 costs as much as some thousand numbers.)
std::uint64_t chunk_rows_for(std::uint64_t rows_to_come) noexcept;

/// Rows turned into columns, as HDF5 keeps them: the chunk of each column that is under way.
class ColumnChunks {
 public:
  ColumnChunks(std::vector<TraceColumn> columns, std::uint64_t chunk_rows);

  /// Takes rows as far as the chunk has room.
  /// @returns how many
  std::size_t add(std::span<const TickRecord> rows);
  /// Begins the next chunk.
  void begin() noexcept { rows_ = 0; }
  /// Puts zeros behind the rows.
  void clear_rest() noexcept;

  std::uint64_t row_count() const noexcept { return rows_; }
  std::uint64_t chunk_rows() const noexcept { return chunk_rows_; }
  bool is_full() const noexcept { return rows_ == chunk_rows_; }
  std::span<const TraceColumn> columns() const noexcept { return columns_; }
  /// All of column k's chunk, what lies behind its rows too.
  std::span<const std::byte> chunk(std::size_t k) const noexcept { return chunks_[k]; }

 private:
  std::vector<TraceColumn> columns_;
  std::vector<std::vector<std::byte>> chunks_;  // one a column
  std::uint64_t chunk_rows_, rows_ = 0;
};

}  // namespace fingerpad
