#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkImageData.h>
#include <vtkJPEGWriter.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkPolyDataNormals.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>
#include <vtkWindowToImageFilter.h>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

#include "base/colour.hpp"
#include "view/overlay.hpp"
#include "view/screen.hpp"
#include "view/thumbnail.hpp"

namespace fingerpad {
namespace {

constexpr int jpeg_quality = 80;
constexpr double path_width_px = 3;

void put_shape(const SmallShape& shape, const Vec3& origin_W, vtkPolyData* mesh) {
  vtkNew<vtkPoints> points;
  for (const Vec3& point_W : shape.points_W) {
    const Vec3 at_mm = (point_W - origin_W) * 1e3;
    points->InsertNextPoint(at_mm.data());
  }
  vtkNew<vtkCellArray> cells;
  for (const auto& triangle : shape.triangles) {
    const vtkIdType ids[] = {triangle[0], triangle[1], triangle[2]};
    cells->InsertNextCell(3, ids);
  }
  mesh->Initialize();
  mesh->SetPoints(points);
  mesh->SetPolys(cells);
}

void put_path(const SmallPath& path, const Vec3& origin_W, double max_force_n, vtkPolyData* line) {
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkUnsignedCharArray> colours;
  colours->SetNumberOfComponents(3);
  for (std::size_t i = 0; i < path.points_W.size(); ++i) {
    const Vec3 at_mm = (path.points_W[i] - origin_W) * 1e3;
    const vtkIdType here = points->InsertNextPoint(at_mm.data());
    if (i == 0) continue;
    const vtkIdType ids[] = {here - 1, here};
    cells->InsertNextCell(2, ids);
    const Colour colour = ramp_colour(max_force_n > 0 ? path.force_n[i] / max_force_n : 0);
    const std::uint8_t rgb[] = {colour.red, colour.green, colour.blue};
    colours->InsertNextTypedTuple(rgb);
  }
  line->Initialize();
  line->SetPoints(points);
  line->SetLines(cells);
  line->GetCellData()->SetScalars(colours);
}

Ball ball_around(const SmallShape& shape, const SmallPath& path) {
  const std::vector<Vec3>& points = shape.points_W.empty() ? path.points_W : shape.points_W;
  if (points.empty()) return {};
  Vec3 low = points.front(), high = points.front();
  for (const Vec3& point_W : points) {
    low = low.cwiseMin(point_W);
    high = high.cwiseMax(point_W);
  }
  return {(low + high) / 2, (high - low).norm() / 2};
}

}  // namespace

class Thumbnails::Studio {
 public:
  Studio(int width, int height) : screen_(screen_to_draw_on()) {
    window_->SetOffScreenRendering(1);
    window_->SetMultiSamples(4);
    window_->SetSize(width, height);
    window_->SetNumberOfLayers(2);
    window_->AddRenderer(scene_);
    window_->AddRenderer(front_);
    scene_->SetBackground(1, 1, 1);
    front_->SetLayer(1);  // before the shape, whose few triangles would hide half of a path that lies on it
    front_->SetActiveCamera(scene_->GetActiveCamera());
    shaded_->SetInputData(mesh_);
    shaded_->SetFeatureAngle(30);
    shaded_->ConsistencyOff();
    mesh_mapper_->SetInputConnection(shaded_->GetOutputPort());
    mesh_actor_->SetMapper(mesh_mapper_);
    const Colour metal = colours::metal;
    mesh_actor_->GetProperty()->SetColor(metal.red / 255.0, metal.green / 255.0, metal.blue / 255.0);
    mesh_actor_->GetProperty()->SetAmbient(0.15);
    line_mapper_->SetInputData(line_);
    line_actor_->SetMapper(line_mapper_);
    line_actor_->GetProperty()->SetLineWidth(path_width_px);
    line_actor_->GetProperty()->LightingOff();
    scene_->AddActor(mesh_actor_);
    front_->AddActor(line_actor_);
  }

  std::string jpeg(const SmallShape& shape, const SmallPath& path, double max_force_n, const LookFrom& look) {
    const Ball ball = ball_around(shape, path);
    if (ball.radius_m <= 0) return {};
    put_shape(shape, ball.centre_W, mesh_);
    put_path(path, ball.centre_W, max_force_n, line_);
    aim(ball.radius_m * 1e3, look);
    window_->Render();
    vtkNew<vtkWindowToImageFilter> grabber;
    grabber->SetInput(window_);
    grabber->SetInputBufferTypeToRGB();
    grabber->ReadFrontBufferOff();
    vtkNew<vtkJPEGWriter> writer;
    writer->SetInputConnection(grabber->GetOutputPort());
    writer->SetQuality(jpeg_quality);
    writer->WriteToMemoryOn();
    writer->Write();
    vtkUnsignedCharArray* const bytes = writer->GetResult();
    return {reinterpret_cast<const char*>(bytes->GetPointer(0)),
            static_cast<std::size_t>(bytes->GetNumberOfValues())};
  }

 private:
  void aim(double radius_mm, const LookFrom& look) {
    vtkCamera* const camera = scene_->GetActiveCamera();
    const Vec3 eye = look.towards_eye_W * radius_mm * 4;
    camera->SetFocalPoint(0, 0, 0);
    camera->SetPosition(eye.data());
    camera->SetViewUp(look.up_W.data());
    camera->ParallelProjectionOn();
    camera->SetParallelScale(0.82 * radius_mm);
    camera->SetClippingRange(0.5 * radius_mm, 8 * radius_mm);
  }

  std::unique_ptr<VirtualScreen> screen_;
  vtkNew<vtkRenderWindow> window_;
  vtkNew<vtkRenderer> scene_, front_;
  vtkNew<vtkPolyData> mesh_, line_;
  vtkNew<vtkPolyDataNormals> shaded_;
  vtkNew<vtkPolyDataMapper> mesh_mapper_, line_mapper_;
  vtkNew<vtkActor> mesh_actor_, line_actor_;
};

Thumbnails::Thumbnails(int width, int height) : studio_(std::make_unique<Studio>(width, height)) {}
Thumbnails::~Thumbnails() = default;

std::string Thumbnails::jpeg(const SmallShape& shape, const SmallPath& path, double max_force_n,
                             const LookFrom& look) {
  return studio_->jpeg(shape, path, max_force_n, look);
}

LookFrom telling_look(const Vec3& facing_W) {
  const Vec3 up_W = std::abs(facing_W.z()) < 0.9 ? Vec3::UnitZ() : Vec3::UnitY();
  const Vec3 right_W = up_W.cross(facing_W).normalized();
  LookFrom look;
  look.towards_eye_W =
      (facing_W + 0.45 * right_W + 0.45 * (std::abs(facing_W.z()) < 0.9 ? 1 : -1) * up_W).normalized();
  look.up_W = (up_W - look.towards_eye_W * look.towards_eye_W.dot(up_W)).normalized();
  return look;
}

}  // namespace fingerpad
