#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "support/calm_scene.hpp"
#include "support/paths.hpp"
#include "support/shell.hpp"

// What the program says and ends with when its output has nowhere to go.

namespace fingerpad::lost_output_test {
namespace {
namespace fs = std::filesystem;
using test::bytes_of;
using test::calm_scene;
using test::lines_of;
using test::ShellResult;
using testing::HasSubstr;

constexpr const char* cube_off =
    "OFF\n8 12 0\n0 0 0\n10 0 0\n10 10 0\n0 10 0\n0 0 10\n10 0 10\n10 10 10\n0 10 10\n"
    "3 0 3 2\n3 0 2 1\n3 4 5 6\n3 4 6 7\n3 0 1 5\n3 0 5 4\n3 1 2 6\n3 1 6 5\n3 2 3 7\n3 2 7 6\n3 3 0 4\n3 3 "
    "4 7\n";

fs::path folder_with_inputs() {
  const fs::path folder = test::scratch_dir();
  std::ofstream(folder / "cube.off") << cube_off;
  std::ofstream(folder / "points.csv") << "x_m,y_m,z_m\n0.005,0.005,0.012\n";
  std::ofstream many(folder / "many.csv");
  many << "x_m,y_m,z_m\n";
  for (int i = 0; i < 2000; ++i) many << i * 1e-5 << ",0.005,0.012\n";
  std::ofstream(folder / "calm.toml") << calm_scene("calm");
  std::ofstream(folder / "coarse.toml")
      << "name = \"coarse\"\n[[plane]]\npoint_m = [0, 0, 0]\nnormal = [0, 0, 1]\n[motion]\nkind = \"line\"\n"
         "from_m = [0, 0, -0.001]\nto_m = [0.01, 0, -0.001]\nspeed_m_per_s = 0.08\n";
  return folder;
}

class LostStandardOutput : public testing::TestWithParam<const char*> {};

TEST_P(LostStandardOutput, EndsOneWithALine) {
  const fs::path folder = folder_with_inputs();
  for (const char* call : {"--help", "--version", "replay --help", "check cube.off", "check cube.off --json",
                           "query cube.off points.csv", "query cube.off many.csv", "replay calm.toml --out o",
                           "replay calm.toml --out o --resume"}) {
    const ShellResult result = test::fingerpad(std::string(call) + " " + GetParam(), folder);
    EXPECT_EQ(result.exit_code, 1) << call << ": " << result.err;
    EXPECT_THAT(result.err, HasSubstr("fingerpad: error: standard output: cannot be written: ")) << call;
    EXPECT_EQ(lines_of(result.err), 1) << result.err;
  }
}

INSTANTIATE_TEST_SUITE_P(Full, LostStandardOutput, testing::Values(">/dev/full"));
INSTANTIATE_TEST_SUITE_P(Closed, LostStandardOutput, testing::Values(">&-"));
INSTANTIATE_TEST_SUITE_P(ClosedLikeInput, LostStandardOutput, testing::Values("<&- >&-"));

TEST(LostOutput, DoesNotHideWhatElseWentWrong) {
  const fs::path folder = folder_with_inputs();
  const ShellResult result = test::fingerpad("check cube.off absent.stl >/dev/full", folder);
  EXPECT_EQ(result.exit_code, 3) << "the more telling of the two codes";
  EXPECT_THAT(result.err, HasSubstr("absent.stl"));
  EXPECT_THAT(result.err, HasSubstr("standard output: cannot be written"));
}

TEST(LostOutput, OfStandardErrorKeepsTheCodeOfWhatWentWrong) {
  const fs::path folder = folder_with_inputs();
  for (const std::string& lost :
       std::vector<std::string>{" 2>&-", " 2>/dev/full", " <&- >&- 2>&-", " >/dev/full 2>/dev/full"}) {
    EXPECT_EQ(test::fingerpad("check absent.stl" + lost, folder).exit_code, 3) << lost;
    EXPECT_EQ(test::fingerpad("nonsense" + lost, folder).exit_code, 2) << lost;
    EXPECT_EQ(test::fingerpad("replay absent.toml --out o" + lost, folder).exit_code, 3) << lost;
    EXPECT_EQ(test::fingerpad("replay calm.toml absent.toml --out o" + lost, folder).exit_code, 4) << lost;
  }
}

TEST(LostOutput, OfStandardErrorIsAFaultOnlyWhereSomethingWasToBeSaid) {
  const fs::path folder = folder_with_inputs();
  for (const std::string& lost : std::vector<std::string>{" 2>&-", " 2>/dev/full"}) {
    EXPECT_EQ(test::fingerpad("replay calm.toml --out o --quiet" + lost, folder).exit_code, 0) << lost;
    EXPECT_EQ(test::fingerpad("replay coarse.toml --out o --quiet" + lost, folder).exit_code, 1)
        << lost << ": a warning was lost";
    EXPECT_EQ(test::fingerpad("check cube.off" + lost, folder).exit_code, 0) << lost;
  }
}

TEST(LostOutput, ClosedStreamsDoNotMixMessagesIntoTraces) {
  const fs::path folder = folder_with_inputs();
  for (const std::string& format : std::vector<std::string>{"h5", "csv"}) {
    const std::string call = "replay coarse.toml --format " + format + " --out ";
    ASSERT_EQ(test::fingerpad(call + "heard", folder).exit_code, 0);
    EXPECT_EQ(test::fingerpad(call + "unheard <&- >&- 2>&-", folder).exit_code, 1);
    for (const std::string& name : std::vector<std::string>{"coarse." + format, "summary.csv"}) {
      EXPECT_EQ(bytes_of(folder / "heard" / name), bytes_of(folder / "unheard" / name)) << name;
    }
  }
}

TEST(LostOutput, AReaderThatIsGoneEndsTheProgramWithoutAnAbort) {
  const fs::path folder = folder_with_inputs();
  // A pipe of which this shell alone holds the reading end, and lets it go before the program starts.
  const std::string dead_pipe = "mkfifo p; exec 4<>p 5>p 4<&-; rm p; ";
  test::shell("bash -c '" + dead_pipe + "(exec >&5; \"$0\" --help); echo $? >code' '" +
                  test::program().string() + "'",
              folder);
  EXPECT_EQ(bytes_of(folder / "code"), "141\n") << "SIGPIPE, as for any program in a pipe";
  const ShellResult ignored =
      test::shell("bash -c 'trap \"\" PIPE; " + dead_pipe + "(exec >&5; \"$0\" --help); echo $? >code' '" +
                      test::program().string() + "'",
                  folder);
  EXPECT_EQ(bytes_of(folder / "code"), "1\n");
  EXPECT_THAT(ignored.err, HasSubstr("standard output: cannot be written: Broken pipe"));
}

}  // namespace
}  // namespace fingerpad::lost_output_test
