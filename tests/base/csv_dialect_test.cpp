#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "base/csv_columns.hpp"
#include "base/error.hpp"
#include "base/unit_row.hpp"
#include "support/paths.hpp"
#include "support/refusal.hpp"

namespace fingerpad::csv_dialect_test {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;

CsvColumns read(const std::string& text, char separator = found_separator, char decimal = '.',
                bool takes_lines_above = false) {
  const auto path = test::scratch_dir() / "t.csv";
  std::ofstream(path, std::ios::binary) << text;
  CsvRequest request{{"t", "x"}, {"f"}, {separator, decimal}};
  request.mend = "map it";
  request.decimal_key = "decimal = \"{0}\" in [motion] (fit: --decimal {0})";
  request.takes_lines_above = takes_lines_above;
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

CsvColumns angled(const std::string& text, char separator = found_separator) {
  const auto path = test::scratch_dir() / "angled.csv";
  std::ofstream(path, std::ios::binary) << text;
  return read_csv_columns(path.string(), {{"<T>", "<X>"}, {}, {separator, '.'}});
}

TEST(CsvDialect, NamesInAngleBracketsAreNoXml) {
  for (const char* mark : {",", ";", "\t", " ,"}) {
    const std::string text = std::string("<T>") + mark + "<X>\n1" + mark + "2\n";
    EXPECT_THAT(angled(text).columns[1], ElementsAre(2)) << text;
  }
  EXPECT_THAT(angled("<T> <X>\n1 2\n", ' ').columns[1], ElementsAre(2));
  for (const char* text :
       {"<?xml version=\"1.0\"?>\n<a/>\n", "<!-- a, b -->\n<a/>\n", "<a>\n<x>1</x>\n</a>\n", "<a>1,2</a>\n",
        "<a b=\"1,2\" c=\"3;4\">\n</a>\n", "<a\n b=\"1\"/>\n"})
    EXPECT_THAT(refusal(text), HasSubstr("is XML and no table")) << text;
  EXPECT_EQ(refusal("<,t,x\n1,2,3\n"), "taken") << "a column called <";
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
              HasSubstr("is no number; with decimal = \",\" in [motion] (fit: --decimal ,) it would be one"));
  EXPECT_THAT(refusal("t;x\n0;1.5\n", ';', ','),
              HasSubstr("with decimal = \".\" in [motion] (fit: --decimal .) it would be one"));
  EXPECT_THAT(refusal("t;x\n0;a\n1;1\n"), Not(HasSubstr("would be one")));
}

TEST(CsvDialect, WithoutAWayToSayTheDecimalMarkNoneIsNamed) {
  const auto path = test::scratch_dir() / "t.csv";
  const auto why_not = [&](const std::string& text) {
    std::ofstream(path) << text;
    return test::why_not([&] { read_csv_columns(path.string(), {"t", "x"}); });
  };
  EXPECT_THAT(why_not("t,x\n0,\"1,5\"\n"),
              EndsWith("'1,5' in column 'x' is no number; its decimal mark must be ."));
  EXPECT_THAT(why_not("t,x\n0,5,1,5\n"), EndsWith("between cells: write decimal points"));
}

TEST(CsvDialect, ACommaCannotPartCellsAndMarkDecimalsToo) {
  EXPECT_EQ(
      refusal("t,x\n0,1.5\n", found_separator, ','),
      (test::scratch_dir() / "t.csv").string() +
          ":1: its cells are parted by ',', which cannot be the decimal mark as well: leave the decimal "
          "mark out where its numbers have points, else part its cells by ;");
}

TEST(CsvDialect, ALastRowWithoutItsEndIsLeftOutWhereTheRequestWantsItSo) {
  const auto path = test::scratch_dir() / "t.csv";
  const auto rows_of = [&](const std::string& text, bool leaves_out) {
    std::ofstream(path) << text;
    CsvRequest request{{"t", "x"}};
    request.takes_units = true;
    request.leaves_out_cut_row = leaves_out;
    const CsvColumns table = read_csv_columns(path.string(), request);
    return std::to_string(table.lines.size()) + " " + table.cut;
  };
  const std::string words = "), which is left out: its last number may lack digits";
  EXPECT_EQ(rows_of("t,x\n1,2\n3,4", false), "2 ");
  EXPECT_EQ(rows_of("t,x\n1,2\n3,4", true), "1 ends within a row (line 3" + words);
  EXPECT_EQ(rows_of("t,x\n1,2\n3,4\n", true), "2 ");
  EXPECT_EQ(rows_of("t,x\n1,2", true), "0 ends within a row (line 2" + words) << "the one that was looked at";
  EXPECT_EQ(rows_of("# t,x\n1,2", true), "0 ends within a row (line 2" + words) << "NumPy's";
}

TEST(CsvDialect, ALastRowThatIsRefusedSaysThatItMayHaveBeenCutOff) {
  constexpr const char* cut =
      "; it is the last line and has no line end, as where a file was cut off: leave the line out";
  EXPECT_THAT(refusal("t,x\n1,2\n3"),
              AllOf(HasSubstr("3: has 1 cells, but column 'x' is number 2"), EndsWith(cut)));
  EXPECT_THAT(refusal("t,x\n1,2\n3,-"), EndsWith(cut));
  EXPECT_THAT(refusal("t,x\n1,2\n3,"), EndsWith(cut));
  EXPECT_THAT(refusal("t,x\n1,2\n3\n"), Not(HasSubstr("cut off")));
}

TEST(CsvDialect, AUnitInACellIsNamed) {
  EXPECT_THAT(
      refusal("t,x\n0,10 mm\n"),
      HasSubstr("t.csv:2: '10 mm' in column 'x' is no number; leave 'mm' out: cells hold numbers alone"));
  EXPECT_THAT(refusal("t,x\n0,1.5m\n"), HasSubstr("leave 'm' out"));
  EXPECT_THAT(refusal("t,x\n0,1.2.3\n"), Not(HasSubstr("leave")));
  EXPECT_THAT(refusal("t,x\n0,1e\n"), HasSubstr("leave 'e' out"));
}

TEST(CsvDialect, ATableWithoutAHeaderIsToldSo) {
  EXPECT_THAT(refusal("0,1\n1,2\n"),
              HasSubstr("t.csv:1: no column 't'; its header must name the columns t,x, "
                        "and it names 0, 1: put a line of names above these numbers"));
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

CsvColumns read_below(const std::string& text, char separator = found_separator, char decimal = '.') {
  return read(text, separator, decimal, true);
}
std::string refusal_below(const std::string& text, char separator = found_separator, char decimal = '.') {
  return test::why_not([&] { read_below(text, separator, decimal); });
}

TEST(CsvDialect, WhatAProgramSaysAboveTheHeaderIsPassedOver) {
  const CsvColumns table =
      read_below("Sensor: ATI, Nano17\n2026-03-01, 12:30\nsubject\t7\n\nnote,x\nt;x;f\n1;2;3\n4;5;6\n");
  EXPECT_THAT(table.columns[1], ElementsAre(2, 5));
  EXPECT_THAT(table.lines, ElementsAre(7, 8));
  EXPECT_THAT(table.names, ElementsAre("t", "x", "f"));
  EXPECT_EQ(table.separator, ';');
  EXPECT_EQ(table.above, "its header is line 6, and what stands above that is passed over");
  EXPECT_EQ(read_below("rig 3\nt,x\n1,2\n", ',').lines.size(), 1u);
  EXPECT_EQ(read_below("t,x\n1,2\n").above, "");
  EXPECT_EQ(read_below("# rig, 3\nt,x\n1,2\n").above, "") << "a comment";
  EXPECT_THAT(read_below("made by rig 3\nchannels are t x f\nt x f\n1 2 3\n").lines, ElementsAre(4))
      << "blanks part any sentence";
  EXPECT_THAT(refusal("rig 3\nt,x\n1,2\n"), HasSubstr("t.csv:1: no column 't'")) << "where nobody is told";
}

TEST(CsvDialect, BelowWhatAProgramSaysTheLineOfNamesIsToldThatLacksOne) {
  // The line above the numbers, of as many cells; and above its units.
  EXPECT_THAT(
      refusal_below("Sensor: ATI, Nano17\nsubject,7,9,1\nTime,x\n1,2\n"),
      HasSubstr("t.csv:3: no column 't'; its header must name the columns t,x, and it names Time, x"));
  EXPECT_THAT(refusal_below("made by a rig\nTime;x\ns;mm\n1,5;2\n", found_separator, ','),
              HasSubstr("t.csv:2: no column 't'"));
  EXPECT_THAT(
      refusal_below("Sensor: ATI, Nano17\nTime (s)\tX pos\n1\t2\n"),
      HasSubstr("t.csv:2: no column 't'; its header must name the columns t,x, and it names Time (s)"))
      << "blanks part cells that tabs do, too";
  EXPECT_THAT(refusal_below("Sensor: ATI, Nano17\nsubject,7\n"), HasSubstr("t.csv:1: no column 't'"));
  std::string far(2000, '\n');
  for (int k = 0; k < 300; ++k) far += "a word\n";
  EXPECT_THAT(refusal_below(far + "t,x\n1,2\n"), HasSubstr("t.csv:2001: no column 't'"))
      << "a table, and not a text, is looked for";
  const std::string long_line = std::string(70000, 'a') + "\n";
  EXPECT_THAT(refusal_below("rig\n" + long_line + "t,x\n1,2\n"), HasSubstr("t.csv:1: no column 't'"));
}

TEST(CsvDialect, AHeaderThatIsNotFoundIsNotToldAsCutOff) {
  const auto path = test::scratch_dir() / "t.csv";
  std::ofstream(path) << "Time,X\n10:00:00,1\n10:00:01,2";
  CsvRequest request{{"t", "x"}};
  request.takes_lines_above = request.leaves_out_cut_row = true;
  EXPECT_THAT(test::why_not([&] { read_csv_columns(path.string(), request); }),
              HasSubstr("t.csv:1: no column 't'"));
  std::ofstream(path) << "rig 3\nt,x";
  EXPECT_THAT(test::why_not([&] { read_csv_columns(path.string(), request); }),
              HasSubstr("ends within its header (line 2)"));
}

TEST(CsvDialect, ARowThatEndsWithinANumberThatIsReadIsRefused) {
  EXPECT_THAT(
      refusal("t,x,more\n0,1,2\n1,1\n2,1,2\n"),
      HasSubstr("t.csv:3: has 2 cells, where rows above have 3, and the number in its last, of column "
                "'x', may be cut"));
  EXPECT_EQ(refusal("t,x,remark\n0,1\n1,1\n"), "taken") << "none has the last";
  EXPECT_EQ(refusal("t,x,more,last\n0,1,2\n"), "taken") << "what is read is whole";
  EXPECT_EQ(refusal("t,x,more\n0,1,\n"), "taken");
}

TEST(CsvDialect, CellsThatPeopleWriteOtherwiseAreToldAsWhatTheyAre) {
  EXPECT_THAT(refusal("t,x\n14:02:11.5,1\n"), HasSubstr("a time of day is not read: write seconds"));
  EXPECT_THAT(refusal("t;x\n0;4,000\n"),
              HasSubstr("if , parts thousands in it, take it out of all cells; only if it is a decimal mark, "
                        "say decimal = \",\""));
  EXPECT_THAT(refusal("t;x\n0;-12.345.678\n", ';', ','), HasSubstr("if . parts thousands"));
  for (const char* cell : {"0,123", "1234,567", "1,5", "1,2345"})
    EXPECT_THAT(refusal(std::string("t;x\n0;") + cell + "\n"), Not(HasSubstr("thousands"))) << cell;
  EXPECT_THAT(refusal(std::string("PK\x03\x04\x14\0\x06\0\n", 9)),
              HasSubstr("Excel's .xlsx is: save it as CSV"));
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

CsvColumns with_units(const std::string& text) {
  const auto path = test::scratch_dir() / "t.csv";
  std::ofstream(path, std::ios::binary) << text;
  CsvRequest request{{"t", "x"}, {"f"}};
  request.takes_gaps = request.takes_units = true;
  return read_csv_columns(path.string(), request);
}

TEST(CsvDialect, ARowOfUnitsIsReadWhereItIsAskedFor) {
  const CsvColumns table = with_units("f,t,x\n# by hand\n-,[s],(mm)\n1,2,3\n4,5,6\n");
  EXPECT_THAT(table.units.words, ElementsAre("s", "mm", "-"));
  EXPECT_THAT(table.units.place, HasSubstr("t.csv:3"));
  EXPECT_THAT(table.columns[1], ElementsAre(3, 6));
  EXPECT_THAT(table.lines, ElementsAre(4, 5));
  for (const char* text : {"f,t,x\n1,2,3\n4,5,6\n", "f,t,x\nNA,NA,NA\n4,5,6\n", "f,t,x\n,,\n4,5,6\n"}) {
    const CsvColumns plain = with_units(text);
    EXPECT_THAT(plain.units.words, testing::IsEmpty()) << text;
    EXPECT_EQ(plain.columns[1].size(), 2U) << text;
  }
}

TEST(CsvDialect, AUnitMayHoldADigitAndARowOfUnitsHasACellAColumn) {
  EXPECT_THAT(with_units("t,x,f\ns,m s^-1,m.s-1\n1,2,3\n").units.words, ElementsAre("s", "m s^-1", "m.s-1"));
  EXPECT_THAT(with_units("t,x,f,k\ns,mm,-\n1,2,3,4\n").units.words, ElementsAre("s", "mm", "-"));
  const auto why = [](const std::string& text) { return test::why_not([&] { with_units(text); }); };
  EXPECT_THAT(why("t,x,f\ns,mm\n1,2,3\n"),
              HasSubstr("t.csv:2: looks like a row of units, with 2 cells where the header has 3"));
  EXPECT_THAT(why("t,x\ns,mm,N\n1,2\n"), HasSubstr("with 3 cells where the header has 2"));
  EXPECT_THAT(why("t,x,f\n2mm,3mm,4mm\n1,2,3\n"), HasSubstr("'2mm' in column 't' is no number"));
}

TEST(UnitRow, ASpeedIsALengthInATime) {
  for (const char* word : {"mm/s", "mm s^-1", "mm.s-1", "mm\u00b7s\u207b\u00b9"})
    EXPECT_EQ(si_per_unit(Quantity::speed, word), 1e-3) << word;
  for (const char* word : {"mm", "mm.s", "s^-1", "mm/min"})
    EXPECT_EQ(si_per_unit(Quantity::speed, word), std::nullopt) << word;
}

TEST(UnitRow, AUnitInAColumnsNameIsHeldAgainstTheRow) {
  const auto why = [](Quantity quantity, const char* word, const char* name) {
    return test::why_not([&] {
      told_unit({{word}, "t.csv:2"}, {name}, {quantity, {0}, false, 1, "--unit"});
    });
  };
  const auto contradicts = HasSubstr("whose name says another unit: put # before the line, and say --unit");
  EXPECT_THAT(why(Quantity::length, "m", "x_mm"), contradicts);
  EXPECT_THAT(why(Quantity::time, "s", "t_ms"), contradicts);
  EXPECT_THAT(why(Quantity::force, "N", "F_mN"), contradicts);
  EXPECT_THAT(why(Quantity::torque, "N mm", "tx_n_m"), contradicts);
  EXPECT_EQ(why(Quantity::length, "mm", "x_mm"), "taken");
  EXPECT_EQ(why(Quantity::length, "mm", "pos_x"), "taken");
}

TEST(UnitRow, WhereAUnitCannotBeSaidTheColumnIsToBeTurned) {
  const auto why = [](const char* word, const char* name) {
    return test::why_not([&] {
      told_unit({{word}, "t.csv:2"}, {name}, {Quantity::force, {0}, false, 1, ""});
    });
  };
  EXPECT_THAT(why("V", "F"), HasSubstr("turn the column into newtons and put # before the line"));
  EXPECT_THAT(why("mN", "fn_n"), HasSubstr("turn the column into newtons and put # before the line"));
}

TEST(UnitRow, SaysTheUnitOfAGroupOrWhatToDo) {
  const UnitRow row{{"ms", "mm", "mm", "furlong", "-", "N mm", "\u00b5s"}, "t.csv:2"};
  const std::vector<std::string_view> names{"t", "x", "y", "z", "k", "tx", "x_m"};
  const auto unit = [&](Quantity quantity, std::vector<std::size_t> columns, bool is_said = false,
                        double said = 1) {
    return told_unit(row, names, {quantity, std::move(columns), is_said, said, "--unit"}).value_or(said);
  };
  EXPECT_EQ(unit(Quantity::time, {0}), 1e-3);
  EXPECT_EQ(unit(Quantity::time, {6}), 1e-6);
  EXPECT_EQ(unit(Quantity::length, {1, 2, 4}), 1e-3);
  EXPECT_EQ(unit(Quantity::torque, {5}), 1e-3);
  EXPECT_EQ(unit(Quantity::force, {4}), 1);  // says nothing
  const auto why = [&](Quantity quantity, std::vector<std::size_t> columns, bool is_said = false,
                       double said = 1) {
    return test::why_not([&] { unit(quantity, std::move(columns), is_said, said); });
  };
  EXPECT_THAT(why(Quantity::length, {3}),
              AllOf(HasSubstr("t.csv:2"), HasSubstr("'furlong' below 'z'"), HasSubstr("m, mm, cm, in"),
                    HasSubstr("put # before the line, and say --unit")));
  EXPECT_THAT(why(Quantity::length, {1}, true, 1e-2), HasSubstr("--unit says another unit"));
  EXPECT_EQ(why(Quantity::length, {1}, true, 1e-3), "taken");
  const UnitRow mixed{{"mm", "m"}, "t.csv:2"};
  EXPECT_THAT(test::why_not([&] {
                told_unit(mixed, {"x", "y"}, {Quantity::length, {0, 1}, false, 1, ""});
              }),
              HasSubstr("which all have one unit"));
  EXPECT_THAT(test::why_not([&] {
                told_unit(mixed, {"x_m", "y_m"}, {Quantity::length, {0}, false, 1, ""});
              }),
              HasSubstr("whose name says another unit"));
}

/// A spreadsheet's "Unicode text", and Western Europe's old tables.
TEST(CsvDialect, AnotherEncodingIsToldSo) {
  const auto wide = [](const std::string& text, bool is_little) {
    std::string bytes;
    for (const char c : text) bytes += is_little ? std::string{c, '\0'} : std::string{'\0', c};
    return bytes;
  };
  for (const bool is_little : {true, false})
    EXPECT_THAT(refusal(wide("t,x\n0,1\n", is_little)), HasSubstr("is a UTF-16 text: save it as UTF-8"));
  EXPECT_THAT(
      refusal("t,Gr\xf6\xdf\n0,1\n"),
      EndsWith("; its header is no UTF-8 (Latin-1?): save the table as UTF-8, or its names are not found"));
  EXPECT_EQ(si_per_unit(Quantity::time, "\xb5s"), 1e-6) << "micro in Latin-1";
  EXPECT_EQ(si_per_unit(Quantity::speed, "\u00b5m/s"), 1e-6);
  EXPECT_EQ(si_per_unit(Quantity::speed, "\u03bcm s^-1"), 1e-6);
  for (const char* micro : {"\u00b5s", "\u03bcs", "us"}) EXPECT_EQ(listed_unit(Quantity::time, micro), "us");
  EXPECT_EQ(listed_unit(Quantity::length, "\u00b5s"), "\u00b5s") << "no length";
  EXPECT_EQ(listed_unit(Quantity::time, "furlong"), "furlong");
  EXPECT_EQ(refusal("# gemessen in Z\xfcrich\nt,x,Gr\xf6\xdf\n0,1,2\n"), "taken")
      << "nothing reads that column";
}

TEST(CsvDialect, AnotherSeparatorThanTheNamedOneIsToldSo) {
  EXPECT_THAT(refusal("t,x\n1,2\n", ';'), HasSubstr("its cells are parted by ',', not by ';'"));
  EXPECT_THAT(refusal("t;x\n1;2\n", ' '), HasSubstr("parted by ';', not by blanks"));
}

}  // namespace
}  // namespace fingerpad::csv_dialect_test
