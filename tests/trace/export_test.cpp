#include "trace/export.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <map>

#include "support/paths.hpp"
#include "trace/trace_column.hpp"
#include "trace_rows.hpp"

namespace fingerpad::export_test {
namespace {

using testing::HasSubstr;

std::string decoded(const std::string& text) {
  std::string out;
  unsigned bits = 0, held = 0;
  for (const char c : text) {
    const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    const std::size_t digit = digits.find(c);
    if (digit == std::string::npos) break;
    bits = bits << 6 | static_cast<unsigned>(digit);
    held += 6;
    if (held < 8) continue;
    held -= 8;
    out += static_cast<char>(bits >> held & 255u);
  }
  return out;
}

/// The numbers of an array of a VTP file, found by its tag and read as VTK does: offset, byte count, values.
std::vector<double> vtp_array(const std::string& vtp, const std::string& name) {
  const std::size_t tag = vtp.find("Name=\"" + name + "\"");
  if (tag == std::string::npos) return {};
  const std::size_t offset_at = vtp.find("offset=\"", tag) + 8;
  const std::size_t offset = std::stoul(vtp.substr(offset_at));
  const std::size_t data = vtp.find('_', vtp.find("<AppendedData")) + 1;
  const std::string bytes = decoded(vtp.substr(data + offset));
  std::uint64_t size = 0;
  std::memcpy(&size, bytes.data(), 8);
  std::vector<double> values(size / 8);
  std::memcpy(values.data(), bytes.data() + 8, size);
  return values;
}

TEST(ExportVtp, HoldsThePathAndEveryColumn) {
  const auto path = test::scratch_dir() / "t.vtp";
  Trace trace;
  trace.rows = test::some_rows(101);
  export_vtp(trace, path.string());
  const std::string vtp = test::bytes_of(path);
  EXPECT_THAT(vtp, HasSubstr("NumberOfPoints=\"101\""));
  EXPECT_THAT(vtp, HasSubstr("NumberOfLines=\"1\""));
  for (const TraceColumn& column : trace_columns(trace.info)) {
    EXPECT_THAT(vtp, HasSubstr("Name=\"" + std::string(column.name) + "\"")) << column.name;
  }
  const auto times = vtp_array(vtp, "t_s"), depths = vtp_array(vtp, "depth_m"),
             points = vtp_array(vtp, "Points");
  const auto centres = vtp_array(vtp, "cx_m");
  ASSERT_EQ(times.size(), 101u);
  ASSERT_EQ(points.size(), 303u);
  for (std::size_t i = 0; i < trace.rows.size(); ++i) {
    EXPECT_EQ(times[i], trace.rows[i].t_s);
    EXPECT_EQ(depths[i], trace.rows[i].depth_m);
    EXPECT_EQ(points[3 * i], trace.rows[i].p_WQ.x());
    EXPECT_TRUE(test::same_number(centres[i], trace.rows[i].stick_centre_W.x()));
  }
}

TEST(ExportVtp, ATraceWithoutRowsHasNoLine) {
  const auto path = test::scratch_dir() / "t.vtp";
  export_vtp({}, path.string());
  EXPECT_THAT(test::bytes_of(path),
              HasSubstr("NumberOfPoints=\"0\" NumberOfVerts=\"0\" NumberOfLines=\"0\""));
}

TEST(Export, APlaceThatCannotBeWrittenIsTheCallersFault) {
  for (const auto& write : {export_csv, export_vtp}) {
    try {
      write({}, "/no/such/folder/t");
      FAIL();
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::usage);
    }
  }
}

TEST(Export, AFullDeviceIsAFault) {
  Trace trace;
  trace.rows = test::some_rows(100);
  EXPECT_THROW(export_csv(trace, "/dev/full"), Error);
}

}  // namespace
}  // namespace fingerpad::export_test
