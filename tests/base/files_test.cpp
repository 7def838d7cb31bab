#include <gtest/gtest.h>

#include <fstream>

#include "base/content_hash.hpp"
#include "base/csv_cell.hpp"
#include "base/csv_columns.hpp"
#include "base/error.hpp"
#include "base/unit.hpp"
#include "support/paths.hpp"

namespace fingerpad::files_test {
namespace {

std::string write(const std::string& name, const std::string& text) {
  const auto path = test::scratch_dir() / name;
  std::ofstream(path, std::ios::binary) << text;
  return path.string();
}

std::string refusal(const std::string& path, const std::vector<std::string_view>& required) {
  try {
    read_csv_columns(path, required);
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::refused);
    return error.what();
  }
  return "";
}

TEST(CsvColumns, AreFoundByNameWhateverTheirOrder) {
  const auto path = write("a.csv", "\xef\xbb\xbfy_m, x_m ,word\r\n1,2,blue\r\n\r\n3,4e0,red\r\n");
  const CsvColumns table = read_csv_columns(path, {"x_m", "y_m"}, {"dx"});
  EXPECT_EQ(table.columns[0], (std::vector<double>{2, 4}));
  EXPECT_EQ(table.columns[1], (std::vector<double>{1, 3}));
  EXPECT_FALSE(table.present[2]);
  EXPECT_EQ(table.lines, (std::vector<long>{2, 4}));
}

TEST(CsvColumns, TellTheLineOfWhatIsWrong) {
  EXPECT_NE(refusal(write("b.csv", "x_m\n1\nzwei\n"), {"x_m"}).find("b.csv:3: 'zwei'"), std::string::npos);
  EXPECT_NE(refusal(write("c.csv", "a,x_m\n1\n"), {"x_m"}).find("c.csv:2: has 1 cells"), std::string::npos);
  EXPECT_NE(refusal(write("d.csv", "x_m\ninf\n"), {"x_m"}).find("d.csv:2: column 'x_m' is not finite"),
            std::string::npos);
  EXPECT_NE(refusal(write("e.csv", "x\n1\n"), {"x_m"}).find("e.csv:1: no column 'x_m'"), std::string::npos);
  EXPECT_NE(refusal(write("f.csv", ""), {"x_m"}).find("is empty"), std::string::npos);
  EXPECT_NE(refusal("/nowhere/g.csv", {"x_m"}).find("cannot be read"), std::string::npos);
}

TEST(CsvColumns, PartedByAnotherMarkAreToldSo) {
  for (const auto& [header, mark] :
       {std::pair("t_s;x_m\n0;1\n", "';'"), std::pair("t_s\tx_m\n0\t1\n", "tabs")}) {
    const std::string told = refusal(write("s.csv", header), {"t_s", "x_m"});
    EXPECT_NE(told.find(std::string("s.csv:1: its cells are parted by ") + mark), std::string::npos) << told;
    EXPECT_NE(told.find("with commas"), std::string::npos) << told;
  }
  EXPECT_NE(refusal(write("n.csv", "t;x\n0;1\n"), {"t_s"}).find("no column 't_s'"), std::string::npos);
}

TEST(CsvColumns, ThatAreThereTwiceAreRefused) {
  const std::string told = refusal(write("d.csv", "x_m,y_m, x_m\n1,2,3\n"), {"y_m", "x_m"});
  EXPECT_NE(told.find("d.csv:1: names the column 'x_m' twice, in cells 1 and 3"), std::string::npos) << told;
  EXPECT_EQ(refusal(write("o.csv", "x_m,word,word\n1,a,b\n"), {"x_m"}), "") << "others do not matter";
}

TEST(CsvColumns, WithAZeroByteInACellAreToldToTheEnd) {
  const std::string text("x_m\n1\0ab\n", 9);
  EXPECT_NE(refusal(write("z.csv", text), {"x_m"}).find("z.csv:2: '1\\x00ab' in column 'x_m'"),
            std::string::npos);
}

TEST(CsvCell, IsQuotedOnlyWhereItMustBe) {
  EXPECT_EQ(csv_cell("plain words"), "plain words");
  EXPECT_EQ(csv_cell("one, two"), "\"one, two\"");
  EXPECT_EQ(csv_cell("a \"word\""), "\"a \"\"word\"\"\"");
  EXPECT_EQ(csv_cell("two\nlines"), "two\\nlines");
}

TEST(ContentHash, IsFnv1a) {
  // The published test vectors of FNV-1a, 64 bits.
  EXPECT_EQ(file_hash(write("empty", "")), "cbf29ce484222325");
  EXPECT_EQ(file_hash(write("a", "a")), "af63dc4c8601ec8c");
  EXPECT_EQ(file_hash(write("foobar", "foobar")), "85944171f73967e8");
}

TEST(Units, AreThoseOfTheContractAndMicrometres) {
  EXPECT_EQ(metres_per_unit("m").value(), 1);
  EXPECT_EQ(metres_per_unit("mm").value(), 1e-3);
  EXPECT_EQ(metres_per_unit("cm").value(), 1e-2);
  EXPECT_EQ(metres_per_unit("in").value(), 0.0254);
  EXPECT_EQ(metres_per_unit("um").value(), 1e-6);
  EXPECT_FALSE(metres_per_unit("ft").has_value());
}

}  // namespace
}  // namespace fingerpad::files_test
