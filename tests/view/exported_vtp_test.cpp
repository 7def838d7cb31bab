#include <gtest/gtest.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataReader.h>

#include <cmath>

#include "support/paths.hpp"
#include "trace/export.hpp"
#include "trace/trace_column.hpp"

// The exported VTP, read back with the reader that ParaView uses.

namespace fingerpad::exported_vtp_test {
namespace {

TEST(ExportedVtp, IsReadByVtkWithEveryColumnAndItsNans) {
  Trace trace;
  for (int k = 0; k < 5; ++k) {
    TickRecord row;
    row.t_s = 0.001 * k;
    row.p_WQ = Vec3(0.1 * k, -0.2, 1.0 / 3);
    if (k == 2) {
      row.phase = Phase::stick;
      row.normal_force_n = 0.7;
      row.stick_centre_W = Vec3(1, 2, 3);
      row.surface = 0;
    }
    trace.rows.push_back(row);
  }
  const auto path = test::scratch_dir() / "path.vtp";
  export_vtp(trace, path.string());

  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  ASSERT_EQ(reader->GetErrorCode(), 0u);
  vtkPolyData* data = reader->GetOutput();
  ASSERT_EQ(data->GetNumberOfPoints(), 5);
  EXPECT_EQ(data->GetNumberOfLines(), 1);
  EXPECT_EQ(data->GetPoint(4)[0], 0.4);
  EXPECT_EQ(data->GetPoint(4)[2], 1.0 / 3);
  for (const TraceColumn& column : trace_columns({})) {
    const std::string name(column.name);
    if (name == "x_m" || name == "y_m" || name == "z_m") continue;  // the points themselves
    ASSERT_NE(data->GetPointData()->GetArray(name.c_str()), nullptr) << name;
  }
  EXPECT_EQ(data->GetPointData()->GetArray("fn_n")->GetComponent(2, 0), 0.7);
  EXPECT_EQ(data->GetPointData()->GetArray("phase")->GetComponent(2, 0), 1);
  EXPECT_EQ(data->GetPointData()->GetArray("cz_m")->GetComponent(2, 0), 3);
  EXPECT_TRUE(std::isnan(data->GetPointData()->GetArray("cz_m")->GetComponent(1, 0)));
}

}  // namespace
}  // namespace fingerpad::exported_vtp_test
