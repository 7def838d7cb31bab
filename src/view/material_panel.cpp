#include "view/material_panel.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "base/number_text.hpp"
#include "contact/contact_method_table.hpp"
#include "friction/law_table.hpp"
#include "motion/stable_stiffness.hpp"
#include "part/part.hpp"

namespace fingerpad {
namespace {

constexpr double mu_step = 0.05, most_mu = 2, least_stiffness = 10, most_stiffness = 1e5, damping_step = 0.5,
                 most_damping = 100;
constexpr const char* row_labels[] = {"part",    "mu static", "mu dynamic", "stiffness",
                                      "damping", "law",       "normals",    "method"};

double to_step(double value, int steps, double step, double least, double most) {
  // Hundredths: numbers that a person reads, and that read back as themselves.
  return std::clamp(std::round((value + steps * step) * 100) / 100, least, most);
}

/// A quarter more a step, to three digits.
double stepped_stiffness(double value, int steps) {
  const double wanted = std::clamp(value * std::pow(1.25, steps), least_stiffness, most_stiffness);
  const double unit = std::pow(10.0, std::floor(std::log10(wanted)) - 2);
  return unit < 1 ? std::round(wanted / unit) / std::round(1 / unit) : std::round(wanted / unit) * unit;
}

template <typename Table, typename NameOf>
std::string next_name(const Table& table, const std::string& now, int steps, NameOf name_of) {
  std::vector<std::string> names;
  for (const auto& row : table) names.emplace_back(name_of(row));
  const auto at = std::find(names.begin(), names.end(), now) - names.begin();
  const auto count = static_cast<std::ptrdiff_t>(names.size());
  return names[static_cast<std::size_t>(((at + steps) % count + count) % count)];
}

}  // namespace

MaterialPanel::MaterialPanel(TouchSwap& swap, const World& world, bool has_motors)
    : swap_(swap), world_(world), has_motors_(has_motors) {}

std::vector<std::string> MaterialPanel::values(const Scene& scene) const {
  const SurfaceProperties& surface = surface_properties(scene, surface_);
  const Surface& touched = world_.surfaces[static_cast<std::size_t>(surface_)];
  const ContactChoice contact = settled_contact(scene, world_);
  const bool planes = needs_no_method(world_);
  return {shown_name(touched),
          number_text(surface.mu_static),
          number_text(surface.mu_dynamic),
          number_text(surface.stiffness_n_per_m) + " N/m",
          number_text(surface.damping_n_s_per_m) + " N s/m",
          scene.friction.law,
          planes ? "-" : std::string(contact.normals->name),
          std::string(method_in(world_, contact.method))};
}

SidePanel MaterialPanel::panel() const {
  SidePanel panel{"material", "material", {}};
  const std::vector<std::string> shown = values(swap_.scene());
  for (int row = 0; row < row_count; ++row) {
    const auto i = static_cast<std::size_t>(row);
    panel.rows.push_back({PanelRow::Kind::value, row_labels[i], shown[i], false, row == selected_});
  }
  const auto note = [&panel](const std::string& words) {
    panel.rows.push_back({PanelRow::Kind::note, words, "", false, false});
  };
  for (const std::string& words : doubts(swap_.scene())) note(words);
  if (swap_.is_scheduled()) {
    note("as recorded: the recording changes it");
  } else {  // in two lines, which a small window has room for
    note("click, wheel, or Tab and [ ]");
    note("changes are kept in the trace");
  }
  return panel;
}

/// Whether a device in a hand would shake against the surface at the tick's rate (SCIENCE 4); empty: not.
std::string MaterialPanel::unstable_words(const Scene& scene) const {
  if (!has_motors_) return {};
  const SurfaceProperties& surface = surface_properties(scene, surface_);
  HeldWall wall = wall_under(scene.hand.value_or(HandSettings{}), scene.motion.rate_hz);
  wall.wall_damping_n_s_per_m = surface.damping_n_s_per_m;
  const double most = stable_stiffness(wall);
  if (surface.stiffness_n_per_m <= most) return {};
  const std::string limit = most < 100 ? rounded_text(most, 3) : number_text(10 * std::round(most / 10));
  return fmt::format("motors shake over {} N/m at {} Hz", limit, number_text(scene.motion.rate_hz));
}

/// Whether a press of 1 N goes through the whole part; empty: not, or an open part, which has no inside.
std::string MaterialPanel::soft_words(const Scene& scene) const {
  const auto index = static_cast<std::size_t>(surface_);
  const Surface& surface = world_.surfaces[index];
  if (surface.is_plane() || !surface.part || index >= world_.verdicts.size() ||
      !world_.verdicts[index].closed)
    return {};
  const double across_m = 2 * surface.part->half_extent.minCoeff();
  const double deep_m = 1 / surface_properties(scene, surface_).stiffness_n_per_m;
  if (deep_m <= across_m) return {};
  return fmt::format("1 N goes {} mm in, through all its {} mm", rounded_text(1e3 * deep_m, 2),
                     rounded_text(1e3 * across_m, 2));
}

std::vector<std::string> MaterialPanel::doubts(const Scene& scene) const {
  std::vector<std::string> words;
  for (std::string& doubt : std::vector{unstable_words(scene), soft_words(scene)}) {
    if (!doubt.empty()) words.push_back(std::move(doubt));
  }
  return words;
}

/// The row's value so many steps on, and the key that it is the value of.
std::string MaterialPanel::stepped(int row, int steps, const Scene& scene, std::string& key) const {
  const SurfaceProperties& surface = surface_properties(scene, surface_);
  const ContactChoice contact = settled_contact(scene, world_);
  switch (row) {
    case mu_static:
      key = surface_key(surface_, "mu_static");
      return number_text(to_step(surface.mu_static, steps, mu_step, surface.mu_dynamic, most_mu));
    case mu_dynamic:
      key = surface_key(surface_, "mu_dynamic");
      return number_text(to_step(surface.mu_dynamic, steps, mu_step, 0, surface.mu_static));
    case stiffness:
      key = surface_key(surface_, "stiffness_n_per_m");
      return number_text(stepped_stiffness(surface.stiffness_n_per_m, steps));
    case damping:
      key = surface_key(surface_, "damping_n_s_per_m");
      return number_text(to_step(surface.damping_n_s_per_m, steps, damping_step, 0, most_damping));
    case law:
      key = "friction.law";
      return next_name(law_table(), scene.friction.law, steps,
                       [](const LawEntry& entry) { return entry.name; });
    case normals:
      key = "contact.normals";
      return next_name(normals_table(), std::string(contact.normals->name), steps,
                       [](Normals entry) { return entry->name; });
    default:
      key = "contact.method";
      return next_name(contact_method_table(), contact.method, steps,
                       [](const ContactMethodEntry& entry) { return entry.name; });
  }
}

std::string MaterialPanel::step(int row, int steps) {
  if (row < 0 || row >= row_count || steps == 0) return {};
  selected_ = row;
  const auto count = static_cast<int>(world_.surfaces.size());
  if (row == part) {
    surface_ = ((surface_ + steps) % count + count) % count;
    return {};
  }
  if (swap_.is_scheduled()) return "the recording that is followed changes the material itself";
  if ((row == normals || row == method) && needs_no_method(world_)) return "a plane needs no method";
  const Scene scene = swap_.scene();
  SceneChange change;
  change.value = stepped(row, steps, scene, change.key);
  try {
    swap_.change(change);
  } catch (const Error& error) {
    return error.what();
  }
  std::string told =
      fmt::format("{}: {}", row_labels[row], values(swap_.scene())[static_cast<std::size_t>(row)]);
  if (row != stiffness && row != damping) return told;
  for (const std::string& words : doubts(swap_.scene())) told += "; " + words;
  return told;
}

}  // namespace fingerpad
