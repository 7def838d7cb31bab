#ifdef FINGERPAD_VIEW
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "support/paths.hpp"
#include "support/shell.hpp"

// Pictures and windows as a user without a display meets them.

namespace fingerpad::pictures_test {
namespace {
namespace fs = std::filesystem;

fs::path folder_with_plane() {
  const fs::path folder = test::scratch_dir();
  std::ofstream(folder / "plane.toml")
      << "[[plane]]\npoint_m = [0, 0, 0]\nnormal = [0, 0, 1]\n[motion]\nkind = \"sine\"\ncentre_m = [0, 0, "
         "-0.001]\n"
         "direction = [1, 0, 0]\namplitude_m = 0.05\nfrequency_hz = 1\nduration_s = 1\n";
  return folder;
}

struct Size {
  unsigned width = 0, height = 0;
};

Size png_size(const fs::path& path) {
  const std::string bytes = test::bytes_of(path);
  if (bytes.size() < 24 || bytes.compare(1, 3, "PNG") != 0) return {};
  const auto number = [&bytes](std::size_t at) {
    unsigned value = 0;
    for (std::size_t i = 0; i < 4; ++i) value = value << 8 | static_cast<unsigned char>(bytes[at + i]);
    return value;
  };
  return {number(16), number(20)};
}

TEST(Pictures, OfASceneAndATraceNeedNoScreen) {
  const fs::path folder = folder_with_plane();
  ASSERT_EQ(test::fingerpad("replay plane.toml --out o --quiet", folder).exit_code, 0);
  for (const char* call : {"view plane.toml --png a.png --size 800x600",
                           "view o/plane.h5 --png a.png --size 800x600 --at 0.5"}) {
    fs::remove(folder / "a.png");
    const auto result = test::fingerpad(call, folder);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(png_size(folder / "a.png").width, 800u) << call;
    EXPECT_EQ(png_size(folder / "a.png").height, 600u) << call;
  }
}

TEST(Movies, OfASceneNeedNoScreen) {
  const fs::path folder = folder_with_plane();
  if (test::shell("command -v ffmpeg", folder).exit_code != 0) GTEST_SKIP() << "ffmpeg is not installed";
  const auto result =
      test::fingerpad("view plane.toml --movie a.mp4 --size 320x240 --fps 5 --speed 2", folder);
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.out, "wrote a.mp4 (3 frames of 320 x 240 pixels, 0.6 s)\n");
  EXPECT_GT(fs::file_size(folder / "a.mp4"), 1000u);
}

TEST(Movies, OfWhatDoesNotMoveOrByOtherNamesAreRefused) {
  const fs::path folder = folder_with_plane();
  fs::copy(test::source_dir() / "scenes/parts/bracket_coarse.stl", folder / "bracket.stl");
  for (const char* call :
       {"view bracket.stl --movie a.mp4", "view plane.toml --movie a.avi", "view plane.toml --movie -",
        "view plane.toml --fps 5 --png a.png", "view plane.toml --movie a.mp4 --png a.png",
        "view plane.toml --movie a.mp4 --fps 0", "view plane.toml --movie a.mp4 --speed nan",
        "view plane.toml --movie a.mp4 --size 321x240", "view plane.toml --movie missing/a.mp4"}) {
    const auto result = test::fingerpad(call, folder);
    EXPECT_EQ(result.exit_code, 2) << call << "\n" << result.err;
    EXPECT_NE(result.err.find("fingerpad: error: "), std::string::npos) << call;
  }
  EXPECT_FALSE(fs::exists(folder / "a.mp4"));
}

TEST(Pictures, OfTheDenseMeshAreDrawnToo) {
  const auto meshes = test::real_files("dense", {".ply"});
  if (meshes.empty()) GTEST_SKIP() << "the shared meshes are not here";
  const fs::path folder = test::scratch_dir();
  const auto result = test::fingerpad("view '" + meshes[0].string() + "' --png dense.png", folder);
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_GT(fs::file_size(folder / "dense.png"), 20000u) << "a blank page is smaller";
}

TEST(Plots, AreWrittenAsPngAndSvgOnly) {
  const fs::path folder = folder_with_plane();
  ASSERT_EQ(test::fingerpad("replay plane.toml --out o --format csv --quiet", folder).exit_code, 0);
  EXPECT_EQ(test::fingerpad("plot o/plane.csv --out p.svg", folder).exit_code, 0);
  EXPECT_EQ(test::fingerpad("plot o/plane.csv --out p.png", folder).exit_code, 0);
  EXPECT_NE(test::bytes_of(folder / "p.svg").find("<svg"), std::string::npos);
  EXPECT_EQ(test::fingerpad("plot o/plane.csv --out p.pdf", folder).exit_code, 2);
}

TEST(Plots, ShowThePapersFigures) {
  const fs::path folder = test::scratch_dir();
  const std::string scenes = (test::source_dir() / "scenes").string();
  ASSERT_EQ(test::fingerpad("replay '" + scenes + "/figure7.toml' '" + scenes + "/figure8.toml' '" + scenes +
                                "/figure9.toml' '" + scenes + "/figure11.toml' --out o --quiet",
                            folder)
                .exit_code,
            0);
  const auto plotted = [&](const std::string& arguments) {
    const auto result = test::fingerpad("plot " + arguments + " --out p.svg", folder);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return test::bytes_of(folder / "p.svg");
  };
  const std::string ellipses = plotted("o/figure7.h5 --show stick-region");
  for (const char* label : {"finger at 15 deg", "finger at 45 deg", "finger at 75 deg", "the law's region"}) {
    EXPECT_NE(ellipses.find(label), std::string::npos) << label;
  }
  EXPECT_NE(plotted("o/figure8.h5 --show force-displacement").find(">longitudinal<"), std::string::npos);
  EXPECT_NE(plotted("o/figure9.h5 --from 1 --to 2").find("end of slip"), std::string::npos);
  // 20 s of a peak 20 Hz wide: its place is known to a few hertz.
  const std::string spectrum = plotted("o/figure11.h5 --show spectrum");
  const std::size_t at = spectrum.find("peaks at ");
  ASSERT_NE(at, std::string::npos);
  EXPECT_NEAR(std::stod(spectrum.substr(at + 9)), 89, 4);
}

TEST(Plots, OfWhatATraceDoesNotHoldAreRefused) {
  const fs::path folder = folder_with_plane();
  ASSERT_EQ(test::fingerpad("replay plane.toml --out o --format csv --quiet", folder).exit_code, 0);
  const auto no_scene = test::fingerpad("plot o/plane.csv --show stick-region --out p.svg", folder);
  EXPECT_EQ(no_scene.exit_code, 3) << "a CSV trace does not say how the finger lay";
  EXPECT_NE(no_scene.err.find("HDF5"), std::string::npos) << no_scene.err;
  EXPECT_EQ(test::fingerpad("plot o/plane.csv --from 5 --out p.svg", folder).exit_code, 3);
  EXPECT_EQ(test::fingerpad("plot o/plane.csv --show tea --out p.svg", folder).exit_code, 2);
  const auto backwards = test::fingerpad("plot o/plane.csv --from 5 --to 2 --out p.svg", folder);
  EXPECT_EQ(backwards.exit_code, 2);
  EXPECT_NE(backwards.err.find("5 s is later than --to, 2 s"), std::string::npos) << backwards.err;
}

TEST(Windows, WithoutADisplayEndTwoWithOneLine) {
  const fs::path folder = folder_with_plane();
  for (const char* call : {"view plane.toml", "touch plane.toml"}) {
    const auto result = test::fingerpad(call, folder);
    EXPECT_EQ(result.exit_code, 2) << call;
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
  }
}

TEST(Windows, ADisplayThatDoesNotAnswerIsToldToo) {
  const fs::path folder = folder_with_plane();
  const auto result = test::shell("DISPLAY=:987 '" + test::program().string() + "' view plane.toml", folder);
  EXPECT_EQ(result.exit_code, 2) << result.err;
}

}  // namespace
}  // namespace fingerpad::pictures_test
#endif
