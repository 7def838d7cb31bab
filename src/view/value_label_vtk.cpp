#include "view/value_label_vtk.hpp"

#include <vtkContext2D.h>
#include <vtkContextScene.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkStdString.h>
#include <vtkTransform2D.h>

#include <algorithm>

#include "view/colours.hpp"
#include "view/drawing_item_vtk.hpp"

namespace fingerpad {

vtkStandardNewMacro(ValueLabel);

Box value_label_box(const Vec2& mouse_px, const Vec2& size_px, double window_width, double window_height) {
  constexpr double gap = 6, rim = 2;
  const double left = std::min(mouse_px.x() + gap, window_width - rim - size_px.x());
  const bool has_room_above = mouse_px.y() + gap + size_px.y() <= window_height - rim;
  const double bottom = has_room_above ? mouse_px.y() + gap : mouse_px.y() - gap - size_px.y();
  return {std::max(rim, left), std::max(rim, bottom), size_px.x(), size_px.y()};
}

bool ValueLabel::Paint(vtkContext2D* painter) {
  if (!this->Visible || this->Text.empty() || this->Scene == nullptr) return false;
  const int width = this->Scene->GetSceneWidth(), height = this->Scene->GetSceneHeight();
  const Box box = value_label_box({this->PositionVector.GetX(), this->PositionVector.GetY()},
                                  {text_width(this->Text, em_) + 1.2 * em_, 1.8 * em_}, width, height);
  Drawing drawing;
  drawing.box(box, colours::white);
  drawing.frame(box, {colours::grey, 1});
  drawing.text({box.left + 0.6 * em_, box.centre().y()}, this->Text,
               {.size = em_, .upright = Upright::middle});
  vtkNew<vtkTransform2D> pixels;
  painter->PushMatrix();
  painter->SetTransform(pixels);
  paint(drawing, painter, width, height);
  painter->PopMatrix();
  return true;
}

}  // namespace fingerpad
