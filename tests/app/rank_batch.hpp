#pragma once

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include "support/paths.hpp"
#include "support/shell.hpp"

// A batch for ranks, and what it leaves.

namespace fingerpad::test {

/// Eight rubs over two parts and a plane, in two scenes, one with a mesh that cannot be read.
inline std::filesystem::path folder_with_batch(int rate_hz = 1000, int duration_s = 2) {
  const std::filesystem::path folder = scratch_dir();
  const std::string rub =
      "[motion]\nkind = \"sine\"\ncentre_m = [0, 0, -0.001]\ndirection = [1, 0, 0]\n"
      "amplitude_m = 0.02\nfrequency_hz = 1\nduration_s = " +
      std::to_string(duration_s) + "\nrate_hz = " + std::to_string(rate_hz) + "\n";
  std::ofstream(folder / "few.off")
      << "OFF\n4 4 0\n0 0 0\n40 0 0\n0 40 0\n0 0 40\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";
  std::ofstream(folder / "broken.off") << "OFF\n";
  std::ofstream(folder / "parts.toml")
      << "name = \"parts\"\n[[part]]\nmesh = \"few.off\"\n" + rub +
             "[[set]]\nmesh = [\"few.off\", \"broken.off\"]\nseed = [1, 2]\n";
  std::ofstream(folder / "plane.toml")
      << "name = \"plane\"\n[[plane]]\npoint_m = [0, 0, 0]\nnormal = [0, 0, 1]\n" + rub +
             "[[set]]\nseed = [1, 2, 3, 4]\n";
  return folder;
}

/// Every file but the times, its name first.
inline std::vector<std::pair<std::string, std::string>> all_bytes(const std::filesystem::path& folder) {
  std::vector<std::pair<std::string, std::string>> files;
  for (const std::filesystem::directory_entry& entry :
       std::filesystem::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file() && entry.path().filename() != "timing.csv")
      files.emplace_back(std::filesystem::relative(entry.path(), folder).string(), bytes_of(entry.path()));
  }
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace fingerpad::test
