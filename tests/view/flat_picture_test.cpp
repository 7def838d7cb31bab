#include "view/flat_picture.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "base/error.hpp"
#include "support/paths.hpp"
#include "view/picture.hpp"
#include "view/svg.hpp"

namespace fingerpad::test {
namespace {

/// Boxes, slanting lines, dashes, words and discs all over a page.
Drawing busy_page(int width, int height) {
  Drawing page;
  for (int k = 0; k < 9; ++k) {
    const double y = 7 + k * (height - 14) / 8.0;
    page.box({10, y - 3, width - 20.0, 5}, colours::yellow);
    page.line({5, y}, {width - 5.0, height - y}, {colours::ink, 1.5});
    page.line({5, height - y}, {width - 5.0, y}, {colours::ink, 2, 9, 5});
    page.disc({width / 2.0, y}, 6, colours::grey);
    page.text({width / 3.0, y}, "words \xc2\xb5", {.size = 13});
  }
  return page;
}

TEST(FlatPicture, IsTheSameInStripsAsInOnePiece) {
  constexpr int width = 300, height = 400;
  const Drawing page = busy_page(width, height);
  const Pixels whole = flat_pixels_in_strips(page, width, height, height);
  for (const int strip : {200, 137}) {
    const Pixels strips = flat_pixels_in_strips(page, width, height, strip);
    ASSERT_EQ(strips.rgb.size(), whole.rgb.size());
    long unlike = 0, ink = 0;
    for (std::size_t i = 0; i < whole.rgb.size(); ++i) {
      ink += whole.rgb[i] < 255;
      // A sample at an edge can fall to the other side by the rounding of a float.
      unlike += std::abs(int{whole.rgb[i]} - int{strips.rgb[i]}) > 64;
    }
    EXPECT_GT(ink, 20'000);
    EXPECT_LT(unlike, ink / 500) << strip;
  }
}

TEST(Drawing, ShowsAFilesWordsWithoutTheirControls) {
  Drawing page;
  page.text({10, 10}, "a\x1b[31m\xe9\xe2\x80\xae \xc2\xb5", {});
  const std::string svg = svg_page(page, 100, 100, "t\x1b\n\xe9<");
  EXPECT_THAT(svg, testing::HasSubstr(">a\\x1b[31m\\xe9\\u202e \xc2\xb5</text>"));
  EXPECT_THAT(svg, testing::HasSubstr("<title>t\\x1b\\n\\xe9&lt;</title>"));
}

TEST(PictureSize, IsBoundedByTheMemoryItTakes) {
  for (const auto& [width, height] :
       {std::pair{199, 800}, {8193, 800}, {8192, 8192}, {4000, 2501}, {-5, 300}}) {
    try {
      refuse_picture_size(width, height);
      ADD_FAILURE() << width << " x " << height;
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::usage);
      EXPECT_THAT(error.what(), testing::HasSubstr("at most 10 million pixels"));
    }
  }
  for (const auto& [width, height] : {std::pair{200, 200}, {3840, 2160}, {8192, 1220}, {4000, 2500}})
    EXPECT_NO_THROW(refuse_picture_size(width, height));
}

}  // namespace
}  // namespace fingerpad::test
