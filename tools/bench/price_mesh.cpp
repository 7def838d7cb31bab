// Writes the mesh of over a million triangles of tools/prices: a sphere of 100 mm, as a binary STL in
// millimetres.
//   build/bin/price_mesh SPHERE.stl

#include <array>
#include <cstdint>
#include <fstream>
#include <iostream>

#include "meshes.hpp"

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: price_mesh SPHERE.stl\n";
    return 2;
  }
  constexpr double mm_of_diameter = 100;
  const fingerpad::TriangleSoup sphere = fingerpad::bench::icosphere(8);
  std::ofstream file(argv[1], std::ios::binary);
  const std::array<char, 80> header{};
  file.write(header.data(), header.size());
  const auto count = static_cast<std::uint32_t>(sphere.triangles.cols());
  file.write(reinterpret_cast<const char*>(&count), sizeof count);
  for (Eigen::Index t = 0; t < sphere.triangles.cols(); ++t) {
    std::array<float, 12> numbers{};  // a normal, which readers make themselves, and three corners
    for (int corner = 0; corner < 3; ++corner) {
      for (int axis = 0; axis < 3; ++axis)
        numbers[static_cast<std::size_t>(3 + 3 * corner + axis)] =
            static_cast<float>(mm_of_diameter * sphere.vertices_P(axis, sphere.triangles(corner, t)));
    }
    constexpr std::uint16_t attributes = 0;
    file.write(reinterpret_cast<const char*>(numbers.data()), sizeof numbers);
    file.write(reinterpret_cast<const char*>(&attributes), sizeof attributes);
  }
  if (file.flush()) return 0;
  std::cerr << argv[1] << ": cannot be written\n";
  return 1;
}
