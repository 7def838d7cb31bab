#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <filesystem>

#include "app/commands.hpp"
#include "app/number_option.hpp"
#include "app/output_folder.hpp"
#include "app/output_name.hpp"
#include "app/standard_streams.hpp"
#include "app/study_output.hpp"
#include "app/study_scene.hpp"
#include "app/word_option.hpp"
#include "base/error.hpp"
#include "study/studies.hpp"

namespace fingerpad {
namespace {

struct StudyOptions {
  std::string subject, scene, out_dir;
  std::string exact_folder = "scenes/exact";
  bool exact_folder_given = false;
  std::string parts_folder;
  int most_levels = 0;  ///< 0: all
};

/// The folder of the CAD part's exact surface; "" where it is not where it was looked for by default, and
/// that is told.
std::string exact_folder(const StudyOptions& options) {
  const std::string table = options.exact_folder + "/meshes.csv";
  std::error_code ignored;
  if (options.exact_folder_given || std::filesystem::exists(table, ignored)) return options.exact_folder;
  print_err(
      "fingerpad: warning: {}: there is no such file: the study goes without the CAD part's exact surface; "
      "--exact DIR says where it is\n",
      table);
  return "";
}

StudyReport studied(const StudyOptions& options) {
  const std::string& subject = options.subject;
  const bool on_terminal = isatty(STDERR_FILENO) != 0;
  const StudyProgress progress = [&](const std::string& next) {
    if (on_terminal) print_err("{}: {} ...\n", subject, next);
  };
  if (subject == "stability") return study_stability(progress);
  if (subject == "friction") return study_friction(progress);
  const std::string exact = exact_folder(options);
  const std::string scenes = exact.empty() ? "" : exact + "/..";
  return study_contact(progress, {exact, scenes, options.parts_folder,
                                  options.most_levels == 0 ? all_levels : options.most_levels});
}

/// A scene is what `scene` studies, and what no other subject has; levels are those of `contact`.
void refuse_odd_options(const StudyOptions& options) {
  if (options.subject == "scene" && options.scene.empty())
    throw Error(ErrorKind::usage, "study scene", "needs a scene: fingerpad study scene SCENE.toml --out DIR");
  if (options.subject != "scene" && !options.scene.empty())
    throw Error(ErrorKind::usage, options.scene, fmt::format("study {} takes no scene", options.subject));
  if (options.subject != "contact" && options.most_levels != 0)
    throw Error(ErrorKind::usage, "--levels", "is of study contact alone");
}

int study(const StudyOptions& options) {
  refuse_odd_options(options);
  if (options.out_dir == "-")
    throw Error(ErrorKind::usage, "--out", "a study needs a folder, not standard output");
  if (options.subject == "scene") return study_one_scene(options.scene, options.out_dir);
  const OutputFolder folder(options.out_dir);  // before the work, which would be lost without it
  const StudyReport report = studied(options);
  print_out("{}\n", write_study(report, options.out_dir));
  return 0;
}

}  // namespace

void add_study(CLI::App& program, Action& action) {
  auto options = std::make_shared<StudyOptions>();
  CLI::App* command =
      program.add_subcommand("study", "Measure speed against accuracy, and stability, as tables and charts");
  command->add_option("SUBJECT", options->subject, "friction, contact, stability or scene")
      ->required()
      ->check(one_of({"friction", "contact", "stability", "scene"}));
  command->add_option("SCENE", options->scene, "scene: the scene (TOML) whose choices are compared");
  refuse_empty(command->add_option("--out", options->out_dir,
                                   "Folder for the CSV tables and the charts (PNG and SVG)"),
               "FOLDER")
      ->required();
  const CLI::Option* exact = command
                                 ->add_option("--exact", options->exact_folder,
                                              "contact: folder of a CAD part's tessellations and points of "
                                              "its exact surface; default scenes/exact")
                                 ->type_name("FOLDER");
  refuse_empty(command->add_option("--parts", options->parts_folder,
                                   "contact: folder of meshes (unit mm) on which to judge auto, besides the "
                                   "scenes beside scenes/exact"),
               "FOLDER");
  command
      ->add_option("--levels", options->most_levels,
                   "contact: so many tessellations of each exact surface, the coarsest; 2 take half of the "
                   "time")
      ->check(whole_number_in(2, 5));
  command->footer(
      "friction: every law's error against its own limit of short ticks and against exact stick-slip, by "
      "rate, beside its cost.\n"
      "contact: every method and kind of normals against exact surfaces, by tessellation, beside its cost; "
      "force "
      "steps; strikes through thin walls; what auto promises, keeps and costs.\n"
      "stability: largest stable stiffness by rate, damping and delay; loads at which stick buzzes; energy "
      "made; restick rules; velocity.\n"
      "scene: every method, normals, rate and reading of events over the scene's own motion, against the "
      "most "
      "complete model: choices.csv, a chart, and scene.toml with the cheapest choice that keeps the scene's "
      "tolerances; under a minute.\n"
      "contact takes two minutes (--levels 2: one), friction and stability ten to thirty seconds. "
      "Files named *_measured "
      "hold times of this machine; all others are "
      "the same "
      "at every run.");
  command->callback([options, exact, &action] {
    options->exact_folder_given = exact->count() > 0;
    action = [options] { return study(*options); };
  });
}

}  // namespace fingerpad
