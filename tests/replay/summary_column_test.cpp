#include "replay/summary_column.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "replay/batch_results.hpp"
#include "replay/figures.hpp"
#include "support/paths.hpp"
#include "support/shell.hpp"

namespace fingerpad::summary_column_test {
namespace {
namespace fs = std::filesystem;

TEST(SummaryColumns, AreAsManyAsARunHasFigures) {
  EXPECT_EQ(summary_figure_columns().size(), Figures().values().size());
  EXPECT_EQ(Figures::names().size(), summary_figure_columns().size());
  for (const SummaryColumn& column : summary_figure_columns()) {
    if (column.name.ends_with("_j")) {
      EXPECT_EQ(column.unit, "J") << column.name;
    }
    if (column.name.ends_with("_force_n")) {
      EXPECT_EQ(column.unit, "N") << column.name;
    }
    EXPECT_FALSE(column.doc.empty()) << column.name;
    EXPECT_NE(column.get, nullptr) << column.name;
  }
}

TEST(SummaryColumns, StandInTheReadme) {
  const std::string readme = test::bytes_of(test::source_dir() / "README.md");
  EXPECT_NE(readme.find(summary_columns_text()), std::string::npos) << summary_columns_text();
}

TEST(SummaryColumns, AreTheFieldsOfTheSchema) {
  const auto schema = nlohmann::json::parse(summary_schema_text({"mesh", "friction.law"}));
  std::vector<std::string> names;
  for (const auto& field : schema["fields"]) {
    names.push_back(field["name"]);
    EXPECT_FALSE(field["description"].get<std::string>().empty()) << field;
    EXPECT_EQ(field.contains("unit"), field["type"] != "string") << field;
  }
  EXPECT_EQ(names, summary_header({"mesh", "friction.law"}));
  EXPECT_EQ(names[2], "mesh");
}

TEST(BatchResults, AreReadAsTheyWereWritten) {
  const fs::path folder = test::scratch_dir();
  std::ofstream(folder / "summary.csv")
      << "scene,job,mesh,status,ticks,pop_throughs,max_normal_force_n,energy_made_j,max_depth_m,warnings\n"
         "s,1,\"a,\"\"b\"\".stl\",ok,10,0,1,0.0001,0.01,\n"
         "s,2,c.stl,ok,10,2,1,0,0.01,\"c.stl: unit = \"\"m\"\", or 1 mm\"\n"
         "s,3,d.stl,\"d.stl: is, empty\",nan,nan,nan,nan,nan,\n"
         "s,4,e.stl,ok,10,0,1,0.0003,0.01,\n";
  std::ofstream(folder / "jobs.csv")
      << "number,file,scene,mesh,motion\n1,s-0001.h5,s,\"a,\"\"b\"\".stl\",m.csv\n"
         "2,../elsewhere.h5,s,c.stl,m.csv\n";
  std::ofstream(folder / "s-0001.h5");
  const BatchResults results = read_batch_results(folder.string());
  ASSERT_EQ(results.jobs.size(), 4u);
  EXPECT_EQ(results.set_keys, std::vector<std::string>{"mesh"});
  EXPECT_EQ(results.jobs[0].values[0].second, "a,\"b\".stl");
  EXPECT_EQ(results.jobs[0].mesh, "a,\"b\".stl");
  EXPECT_EQ(results.jobs[0].trace, (folder / "s-0001.h5").string());
  EXPECT_EQ(results.jobs[1].trace, "") << "a table's path leads nowhere else";
  EXPECT_EQ(results.jobs[2].status, "d.stl: is, empty");

  const auto order = worst_first(results.jobs);
  std::vector<std::size_t> jobs;
  for (const JobTrouble& trouble : order) jobs.push_back(trouble.job + 1);
  EXPECT_EQ(jobs, (std::vector<std::size_t>{3, 2, 4, 1}));
  EXPECT_EQ(order[0].words, "failed");
  EXPECT_EQ(order[1].words, "2 pop-throughs, c.stl: unit = \"m\", or 1 mm");
  EXPECT_EQ(order[2].words, "made 0.0003 J of energy");
  EXPECT_EQ(order[3].words, "") << "0.1 mJ is a hundredth of 1 N times 1 cm, and no more";
}

}  // namespace
}  // namespace fingerpad::summary_column_test
