#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <iterator>
#include <sstream>

#include "support/paths.hpp"
#include "support/shell.hpp"

// Man pages, bash completion, versions: what is told of the program outside of it.

namespace fingerpad::manual_test {
namespace {
namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

fs::path folder_with_manual() {
  const fs::path folder = test::scratch_dir();
  fs::create_directory(folder / "m");
  const auto result = test::fingerpad("--write-manual m", folder);
  EXPECT_EQ(result.exit_code, 0) << result.err;
  return folder;
}

/// What bash offers for a word behind others: "fingerpad replay --fo".
std::vector<std::string> completed(const fs::path& folder, const std::string& words) {
  const auto result =
      test::shell("bash -c 'source m/fingerpad.bash; COMP_WORDS=(" + words +
                      "); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _fingerpad; echo ${COMPREPLY[@]}'",
                  folder);
  EXPECT_EQ(result.exit_code, 0) << result.err;
  std::istringstream text(result.out);
  return {std::istream_iterator<std::string>(text), {}};
}

TEST(Manual, HasAPageOfEachSubcommandWithAllItsOptions) {
  const fs::path folder = folder_with_manual();
  std::size_t pages = 0;
  for (const auto& entry : fs::directory_iterator(folder / "m")) {
    const std::string name = entry.path().stem().string();
    if (entry.path().extension() != ".1" || name == "fingerpad") continue;
    ++pages;
    const std::string page = test::bytes_of(entry.path());
    std::istringstream help(test::fingerpad(name.substr(10) + " --help", folder).out);
    for (std::string word; help >> word;) {
      if (!word.starts_with("--") || word.size() < 3) continue;
      std::string option = word.substr(0, word.find_first_of(",.;:)` "));
      for (std::size_t at = 0; (at = option.find('-', at)) != std::string::npos; at += 2)
        option.insert(at, "\\");
      EXPECT_THAT(page, HasSubstr(option)) << name;
    }
    EXPECT_THAT(test::bytes_of(folder / "m" / "fingerpad.1"), HasSubstr("fingerpad\\-" + name.substr(10)));
  }
  EXPECT_GE(pages, 8u);
}

TEST(Manual, IsRoffWithoutAWarning) {
  const fs::path folder = folder_with_manual();
  if (test::shell("command -v groff", folder).exit_code != 0) GTEST_SKIP() << "groff is not installed";
  const auto result = test::shell("groff -man -ww -z -Tutf8 m/*.1", folder);
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.err, "");
}

TEST(Completion, OffersSubcommandsOptionsChoicesAndKeys) {
  const fs::path folder = folder_with_manual();
  EXPECT_THAT(completed(folder, "fingerpad re"), testing::Contains("replay"));
  EXPECT_THAT(completed(folder, "fingerpad che"), testing::ElementsAre("check"));
  EXPECT_THAT(completed(folder, "fingerpad replay --for"), testing::ElementsAre("--format"));
  EXPECT_THAT(completed(folder, "fingerpad replay --format h"), testing::ElementsAre("h5"));
  EXPECT_THAT(completed(folder, "fingerpad keys part.mu_"),
              testing::ElementsAre("part.mu_static", "part.mu_dynamic"));
  EXPECT_THAT(completed(folder, "fingerpad compare m/fingerpad.b"), testing::ElementsAre("m/fingerpad.bash"));
}

TEST(Keys, AreToldWithDefaultAndMeaning) {
  const fs::path folder = test::scratch_dir();
  const auto law = test::fingerpad("keys friction.law mu_static", folder);
  EXPECT_EQ(law.exit_code, 0) << law.err;
  EXPECT_THAT(law.out, AllOf(HasSubstr("friction.law = \"finger-pad\""), HasSubstr("part.mu_static = 0.3"),
                             Not(HasSubstr("mu_dynamic"))));
  for (const auto& [word, told] : {std::pair("frictoin", "did you mean 'friction'?"),
                                   {"mu_statik", "did you mean 'mu_static'?"},
                                   {"set", "[[set]] takes any of the keys"}})
    EXPECT_THAT(test::fingerpad(std::string("keys ") + word, folder).err, testing::HasSubstr(told));
  const auto wrong = test::fingerpad("keys part.mu_statik", folder);
  EXPECT_EQ(wrong.exit_code, 2);
  EXPECT_THAT(wrong.err, HasSubstr("did you mean 'part.mu_static'?"));
}

TEST(Version, NamesTheLibraries) {
  const std::string words = test::fingerpad("--version", test::scratch_dir()).out;
  EXPECT_TRUE(words.starts_with("fingerpad "));
  std::vector<std::string> libraries = {"Embree", "OpenMesh", "HDF5", "Eigen"};
#ifdef FINGERPAD_VIEW
  libraries.emplace_back("VTK");
#endif
#ifdef FINGERPAD_MPI
  libraries.emplace_back("MPI");
#endif
  for (const std::string& library : libraries) {
    const std::size_t line = words.find("\n  " + library);
    ASSERT_NE(line, std::string::npos) << library;
    EXPECT_THAT(words.substr(line + 1, words.find('\n', line + 1) - line),
                testing::ContainsRegex("[0-9]\\.[0-9]"));
  }
}

}  // namespace
}  // namespace fingerpad::manual_test
