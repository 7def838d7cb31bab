// Writes scenes/motions/*.csv, rubs over a plane and over the meshes of scenes/parts:
// make_motions PARTS_DIR OUT_DIR.
#include <cstdio>
#include <exception>
#include <memory>
#include <stdexcept>
#include <string>

#include "pad_pushes.hpp"
#include "plane_strokes.hpp"
#include "rub.hpp"

namespace {

using namespace fingerpad::parts;

constexpr double fingertip_radius_mm = 7;  // the scenes' radius_m
constexpr double rate_hz = 500;

struct Close {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

/// Columns dx,dy,dz only where the samples have directions.
void write_motion(const std::vector<RubSample>& samples, const std::string& directory,
                  const std::string& name) {
  const std::string path = directory + "/" + name + ".csv";
  const std::unique_ptr<std::FILE, Close> file(std::fopen(path.c_str(), "wb"));
  if (!file) throw std::runtime_error(path + ": cannot be written");
  const bool directed = !samples.front().direction.isZero();
  std::fputs(directed ? "t_s,x_m,y_m,z_m,dx,dy,dz\n" : "t_s,x_m,y_m,z_m\n", file.get());
  for (const RubSample& sample : samples) {
    // + 0.0 turns -0 into 0
    const Eigen::Vector3d p = (sample.centre_mm * 1e4).array().round() * 1e-7 + 0.0;
    std::fprintf(file.get(), "%.3f,%.7f,%.7f,%.7f", sample.t_s, p.x(), p.y(), p.z());
    const Eigen::Vector3d d = sample.direction;
    if (directed) std::fprintf(file.get(), ",%.4f,%.4f,%.4f", d.x(), d.y(), d.z());
    std::fputs("\n", file.get());
  }
  if (std::ferror(file.get()) != 0) throw std::runtime_error(path + ": cannot be written");
  std::printf("%-16s %6.1f s\n", name.c_str(), samples.back().t_s);
}

void make_all(const std::string& parts, const std::string& out) {
  for (const Recipe& recipe : rub_recipes()) {
    const RollingSphere surface(read_stl(parts + "/" + recipe.mesh), fingertip_radius_mm);
    write_motion(rub(recipe, surface, rate_hz), out, recipe.name);
  }
  write_motion(plane_strokes(rate_hz), out, "plane_strokes");
  constexpr double pad_rate_hz = 50;
  write_motion(pad_ellipses(pad_rate_hz), out, "pad_ellipses");
  write_motion(pad_pushes(pad_rate_hz), out, "pad_pushes");
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fputs("usage: make_motions PARTS_DIR OUT_DIR\n", stderr);
    return 2;
  }
  try {
    make_all(argv[1], argv[2]);
    return 0;
  } catch (const std::exception& failure) {
    std::fprintf(stderr, "make_motions: error: %s\n", failure.what());
    return 1;
  }
}
