// Writes scenes/parts/*.stl from exact solids: make_parts OUT_DIR. Ends 1 where a mesh is not closed.
#include <Standard_Failure.hxx>
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include "parts.hpp"
#include "tessellate.hpp"

namespace {

using namespace fingerpad::parts;

struct Output {
  const char* name;
  Fineness fineness;
};

struct Job {
  TopoDS_Shape (*make)();
  std::vector<Output> outputs;
};

const std::vector<Job> jobs = {
    {dashboard, {{"dashboard_coarse", {0.5, 0.9}}, {"dashboard_fine", {0.08, 0.4}}}},
    {bracket,
     {{"bracket_coarse", {0.3, 0.5}}, {"bracket_medium", {0.05, 0.25}}, {"bracket_fine", {0.02, 0.15}}}},
    {housing, {{"housing_coarse", {0.3, 0.6}}, {"housing_fine", {0.04, 0.25}}}},
};

int make_all(const std::string& directory) {
  int faults = 0;
  for (const Job& job : jobs) {
    const TopoDS_Shape solid = job.make();
    for (const Output& output : job.outputs) {
      const ClosedMesh mesh = tessellate(solid, output.fineness);
      const std::string path = directory + "/" + output.name + ".stl";
      write_stl(mesh, output.name, path);
      const std::string fault = fault_of(read_stl(path));  // as a reader will weld it
      std::printf("%-18s %6zu triangles %9.1f mm3 %s\n", output.name, mesh.triangles.size(), volume_mm3(mesh),
                  fault.empty() ? "closed" : fault.c_str());
      if (!fault.empty()) ++faults;
    }
  }
  return faults == 0 ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fputs("usage: make_parts OUT_DIR\n", stderr);
    return 2;
  }
  try {
    return make_all(argv[1]);
  } catch (const Standard_Failure& failure) {
    std::fprintf(stderr, "make_parts: error: OpenCASCADE: %s\n", failure.GetMessageString());
  } catch (const std::exception& failure) {
    std::fprintf(stderr, "make_parts: error: %s\n", failure.what());
  }
  return 1;
}
