#include "view/drawing_item_vtk.hpp"

#include <vtkBrush.h>
#include <vtkContext2D.h>
#include <vtkContextScene.h>
#include <vtkNew.h>
#include <vtkPen.h>
#include <vtkTextProperty.h>
#include <vtkTransform2D.h>

#include <algorithm>
#include <cmath>

#include "view/drawing_device_vtk.hpp"
#include "view/text_width_vtk.hpp"
#include "view/theme_device_vtk.hpp"

namespace fingerpad {
namespace {

unsigned char alpha_of(const Colour& colour) {
  return static_cast<unsigned char>(std::lround(255 * colour.opacity));
}

/// A line cut into dashes: pairs of end points with the corners between them lost, which is as good for
/// dashes a few pixels long.
std::vector<Vec2> dashes_of(const Drawing::Line& line) {
  std::vector<Vec2> ends;
  const double period = line.stroke.dash + line.stroke.gap;
  double along = 0;  // since the start of the present dash
  for (std::size_t i = 1; i < line.points.size(); ++i) {
    const Vec2 step = line.points[i] - line.points[i - 1];
    const double length = step.norm();
    double done = 0;
    while (done < length) {
      const bool drawn = along < line.stroke.dash;
      const double here = std::min(length - done, (drawn ? line.stroke.dash : period) - along);
      if (drawn) {
        for (const double at : {done, done + here}) {
          ends.emplace_back(line.points[i - 1] + step * (at / length));
        }
      }
      done += here;
      along += here;
      if (along >= period - 1e-9) along = 0;
      if (!(here > 0)) break;
    }
  }
  return ends;
}

/// VTK maps 0.5 .. height - 0.5 to the viewport. A strip of a page maps its part of the page's 0.5 ..
/// page height - 0.5, so that strips meet without a step.
struct Strip {
  double bottom = 0, height = 0, page_height = 0;  ///< [px]

  double y_of(double page_y) const {
    if (height == page_height) return page_y;
    const double pixel = (page_y - 0.5) * page_height / (page_height - 1) - bottom;
    return 0.5 + pixel * (height - 1) / height;
  }
};

struct Painter {
  vtkContext2D* context;
  double width;  ///< of the viewport [px]
  Strip strip;

  void operator()(const Drawing::Line& line) const {
    const Colour colour = colour_on(context, line.stroke.colour);
    context->GetPen()->SetLineType(vtkPen::SOLID_LINE);
    context->GetPen()->SetColor(colour.red, colour.green, colour.blue, alpha_of(colour));
    context->GetPen()->SetWidth(static_cast<float>(line.stroke.width));
    if (line.stroke.dash > 0) {
      std::vector<float> ends = flat(dashes_of(line));
      if (!ends.empty()) context->DrawLines(ends.data(), static_cast<int>(ends.size() / 2));
      return;
    }
    std::vector<float> points = flat(line.points);
    context->DrawPoly(points.data(), static_cast<int>(line.points.size()));
  }

  void operator()(const Drawing::Area& area) const {
    context->GetPen()->SetLineType(vtkPen::NO_PEN);
    const Colour fill = colour_on(context, area.fill);
    context->GetBrush()->SetColor(fill.red, fill.green, fill.blue, alpha_of(fill));
    std::vector<float> points = flat(area.points);
    context->DrawPolygon(points.data(), static_cast<int>(area.points.size()));
  }

  void operator()(const Drawing::Text& text) const {
    vtkTextProperty* property = context->GetTextProp();
    const TextStyle& style = text.style;
    set_font(property, style.size, style.bold);
    const Colour colour = colour_on(context, style.colour);
    property->SetColor(colour.red / 255.0, colour.green / 255.0, colour.blue / 255.0);
    property->SetOpacity(colour.opacity);
    property->SetOrientation(style.turned ? 90 : 0);
    constexpr int across[] = {VTK_TEXT_LEFT, VTK_TEXT_CENTERED, VTK_TEXT_RIGHT};
    constexpr int upright[] = {VTK_TEXT_BOTTOM, VTK_TEXT_CENTERED, VTK_TEXT_TOP};
    property->SetJustification(across[static_cast<int>(style.across)]);
    property->SetVerticalJustification(upright[static_cast<int>(style.upright)]);
    // VTK maps 0.5 .. width - 0.5 to the viewport, so that pixels drift by up to a half, and a text's texture
    // wraps round at its edges. A shift of its own puts each text on the grid.
    vtkNew<vtkTransform2D> onto_grid;
    onto_grid->Translate(std::lround(text.at.x()) * (width - 1) / width + 0.5,
                         (std::lround(text.at.y()) - strip.bottom) * (strip.height - 1) / strip.height + 0.5);
    context->PushMatrix();
    context->AppendTransform(onto_grid);
    context->DrawString(0.0F, 0.0F, text.words.c_str());
    context->PopMatrix();
  }

  std::vector<float> flat(const std::vector<Vec2>& points) const {
    std::vector<float> values;
    values.reserve(2 * points.size());
    for (const Vec2& p : points) {
      values.push_back(static_cast<float>(p.x()));
      values.push_back(static_cast<float>(strip.y_of(p.y())));
    }
    return values;
  }
};

void paint_strip(const Drawing& drawing, vtkContext2D* painter, double width, const Strip& strip) {
  if (Drawing* const record = recording_of(painter)) {
    record->append(drawing);
    return;
  }
  const Painter onto{painter, width, strip};
  for (const auto& mark : drawing.marks()) std::visit(onto, mark);
}

}  // namespace

void paint(const Drawing& drawing, vtkContext2D* painter, int width, int height) {
  const double page_height = height;
  paint_strip(drawing, painter, width, {0, page_height, page_height});
}

vtkStandardNewMacro(DrawingItem);

void DrawingItem::show(std::vector<std::shared_ptr<const Drawing>> drawings) {
  drawings_ = std::move(drawings);
  this->Modified();
}

void DrawingItem::show_strip(int bottom_px, int page_height_px) {
  strip_bottom_px_ = bottom_px;
  page_height_px_ = page_height_px;
  this->Modified();
}

bool DrawingItem::Paint(vtkContext2D* painter) {
  const double height = this->GetScene()->GetSceneHeight();
  const Strip strip{static_cast<double>(strip_bottom_px_), height,
                    page_height_px_ > 0 ? page_height_px_ : height};
  for (const auto& drawing : drawings_)
    paint_strip(*drawing, painter, this->GetScene()->GetSceneWidth(), strip);
  return true;
}

}  // namespace fingerpad
