#include "view/movie.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>

#include "base/error.hpp"
#include "support/paths.hpp"
#include "support/shell.hpp"
#include "view/colours.hpp"
#include "view/find_program.hpp"
#include "view/layout.hpp"
#include "view/picture.hpp"
#include "view/pixel_statistics.hpp"
#include "view/rub.hpp"

namespace fingerpad::movie_test {
namespace {

using test::torus_rub;

MovieChoice small_choice() {
  return {.width = 640, .height = 480, .frames_per_s = 10, .speed = 0.5};
}

/// A frame of a movie as ffmpeg reads it back.
Pixels frame_of(const std::filesystem::path& movie, int number, int width, int height) {
  const auto folder = movie.parent_path();
  const auto result =
      test::shell("ffmpeg -loglevel error -y -i " + movie.filename().string() + " -vf 'select=eq(n\\," +
                      std::to_string(number) + "),vflip' -frames:v 1 -f rawvideo -pix_fmt rgb24 frame.rgb",
                  folder);
  EXPECT_EQ(result.exit_code, 0) << result.err;
  const std::string bytes = test::bytes_of(folder / "frame.rgb");
  Pixels pixels{width, height, {bytes.begin(), bytes.end()}};
  EXPECT_EQ(bytes.size(), 3u * static_cast<unsigned>(width) * static_cast<unsigned>(height));
  return pixels;
}

double mean_difference(const Pixels& a, const Pixels& b) {
  double sum = 0;
  for (std::size_t i = 0; i < std::min(a.rgb.size(), b.rgb.size()); ++i) sum += std::abs(a.rgb[i] - b.rgb[i]);
  return sum / static_cast<double>(a.rgb.size());
}

class Movie : public testing::TestWithParam<const char*> {};

TEST_P(Movie, IsReadBackAsItWasMade) {
  if (find_program("ffmpeg").empty() || find_program("ffprobe").empty())
    GTEST_SKIP() << "ffmpeg is not installed";
  const auto folder = test::scratch_dir();
  const auto path = folder / (std::string("rub") + GetParam());
  const ViewInput input =
      torus_rub(0.3);  // 0.4 s, at half its speed 0.8 s: frames 0 .. 7, the last row is at 0.399
  long told = 0;
  write_view_movie(input, path.string(), small_choice(), {}, [&](long done) { told = done; });
  EXPECT_EQ(told, 8);
  EXPECT_FALSE(std::filesystem::exists(path.string() + ".part"));
  const auto probe = test::shell(
      "ffprobe -loglevel error -count_frames -select_streams v -show_entries "
      "stream=width,height,nb_read_frames,r_frame_rate -of csv=p=0 " +
          path.filename().string(),
      folder);
  EXPECT_EQ(probe.out, "640,480,10/1,8\n") << probe.err;

  const Pixels frame = frame_of(path, 5, 640, 480);  // at 0.25 s: it sticks
  const Layout layout = layout_for(640, 480, true, true);
  EXPECT_GT(test::share_drawn(frame, layout.scene), 0.3);
  EXPECT_GT(test::share_drawn(frame, layout.charts), 0.1);
  const Pixels picture = view_pixels(input, 640, 480, 0.25, {});
  const Pixels another = view_pixels(input, 640, 480, 0.02, {});
  // What is lost in coding is little beside what differs from moment to moment: finger, close-up and cursor.
  EXPECT_LT(mean_difference(frame, picture), 4);
  EXPECT_LT(mean_difference(frame, picture), 0.5 * mean_difference(frame, another));
}

TEST(MovieCamera, LooksFromWhereItWasTold) {
  if (find_program("ffmpeg").empty()) GTEST_SKIP() << "ffmpeg is not installed";
  const auto path = test::scratch_dir() / "rub.mp4";
  const ViewInput input = torus_rub(0.1);
  ViewState from_below;
  from_below.look = *named_look("bottom");
  MovieChoice choice = small_choice();
  choice.speed = 1;
  write_view_movie(input, path.string(), choice, from_below, [](long) {});
  const Pixels frame = frame_of(path, 0, 640, 480);
  EXPECT_LT(mean_difference(frame, view_pixels(input, 640, 480, 0, from_below)), 4);
  EXPECT_GT(mean_difference(frame, view_pixels(input, 640, 480, 0, {})), 8);
}

INSTANTIATE_TEST_SUITE_P(Kinds, Movie, testing::Values(".mp4", ".ogv"),
                         [](const auto& info) { return std::string(info.param + 1); });

TEST(Movie, ShowsTheNearestRow) {
  const ViewInput input = torus_rub(0.3);
  MovieChoice choice = small_choice();
  EXPECT_EQ(movie_frames(input, choice), 8);
  EXPECT_EQ(movie_row(input, choice, 0), 0u);
  EXPECT_EQ(movie_row(input, choice, 3), 150u);
  choice.speed = 0.0149;  // 0.00149 s a frame: row 1 is nearer than row 2
  EXPECT_EQ(movie_row(input, choice, 1), 1u);
  choice.speed = 0.0151;
  EXPECT_EQ(movie_row(input, choice, 1), 2u);
  EXPECT_EQ(movie_frames({}, choice), 0);
}

TEST(Movie, RefusesWhatNoMovieCanBe) {
  for (const MovieChoice& choice : {MovieChoice{.width = 641}, MovieChoice{.frames_per_s = 0.5},
                                    MovieChoice{.speed = 0}, MovieChoice{.speed = -1}}) {
    try {
      refuse_movie_choice(choice);
      FAIL();
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::usage);
    }
  }
  MovieChoice slow;
  slow.speed = 1e-6;
  EXPECT_THROW(movie_frames(torus_rub(0.3), slow), Error);
}

/// A folder with a program called ffmpeg that is none, alone in PATH while it lives.
class OtherEncoder {
 public:
  OtherEncoder(const std::filesystem::path& folder, const std::string& script) : path_(std::getenv("PATH")) {
    std::filesystem::create_directories(folder);
    std::filesystem::create_symlink(find_program("Xvfb"), folder / "Xvfb");
    if (!script.empty()) {
      std::ofstream(folder / "ffmpeg") << "#!/bin/sh\n" << script;
      std::filesystem::permissions(folder / "ffmpeg", std::filesystem::perms::owner_all);
    }
    setenv("PATH", folder.c_str(), 1);
  }
  ~OtherEncoder() { setenv("PATH", path_.c_str(), 1); }

 private:
  std::string path_;
};

std::string words_of_failure(const std::string& script, ErrorKind kind) {
  const auto folder = test::scratch_dir();
  const auto path = folder / "rub.mp4";
  std::ofstream(path) << "before";
  const OtherEncoder other(folder / "programs", script);
  std::string words;
  try {
    write_view_movie(torus_rub(0.1), path.string(), small_choice(), {}, [](long) {});
    ADD_FAILURE() << "made a movie";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), kind);
    words = error.what();
  }
  EXPECT_EQ(test::bytes_of(path), "before");
  EXPECT_FALSE(std::filesystem::exists(path.string() + ".part"));
  return words;
}

TEST(Movie, NamesThePackageWhereThereIsNoEncoder) {
  EXPECT_NE(words_of_failure("", ErrorKind::usage).find("apt-get install ffmpeg"), std::string::npos);
}

TEST(Movie, TellsWhatTheEncoderSaidAndLeavesNoHalf) {
  const std::string words = words_of_failure("echo no such codec >&2\nexit 1\n", ErrorKind::fault);
  EXPECT_NE(words.find("no such codec"), std::string::npos) << words;
}

}  // namespace
}  // namespace fingerpad::movie_test
