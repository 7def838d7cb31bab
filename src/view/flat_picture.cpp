#include "view/flat_picture.hpp"

#include <vtkContextActor.h>
#include <vtkContextScene.h>
#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include <algorithm>

#include "view/drawing_item_vtk.hpp"
#include "view/png_vtk.hpp"
#include "view/screen.hpp"

namespace fingerpad {
namespace {

/// A window that shows a drawing, or strips of it one after the other.
struct FlatWindow {
  vtkNew<vtkRenderWindow> window;
  vtkNew<DrawingItem> item;

  FlatWindow(const Drawing& drawing, int width, int height) {
    window->SetOffScreenRendering(1);
    window->SetMultiSamples(8);
    window->SetSize(width, height);
    vtkNew<vtkRenderer> renderer;
    renderer->SetBackground(1, 1, 1);
    window->AddRenderer(renderer);
    item->show({std::make_shared<const Drawing>(drawing)});
    vtkNew<vtkContextActor> actor;
    actor->GetScene()->AddItem(item);
    renderer->AddActor(actor);
  }
};

}  // namespace

Pixels flat_pixels_in_strips(const Drawing& drawing, int width, int height, int strip_height) {
  const auto screen = screen_to_draw_on();
  FlatWindow flat(drawing, width, strip_height);
  Pixels picture{width, height, {}};
  const std::size_t row_bytes = 3 * static_cast<std::size_t>(width);
  picture.rgb.reserve(row_bytes * static_cast<std::size_t>(height));
  for (int bottom = 0; bottom < height; bottom += strip_height) {
    flat.item->show_strip(bottom, height);
    flat.window->Render();
    const Pixels strip = pixels_of(flat.window);
    const auto rows = static_cast<std::size_t>(std::min(strip_height, height - bottom));
    picture.rgb.insert(picture.rgb.end(), strip.rgb.begin(),
                       strip.rgb.begin() + static_cast<std::ptrdiff_t>(rows * row_bytes));
  }
  return picture;
}

void write_flat_png(const Drawing& drawing, int width, int height, const std::string& path) {
  // Eight samples a pixel with their depths, and their copies, take some 70 bytes: a window of so many pixels
  // takes a third of a gigabyte.
  constexpr long most_window_pixels = 4L << 20;
  if (static_cast<long>(width) * height > most_window_pixels) {
    write_png(flat_pixels_in_strips(drawing, width, height,
                                    static_cast<int>(std::max(1L, most_window_pixels / width))),
              path);
    return;
  }
  const auto screen = screen_to_draw_on();
  FlatWindow flat(drawing, width, height);
  flat.window->Render();
  write_png(flat.window, path);
}

}  // namespace fingerpad
