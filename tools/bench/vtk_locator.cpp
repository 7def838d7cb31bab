#include <vtkCellArray.h>
#include <vtkGenericCell.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStaticCellLocator.h>

#include "locator.hpp"

namespace fingerpad::bench {
namespace {

class VtkLocator : public Locator {
 public:
  explicit VtkLocator(const Part& part) {
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    for (Eigen::Index i = 0; i < part.vertices.cols(); ++i)
      points->InsertNextPoint(part.vertices.col(i).data());
    vtkNew<vtkCellArray> cells;
    for (int t = 0; t < part.triangle_count(); ++t) {
      cells->InsertNextCell({part.triangles(0, t), part.triangles(1, t), part.triangles(2, t)});
    }
    surface_->SetPoints(points);
    surface_->SetPolys(cells);
    surface_->BuildCells();
    locator_->SetDataSet(surface_);
    locator_->BuildLocator();
  }

  double distance2_m2(const Vec3& q) override {
    double closest[3];
    double distance2 = 0;
    vtkIdType cell = 0;
    int part_of_cell = 0;
    locator_->FindClosestPoint(q.data(), closest, cell_, cell, part_of_cell, distance2);
    return distance2;
  }

 private:
  vtkNew<vtkPolyData> surface_;
  vtkNew<vtkStaticCellLocator> locator_;
  vtkNew<vtkGenericCell> cell_;
};

}  // namespace

std::unique_ptr<Locator> make_vtk_locator(const Part& part) {
  return std::make_unique<VtkLocator>(part);
}

}  // namespace fingerpad::bench
