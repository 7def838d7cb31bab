// VTK 9.1's device must be told of a string type that it will drop, too.
#define VTK_DEPRECATION_LEVEL 0

#include "view/drawing_device_vtk.hpp"

#include <vtkAbstractContextItem.h>
#include <vtkBrush.h>
#include <vtkContext2D.h>
#include <vtkContextDevice2D.h>
#include <vtkContextScene.h>
#include <vtkMatrix3x3.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPen.h>
#include <vtkRect.h>
#include <vtkTextProperty.h>
#include <vtkUnicodeString.h>

#include <algorithm>
#include <cmath>

namespace fingerpad {
namespace {

/// A device of VTK that writes down what is painted on it.
///
/// VTK 9.1's own way to SVG, vtkSVGExporter, cannot draw charts: it places the clipping of curves in units of
/// the data (so that they vanish), stretches their strokes with the axes, writes text-anchor="right", which
/// SVG does not know, and sizes in points for pixels; and it needs a screen.
class DrawingDevice : public vtkContextDevice2D {
 public:
  static DrawingDevice* New();
  vtkTypeMacro(DrawingDevice, vtkContextDevice2D);

  Drawing& drawing() { return drawing_; }

  void DrawPoly(float* points, int n, unsigned char*, int) override {
    if (this->Pen->GetLineType() != vtkPen::NO_PEN) drawing_.line(placed(points, n), stroke());
  }
  void DrawLines(float* points, int n, unsigned char*, int) override {
    if (this->Pen->GetLineType() == vtkPen::NO_PEN) return;
    for (; n >= 2; n -= 2, points += 4) drawing_.line(placed(points, 2), stroke());
  }
  void DrawPolygon(float* points, int n) override { fill(points, n); }
  void DrawColoredPolygon(float* points, int n, unsigned char*, int) override { fill(points, n); }
  void DrawQuad(float* points, int n) override { fill(points, n); }

  void SetMatrix(vtkMatrix3x3* m) override { matrix_ = taken(m); }
  void GetMatrix(vtkMatrix3x3* m) override {
    for (int i = 0; i < 9; ++i) m->SetElement(i / 3, i % 3, matrix_(i / 3, i % 3));
  }
  void MultiplyMatrix(vtkMatrix3x3* m) override { matrix_ = (matrix_ * taken(m)).eval(); }
  void PushMatrix() override { pushed_.push_back(matrix_); }
  void PopMatrix() override {
    matrix_ = pushed_.back();
    pushed_.pop_back();
  }

  void SetPointSize(float size) override { this->Pen->SetWidth(size); }
  void SetLineWidth(float width) override { this->Pen->SetWidth(width); }
  void SetLineType(int type) override { this->Pen->SetLineType(type); }
  void SetColor4(unsigned char colour[4]) override { this->Pen->SetColor(colour); }

  // Charts write through paint(), which hands its texts and dashes over whole, and keep to their frames
  // themselves; they have neither sprites nor arcs nor images.
  void DrawString(float*, const vtkStdString&) override {}
  void DrawString(float*, const vtkUnicodeString&) override {}
  void DrawMathTextString(float*, const vtkStdString&) override {}
  void ComputeStringBounds(const vtkStdString&, float bounds[4]) override { std::fill_n(bounds, 4, 0.0F); }
  void ComputeStringBounds(const vtkUnicodeString&, float bounds[4]) override {
    std::fill_n(bounds, 4, 0.0F);
  }
  void ComputeJustifiedStringBounds(const char*, float bounds[4]) override { std::fill_n(bounds, 4, 0.0F); }
  void DrawPoints(float*, int, unsigned char*, int) override {}
  void DrawPointSprites(vtkImageData*, float*, int, unsigned char*, int) override {}
  void DrawEllipseWedge(float, float, float, float, float, float, float, float) override {}
  void DrawEllipticArc(float, float, float, float, float, float) override {}
  void DrawImage(float[2], float, vtkImageData*) override {}
  void DrawImage(const vtkRectf&, vtkImageData*) override {}
  void SetTexture(vtkImageData*, int) override {}
  void SetClipping(int*) override {}
  void EnableClipping(bool) override {}

 private:
  static Mat3 taken(vtkMatrix3x3* m) {
    Mat3 matrix;
    for (int i = 0; i < 9; ++i) matrix(i / 3, i % 3) = m->GetElement(i / 3, i % 3);
    return matrix;
  }
  std::vector<Vec2> placed(const float* points, int n) const {
    std::vector<Vec2> out;
    out.reserve(static_cast<std::size_t>(n));
    for (int i = 0; i < n; ++i, points += 2) {
      out.emplace_back((matrix_ * Vec3(points[0], points[1], 1)).head<2>());
    }
    return out;
  }
  static Colour colour_of(const unsigned char* rgba) { return {rgba[0], rgba[1], rgba[2], rgba[3] / 255.0}; }
  Stroke stroke() { return {colour_of(this->Pen->GetColorObject().GetData()), this->Pen->GetWidth()}; }
  void fill(float* points, int n) {
    const Colour colour = colour_of(this->Brush->GetColorObject().GetData());
    if (colour.opacity > 0) drawing_.area(placed(points, n), colour);
  }

  Drawing drawing_;
  Mat3 matrix_ = Mat3::Identity();
  std::vector<Mat3> pushed_;
};
vtkStandardNewMacro(DrawingDevice);

}  // namespace

Drawing recorded(vtkContextScene* scene) {
  vtkNew<DrawingDevice> device;
  vtkNew<vtkContext2D> painter;
  painter->Begin(device);
  scene->Paint(painter);
  painter->End();
  return std::move(device->drawing());
}

Drawing recorded(std::span<vtkAbstractContextItem* const> items, int width, int height) {
  vtkNew<vtkContextScene> scene;
  scene->SetGeometry(width, height);
  for (vtkAbstractContextItem* item : items) scene->AddItem(item);
  return recorded(scene);
}

Drawing* recording_of(vtkContext2D* painter) {
  auto* const device = DrawingDevice::SafeDownCast(painter->GetDevice());
  return device != nullptr ? &device->drawing() : nullptr;
}

}  // namespace fingerpad
