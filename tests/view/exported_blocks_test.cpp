#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <vtkCellData.h>
#include <vtkCompositeDataSet.h>
#include <vtkDataArray.h>
#include <vtkInformation.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkXMLMultiBlockDataReader.h>
#include <Eigen/Geometry>

#include <fstream>
#include <map>

#include "base/error.hpp"
#include "scene/scene_file.hpp"
#include "support/paths.hpp"
#include "trace/trace_column.hpp"
#include "view/export_blocks.hpp"
#include "view/rub.hpp"

// The parts beside the path, read back with the reader that ParaView uses.

namespace fingerpad::exported_blocks_test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using Blocks = std::map<std::string, vtkSmartPointer<vtkPolyData>>;

Blocks read_back(const std::filesystem::path& path) {
  vtkNew<vtkXMLMultiBlockDataReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  EXPECT_EQ(reader->GetErrorCode(), 0u);
  auto* data = vtkMultiBlockDataSet::SafeDownCast(reader->GetOutput());
  Blocks blocks;
  for (unsigned i = 0; data != nullptr && i < data->GetNumberOfBlocks(); ++i) {
    blocks[data->GetMetaData(i)->Get(vtkCompositeDataSet::NAME())] =
        vtkPolyData::SafeDownCast(data->GetBlock(i));
  }
  return blocks;
}

/// A rub over a torus that stands turned and moved in the world, and a plane that is not touched.
Trace rub_trace() {
  ViewInput input = test::torus_rub(0.1);
  Trace trace;
  trace.rows = input.rows;
  auto world = std::make_shared<World>(*input.world);
  world->surfaces[0].p_WP = Vec3(1, 2, 3);
  world->surfaces[0].R_WP = Eigen::AngleAxisd(0.5, Vec3::UnitZ()).toRotationMatrix();
  world->surfaces.push_back(world->surfaces[0]);
  Surface plane;
  plane.plane_point_W = Vec3(0, 0, -1);
  world->surfaces.push_back(plane);
  trace.world = world;
  return trace;
}

TEST(ExportedBlocks, HoldPartsPathAndContactPointsByName) {
  const Trace trace = rub_trace();
  const auto path = test::scratch_dir() / "rub.vtm";
  EXPECT_THAT(export_blocks(trace, "rub.h5", path.string()), IsEmpty());
  Blocks blocks = read_back(path);
  ASSERT_EQ(blocks.size(), 5u);
  ASSERT_TRUE(blocks.count("torus.stl") && blocks.count("torus.stl 2") && blocks.count("plane"));

  const Surface& torus = trace.world->surfaces[0];
  vtkPolyData* part = blocks["torus.stl"];
  ASSERT_EQ(part->GetNumberOfCells(), torus.part->triangle_count());
  const Vec3 corner_W = torus.p_WP + torus.R_WP * (torus.part->centre_P + torus.part->vertices.col(5));
  for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(part->GetPoint(5)[axis], corner_W[axis], 1e-15);
  EXPECT_EQ(part->GetCellData()->GetArray("triangle")->GetTuple1(7), torus.part->file_triangle[7]);

  vtkPolyData* line = blocks["path"];
  ASSERT_EQ(line->GetNumberOfPoints(), static_cast<int>(trace.rows.size()));
  EXPECT_EQ(line->GetNumberOfLines(), 1);
  vtkPolyData* contacts = blocks["contact points"];
  ASSERT_EQ(contacts->GetNumberOfPoints(), 100) << "the ticks that touch";
  EXPECT_EQ(contacts->GetPoint(3)[1], trace.rows[103].contact_W.y());
  for (const TraceColumn& column : trace_columns({})) {
    const std::string name(column.name);
    EXPECT_NE(line->GetPointData()->GetArray(name.c_str()), nullptr) << name;
    EXPECT_NE(contacts->GetPointData()->GetArray(name.c_str()), nullptr) << name;
  }
  EXPECT_EQ(contacts->GetPointData()->GetArray("friction_n")->GetComponent(3, 1),
            trace.rows[103].friction_W_n.y());
}

TEST(ExportedBlocks, APathOfOneTickIsAPoint) {
  Trace trace = rub_trace();
  trace.rows.resize(1);
  const auto path = test::scratch_dir() / "tick.vtm";
  EXPECT_THAT(export_blocks(trace, "tick.h5", path.string()), IsEmpty());
  Blocks blocks = read_back(path);
  ASSERT_TRUE(blocks.count("path"));
  EXPECT_EQ(blocks["path"]->GetNumberOfPoints(), 1);
  EXPECT_EQ(blocks["path"]->GetNumberOfVerts(), 1);
}

TEST(ExportedBlocks, ThatChangedOrVanishedAreTold) {
  const auto folder = test::scratch_dir();
  std::ofstream(folder / "a.stl")
      << "solid a\n facet normal 0 0 1\n  outer loop\n   vertex 0 0 0\n   vertex 1 0 0\n"
         "   vertex 0 1 0\n  endloop\n endfacet\nendsolid a\n";
  Trace trace = rub_trace();
  trace.info.scene_text =
      "[[part]]\nmesh = \"a.stl\"\n[[part]]\nmesh = \"/gone/from/here.stl\"\n[[part]]\nmesh = "
      "\"elsewhere.stl\"\n[motion]\nkind = \"line\"\nfrom_m = "
      "[0,0,0]\n"
      "to_m = [1,0,0]\nspeed_m_per_s = 1\n";
  trace.info.mesh_hashes = {"0123", "4567"};
  const std::string of_trace = (folder / "t.h5").string(), out = (folder / "t.vtm").string();
  EXPECT_THAT(export_blocks(trace, of_trace, out),
              ElementsAre(HasSubstr("a.stl: has changed since; the shape is the one that the trace holds"),
                          HasSubstr("/gone/from/here.stl: is no longer there")));
  EXPECT_EQ(read_back(out).size(), 5u);
  trace.world = nullptr;  // as of parts too large for a trace
  EXPECT_THAT(export_blocks(trace, of_trace, out),
              ElementsAre(HasSubstr("a.stl: has changed since the trace was made; it is shown as it is now"),
                          HasSubstr("the trace does not hold its shape, so it is left out"),
                          HasSubstr("elsewhere.stl: cannot be read")));
  EXPECT_EQ(read_back(out).size(), 3u) << "a.stl, path and contact points: no block of before is left";
  trace.info.scene_text.clear();
  EXPECT_THAT(export_blocks(trace, "t.csv", out),
              ElementsAre(HasSubstr("t.csv: does not say what the finger touched")));
}

TEST(ExportedBlocks, LeaveTheFilesOfOthersAlone) {
  const auto folder = test::scratch_dir();
  std::filesystem::create_directory(folder / "t");
  std::ofstream(folder / "t" / "thesis.tex") << "years\n";
  EXPECT_THROW(export_blocks(rub_trace(), "t.h5", (folder / "t.vtm").string()), Error);
  EXPECT_TRUE(std::filesystem::exists(folder / "t" / "thesis.tex"));
  EXPECT_FALSE(std::filesystem::exists(folder / "t.vtm"));
}

}  // namespace
}  // namespace fingerpad::exported_blocks_test
