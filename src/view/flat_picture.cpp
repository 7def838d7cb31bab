#include "view/flat_picture.hpp"

#include <vtkContextActor.h>
#include <vtkContextScene.h>
#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include "view/drawing_item_vtk.hpp"
#include "view/png_vtk.hpp"
#include "view/screen.hpp"

namespace fingerpad {

void write_flat_png(const Drawing& drawing, int width, int height, const std::string& path) {
  const auto screen = screen_to_draw_on();
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(8);
  window->SetSize(width, height);
  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(1, 1, 1);
  window->AddRenderer(renderer);
  vtkNew<DrawingItem> item;
  item->show({std::make_shared<const Drawing>(drawing)});
  vtkNew<vtkContextActor> actor;
  actor->GetScene()->AddItem(item);
  renderer->AddActor(actor);
  window->Render();
  write_png(window, path);
}

}  // namespace fingerpad
