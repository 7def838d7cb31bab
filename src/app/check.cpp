#include <CLI/CLI.hpp>
#include <algorithm>
#include <cctype>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>

#include "app/check_mesh.hpp"
#include "app/check_scene.hpp"
#include "app/commands.hpp"
#include "app/standard_streams.hpp"
#include "app/unit_option.hpp"
#include "base/error.hpp"
#include "base/printable_text.hpp"
#include "part/mesh_format.hpp"

namespace fingerpad {
namespace {

struct CheckOptions {
  std::vector<std::string> meshes;
  std::string unit = "mm";
  bool json = false;
  bool repair = false;
  bool says_how = false;  ///< unit or repair are given, which a scene has for each of its parts
};

using Json = nlohmann::ordered_json;

/// In ASCII, so that no word of a file reaches a terminal's controls.
std::string json_text(const Json& report) {
  return report.dump(2, ' ', true, Json::error_handler_t::replace) + '\n';
}

bool is_scene(const std::string& path) {
  return path.ends_with(".toml");
}

/// What to do with a file that is no mesh, but likely a recording.
void hint_at_scene(const std::string& path) {
  std::string ending = std::filesystem::path(path).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return std::tolower(c); });
  const bool is_recording = ending == ".csv" || ending == ".tsv" || ending == ".txt" || ending == ".h5";
  std::error_code failed;
  if (is_recording && std::filesystem::exists(path, failed))
    print_err(
        "fingerpad: {}: a recording is looked at with a scene that follows it: write `[motion] file = ...` "
        "and check the scene\n",
        printable(path));
}

int check(const CheckOptions& options) {
  bool all_touchable = true;
  Json report = Json::array();
  ImportOptions how;
  how.metres_per_unit = metres_of(options.unit);
  how.repair = options.repair;
  for (const std::string& path : options.meshes) {
    if (options.says_how && is_scene(path))
      throw Error(
          ErrorKind::usage, path,
          "is a scene, which says `unit` and `repair` for each [[part]]: leave --unit and --repair out");
  }
  std::optional<Error> refused;
  for (const std::string& path : options.meshes) {
    if (!is_scene(path)) {
      const bool is_touchable = tell_mesh(checked(path, how), options.json, report);
      if (!is_touchable) hint_at_scene(path);
      all_touchable &= is_touchable;
      continue;
    }
    bool touchable = false;
    try {
      touchable = check_scene(path, options.json, report);
    } catch (const Error& error) {  // the others are looked at all the same
      if (options.json) report.push_back({{"file", path}, {"touchable", false}, {"error", error.what()}});
      if (refused) print_err("fingerpad: error: {}\n", refused->what());
      refused = error;
    }
    if (!touchable && !options.json) print_out("{}: refused\n", path);  // whatever was said of its meshes
    all_touchable &= touchable;
  }
  if (options.json) write_stream(stdout, json_text(report));
  if (refused) throw *refused;
  return all_touchable ? 0 : 3;
}

}  // namespace

void add_check(CLI::App& program, Action& action) {
  auto options = std::make_shared<CheckOptions>();
  CLI::App* command =
      program.add_subcommand("check", "The verdict on each mesh: can it be touched, and what is damaged");
  command
      ->add_option(
          "MESH", options->meshes,
          mesh_format_names("or") +
              " files, - is standard input; or scenes (.toml), whose parts are taken in their "
              "units and looked at for overlaps, and whose motion and finger for what replay would refuse")
      ->required();
  add_unit_option(*command, options->unit);
  command->add_flag("--json", options->json,
                    "Print an array with an object for each mesh, and for each scene that has none or is "
                    "refused beside them (lengths in m)");
  command->add_flag("--repair", options->repair,
                    "Say what `repair = true` in a scene's [[part]] would do: weld, drop degenerate and "
                    "duplicate faces, make the winding right");
  command->footer("Ends 0 if every mesh can be touched and no scene is refused, else 3.");
  command->callback([options, command, &action] {
    options->says_how = command->count("--unit") > 0 || options->repair;
    action = [options] { return check(*options); };
  });
}

}  // namespace fingerpad
