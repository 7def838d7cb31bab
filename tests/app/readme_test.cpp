#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <utility>

#include "contact/contact_method_table.hpp"
#include "friction/law_table.hpp"
#include "part/mesh_format.hpp"
#include "scene/scene_key.hpp"
#include "support/paths.hpp"
#include "support/shell.hpp"
#include "trace/trace_column.hpp"

// Every command that the README shows (but tools/run and tools/test, which build this very program) is run as
// it stands, in a folder that looks like the checkout.

namespace fingerpad::readme_test {
namespace {
namespace fs = std::filesystem;

/// The lines of the README's ```sh blocks.
std::vector<std::string> readme_commands() {
  std::istringstream text(test::bytes_of(test::source_dir() / "README.md"));
  std::vector<std::string> commands;
  bool in_block = false;
  for (std::string line; std::getline(text, line);) {
    if (line.rfind("```", 0) == 0) {
      in_block = line == "```sh";
    } else if (in_block && line != "./tools/run") {
      commands.push_back(line);
    }
  }
  return commands;
}

bool needs_view(const std::string& command) {
  return command.find("--with-parts") != std::string::npos ||
         command.find("fingerpad view") != std::string::npos ||
         command.find("fingerpad plot") != std::string::npos ||
         command.find("fingerpad report") != std::string::npos ||
         command.find("fingerpad study") != std::string::npos;  // it draws its charts
}

/// Beside the checkout's folder: few scenes, and of the exact surface few meshes. `study contact` judges auto
/// on all that it finds, which the tests of study do on all that there is.
fs::path folder_with_few_scenes(const fs::path& folder) {
  const fs::path few = folder / "few", scenes = test::source_dir() / "scenes";
  fs::create_directories(few / "scenes" / "exact");
  fs::create_directory_symlink(folder / "build", few / "build");
  for (const char* name : {"parts", "motions", "bracket.toml"})
    fs::create_symlink(scenes / name, few / "scenes" / name);
  for (const char* name : {"mesh-1.ply", "mesh-2.ply", "path-boss.csv", "path-rim.csv", "samples.csv"})
    fs::create_symlink(scenes / "exact" / name, few / "scenes" / "exact" / name);
  std::ifstream meshes(scenes / "exact" / "meshes.csv");
  std::ofstream few_meshes(few / "scenes" / "exact" / "meshes.csv");
  std::string line;
  for (int i = 0; i < 3 && std::getline(meshes, line); ++i) few_meshes << line << "\n";
  return few;
}

TEST(Readme, EveryCommandEndsZero) {
  const fs::path folder = test::scratch_dir();
  fs::create_directory_symlink(test::source_dir() / "scenes", folder / "scenes");
  fs::create_directory_symlink(test::source_dir() / "tools", folder / "tools");
  fs::create_directories(folder / "build" / "bin");
  fs::create_symlink(test::program(), folder / "build" / "bin" / "fingerpad");
  const fs::path few = folder_with_few_scenes(folder);
  const auto commands = readme_commands();
  EXPECT_GE(commands.size(), 10u);
  for (const std::string& command : commands) {
#ifndef FINGERPAD_VIEW
    if (needs_view(command)) continue;
#endif
    const bool judges_all = command.find("study contact") != std::string::npos;
    const auto result = test::shell(command, judges_all ? few : folder);
    EXPECT_EQ(result.exit_code, 0) << command << "\n" << result.err;
  }
#ifdef FINGERPAD_VIEW
  EXPECT_TRUE(std::any_of(commands.begin(), commands.end(), needs_view));
  for (const char* picture : {"figure12.png", "figure2.svg", "view.png", "housing.png"}) {
    EXPECT_TRUE(fs::exists(folder / "build" / "example" / picture)) << picture;
  }
  const std::string choices = test::bytes_of(folder / "build" / "study-contact" / "contact_choice.csv");
  EXPECT_NE(choices.find(",\"sphere: "), std::string::npos) << "a reason is one cell";
  EXPECT_EQ(choices.find("\"\"\""), std::string::npos) << "quoted once";
#endif
}

TEST(Readme, ShowsTheProgramsThatAreBuiltAgainstAnInstallation) {
  const std::string readme = test::bytes_of(test::source_dir() / "README.md");
  const fs::path programs = test::source_dir() / "tests" / "install" / "touch";
  for (const auto& [fence, file] : {std::pair("cmake", "CMakeLists.txt"), std::pair("cpp", "touch_mesh.cpp"),
                                    std::pair("cpp", "closest_points.cpp")}) {
    const std::string block = fmt::format("```{}\n{}```\n", fence, test::bytes_of(programs / file));
    EXPECT_NE(readme.find(block), std::string::npos) << file;
  }
}

TEST(Readme, ListsEveryLawWithItsKeysAndDefaults) {
  const std::string readme = test::bytes_of(test::source_dir() / "README.md");
  for (const LawEntry& law : law_table()) {
    EXPECT_NE(readme.find(fmt::format("| `{}` | {} |", law.name, law.summary)), std::string::npos)
        << law.name;
    for (const LawParameter& key : law.parameters) {
      EXPECT_NE(readme.find(fmt::format("`{} = {}`", key.key, key.default_value)), std::string::npos)
          << key.key;
    }
  }
}

TEST(Readme, TellsTheContactMethodsAndNormalsAsTheirRowsDo) {
  const std::string readme = test::bytes_of(test::source_dir() / "README.md");
  EXPECT_NE(readme.find("\n```" + contact_help_text() + "```\n"), std::string::npos)
      << "tools/scene_keys puts this into the README:" << contact_help_text();
}

TEST(Readme, ShowsTheSceneFileAsTheRowsOfItsKeysTellIt) {
  const std::string readme = test::bytes_of(test::source_dir() / "README.md");
  EXPECT_NE(readme.find("\n```toml\n" + scene_keys_text() + "```\n"), std::string::npos)
      << "tools/scene_keys puts this into the README:\n"
      << scene_keys_text();
}

TEST(Readme, NamesEveryMeshFormat) {
  const std::string readme = test::bytes_of(test::source_dir() / "README.md");
  EXPECT_NE(readme.find("reads " + mesh_format_names("and")), std::string::npos);
}

TEST(Readme, HasARowForEachTraceColumn) {
  std::istringstream text(test::bytes_of(test::source_dir() / "README.md"));
  std::vector<std::string> lines;
  for (std::string line; std::getline(text, line);) lines.push_back(line);
  for (const TraceColumn& column : trace_columns()) {
    EXPECT_TRUE(std::any_of(lines.begin(), lines.end(), [&](const std::string& line) {
      return line.rfind("| `", 0) == 0 && line.find(column.name) < line.find(" | ") &&
             line.find(fmt::format("| {} |", column.doc)) != std::string::npos;
    })) << column.name;
  }
}

}  // namespace
}  // namespace fingerpad::readme_test
