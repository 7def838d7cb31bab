#include <gtest/gtest.h>
#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkPlaneSource.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include "view/blending_renderer_vtk.hpp"
#include "view/png_vtk.hpp"
#include "view/screen.hpp"

// What is translucent is laid over the picture in the order of its actors.

namespace fingerpad::blending_test {
namespace {

vtkSmartPointer<vtkActor> square(double z, double red, double blue) {
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(-1, -1, z);
  plane->SetPoint1(1, -1, z);
  plane->SetPoint2(-1, 1, z);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(plane->GetOutputPort());
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(red, 0, blue);
  actor->GetProperty()->SetLighting(false);
  actor->GetProperty()->SetOpacity(0.5);
  return actor;
}

/// Red, green and blue in the middle of a picture of two squares, one over the other.
std::array<int, 3> seen(vtkRenderer* renderer, const std::vector<vtkSmartPointer<vtkActor>>& actors) {
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  window->SetSize(40, 40);
  window->AddRenderer(renderer);
  renderer->SetBackground(0, 0, 0);
  for (const auto& actor : actors) renderer->AddActor(actor);
  renderer->GetActiveCamera()->ParallelProjectionOn();
  renderer->ResetCamera(-0.5, 0.5, -0.5, 0.5, -1, 2);
  window->Render();
  const Pixels pixels = pixels_of(window);
  const std::size_t middle = 3 * (20 * 40 + 20);
  return {pixels.rgb[middle], pixels.rgb[middle + 1], pixels.rgb[middle + 2]};
}

TEST(BlendingRenderer, LaysTheLaterActorOverTheEarlierWhicheverIsNearer) {
  const VirtualScreen screen;
  for (const double red_z : {0.0, 1.0}) {
    const auto red = square(red_z, 1, 0), blue = square(1 - red_z, 0, 1);
    vtkNew<BlendingRenderer> red_first, blue_first;
    const auto blue_over = seen(red_first, {red, blue});
    const auto red_over = seen(blue_first, {blue, red});
    // Half of the one over a quarter of the other.
    EXPECT_NEAR(blue_over[2], 127, 3) << red_z;
    EXPECT_NEAR(blue_over[0], 64, 3) << red_z;
    EXPECT_NEAR(red_over[0], 127, 3) << red_z;
    EXPECT_NEAR(red_over[2], 64, 3) << red_z;
  }
}

TEST(BlendingRenderer, KeepsWhatIsTranslucentBehindWhatIsNot) {
  const VirtualScreen screen;
  const auto red = square(0, 1, 0), blue = square(1, 0, 1);
  blue->GetProperty()->SetOpacity(1);
  vtkNew<BlendingRenderer> renderer;
  const auto colour = seen(renderer, {blue, red});
  EXPECT_NEAR(colour[0], 0, 3) << "the red one is behind";
  EXPECT_NEAR(colour[2], 255, 3);
}

}  // namespace
}  // namespace fingerpad::blending_test
