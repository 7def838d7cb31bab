#include "view/stage_vtk.hpp"

#include <gtest/gtest.h>

#include "view/png_vtk.hpp"
#include "view/rub.hpp"
#include "view/screen.hpp"
#include "view/touch_chart.hpp"

namespace fingerpad::test {
namespace {

long pixels_that_differ(const Pixels& a, const Pixels& b) {
  long count = 0;
  for (std::size_t i = 0; i + 2 < a.rgb.size(); i += 3) {
    count += a.rgb[i] != b.rgb[i] || a.rgb[i + 1] != b.rgb[i + 1] || a.rgb[i + 2] != b.rgb[i + 2];
  }
  return count;
}

TEST(Stage, PaintsTheValueThatTheMouseAsksFor) {
  const VirtualScreen screen;
  const ViewInput input = torus_rub(1);
  Stage stage(input, 900, 600, true, true);
  stage.show_chart(touch_chart(input.rows, Vec3::UnitX(), touch_levels(input)));
  stage.show(input.rows.front(), 0);
  stage.render();
  const Pixels before = pixels_of(stage.window());
  const Box lowest = stage.charts().place().panels.back();
  const int x = static_cast<int>(lowest.left + 0.6 * lowest.width);
  for (int y = static_cast<int>(lowest.bottom); y < lowest.top() && stage.charts().told().empty(); ++y) {
    stage.charts().move(x, y);
  }
  ASSERT_NE(stage.charts().told(), "");
  stage.render();
  // A box of a dozen letters.
  EXPECT_GT(pixels_that_differ(before, pixels_of(stage.window())), 500);
}

}  // namespace
}  // namespace fingerpad::test
