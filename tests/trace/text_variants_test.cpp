// Motions and traces as CSV from other programs and systems: read exactly right, or refused.
#include "support/text_variants.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "motion/motion.hpp"
#include "support/paths.hpp"
#include "trace/csv_rows.hpp"
#include "trace_rows.hpp"

namespace fingerpad::text_variants_test {
namespace {

std::string written(const std::string& name, const std::string& text) {
  const auto path = test::scratch_dir() / name;
  std::ofstream(path, std::ios::binary) << text;
  return path.string();
}

TEST(TraceTextVariants, AreReadExactlyRightOrRefused) {
  const auto rows = test::some_rows(9);
  const auto columns = csv_columns({});
  std::string text = csv_header(columns);
  for (const TickRecord& row : rows) append_csv_row(text, columns, row);
  for (const test::TextVariant& variant : test::text_variants()) {
    SCOPED_TRACE(variant.name);
    try {
      const Trace trace = read_trace(written("t.csv", variant.of(text)));
      // A row that lacks its line end is none, and that is told.
      const bool lacks_row = std::string(variant.name) == "no last end";
      std::vector<TickRecord> whole = rows;
      if (lacks_row) whole.pop_back();
      EXPECT_TRUE(test::same_rows(trace.rows, whole));
      EXPECT_TRUE(trace.complete || !variant.must_read || lacks_row);
      EXPECT_FALSE(trace.complete && lacks_row);
    } catch (const Error& error) {
      const std::string name = variant.name;
      EXPECT_EQ(error.kind(), ErrorKind::refused);
      EXPECT_FALSE(variant.must_read && name.find("feed") == name.npos && name != "blanks before ends")
          << error.what();
    }
  }
}

TEST(MotionTextVariants, AreReadExactlyRightOrRefused) {
  const std::string text = "t_s, x_m, y_m, z_m, note\n0, 1, 2, 3, a\n1, 4, 5, 6, b\n2, 7, 8, 9, c\n";
  Points expected(3, 3);
  expected << 1, 4, 7, 2, 5, 8, 3, 6, 9;
  for (const test::TextVariant& variant : test::text_variants()) {
    SCOPED_TRACE(variant.name);
    try {
      const Motion motion = read_motion_csv(written("m.csv", variant.of(text)));
      EXPECT_EQ(motion.t_s, (std::vector<double>{0, 1, 2}));
      EXPECT_EQ(motion.p_WQ, expected);
    } catch (const Error& error) {
      const std::string name = variant.name;
      EXPECT_EQ(error.kind(), ErrorKind::refused);
      EXPECT_FALSE(variant.must_read && name.find("feed") == name.npos && name.find("vertical") == name.npos)
          << error.what();
    }
  }
}

}  // namespace
}  // namespace fingerpad::text_variants_test
