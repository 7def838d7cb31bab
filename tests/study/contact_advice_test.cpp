#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <regex>

#include "base/number_text.hpp"
#include "contact/part_measures.hpp"
#include "contact/triangle_tree.hpp"
#include "part/import.hpp"
#include "scene/scene.hpp"
#include "study/contact_surfaces.hpp"
#include "support/effort.hpp"
#include "support/paths.hpp"
#include "touch/contact_choice.hpp"
#include "touch/world.hpp"

// What `auto` says would keep a tolerance, put back into the scene: it does.

namespace fingerpad::contact_advice_test {
namespace {

constexpr double crease_rad = 30 * std::numbers::pi / 180;

/// A part in its place, measured once.
struct Measured {
  std::string name;
  std::vector<Surface> surfaces = std::vector<Surface>(1);
  std::vector<PartMeasures> measures{};

  Measured(const std::string& named, std::shared_ptr<const Part> part) : name(named) {
    surfaces[0].mesh = named;
    surfaces[0].part = std::move(part);
    surfaces[0].tree = std::make_shared<const TriangleTree>(surfaces[0].part);
    measures.push_back(measure_part(*surfaces[0].part, *surfaces[0].tree));
  }
  ContactChoice choice_for(const Scene& scene) const { return choose_contact(scene, surfaces, measures); }
  std::string said_of(const Scene& scene) const { return choice_for(scene).limits.at(0).said; }
};

Scene open_scene(double radius_m) {
  Scene scene;
  scene.contact.automatic_normals = true;
  scene.finger.radius_m = radius_m;
  return scene;
}

/// The number behind some words; nothing where they do not stand there.
std::optional<double> number_after(const std::string& text, const std::string& words) {
  std::smatch found;
  if (!std::regex_search(text, found, std::regex(words + "([0-9.e-]*[0-9])"))) return std::nullopt;
  return parse_number(found[1].str());
}

/// Puts what a sentence says would keep the tolerances into a scene. False where that is none of its numbers.
bool paste(const std::string& advice, Scene& scene) {
  bool any = false;
  const auto put = [&](const std::string& words, double& number) {
    const auto told = number_after(advice, words);
    if (told) number = *told;
    any = any || told;
  };
  put("a greatest_force_n of ", scene.contact.greatest_force_n);
  put("a finger radius_m of ", scene.finger.radius_m);
  put("with force_tolerance ", scene.contact.force_tolerance);
  put("mu_tolerance ", scene.contact.mu_tolerance);
  if (advice.find("method = \"auto\"") != std::string::npos) {
    scene.contact.method = automatic_method;
    any = true;
  }
  if (advice.find("normals = \"auto\"") != std::string::npos) {
    scene.contact.automatic_normals = true;
    any = true;
  }
  return any;
}

/// How often each kind of advice was met.
struct Met {
  int numbers = 0, numbers_and_tolerances = 0, instead = 0;
};

/// What can be kept instead, "0.26 can" and "0.35 can", and what would keep it.
void expect_true(const Measured& part, const Scene& scene, Met& met) {
  const ContactChoice choice = part.choice_for(scene);
  const std::string said = choice.limits.at(0).said;
  if (said.empty()) return;
  const std::string where = part.name + ": " + said;
  if (std::isinf(choice.limits[0].kept_tolerance)) {
    // No figure beside "nor anything like it".
    EXPECT_EQ(choice.reasons.at(0).find('%'), std::string::npos) << choice.reasons[0];
  }
  Scene instead = scene;
  const auto kept = number_after(said, "force_tolerance [0-9.e-]+ cannot be kept(?: by [a-z-]+)?, ");
  const auto kept_mu = number_after(said, "mu_tolerance [0-9.e-]+ cannot be kept, ");
  if (kept) instead.contact.force_tolerance = *kept;
  if (kept_mu) instead.contact.mu_tolerance = *kept_mu;
  if (kept || kept_mu) {
    ++met.instead;
    EXPECT_EQ(part.said_of(instead), "") << where;
  }
  std::smatch advice;
  ASSERT_TRUE(std::regex_search(said, advice, std::regex("; ([^;]* would[^;]*)"))) << where;
  // "X would, with A, or with B": X and A, of what is a number of the scene.
  const std::string first = std::regex_replace(advice[1].str(), std::regex(", or with .*"), "");
  Scene mended = scene;
  if (first.find("finer mesh") != std::string::npos || first.find("would not") != std::string::npos) return;
  if (!paste(first, mended)) return;
  ++(first.find("force_tolerance") == std::string::npos ? met.numbers : met.numbers_and_tolerances);
  EXPECT_EQ(part.said_of(mended), "") << where;
}

TEST(ContactAdvice, OnRealPartsIsTrue) {
  const auto files = test::real_parts();
  if (files.empty()) GTEST_SKIP() << "no real parts here";
  Met met;
  int touched = 0;
  for (const auto& file : files) {
    const auto part = import_part(file.string(), 1e-3, crease_rad).part;
    if (!part) continue;
    const Measured measured(file.filename().string(), part);
    // With the forces by turns, the other way round on the next part.
    int turn = ++touched;
    for (const double radius_m : {0.0, 0.003, 0.007}) {
      const double greatest_force_n = ++turn % 2 == 0 ? 10 : 1;
      SCOPED_TRACE(testing::Message() << radius_m << " m, " << greatest_force_n << " N");
      Scene scene = open_scene(radius_m);
      scene.contact.greatest_force_n = greatest_force_n;
      expect_true(measured, scene, met);
    }
  }
  EXPECT_GT(met.numbers_and_tolerances, 0);
  EXPECT_GT(met.instead, 0);
}

TEST(ContactAdvice, OnTheStudysSurfacesIsTrue) {
  std::vector<ExactSurface> surfaces = exact_surfaces();
  if (!test::sanitized())
    for (ExactSurface& small : small_exact_surfaces()) surfaces.push_back(std::move(small));
  Met met;
  for (const ExactSurface& surface : surfaces) {
    for (const int level : test::cases({surface.levels.front(), surface.levels[surface.levels.size() / 2]})) {
      const Measured measured(surface.name,
                              std::make_shared<const Part>(make_part(surface.mesh(level), crease_rad)));
      for (const double radius_m : test::cases({0.0, 0.007})) {
        SCOPED_TRACE(radius_m);
        expect_true(measured, open_scene(radius_m), met);
        Scene insists = open_scene(radius_m);
        insists.contact.automatic_normals = false;
        insists.contact.normals = Normals::facet;
        expect_true(measured, insists, met);
        insists = open_scene(radius_m);
        insists.contact.method = "closest-point";
        expect_true(measured, insists, met);
      }
    }
  }
  EXPECT_GT(met.numbers, 0);
  EXPECT_GT(met.instead, 0);
}

TEST(ContactAdvice, AMeshThatIsSoMuchFinerKeepsIt) {
  int finer_meshes = 0;
  for (const ExactSurface& surface : exact_surfaces()) {
    if (surface.name != "sphere" && surface.name != "torus") continue;
    const int level = surface.levels.front() - (surface.name == "sphere" ? 1 : 0);
    const auto measured = [&](int at_level) {
      return Measured(surface.name,
                      std::make_shared<const Part>(make_part(surface.mesh(at_level), crease_rad)));
    };
    const Scene scene = open_scene(0);
    const auto times = number_after(measured(level).said_of(scene), "finer mesh would \\(facets ");
    if (!times) continue;
    ++finer_meshes;
    const int of_level = surface.name == "sphere" ? level + static_cast<int>(std::lround(std::log2(*times)))
                                                  : level * static_cast<int>(*times);
    EXPECT_EQ(measured(of_level).said_of(scene), "") << surface.name << ", facets smaller by " << *times;
  }
  EXPECT_EQ(finer_meshes, 2);
}

}  // namespace
}  // namespace fingerpad::contact_advice_test
