#include "view/picture.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "base/error.hpp"
#include "support/paths.hpp"
#include "view/colours.hpp"
#include "view/layout.hpp"
#include "view/overlay.hpp"
#include "view/pixel_statistics.hpp"
#include "view/rub.hpp"

namespace fingerpad::test {
namespace {

constexpr double sticks_at_s = 0.25, slips_at_s = 0.5, flies_at_s = 0.05;  // see torus_rub

/// Width and height as a PNG's header says them.
std::pair<int, int> png_size(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  unsigned char head[24] = {};
  file.read(reinterpret_cast<char*>(head), sizeof head);
  EXPECT_EQ(std::string(reinterpret_cast<char*>(head) + 1, 3), "PNG");
  const auto number = [&](int at) {
    return head[at] << 24 | head[at + 1] << 16 | head[at + 2] << 8 | head[at + 3];
  };
  return {number(16), number(20)};
}

TEST(Picture, HasTheSizeAskedFor) {
  const auto path = scratch_dir() / "view.png";
  write_view_png(torus_rub(), path.string(), 640, 480, sticks_at_s, {});
  EXPECT_EQ(png_size(path), std::make_pair(640, 480));
}

TEST(Picture, ShowsPartChartsAndTimeLine) {
  const Pixels pixels = view_pixels(torus_rub(), 800, 600, sticks_at_s, {});
  const Layout layout = layout_for(800, 600, true, true);
  // The torus fills about half of the scene; a chart's curves, bands and texts a few percent at least.
  EXPECT_GT(share_drawn(pixels, layout.scene), 0.4);
  EXPECT_GT(share_drawn(pixels, layout.charts), 0.1);
  EXPECT_GT(share_of(pixels, layout.charts, colours::white), 0.1);
  EXPECT_GT(share_drawn(pixels, layout.timeline), 0.01);
  EXPECT_GT(share_drawn(pixels, layout.title), 0.003);
}

TEST(Picture, OfASmallWindowShowsAllOfIt) {
  const Pixels pixels = view_pixels(torus_rub(), 640, 480, sticks_at_s, {});
  const Layout layout = layout_for(640, 480, true, true);
  EXPECT_GT(share_drawn(pixels, layout.scene), 0.35);
  EXPECT_GT(share_drawn(pixels, layout.charts), 0.1);
  EXPECT_GT(share_of(pixels, layout.charts, colours::white), 0.1);
  EXPECT_GT(share_drawn(pixels, layout.timeline), 0.01);
  EXPECT_GT(share_drawn(pixels, layout.title), 0.003);
  // The axes in the corner and the scale bar beside them, over the scene's ground.
  const double em = layout.em;
  const Box corner{layout.scene.right() - 7 * em, layout.scene.bottom + em, 6.5 * em, 6 * em};
  const double ink = share_of(pixels, corner, colours::ink);
  EXPECT_GT(ink, 0.005);
  EXPECT_LT(ink, 0.2) << "nothing lies over them";
}

TEST(Picture, ColoursThePhase) {
  const Layout layout = layout_for(800, 600, true, true);
  const double em = layout.em;
  // The chip behind the word: second line of the readings, at the right end.
  const Box chip{layout.scene.left + 9 * em, layout.scene.top() - 4.2 * em, 6 * em, 1.6 * em};
  const struct {
    double at_s;
    Phase phase;
  } moments[] = {{sticks_at_s, Phase::stick}, {slips_at_s, Phase::slip}, {flies_at_s, Phase::free}};
  for (const auto& moment : moments) {
    const Pixels pixels = view_pixels(torus_rub(), 800, 600, moment.at_s, {});
    for (const Phase phase : {Phase::free, Phase::stick, Phase::slip}) {
      const double share = share_of(pixels, chip, phase_colour(phase));
      // A chip with its white word: half of this box is plain, or none of it.
      if (phase == moment.phase) {
        EXPECT_GT(share, 0.15) << phase_name(phase);
      } else {
        EXPECT_LT(share, 0.01) << phase_name(phase);
      }
    }
  }
}

TEST(Picture, MagnifiesAStickRegionTooSmallToSee) {
  const Layout layout = layout_for(800, 600, true, true);
  const Pixels sticking = view_pixels(torus_rub(), 800, 600, sticks_at_s, {});
  const Pixels flying = view_pixels(torus_rub(), 800, 600, flies_at_s, {});
  const Colour rim = phase_colour(Phase::stick);
  const double region = share_of(sticking, layout.inset, rim);
  // The region's rim and the path in it, lit: some 60 x 2 pixels of 170 x 170.
  EXPECT_GT(region, 0.002);
  EXPECT_LT(share_of(flying, layout.inset, rim), 0.001);
  ViewState without;
  without.close_up = false;
  const Pixels plain = view_pixels(torus_rub(), 800, 600, sticks_at_s, without);
  EXPECT_NE(plain.rgb, sticking.rgb);
}

TEST(Picture, ColoursThePathByForceWhenAsked) {
  ViewState by_force;
  by_force.colouring = PathColouring::force;
  const Layout layout = layout_for(800, 600, true, true);
  const Box legend{layout.scene.left, layout.scene.bottom, 22 * layout.em, 6 * layout.em};
  const Pixels phases = view_pixels(torus_rub(), 800, 600, slips_at_s, {});
  const Pixels forces = view_pixels(torus_rub(), 800, 600, slips_at_s, by_force);
  EXPECT_GT(share_of(forces, legend, ramp_colour(0.9875)),
            10 * share_of(phases, legend, ramp_colour(0.9875)) + 1e-4);
}

TEST(Picture, ShowsAMeshAlone) {
  ViewInput mesh = torus_rub();
  mesh.rows.clear();
  const Pixels pixels = view_pixels(mesh, 400, 300, {}, {});
  EXPECT_GT(share_drawn(pixels, {0, 0, 400, 270}), 0.3);
}

TEST(Picture, ShowsAPathWithoutItsSurfaces) {
  ViewInput path = torus_rub(0.2);
  path.world.reset();
  path.scene.reset();
  const Pixels pixels = view_pixels(path, 400, 300, {}, {});
  EXPECT_GT(share_drawn(pixels, {0, 0, 400, 270}), 0.05);
}

TEST(Picture, IsTheSameTwice) {
  const ViewInput input = torus_rub(0.3);
  EXPECT_EQ(view_pixels(input, 400, 300, sticks_at_s, {}).rgb,
            view_pixels(input, 400, 300, sticks_at_s, {}).rgb);
}

TEST(Picture, RefusesASizeThatIsNone) {
  for (const auto& [width, height] : {std::pair{0, 600}, {800, -1}, {100'000, 600}}) {
    try {
      view_pixels(torus_rub(0.1), width, height, {}, {});
      FAIL() << width << "x" << height;
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::usage);
    }
  }
}

TEST(Picture, PicksTheMomentThatTellsMost) {
  const ViewInput input = torus_rub();
  const long row = telling_row(input);
  ASSERT_GE(row, 0);
  EXPECT_EQ(input.rows[static_cast<std::size_t>(row)].phase, Phase::stick);
  EXPECT_EQ(telling_row(ViewInput{}), -1);
  EXPECT_EQ(row_at(ViewInput{}, 1), -1);
  EXPECT_EQ(row_at(input, -5), 0);
  EXPECT_EQ(row_at(input, 0.0105), 10);
  EXPECT_EQ(row_at(input, 1e9), static_cast<long>(input.rows.size()) - 1);
}

}  // namespace
}  // namespace fingerpad::test
