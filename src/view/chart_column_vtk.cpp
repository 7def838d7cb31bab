#include "view/chart_column_vtk.hpp"

#include <vtkContextActor.h>
#include <vtkContextScene.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include <utility>

#include "view/colours.hpp"

namespace fingerpad {

void ChartColumn::add_to(vtkRenderWindow* window) {
  for (vtkRenderer* renderer : {paper_.Get(), static_cast<vtkRenderer*>(marks_)}) {
    window->AddRenderer(renderer);
    renderer->InteractiveOff();
    renderer->SetDraw(wanted_ ? 1 : 0);
  }
  marks_->PreserveColorBufferOn();
  marks_->AutomaticLightCreationOff();
  marks_->keep_box_of(paper_);
  marks_->set_flat(true);
  // They have no use for depths, and to clear them takes time without a graphics card.
  marks_->PreserveDepthBufferOn();
  // A device keeps fifty texts from one frame to the next, and of more none.
  for (const auto& [item, device] :
       {std::pair{board_.items()[0], words_device_.Get()}, std::pair{board_.items()[1], device_.Get()}}) {
    vtkNew<vtkContextActor> charts;
    charts->SetForceDevice(device);
    // By its renderer VTK keeps a tooltip in sight.
    charts->GetScene()->SetRenderer(marks_);
    if (wanted_) charts->GetScene()->AddItem(item);
    marks_->AddActor(charts);
  }
}

void ChartColumn::show(Chart chart) {
  chart_ = std::move(chart);
  placed_ = false;
}

void ChartColumn::lay_out(const Layout& layout) {
  layout_ = layout;
  placed_ = false;
  if (!wanted_) return;
  const Box& box = layout.charts;
  const double w = layout.window.width, h = layout.window.height;
  paper_->SetViewport(box.left / w, box.bottom / h, box.right() / w, box.top() / h);
}

void ChartColumn::set_dark(bool dark) {
  if (dark != device_->dark()) redraw();
  for (ThemeDevice* const device : {words_device_.Get(), device_.Get()}) device->set_dark(dark);
  const Colour paper = dark ? in_the_dark(colours::white) : colours::white;
  paper_->SetBackground(paper.red / 255.0, paper.green / 255.0, paper.blue / 255.0);
  board_.set_dark(dark);
}

void ChartColumn::place() {
  if (!wanted_ || !chart_ || placed_) return;
  placed_ = true;
  redraw();
  board_.set_visible(layout_.charts.width > 0);
  paper_->SetDraw(board_.visible() ? 1 : 0);
  marks_->SetDraw(board_.visible() ? 1 : 0);
  if (!board_.visible()) return;
  const double em = layout_.em;
  const Box inner{layout_.charts.left + 0.4 * em, layout_.charts.bottom + 0.4 * em,
                  layout_.charts.width - 0.8 * em, layout_.charts.height - 0.8 * em};
  board_.show(*chart_, stacked_layout(*chart_, inner, em), static_cast<int>(layout_.window.width),
              static_cast<int>(layout_.window.height));
}

void ChartColumn::prepare(bool keeping) {
  place();
  // What is told of a value may reach beyond the charts.
  marks_->set_keeping(keeping && board_.told().empty());
  marks_->set_content(changes_ + board_.changes());
}

std::shared_ptr<const Drawing> ChartColumn::cursor(double t_s) const {
  auto cursor = std::make_shared<Drawing>();
  const ChartPlace place = board_.place();
  if (t_s < place.x_min || t_s > place.x_max) return cursor;
  const double x = place.drawing_x_at(t_s);
  for (const Box& panel : place.panels) {
    cursor->line({x, panel.bottom}, {x, panel.top()}, {colours::ink, 0.12 * layout_.em});
  }
  return cursor;
}

}  // namespace fingerpad
