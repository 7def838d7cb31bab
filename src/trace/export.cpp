#include "trace/export.hpp"

#include <fmt/format.h>

#include <bit>
#include <cstdint>
#include <cstring>
#include <functional>
#include <limits>
#include <utility>

#include "base/error.hpp"
#include "trace/csv_rows.hpp"
#include "trace/output_file.hpp"
#include "trace/trace_column.hpp"

namespace fingerpad {
namespace {

static_assert(std::endian::native == std::endian::little, "VTP bytes are written as they lie in memory");

/// Bytes as base64 (RFC 4648).
std::string base64(std::string_view bytes) {
  constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  out.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t triple = 0;
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
    for (std::size_t k = 0; k < 3; ++k) {
      triple = triple << 8 | (k < count ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    }
    for (std::size_t k = 0; k < 4; ++k) out += k <= count ? digits[triple >> (18 - 6 * k) & 63u] : '=';
  }
  return out;
}

/// The arrays of a VTP file: their tags now, their bytes at its end (base64, since text has no agreed way to
/// say nan).
class VtpArrays {
 public:
  template <typename Number>
  void add(std::string_view name, std::string_view type, int components, const std::vector<Number>& values) {
    tags_ += fmt::format(
        "        <DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"appended\" "
        "offset=\"{}\"/>\n",
        type, name, components, data_.size());
    const std::uint64_t size = values.size() * sizeof(Number);
    std::string bytes(sizeof(size) + size, '\0');
    std::memcpy(bytes.data(), &size, sizeof(size));
    if (size > 0) std::memcpy(bytes.data() + sizeof(size), values.data(), size);
    data_ += base64(bytes);
  }
  /// The tags since the last call.
  std::string take_tags() { return std::exchange(tags_, {}); }
  const std::string& data() const { return data_; }

 private:
  std::string tags_, data_;
};

void add_column(VtpArrays& arrays, const Trace& trace, const TraceColumn& column) {
  const auto gather = [&]<typename Number>(std::string_view type, Number) {
    std::vector<Number> values;
    values.reserve(trace.rows.size());
    for (const TickRecord& row : trace.rows) values.push_back(static_cast<Number>(column.get(row)));
    arrays.add(column.name, type, 1, values);
  };
  if (column.kind == ColumnKind::phase) {
    gather("UInt8", std::uint8_t{});
  } else if (column.kind == ColumnKind::index) {
    gather("Int32", std::int32_t{});
  } else {
    gather("Float64", double{});
  }
}

void add_vectors(VtpArrays& arrays, const Trace& trace, std::string_view name, Vec3 TickRecord::*member) {
  std::vector<double> values;
  values.reserve(3 * trace.rows.size());
  for (const TickRecord& row : trace.rows) {
    const Vec3& vector = row.*member;
    values.insert(values.end(), vector.data(), vector.data() + 3);
  }
  arrays.add(name, "Float64", 3, values);
}

}  // namespace

void export_csv(const Trace& trace, const std::string& path) {
  OutputFile file(path);
  const auto columns = csv_columns(trace.info);
  const std::uint64_t every = trace.info.every;
  std::string text = csv_header(columns, every);
  for (const TickRecord& row : trace.rows) {
    append_csv_row(text, columns, row, every);
    if (text.size() < std::size_t{1} << 20) continue;
    file.write(text);
    text.clear();
  }
  file.write(text);
  file.commit();
}

void export_vtp(const Trace& trace, const std::string& path) {
  VtpArrays arrays;
  for (const TraceColumn& column : trace_columns(trace.info)) add_column(arrays, trace, column);
  add_vectors(arrays, trace, "force_n", &TickRecord::force_W_n);
  add_vectors(arrays, trace, "friction_n", &TickRecord::friction_W_n);
  const std::string point_data = arrays.take_tags();
  add_vectors(arrays, trace, "Points", &TickRecord::p_WQ);
  const std::string points = arrays.take_tags();
  const auto count = static_cast<std::int64_t>(trace.rows.size());
  std::vector<std::int64_t> connectivity;
  for (std::int64_t i = 0; i < count; ++i) connectivity.push_back(i);
  std::vector<std::int64_t> line_ends;
  if (count > 0) line_ends.push_back(count);
  arrays.add("connectivity", "Int64", 1, connectivity);
  arrays.add("offsets", "Int64", 1, line_ends);
  const std::string lines = arrays.take_tags();

  OutputFile file(path);
  file.write(fmt::format(
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n"
      "  <PolyData>\n    <Piece NumberOfPoints=\"{}\" NumberOfVerts=\"0\" NumberOfLines=\"{}\" "
      "NumberOfStrips=\"0\" "
      "NumberOfPolys=\"0\">\n      <PointData>\n{}      </PointData>\n      <Points>\n{}      </Points>\n    "
      "  <Lines>\n{}"
      "      </Lines>\n    </Piece>\n  </PolyData>\n  <AppendedData encoding=\"base64\">\n   _",
      count, line_ends.size(), point_data, points, lines));
  file.write(arrays.data());
  file.write("\n  </AppendedData>\n</VTKFile>\n");
  file.commit();
}

}  // namespace fingerpad
