#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/mesh_files.hpp"
#include "support/paths.hpp"
#include "support/shell.hpp"

// What is misspelled on the command line is told with what is there.

namespace fingerpad::near_miss_test {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;

constexpr const char* scene =
    "[[plane]]\npoint_m = [0, 0, 0]\nnormal = [0, 0, 1]\n"
    "[motion]\nkind = \"line\"\nfrom_m = [0, 0, 0]\nto_m = [0.001, 0, 0]\nspeed_m_per_s = 1\n";

fs::path folder_with_scenes() {
  const fs::path folder = test::scratch_dir();
  fs::create_directory(folder / "scenes");
  for (const char* name : {"sweep", "bracket"})
    test::write_file(folder / "scenes", std::string(name) + ".toml", scene);
  return folder;
}

TEST(NearMiss, ARecordingThatIsNotFinishedIsToldBeforeANameLikeIt) {
  const fs::path folder = test::scratch_dir();
  test::write_file(folder, "live_e.csv", "t_s\n");
  test::write_file(folder, "live.csv.part", "t_s\n");
  EXPECT_THAT(test::fingerpad("export live.csv --out p.csv", folder).err,
              AllOf(HasSubstr("of a recording by that name there is live.csv.part"),
                    HasSubstr("still being written"), testing::Not(HasSubstr("live_e.csv"))));
}

TEST(NearMiss, OfASceneFileIsOneLineAndWritesNothing) {
  const fs::path folder = folder_with_scenes();
  for (const char* name : {"scenes/swep.toml", "scenes/sweep", "scenes/sweep.tml"}) {
    const auto result = test::fingerpad("replay " + std::string(name) + " --out o", folder);
    EXPECT_EQ(result.exit_code, 3) << name;
    EXPECT_EQ(result.out, "") << name;
    EXPECT_EQ(result.err, "fingerpad: error: " + std::string(name) +
                              ": cannot be read: there is no such file; did you mean scenes/sweep.toml?\n");
  }
  EXPECT_FALSE(fs::exists(folder / "o"));
}

TEST(NearMiss, ThatIsNearToNothingHasNoHint) {
  const auto result = test::fingerpad("replay scenes/dashboard.toml --out o", folder_with_scenes());
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_EQ(result.err, "fingerpad: error: scenes/dashboard.toml: cannot be read: there is no such file\n");
}

TEST(NearMiss, OfATraceForASceneSaysWhatOneDoesWithATrace) {
  const fs::path folder = folder_with_scenes();
  test::write_file(folder, "run.h5", std::string("\x89HDF\r\n\x1a\n", 8) + std::string(5 << 20, 'x'));
  const auto result = test::fingerpad("replay run.h5 scenes/sweep.toml --out o", folder);
  EXPECT_EQ(result.exit_code, 4) << "the other job is done";
  EXPECT_THAT(result.err,
              HasSubstr("run.h5: is a trace, a run that was made already: view, plot and export"));
  const auto alone = test::fingerpad("replay run.h5 --out p", folder);
  EXPECT_THAT(alone.out, testing::Not(HasSubstr("traces"))) << "none was written";
}

TEST(NearMiss, OfATableOrAMeshForASceneSaysWhatASceneIs) {
  const fs::path folder = folder_with_scenes();
  test::write_file(folder, "summary.csv", "job,exit_code\n1,0\n");
  test::write_file(folder, "part.stl", "solid part\nendsolid part\n");
  for (const char* name : {"summary.csv", "part.stl"}) {
    const auto result = test::fingerpad("replay " + std::string(name) + " --out o", folder);
    EXPECT_EQ(result.exit_code, 3);
    EXPECT_THAT(result.err, HasSubstr(std::string(name) + ":1:"));
    EXPECT_THAT(result.err, HasSubstr("is it a scene? That is a .toml file, which names its mesh"));
  }
}

TEST(NearMiss, OfAnOptionIsNamedBeforeWhatIsMissingForIt) {
  const fs::path folder = folder_with_scenes();
  for (const char* words : {"replay scenes/sweep.toml --ot o", "replay scenes/sweep.toml --ot=o"}) {
    const auto result = test::fingerpad(words, folder);
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_THAT(result.err,
                HasSubstr("fingerpad: error: there is no option '--ot'; did you mean '--out'?\n"));
  }
  const auto extra = test::fingerpad("replay scenes/sweep.toml --out o --colums t_s", folder);
  EXPECT_THAT(extra.err, HasSubstr("no option '--colums'; did you mean '--columns'?"));
  const auto own = test::fingerpad("--versoin", folder);
  EXPECT_EQ(own.exit_code, 2);
  EXPECT_THAT(own.err, HasSubstr("there is no option '--versoin'; did you mean '--version'?"));
  const auto missing = test::fingerpad("replay scenes/sweep.toml", folder);
  EXPECT_THAT(missing.err, HasSubstr("--out is required")) << "nothing is spelled wrong";
}

TEST(NearMiss, OfAnOptionThatIsLikeNoneTellsWhichThereAre) {
  const auto result = test::fingerpad("merge a b --threads 2", test::scratch_dir());
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.err, HasSubstr("there is no option '--threads'; merge has --help, --out"));
}

TEST(NearMiss, OfAKeyWithoutItsUnitIsTold) {
  const auto result = test::fingerpad("keys stifness", test::scratch_dir());
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.err, HasSubstr("a scene has no key 'stifness'; did you mean 'stiffness_n_per_m'?"));
}

#ifdef FINGERPAD_VIEW
TEST(NearMiss, AWindowsPictureIsAskedForByAnotherOption) {
  const auto result = test::fingerpad("view --out x.png s.toml", test::scratch_dir());
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.err, HasSubstr("there is no option '--out'; did you mean '--png'?"));
}
#endif

TEST(NearMiss, OfAFileThatASceneNamesIsToldFromItsFolder) {
  const fs::path folder = test::scratch_dir();
  fs::create_directory(folder / "meshes");
  test::write_file(folder / "meshes", "bracket.stl", "solid part\nendsolid part\n");
  test::write_file(folder / "meshes", "brackett.obj", "");
  test::write_file(folder, "s.toml", "[[part]]\nmesh = \"meshes/brackt.stl\"\n");
  const auto result = test::fingerpad("replay s.toml --out o", folder);
  EXPECT_THAT(result.err, HasSubstr("there is no such file; did you mean"));
  EXPECT_THAT(result.err, HasSubstr("meshes/bracket.stl?"));
}

TEST(NearMiss, HelpOnAMisspelledSubcommandIsToldSo) {
  const auto result = test::fingerpad("help merg", test::scratch_dir());
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.err, HasSubstr("there is no subcommand 'merg'; did you mean 'merge'?"));
}

TEST(NearMiss, OfFilesThatDifferInTheirNumbersAloneNoneIsNamed) {
  const fs::path folder = test::scratch_dir();
  test::write_file(folder, "subject_01.stl", "solid part\nendsolid part\n");
  fs::create_directory(folder / "partt.stl");
  for (const char* call : {"check subject_02.stl", "check part.stl"})
    EXPECT_THAT(test::fingerpad(call, folder).err, testing::EndsWith("there is no such file\n")) << call;
}

TEST(NearMiss, OfAnEndingACaseOrAFolderIsTold) {
  const fs::path folder = folder_with_scenes();
  test::write_file(folder / "scenes", "knob.stl", "solid part\nendsolid part\n");
  for (const auto& [call, meant] :
       {std::pair("check scenes/knob.STL", "such file; did you mean scenes/knob.stl?"),
        {"check scenes/Knob.stl", "such file; did you mean scenes/knob.stl?"},
        {"export scenes/sweep.tml --out x.csv", "such file; did you mean scenes/sweep.toml?"},
        {"replay scene/sweep.toml --out o", "; did you mean scenes/sweep.toml?"},
        {"replay scene/swep.toml --out o", "; did you mean the folder scenes?"},
        {"compare scens scenes", "such folder; did you mean scenes?"}})
    EXPECT_THAT(test::fingerpad(call, folder).err, HasSubstr(meant)) << call;
}

TEST(NearMiss, OfASceneWhoseNameEndsInAnotherWaySaysHowItIsToEnd) {
  const fs::path folder = test::scratch_dir();
  test::write_file(folder, "knob.tml", scene);
  test::write_file(folder, "knob.TOML", scene);
  test::write_file(folder, "knob.txt", scene);
  EXPECT_THAT(
      test::fingerpad("check knob.tml", folder).err,
      HasSubstr("its name ends in '.tml': STL, OBJ, PLY and OFF are read; a scene's ends in .toml\n"));
  EXPECT_THAT(test::fingerpad("check knob.TOML", folder).err,
              HasSubstr("are read; a scene's ends in .toml, in small letters\n"));
  EXPECT_THAT(test::fingerpad("check knob.txt", folder).err, HasSubstr("are read\n"));
}

TEST(NearMiss, OfWhatIsOneTooManySaysWhatIsTaken) {
  const fs::path folder = folder_with_scenes();
  const auto touched =
      test::fingerpad("touch scenes/sweep.toml motions --device recorded --headless", folder);
  EXPECT_EQ(touched.exit_code, 2);
  EXPECT_THAT(touched.err, HasSubstr("touch takes one SUBJECT: 'motions' is one too many; the recording that "
                                     "--device recorded follows is named in the scene ([motion] file)\n"));
  EXPECT_THAT(test::fingerpad("export a.h5 b.h5 --out x.csv", folder).err,
              HasSubstr("export takes one TRACE: 'b.h5' is one too many\n"));
}

TEST(NearMiss, OfASubcommandIsOneQuestion) {
  const auto near = test::fingerpad("repaly", test::scratch_dir());
  EXPECT_EQ(near.err,
            "fingerpad: error: there is no subcommand 'repaly'; did you mean 'replay'?\n"
            "Run with --help for the options.\n");
  const auto unlike = test::fingerpad("xyzzy", test::scratch_dir());
  EXPECT_THAT(unlike.err, HasSubstr("there is no subcommand 'xyzzy'; there are check, query"));
}

TEST(NearMiss, HelpIsAlsoASubcommand) {
  for (const char* name : {"", " merge"}) {
    const auto asked = test::fingerpad("help" + std::string(name), test::scratch_dir());
    EXPECT_EQ(asked.exit_code, 0);
    EXPECT_EQ(asked.out, test::fingerpad(std::string(name) + " --help", test::scratch_dir()).out);
  }
}

TEST(NearMiss, InABatchFailsItsJobAlone) {
  const auto result =
      test::fingerpad("replay scenes/bracket.toml scenes/swep.toml --out o", folder_with_scenes());
  EXPECT_EQ(result.exit_code, 4);
  EXPECT_THAT(result.err, HasSubstr("did you mean scenes/sweep.toml?"));
  EXPECT_EQ(result.out, "1 of 2 jobs done, traces and summary.csv in o\n");
}

TEST(NearMiss, OfALawsKeyIsRefusedInOneLine) {
  const fs::path folder = test::scratch_dir();
  test::write_file(folder, "s.toml",
                   std::string(scene) + "[friction]\nlaw = \"coulomb\"\nrestick = \"level\"\n");
  const auto result = test::fingerpad("replay s.toml --out o", folder);
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_EQ(result.out, "");
  EXPECT_EQ(result.err,
            "fingerpad: error: s.toml:11:1: 'restick' is not read by law \"coulomb\"; it is read by: "
            "stick-slip, finger-pad, contact-area\n");
}

TEST(NearMiss, OfAKeyWithSwappedLettersOrAPartOfAWordIsTold) {
  const fs::path folder = test::scratch_dir();
  const auto told = [&](const std::string& more) {
    test::write_file(folder, "s.toml", scene + more);
    return test::fingerpad("replay s.toml --out o", folder).err;
  };
  EXPECT_THAT(told("[friction]\nlwa = \"coulomb\"\n"),
              HasSubstr("unknown key 'lwa' in [friction]; did you mean 'law'?"));
  EXPECT_THAT(told("[[set]]\nfriction.lwa = [\"coulomb\"]\n"), HasSubstr("did you mean 'friction.law'?"));
  EXPECT_THAT(told("[[set]]\nmu_dynamic = [0.1]\n"),
              HasSubstr("unknown key 'mu_dynamic' in [[set]]; did you mean 'part.mu_dynamic' or "
                        "'plane.mu_dynamic'?"));
  EXPECT_THAT(told("[contact]\nmethod = \"point\"\n"),
              HasSubstr("unknown method 'point'; did you mean 'closest-point'?"));
  EXPECT_THAT(told("[friction]\nlaw = \"pad\"\n"), HasSubstr("did you mean 'finger-pad'?"));
}

TEST(NearMiss, OfAnHdf5FileByItsNameIsNotReadAsText) {
  const fs::path folder = test::scratch_dir();
  test::write_file(folder, "run.h5", "t_s,x_m,y_m,z_m\n0,0,0,0\n");
  test::write_file(folder, "s.toml",
                   "[[plane]]\npoint_m = [0, 0, 0]\nnormal = [0, 0, 1]\n[motion]\nfile = \"run.h5\"\n");
  for (const char* call : {"replay s.toml --out o", "export run.h5 --out a.csv"}) {
    const auto result = test::fingerpad(call, folder);
    EXPECT_EQ(result.exit_code, 3) << call;
    EXPECT_EQ(result.err,
              "fingerpad: error: run.h5: is no HDF5 file, as its name says: it is damaged, or "
              "something else by that name\n");
  }
  test::write_file(folder, "empty.h5", "");
  EXPECT_EQ(test::fingerpad("export empty.h5 --out a.csv", folder).err,
            "fingerpad: error: empty.h5: is empty: whatever was to write it ended before it had begun\n");
}

TEST(NearMiss, OfAnOptionsWordOrASubjectIsTold) {
  const fs::path folder = folder_with_scenes();
  const auto told = [&](const std::string& call) {
    const auto result = test::fingerpad(call, folder);
    EXPECT_EQ(result.exit_code, 2) << call;
    return result.err;
  };
  EXPECT_THAT(told("study contct --out o"),
              HasSubstr("SUBJECT: 'contct' is none of friction, contact, stability, scene; did you mean "
                        "'contact'?\n"));
  EXPECT_THAT(told("replay scenes/sweep.toml --out o --format cvs"), HasSubstr("did you mean 'csv'?"));
  EXPECT_THAT(told("keys frict"), HasSubstr("a scene has no key 'frict'; did you mean 'friction'?\n"));
  EXPECT_THAT(told("keys fric"), HasSubstr("did you mean 'friction'?"));
  EXPECT_THAT(told("keys part.mu_sttic"), HasSubstr("did you mean 'part.mu_static'?"));
  EXPECT_THAT(told("check part.stl --unit inch"), HasSubstr("'inch' is none of m, mm, cm, in"));
#ifdef FINGERPAD_VIEW
  EXPECT_THAT(told("plot a.h5 --out p.svg --show spectrm"), HasSubstr("did you mean 'spectrum'?"));
  for (const auto& [word, meant] :
       {std::pair("u", "s"), {"time", "t"}, {"tim", "t"}, {"travl", "s"}, {"angl", "angle"}})
    EXPECT_THAT(
        told(std::string("plot a.h5 --out p.svg --over ") + word),
        HasSubstr(std::string("'") + word +
                  "' is none of t (time), s (travel along the surface), angle (its turn); did you mean '" +
                  meant + "'?"));
  EXPECT_THAT(told("plot a.h5 --out p.svg --over q"), HasSubstr("angle (its turn)\n"));
#endif
}

TEST(NearMiss, OfAColumnIsToldWithTheColumn) {
  const fs::path folder = folder_with_scenes();
  const auto replayed = test::fingerpad("replay scenes/sweep.toml --out o --columns fx", folder);
  EXPECT_EQ(replayed.exit_code, 2);
  EXPECT_THAT(replayed.err, HasSubstr("'fx' is no column of a trace (did you mean 'fx_n'?)"));
#ifdef FINGERPAD_VIEW
  ASSERT_EQ(test::fingerpad("replay scenes/sweep.toml --out o --quiet", folder).exit_code, 0);
  const auto plotted = test::fingerpad("plot o/sweep.h5 --columns fx --out p.svg", folder);
  EXPECT_EQ(plotted.exit_code, 3);
  EXPECT_THAT(plotted.err, HasSubstr("o/sweep.h5: has no column 'fx'; did you mean 'fx_n'? (it has x_m, "));
  const auto other = test::fingerpad("plot o/sweep.h5 --columns pressure --out p.svg", folder);
  EXPECT_THAT(other.err, HasSubstr("has no column 'pressure'; it has x_m, "));
#endif
}

TEST(NearMiss, OfAProfileForASceneSaysWhereAProfileGoes) {
  const fs::path folder = folder_with_scenes();
  test::write_file(folder, "pad.toml", "lateral_axis_m = 3e-4\nlongitudinal_axis_m = 2.4e-4\n");
  std::vector<std::string> calls{"replay pad.toml --out o", "check pad.toml",
                                 "touch pad.toml --headless --device recorded", "touch pad.toml --headless"};
#ifdef FINGERPAD_VIEW
  calls.emplace_back("view pad.toml --png p.png");
  calls.emplace_back("touch pad.toml");
#endif
  for (const std::string& call : calls) {
    const auto result = test::fingerpad(call, folder);
    EXPECT_EQ(result.exit_code, 3) << call;
    EXPECT_THAT(
        result.err,
        HasSubstr("pad.toml: is the profile of a finger pad, not a scene: a scene names it, "
                  "with profile = \"pad.toml\" in [finger], which is a path from the scene's own folder\n"))
        << call;
  }
}

TEST(NearMiss, OfASceneForAProfileSaysWhatAProfileIs) {
  const fs::path folder = folder_with_scenes();
  test::write_file(folder, "s.toml",
                   "[[plane]]\npoint_m = [0, 0, 0]\nnormal = [0, 0, 1]\n[finger]\nprofile = \"s.toml\"\n"
                   "[motion]\nkind = \"line\"\nfrom_m = [0, 0, 0]\nto_m = [1, 0, 0]\nspeed_m_per_s = 1\n");
  const auto result = test::fingerpad("replay s.toml --out o", folder);
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_THAT(result.err,
              HasSubstr("s.toml: is a scene, not the profile of a finger pad: that is a file of the "
                        "pad's own numbers (lateral_axis_m, longitudinal_axis_m and so on), as "
                        "`fingerpad fit` writes one"));
  test::write_file(folder, "s.toml", "source = \"x\"\n[refused]\nlateral_axis_m = \"too few trials\"\n");
  EXPECT_THAT(test::fingerpad("replay s.toml --out o", folder).err,
              HasSubstr("s.toml: is the profile of a finger pad, not a scene"))
      << "though it has no axes";
}

#ifdef FINGERPAD_VIEW
TEST(NearMiss, OfASubjectIsToldBeforeThatThereIsNoDisplay) {
  const fs::path folder = folder_with_scenes();
  for (const char* call : {"view scenes/swep.toml", "touch scenes/swep.toml"}) {
    const auto result = test::fingerpad(call, folder);
    EXPECT_EQ(result.exit_code, 3) << call;
    EXPECT_THAT(result.err, HasSubstr("there is no such file; did you mean scenes/sweep.toml?")) << call;
  }
  for (const char* call : {"view absent.h5", "view absent.stl", "touch absent.stl"}) {
    const auto result = test::fingerpad(call, folder);
    EXPECT_EQ(result.exit_code, 3) << call;
    EXPECT_THAT(result.err, HasSubstr("cannot be read: there is no such file")) << call;
  }
  const auto there = test::fingerpad("view scenes/sweep.toml", folder);
  EXPECT_EQ(there.exit_code, 2);
  EXPECT_THAT(there.err, HasSubstr("no display: a window needs a screen"));
}
#endif

TEST(NearMiss, OfAFolderForATraceNamesTheTracesInIt) {
  const fs::path folder = folder_with_scenes();
  ASSERT_EQ(test::fingerpad("replay scenes/sweep.toml scenes/bracket.toml --out o --quiet", folder).exit_code,
            0);
  ASSERT_EQ(test::fingerpad("replay scenes/sweep.toml --format csv --out text --quiet", folder).exit_code, 0);
  std::vector<std::string> calls{"export {} --out e.csv"};
#ifdef FINGERPAD_VIEW
  for (const char* call : {"plot {} --out p.svg", "plot text/sweep.csv {} --out p.svg",
                           "plot {} --out p.svg --show residual", "view {} --png v.png"})
    calls.emplace_back(call);
#endif
  const auto told = [&](std::string call, const std::string& input) {
    call.replace(call.find("{}"), 2, input);
    const auto result = test::fingerpad(call, folder);
    EXPECT_EQ(result.exit_code, 3) << call;
    return result.err;
  };
  for (const std::string& call : calls) {
    const bool is_view = call.starts_with("view");
    const std::string is_folder =
        std::string(": is a folder, not ") + (is_view ? "a scene, mesh or trace; " : "a trace; ");
    EXPECT_EQ(told(call, "o"), "fingerpad: error: o" + is_folder + "name one: o/bracket.h5, o/sweep.h5\n")
        << call;
    EXPECT_THAT(told(call, "text"), HasSubstr("name one: text/sweep.csv\n")) << "its tables are none";
    EXPECT_THAT(told(call, "scenes"), HasSubstr("scenes" + is_folder + "no trace is in it\n"));
  }
}

TEST(NearMiss, OfADeviceIsToldWithTheDevices) {
  const auto result = test::fingerpad("touch scenes/sweep.toml --device poiner", folder_with_scenes());
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(
      result.err,
      AllOf(HasSubstr("--device"),
            HasSubstr(
                "unknown device 'poiner'; did you mean "
                "'pointer'? (known: mouse, pointer, keyboard, spacemouse, recorded, hand, network, haply)")));
  const auto help = test::fingerpad("touch --help", folder_with_scenes());
  EXPECT_THAT(help.out, HasSubstr("  mouse            the mouse and the keyboard"));
}

}  // namespace
}  // namespace fingerpad::near_miss_test
