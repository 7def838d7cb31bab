#include "base/input_file.hpp"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>
#include <thread>

#include "base/csv_columns.hpp"
#include "base/error.hpp"
#include "base/path_words.hpp"
#include "base/printable_text.hpp"
#include "base/text_lines.hpp"
#include "support/paths.hpp"

namespace fingerpad::input_file_test {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr InputKind small_file{"a small file", 1 << 10}, small_stream{"a small file", 1 << 10, true};

std::string written(const std::string& name, const std::string& text) {
  const auto path = test::scratch_dir() / name;
  std::ofstream(path, std::ios::binary) << text;
  return path.string();
}

std::string why(const fs::path& path, const InputKind& kind = small_file) {
  // A regression would wait for ever for somebody to open the pipe's other end.
  alarm(60);
  std::string words;
  try {
    read_whole_file(path.string(), kind);
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::refused);
    words = error.what();
  }
  alarm(0);
  return words;
}

TEST(InputFile, GivesTheBytesOfAFileUpToTheLimit) {
  EXPECT_EQ(read_whole_file(written("a", std::string("a\0b\r\n", 5)), small_file),
            std::string("a\0b\r\n", 5));
  EXPECT_EQ(read_whole_file(written("b", std::string(1 << 10, 'x')), small_file).size(), 1u << 10);
  EXPECT_THAT(why(written("c", std::string(1025, 'x'))), HasSubstr("more than 1 KiB are not read"));
  EXPECT_EQ(read_whole_file(written("d", ""), small_file), "");
}

TEST(InputFile, TellsWhatIsNoFileApart) {
  const fs::path folder = test::scratch_dir();
  std::ofstream(folder / "file") << "x";
  fs::create_symlink("loop", folder / "loop");
  fs::create_symlink("gone", folder / "dangling");
  ASSERT_EQ(mkfifo((folder / "pipe").c_str(), 0600), 0);
  EXPECT_THAT(why(folder / "absent"), HasSubstr("cannot be read: there is no such file"));
  EXPECT_THAT(why(folder / "no" / "where" / "a"),
              HasSubstr("its folder " + (folder / "no" / "where").string() + " is not there (only " +
                        folder.string() + " is)"));
  EXPECT_THAT(why(folder), HasSubstr("is a folder, not a small file"));
  EXPECT_THAT(why(folder / "file" / "a"), HasSubstr((folder / "file").string() + " is a file, not a folder"));
  EXPECT_THAT(why(folder / "loop"), HasSubstr("leads back to itself"));
  EXPECT_THAT(why(folder / "dangling"), HasSubstr("is a link to gone, which is not there"));
  EXPECT_THAT(why(folder / std::string(300, 'n')), HasSubstr("longer than the file system takes"));
  EXPECT_THAT(why(folder / "pipe"), HasSubstr("is a pipe, not a regular file: write a small file to a file"));
  EXPECT_THAT(why(folder / "pipe", small_stream), HasSubstr("lead it to standard input and give `-`"));
  EXPECT_THAT(why("/dev/zero"), HasSubstr("is a device, not a regular file"));
  EXPECT_THAT(why(std::string("a\0b", 3)), HasSubstr("zero byte"));
}

TEST(InputFile, ToldThatAPermissionIsMissing) {
  const fs::path folder = test::scratch_dir();
  fs::create_directory(folder / "shut");
  std::ofstream(folder / "forbidden") << "x";
  std::ofstream(folder / "shut" / "file") << "x";
  fs::permissions(folder / "forbidden", fs::perms::none);
  fs::permissions(folder / "shut", fs::perms::none);
  fs::create_directory(folder / "fixed");
  fs::permissions(folder / "fixed", fs::perms(0555));
  // Root may read all: a child gives its rights away first.
  const pid_t child = fork();
  if (child == 0) {
    if (geteuid() == 0 && seteuid(65534) != 0) _exit(2);
    if (!fs::exists(folder)) _exit(2);
    const bool file = why(folder / "forbidden").find("you have no right to it") != std::string::npos;
    const bool inside = why(folder / "shut" / "file").find("look into its folder") != std::string::npos;
    const bool deeper = path_words(folder / "shut" / "new" / "file", EACCES).find("look into its folder") !=
                        std::string::npos;
    const std::string denied = "you may not write into the folder " + (folder / "fixed").string();
    const bool beside = path_words(folder / "fixed" / "new" / "", EACCES).ends_with(denied);
    _exit(file && inside && deeper && beside ? 0 : 1);
  }
  int status = 0;
  waitpid(child, &status, 0);
  fs::permissions(folder / "shut", fs::perms::owner_all);
  if (WEXITSTATUS(status) == 2) GTEST_SKIP() << "no other user could reach the scratch folder";
  EXPECT_EQ(status, 0);
}

TEST(InputFile, ReadsAStreamOnceAndNotForEver) {
  int ends[2];
  ASSERT_EQ(pipe(ends), 0);
  const std::string path = "/dev/fd/" + std::to_string(ends[0]);
  ASSERT_EQ(write(ends[1], "12\n34\n", 6), 6);
  std::thread late([&] {  // bytes that come while they are waited for
    ASSERT_EQ(write(ends[1], "56\n", 3), 3);
    close(ends[1]);
  });
  EXPECT_THAT(why(path), HasSubstr("is a pipe")) << "a reader that looks twice";
  EXPECT_EQ(read_whole_file(path, small_stream), "12\n34\n56\n");
  late.join();
  close(ends[0]);
  EXPECT_THAT(why(path, small_stream), HasSubstr("it is not open"));

  const int zeros = open("/dev/zero", O_RDONLY);
  EXPECT_THAT(why("/proc/self/fd/" + std::to_string(zeros), small_stream),
              HasSubstr("does not end within 1 KiB"));
  close(zeros);
}

TEST(InputFile, KnowsAStreamByItsPath) {
  EXPECT_EQ(stream_descriptor("-"), 0);
  EXPECT_EQ(stream_descriptor("/dev/stdin"), 0);
  EXPECT_EQ(stream_descriptor("/dev/fd/63"), 63);
  for (const char* path : {"", "./-", "/dev/fd/", "/dev/fd/-1", "/dev/fd/6x", "/dev/fd/99999999999", "a"})
    EXPECT_FALSE(stream_descriptor(path)) << path;
  EXPECT_THAT(why("-"), HasSubstr("standard input: cannot be a small file here"));
}

std::vector<std::string> lines_of(const std::string& text) {
  TextLines lines(written("lines", text), {"a text", 1 << 23});
  std::vector<std::string> all;
  for (std::string_view line; lines.next(line);) all.emplace_back(line);
  EXPECT_EQ(lines.number(), static_cast<long>(all.size()));
  return all;
}

TEST(TextLines, EndAsOnAnySystem) {
  EXPECT_THAT(lines_of("a\nb\r\nc\rd"), ElementsAre("a", "b", "c", "d"));
  EXPECT_THAT(lines_of("a\r\r\n\nb\n"), ElementsAre("a", "", "", "b"));
  EXPECT_THAT(lines_of("\xef\xbb\xbf"
                       "a\r\x1a"),
              ElementsAre("a"));
  EXPECT_THAT(lines_of(""), ElementsAre());
  EXPECT_THAT(lines_of("\n"), ElementsAre(""));
}

TEST(TextLines, MeetTheSameEndsAcrossTheBlocksOfTheReading) {
  for (const std::size_t before : {0, 1, 2, 3}) {
    const std::string first((1 << 18) - before, 'x');
    for (const char* end : {"\n", "\r\n", "\r"})
      EXPECT_THAT(lines_of(first + end + "b" + end), ElementsAre(first, "b"));
  }
}

TEST(TextLines, RefuseWhatIsNoTableAtAll) {
  const auto refusal = [](const std::string& text) {
    try {
      lines_of(text);
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_THAT(refusal("\xff\xfex\0"), HasSubstr("is a UTF-16 text"));
  EXPECT_THAT(refusal("a\n" + std::string(3 << 20, 'x')), HasSubstr("lines:2: is a line of over 1 MiB"));
}

TEST(CsvColumns, AreTheSameWhateverTheTextsLineEnds) {
  const std::string text = "x_m,y_m\n1,2\n3,4\n";
  const std::vector<double> x{1, 3}, y{2, 4};
  for (const char* end : {"\n", "\r\n", "\r", "\r\r\n", " \t\n", "\n\n"}) {
    for (const char* start : {"", "\xef\xbb\xbf", "\n\r\n \n", "\xef\xbb\xbf\n"}) {
      for (const char* last : {"", "\x1a"}) {
        std::string bytes = start;
        for (const char c : text) c == '\n' ? bytes += end : bytes += c;
        const CsvColumns table = read_csv_columns(written("t.csv", bytes + last), {"x_m", "y_m"});
        EXPECT_EQ(table.columns, (std::vector<std::vector<double>>{x, y})) << testing::PrintToString(bytes);
      }
    }
  }
}

TEST(CsvColumns, OfRowsThatRunTogetherAreRefused) {
  const auto refusal = [](const std::string& bytes) {
    try {
      read_csv_columns(written("t.csv", bytes), {"x_m"});
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string("read");
  };
  EXPECT_THAT(refusal("x_m,note\n1,a\f2,b\n"), HasSubstr("t.csv:2: has 3 cells, but the header has 2"));
  EXPECT_THAT(refusal("x_m,y_m\n0,001,-3,5\n"),
              HasSubstr("t.csv:2: has 4 cells, but the header has 2: are its commas decimal marks, too?"));
  EXPECT_THAT(refusal("x_m,y_m\n0.1,2,3\n"), testing::EndsWith("t.csv:2: has 3 cells, but the header has 2"));
  EXPECT_THAT(refusal("x_m\n1\f\n"), HasSubstr("is no number"));
  EXPECT_THAT(refusal("x_m,note\n1,a,,\n"), HasSubstr("read")) << "blank cells at the end are a habit";
  EXPECT_THAT(refusal(std::string("\0x_m\n1\n", 7)), HasSubstr("zero byte"));
}

TEST(PrintableText, SpellsOutWhatATerminalWouldObey) {
  EXPECT_EQ(printable("a b \xc3\xa9 \xe4\xb8\xad \xf0\x9f\x99\x82"),
            "a b \xc3\xa9 \xe4\xb8\xad \xf0\x9f\x99\x82");
  EXPECT_EQ(printable(std::string("\x1b[2J\n\r\t\0\x7f", 9)), "\\x1b[2J\\n\\r\\t\\x00\\x7f");
  EXPECT_EQ(printable("\xc2\x9b"
                      "31m \xe2\x80\xae \xe2\x81\xa6 \xe2\x80\xa8"),
            "\\u009b31m \\u202e \\u2066 \\u2028");
  // Bytes that are no UTF-8: Latin-1, a cut character, an overlong slash, half a pair.
  EXPECT_EQ(printable("caf\xe9 \xe4\xb8 \xc0\xaf \xed\xa0\x80"),
            "caf\\xe9 \\xe4\\xb8 \\xc0\\xaf \\xed\\xa0\\x80");
  EXPECT_EQ(printable(std::string(100, 'x'), 10), "xxxxxxxxxx...");
  EXPECT_TRUE(is_utf8("caf\xc3\xa9"));
  EXPECT_FALSE(is_utf8("caf\xe9"));
}

}  // namespace
}  // namespace fingerpad::input_file_test
