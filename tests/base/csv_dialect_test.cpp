#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "base/csv_columns.hpp"
#include "base/error.hpp"
#include "support/paths.hpp"
#include "support/refusal.hpp"

namespace fingerpad::csv_dialect_test {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

CsvColumns read(const std::string& text, char separator = found_separator, char decimal = '.') {
  const auto path = test::scratch_dir() / "t.csv";
  std::ofstream(path, std::ios::binary) << text;
  CsvRequest request{{"t", "x"}, {"f"}, {separator, decimal}};
  request.mend = "map it";
  return read_csv_columns(path.string(), request);
}

std::string refusal(const std::string& text, char separator = found_separator, char decimal = '.') {
  return test::why_not([&] { read(text, separator, decimal); });
}

TEST(CsvDialect, IsFoundFromTheHeaderWhereItIsTheOnlyOne) {
  for (const auto& [text, mark] :
       {std::pair("t,x\n1,2\n", ','), std::pair("t;x\n1;2\n", ';'), std::pair("t\tx\n1\t2\n", '\t'),
        std::pair("  t   x\n 1 \t 2  \n", ' '), std::pair("t , x y, x\n1,9,2\n", ',')}) {
    const CsvColumns table = read(text);
    EXPECT_EQ(table.separator, mark) << text;
    EXPECT_THAT(table.columns[0], ElementsAre(1)) << text;
    EXPECT_THAT(table.columns[1], ElementsAre(2)) << text;
  }
  EXPECT_THAT(refusal("t|x\n1|2\n"), HasSubstr("its cells are parted by '|', not by blanks"));
  EXPECT_THAT(refusal("t;,;x;,t,x\n1;2;3;4;5;6\n"),
              HasSubstr("may be parted by ',' or by ';': say separator"));
  EXPECT_EQ(read("t;,;x;,t,x\n1;2;3;4\n", ';').separator, ';');
}

TEST(CsvDialect, HasADecimalComma) {
  const CsvColumns table = read("t;x\n0,5;-1,25e-3\n1;2\n", found_separator, ',');
  EXPECT_THAT(table.columns[0], ElementsAre(0.5, 1));
  EXPECT_THAT(table.columns[1], ElementsAre(-1.25e-3, 2));
  EXPECT_THAT(refusal("t;x\n0;1.234,5\n", ';', ','),
              HasSubstr("t.csv:2: '1.234,5' in column 'x' is no number"));
  EXPECT_THAT(refusal("t;x\n0;1,234,5\n", ';', ','), HasSubstr("is no number"));
  EXPECT_THAT(refusal("t;x\n0;" + std::string(70, '1') + "\n", ';', ','), HasSubstr("is no number"));
}

TEST(CsvDialect, TellsTheDecimalMarkThatWouldDo) {
  EXPECT_THAT(refusal("t;x\n0;1,5\n"),
              HasSubstr("is no number; with decimal = \",\" (--decimal ,) it would be one"));
  EXPECT_THAT(refusal("t;x\n0;1.5\n", ';', ','),
              HasSubstr("with decimal = \".\" (--decimal .) it would be one"));
  EXPECT_THAT(refusal("t;x\n0;a\n1;1\n"), Not(HasSubstr("would be one")));
}

TEST(CsvDialect, QuotedCellsMayHoldTheSeparator) {
  const CsvColumns table = read("\"t\", \"x\" ,\"a, b\"\n\"1\",\"2\",\"3, 4\"\n");
  EXPECT_THAT(table.columns[0], ElementsAre(1));
  EXPECT_THAT(table.columns[1], ElementsAre(2));
  EXPECT_THAT(read("t,x\n\"0,5\",\"1,5\"\n", ',', ',').columns[1], ElementsAre(1.5));
  EXPECT_THAT(refusal("t,x\n\"1,2\n"), HasSubstr("t.csv:2: '\"1' in column 't' is no number"));
}

TEST(CsvDialect, CommentsArePassedOverAndOneMayBeTheHeader) {
  EXPECT_THAT(read("# of the 3rd\n\nt,x\n# pause\n1,2\n").lines, ElementsAre(5));
  const CsvColumns numpy = read("# made by hand\n# t x f\n1 2 3\n4 5 6\n");
  EXPECT_THAT(numpy.columns[0], ElementsAre(1, 4));
  EXPECT_THAT(numpy.columns[2], ElementsAre(3, 6));
  EXPECT_THAT(numpy.lines, ElementsAre(3, 4));
  EXPECT_THAT(refusal("# y z\n1 2\n"), HasSubstr("t.csv:1: no column 't'"));
}

TEST(CsvDialect, AMissingColumnIsToldWithThoseThatAreThereAndTheNearest) {
  EXPECT_THAT(refusal("x;force;T\n1;2;3\n"), HasSubstr("did you mean 'T'?")) << "of its letters";
  EXPECT_THAT(refusal("T;x;force\n1;2;3\n"), AllOf(HasSubstr("t.csv:1: no column 't' (did you mean 'T'?)"),
                                                   HasSubstr("it names T, x, force"), HasSubstr(": map it")));
  EXPECT_THAT(refusal("1;2\n3;4\n"), HasSubstr("it names 1, 2"));
}

TEST(CsvDialect, ARowOfUnitsIsRefusedWithItsLine) {
  EXPECT_THAT(refusal("t;x\n[s];[mm]\n1;2\n"),
              AllOf(HasSubstr("t.csv:2: is a second line of words ('[s]' in column 't')"),
                    HasSubstr("put # before it")));
  EXPECT_THAT(refusal("t;x\n1;2\ns;mm\n"), HasSubstr("t.csv:3: 's' in column 't' is no number"));
}

TEST(CsvDialect, AnotherSeparatorThanTheNamedOneIsToldSo) {
  EXPECT_THAT(refusal("t,x\n1,2\n", ';'), HasSubstr("its cells are parted by ',', not by ';'"));
  EXPECT_THAT(refusal("t;x\n1;2\n", ' '), HasSubstr("parted by ';', not by blanks"));
}

}  // namespace
}  // namespace fingerpad::csv_dialect_test
