#include "trace/trace_glance.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "support/paths.hpp"
#include "trace/csv_rows.hpp"
#include "trace/file_seal.hpp"
#include "trace/trace_column.hpp"

namespace fingerpad::trace_glance_test {
namespace {
namespace fs = std::filesystem;

bool looks_whole_with(const std::string& bytes) {
  const fs::path path = test::scratch_dir() / "t";
  std::ofstream(path, std::ios::binary) << bytes;
  return looks_whole(path.string());
}

TEST(TraceGlance, SeesWhereACsvLacksItsHeaderOrItsEnd) {
  const std::string whole = csv_header(trace_columns()), some = "t_s,fn_n\n";
  EXPECT_TRUE(looks_whole_with(whole));
  EXPECT_TRUE(looks_whole_with(some + "0,1\n"));
  EXPECT_FALSE(looks_whole_with(some + "0,1"));
  EXPECT_FALSE(looks_whole_with(whole.substr(0, whole.size() - 1)));
  EXPECT_FALSE(looks_whole_with("income,year\n1,2026\n"));
  EXPECT_FALSE(looks_whole_with(""));
}

TEST(TraceGlance, SeesWhereAnHdf5FileLacksItsSealOrItsLength) {
  const fs::path path = test::scratch_dir() / "t";
  const std::string contents = "\x89HDF\r\n\x1a\n and columns";
  std::ofstream(path, std::ios::binary) << contents;
  EXPECT_FALSE(looks_whole(path.string())) << "no seal: read_trace must tell";
  seal_file(path.string());
  EXPECT_TRUE(looks_whole(path.string()));
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  const std::string sealed = text.str();
  EXPECT_FALSE(looks_whole_with(sealed.substr(0, sealed.size() - 1)));
  EXPECT_FALSE(looks_whole_with(sealed + "\n"));
  EXPECT_FALSE(looks_whole_with(contents + "." + sealed.substr(contents.size())))
      << "a byte more than was sealed";
}

}  // namespace
}  // namespace fingerpad::trace_glance_test
