#include <fmt/format.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCompositeDataSet.h>
#include <vtkDoubleArray.h>
#include <vtkErrorCode.h>
#include <vtkInformation.h>
#include <vtkIntArray.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkXMLMultiBlockDataWriter.h>

#include <algorithm>
#include <filesystem>

#include "base/error.hpp"
#include "base/tangent_frame.hpp"
#include "part/part.hpp"
#include "touch/world.hpp"
#include "trace/trace_column.hpp"
#include "view/block_folder.hpp"
#include "view/export_blocks.hpp"
#include "view/recorded_parts.hpp"

namespace fingerpad {
namespace {

vtkSmartPointer<vtkPoints> points_at(const std::vector<Vec3>& places_W) {
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataTypeToDouble();
  for (const Vec3& place : places_W) points->InsertNextPoint(place.data());
  return points;
}

void add_block(vtkMultiBlockDataSet* blocks, vtkPolyData* data, const std::string& name) {
  const unsigned at = blocks->GetNumberOfBlocks();
  blocks->SetBlock(at, data);
  blocks->GetMetaData(at)->Set(vtkCompositeDataSet::NAME(), name.c_str());
}

vtkSmartPointer<vtkPolyData> part_block(const Surface& surface) {
  const Part& part = *surface.part;
  std::vector<Vec3> places;
  for (Eigen::Index i = 0; i < part.vertices.cols(); ++i) {
    places.emplace_back(surface.p_WP + surface.R_WP * (part.centre_P + part.vertices.col(i)));
  }
  vtkNew<vtkCellArray> triangles;
  vtkNew<vtkIntArray> numbers;
  numbers->SetName("triangle");
  for (int t = 0; t < part.triangle_count(); ++t) {
    const vtkIdType corners[] = {part.triangles(0, t), part.triangles(1, t), part.triangles(2, t)};
    triangles->InsertNextCell(3, corners);
    numbers->InsertNextValue(part.file_triangle[static_cast<std::size_t>(t)]);
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points_at(places));
  data->SetPolys(triangles);
  data->GetCellData()->AddArray(numbers);
  return data;
}

/// A square of a plane that holds all that the finger touched, or where it was nearest.
vtkSmartPointer<vtkPolyData> plane_block(const Surface& plane, const std::vector<TickRecord>& rows) {
  constexpr double least_half_side_m = 0.01, margin = 1.2;
  const Mat3 frame = tangent_frame(plane.plane_normal_W, Vec3::UnitX());
  Vec2 low = Vec2::Constant(HUGE_VAL), high = Vec2::Constant(-HUGE_VAL);
  for (const TickRecord& row : rows) {
    const Vec3 way = row.p_WQ - plane.plane_point_W;
    const Vec2 at(frame.col(0).dot(way), frame.col(1).dot(way));
    low = low.cwiseMin(at);
    high = high.cwiseMax(at);
  }
  if (rows.empty()) low = high = Vec2::Zero();
  const Vec2 middle = (low + high) / 2;
  const double half = std::max(least_half_side_m, margin * (high - low).maxCoeff() / 2);
  std::vector<Vec3> corners;
  for (const Vec2& turn : {Vec2(-1, -1), Vec2(1, -1), Vec2(1, 1), Vec2(-1, 1)}) {
    const Vec2 at = middle + half * turn;
    corners.emplace_back(plane.plane_point_W + at.x() * frame.col(0) + at.y() * frame.col(1));
  }
  vtkNew<vtkCellArray> square;
  const vtkIdType order[] = {0, 1, 2, 3};
  square->InsertNextCell(4, order);
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points_at(corners));
  data->SetPolys(square);
  return data;
}

void add_vectors(vtkPolyData* data, const std::vector<const TickRecord*>& rows, const char* name,
                 Vec3 TickRecord::*member) {
  vtkNew<vtkDoubleArray> values;
  values->SetName(name);
  values->SetNumberOfComponents(3);
  for (const TickRecord* row : rows) values->InsertNextTuple((row->*member).data());
  data->GetPointData()->AddArray(values);
}

/// Every column of the trace, whose names say their units, and the forces and the normal as vectors.
void add_columns(vtkPolyData* data, const std::vector<const TickRecord*>& rows, const TraceInfo& info) {
  for (const TraceColumn& column : trace_columns(info)) {
    vtkSmartPointer<vtkDataArray> values = vtkSmartPointer<vtkDoubleArray>::New();
    if (column.kind == ColumnKind::phase || column.kind == ColumnKind::index)
      values = vtkSmartPointer<vtkIntArray>::New();
    values->SetName(std::string(column.name).c_str());
    for (const TickRecord* row : rows) values->InsertNextTuple1(column.get(*row));
    data->GetPointData()->AddArray(values);
  }
  add_vectors(data, rows, "force_n", &TickRecord::force_W_n);
  add_vectors(data, rows, "friction_n", &TickRecord::friction_W_n);
  add_vectors(data, rows, "normal", &TickRecord::normal_W);
}

vtkSmartPointer<vtkPolyData> path_block(const Trace& trace) {
  std::vector<Vec3> places;
  std::vector<const TickRecord*> rows;
  vtkNew<vtkCellArray> cell;
  if (!trace.rows.empty()) cell->InsertNextCell(static_cast<int>(trace.rows.size()));
  for (const TickRecord& row : trace.rows) {
    cell->InsertCellPoint(static_cast<vtkIdType>(rows.size()));
    rows.push_back(&row);
    places.push_back(row.p_WQ);
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points_at(places));
  // VTK ends the program over a line of one point.
  rows.size() == 1 ? data->SetVerts(cell) : data->SetLines(cell);
  add_columns(data, rows, trace.info);
  return data;
}

vtkSmartPointer<vtkPolyData> contact_block(const Trace& trace) {
  std::vector<Vec3> places;
  std::vector<const TickRecord*> rows;
  vtkNew<vtkCellArray> marks;
  for (const TickRecord& row : trace.rows) {
    if (row.phase == Phase::free) continue;
    const auto at = static_cast<vtkIdType>(rows.size());
    marks->InsertNextCell(1, &at);
    rows.push_back(&row);
    places.push_back(row.contact_W);
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points_at(places));
  data->SetVerts(marks);
  add_columns(data, rows, trace.info);
  return data;
}

/// Names that no other block has.
std::string unique_name(const std::string& wanted, std::vector<std::string>& taken) {
  std::string name = wanted;
  for (int k = 2; std::find(taken.begin(), taken.end(), name) != taken.end(); ++k) {
    name = fmt::format("{} {}", wanted, k);
  }
  taken.push_back(name);
  return name;
}

}  // namespace

std::vector<std::string> export_blocks(const Trace& trace, const std::string& trace_path,
                                       const std::string& path) {
  const RecordedParts parts = recorded_parts(trace, trace_path);
  vtkNew<vtkMultiBlockDataSet> blocks;
  std::vector<std::string> names{"path", "contact points"};
  for (const Surface& surface : parts.surfaces) {
    const std::string name = unique_name(shown_name(surface), names);
    add_block(blocks, surface.part ? part_block(surface) : plane_block(surface, trace.rows), name);
  }
  add_block(blocks, path_block(trace), names[0]);
  add_block(blocks, contact_block(trace), names[1]);

  BlockFolder folder(path);
  vtkNew<vtkXMLMultiBlockDataWriter> writer;
  writer->SetFileName(folder.writes_to().c_str());
  writer->SetInputData(blocks);
  if (writer->Write() == 0 || writer->GetErrorCode() != vtkErrorCode::NoError)
    throw Error(ErrorKind::fault, path, "cannot be written: " + folder.reason(writer->GetErrorCode()));
  folder.commit();
  return parts.missing;
}

}  // namespace fingerpad
