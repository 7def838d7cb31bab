// Writes scenes/exact from the grip's exact solid: make_exact OUT_DIR. Ends 1 where a mesh is not closed or a
// path is not what it should be. See scenes/exact/README.md for the files.
#include <BRepAdaptor_Surface.hxx>
#include <BRep_Tool.hxx>
#include <Poly_Triangulation.hxx>
#include <Standard_Failure.hxx>
#include <TopExp_Explorer.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <memory>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "exact_shell.hpp"
#include "grip.hpp"
#include "grip_paths.hpp"
#include "tessellate.hpp"

namespace {

using namespace fingerpad::parts;

constexpr Fineness levels[] = {{0.5, 0.9}, {0.13, 0.5}, {0.035, 0.25}, {0.009, 0.125}};
constexpr int samples = 700;
constexpr double reach_mm = 2;       // of query points
constexpr double pace_mm = 0.1;      // along a path, from tick to tick
constexpr double path_depth_mm = 1;  // at which a path's feet are the nearest still
constexpr double mm = 1e-3;          // in metres

using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

File opened(const std::string& path) {
  File file(std::fopen(path.c_str(), "wb"), std::fclose);
  if (!file) throw std::runtime_error(path + ": cannot be written");
  return file;
}

/// Mean width of the triangles on curved faces, by area: a triangle's smallest height. As tessellated last.
double facet_across_mm(const TopoDS_Shape& solid) {
  double area = 0, weighted = 0;
  for (TopExp_Explorer faces(solid, TopAbs_FACE); faces.More(); faces.Next()) {
    const TopoDS_Face& face = TopoDS::Face(faces.Current());
    if (BRepAdaptor_Surface(face).GetType() == GeomAbs_Plane) continue;
    TopLoc_Location location;
    const Handle(Poly_Triangulation) mesh = BRep_Tool::Triangulation(face, location);
    for (int i = 1; i <= mesh->NbTriangles(); ++i) {
      int a = 0, b = 0, c = 0;
      mesh->Triangle(i).Get(a, b, c);
      const gp_Pnt pa = mesh->Node(a), pb = mesh->Node(b), pc = mesh->Node(c);
      const double twice = gp_Vec(pa, pb).Crossed(gp_Vec(pa, pc)).Magnitude();
      const double longest = std::max({pa.Distance(pb), pb.Distance(pc), pc.Distance(pa)});
      area += twice;
      weighted += twice * twice / longest;
    }
  }
  return weighted / area;
}

gp_Pnt corner_of(const ClosedMesh& mesh, std::size_t triangle, int corner) {
  const auto& v = mesh.vertices[mesh.triangles[triangle][std::size_t(corner)]];
  return {v[0], v[1], v[2]};
}

/// Points spread evenly by area over a mesh.
class Spread {
 public:
  explicit Spread(const ClosedMesh& mesh) : mesh_(mesh) {
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      const gp_Vec ab(corner_of(mesh, t, 0), corner_of(mesh, t, 1)),
          ac(corner_of(mesh, t, 0), corner_of(mesh, t, 2));
      area_.push_back((area_.empty() ? 0 : area_.back()) + ab.Crossed(ac).Magnitude());
    }
  }
  double uniform() { return double(random_() >> 11) * 0x1p-53; }
  /// Evenly within a ball.
  gp_Vec in_ball(double radius_mm) {
    for (;;) {
      const double x = 2 * uniform() - 1, y = 2 * uniform() - 1, z = 2 * uniform() - 1;
      if (x * x + y * y + z * z <= 1) return gp_Vec(x, y, z) * radius_mm;
    }
  }
  gp_Pnt operator()() {
    const auto at = std::upper_bound(area_.begin(), area_.end(), uniform() * area_.back());
    const auto t = std::min(std::size_t(at - area_.begin()), area_.size() - 1);
    double b = uniform(), c = uniform();
    if (b + c > 1) b = 1 - b, c = 1 - c;
    const gp_Pnt from = corner_of(mesh_, t, 0);
    return from.Translated(gp_Vec(from, corner_of(mesh_, t, 1)) * b +
                           gp_Vec(from, corner_of(mesh_, t, 2)) * c);
  }

 private:
  const ClosedMesh& mesh_;
  std::vector<double> area_;  ///< twice, summed up
  std::mt19937_64 random_{5};
};

/// To a micrometre, so that a query's few digits are all of it.
gp_Pnt rounded(const gp_Pnt& p) {
  return {std::round(1e3 * p.X()) / 1e3, std::round(1e3 * p.Y()) / 1e3, std::round(1e3 * p.Z()) / 1e3};
}

/// Without negative zeros.
void write_numbers(std::FILE* file, const gp_XYZ& p) {
  std::fprintf(file, "%.12g,%.12g,%.12g,", p.X() + 0.0, p.Y() + 0.0, p.Z() + 0.0);
}

void write_samples(const ExactShell& shell, const ClosedMesh& finest, const std::string& path) {
  Spread spread(finest);
  const File file = opened(path);
  std::fputs(
      "x_m,y_m,z_m,foot_x_m,foot_y_m,foot_z_m,nx,ny,nz,signed_distance_m,sharp_edge_m,on_face,surface\n",
      file.get());
  for (int i = 0; i < samples; ++i) {
    const ExactPoint on = shell.closest(spread());
    const gp_Pnt query = rounded(on.foot.Translated(spread.in_ball(reach_mm)));
    const ExactPoint exact = shell.closest(query);
    write_numbers(file.get(), query.XYZ() * mm);
    write_numbers(file.get(), exact.foot.XYZ() * mm);
    write_numbers(file.get(), exact.normal.XYZ());
    std::fprintf(file.get(), "%.12g,%.6g,%d,%s\n", exact.signed_distance_mm * mm, exact.to_sharp_edge_mm * mm,
                 exact.on_face ? 1 : 0, exact.surface.c_str());
  }
}

/// Where to ask a guide so that its feet lie `pace_mm` apart, nearly.
std::vector<double> even_pace(const ExactShell& shell, gp_Pnt (*guide)(double)) {
  constexpr int pieces = 800;
  std::vector<double> length{0};
  gp_Pnt last = shell.closest(guide(0)).foot;
  for (int i = 1; i <= pieces; ++i) {
    const gp_Pnt foot = shell.closest(guide(double(i) / pieces)).foot;
    if (foot.Distance(last) > 3 * pace_mm) throw std::runtime_error("a path jumps");
    length.push_back(length.back() + foot.Distance(last));
    last = foot;
  }
  std::vector<double> places;
  for (double at = 0; at < length.back(); at += pace_mm) {
    const auto next =
        std::max<std::ptrdiff_t>(1, std::upper_bound(length.begin(), length.end(), at) - length.begin());
    const double share =
        (at - length[std::size_t(next - 1)]) / (length[std::size_t(next)] - length[std::size_t(next - 1)]);
    places.push_back((double(next - 1) + share) / pieces);
  }
  return places;
}

void write_path(const ExactShell& shell, gp_Pnt (*guide)(double), const std::string& path) {
  const File file = opened(path);
  std::fputs("foot_x_m,foot_y_m,foot_z_m,nx,ny,nz\n", file.get());
  const std::vector<double> places = even_pace(shell, guide);
  for (const double along : places) {
    const ExactPoint exact = shell.closest(guide(along));
    const ExactPoint deep = shell.closest(exact.foot.Translated(gp_Vec(exact.normal) * -path_depth_mm));
    if (!exact.on_face || deep.foot.Distance(exact.foot) > 1e-7)
      throw std::runtime_error("under a path's foot another is nearer, at " + std::to_string(along));
    write_numbers(file.get(), exact.foot.XYZ() * mm);
    std::fprintf(file.get(), "%.12g,%.12g,%.12g\n", exact.normal.X() + 0.0, exact.normal.Y() + 0.0,
                 exact.normal.Z() + 0.0);
  }
  std::printf("%s: %zu ticks\n", path.c_str(), places.size());
}

int make_all(const std::string& directory) {
  const TopoDS_Shape solid = grip();
  const File table = opened(directory + "/meshes.csv");
  std::fputs("level,deflection_m,turn_rad,facet_m,triangles\n", table.get());
  int level = 0, faults = 0;
  ClosedMesh mesh;
  for (const Fineness& fineness : levels) {
    mesh = tessellate(solid, fineness);
    const double facet_mm = facet_across_mm(solid);
    std::fprintf(table.get(), "%d,%.12g,%.12g,%.6g,%zu\n", ++level, fineness.deflection_mm * mm,
                 fineness.turn_rad, facet_mm * mm, mesh.triangles.size());
    write_ply(mesh, "the grip, mm; (c) the fingerpad authors, BSD-3-Clause",
              directory + "/mesh-" + std::to_string(level) + ".ply");
    const std::string fault = fault_of(mesh);
    std::printf("mesh-%d %6zu triangles %9.2f mm3 %.3f mm across %s\n", level, mesh.triangles.size(),
                volume_mm3(mesh), facet_mm, fault.empty() ? "closed" : fault.c_str());
    if (!fault.empty()) ++faults;
  }
  const ExactShell shell(solid);
  write_samples(shell, mesh, directory + "/samples.csv");
  write_path(shell, rim_guide, directory + "/path-rim.csv");
  write_path(shell, boss_guide, directory + "/path-boss.csv");
  return faults == 0 ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fputs("usage: make_exact OUT_DIR\n", stderr);
    return 2;
  }
  try {
    return make_all(argv[1]);
  } catch (const Standard_Failure& failure) {
    std::fprintf(stderr, "make_exact: error: OpenCASCADE: %s\n", failure.GetMessageString());
  } catch (const std::exception& failure) {
    std::fprintf(stderr, "make_exact: error: %s\n", failure.what());
  }
  return 1;
}
