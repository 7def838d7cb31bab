#include "touch/contact_mend.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "base/number_text.hpp"
#include "contact/proxy_limits.hpp"
#include "scene/scene.hpp"

namespace fingerpad {
namespace {

constexpr double no_tolerance = std::numeric_limits<double>::infinity();
constexpr int most_times_finer = 64;

double rounded(double x) {
  return parse_number(rounded_text(x, 2)).value_or(x);
}

/// To two digits, and no more than it is.
double floored(double x) {
  const double unit = std::pow(10, std::floor(std::log10(x)) - 1);
  return rounded(std::floor(x / unit) * unit);
}

/// A scene as it might be: some of its numbers, and how many times smaller its facets are.
struct Change {
  std::string words{};
  Scene scene{};
  int finer = 1;
};

/// What a change leaves unkept on the part.
struct Left {
  Unkept unkept = Unkept::nothing;
  double force_error = no_tolerance;  ///< in the place of which one may be kept; infinity: nothing
  double mu_tolerances = 0;           ///< the error of friction, in tolerances
  double tolerances = 0;              ///< that of the force or of friction, whichever is more

  bool is_facets_alone() const { return unkept == Unkept::force || unkept == Unkept::friction; }
};

struct Tried {
  Change change;
  Left left;
};

/// The changes that are tried for one part of a scene.
class Trials {
 public:
  Trials(const Scene& scene, ContactReckoning& reckoning, const ContactVerdict& verdict, std::size_t i)
      : scene_(scene), reckoning_(reckoning), verdict_(verdict), i_(i) {}

  /// On the part alone where it is not even kept there, else on the whole scene.
  Left left_by(const Change& change) const;
  /// What might mend it, by itself or with more: first what the scene insists on, then its numbers; up to the
  /// first that keeps it.
  std::vector<Tried> try_all() const;
  /// How many times smaller facets keep it beside this change, at the least; 0: no such.
  int finer_facets(const Tried& beside) const;
  /// "force_tolerance 0.26", the tolerances that are kept beside it; empty where none is of use.
  std::string tolerances(const Tried& beside) const;

 private:
  /// Whether it keeps it.
  bool try_one(Change change, std::vector<Tried>& tried) const;
  bool try_what_is_insisted_on(std::vector<Tried>& tried) const;
  bool try_presses(std::vector<Tried>& tried) const;
  bool try_radii(std::vector<Tried>& tried) const;

  const Scene& scene_;
  ContactReckoning& reckoning_;
  const ContactVerdict& verdict_;
  std::size_t i_;
};

/// What a verdict leaves unkept on its i-th case.
Left left_on(const ContactVerdict& verdict, std::size_t i) {
  const ContactCase& on = verdict.cases[i];
  const ReckonedError& error = verdict.chosen().errors[i];
  Left left{verdict.unkept_on(i), no_tolerance, error.mean_tilt_rad / on.mean_tilt_rad,
            verdict.chosen().tolerances(verdict.cases, i)};
  if (left.unkept == Unkept::force) left.force_error = error.force_share;
  if (left.unkept == Unkept::method && falls_behind(on, error))
    left.force_error = error.force_share + error.behind_share;
  return left;
}

Left Trials::left_by(const Change& change) const {
  const Left alone = left_on(reckoning_.on_one(change.scene, i_, change.finer), 0);
  if (alone.unkept != Unkept::nothing || reckoning_.part_count() == 1) return alone;
  return left_on(reckoning_.on_all(change.scene, change.finer), i_);
}

bool Trials::try_one(Change change, std::vector<Tried>& tried) const {
  const Left left = left_by(change);
  tried.push_back({std::move(change), left});
  return left.unkept == Unkept::nothing;
}

bool Trials::try_what_is_insisted_on(std::vector<Tried>& tried) const {
  const Unkept unkept = verdict_.unkept_on(i_);
  const bool opens_method = !verdict_.method_open && unkept == Unkept::method,
             opens_normals = !verdict_.normals_open && unkept != Unkept::grip;
  const auto opened = [&](const char* words, bool method, bool normals) {
    Change change{words, scene_};
    if (method) change.scene.contact.method = automatic_method;
    if (normals) change.scene.contact.automatic_normals = true;
    return try_one(std::move(change), tried);
  };
  return (opens_method && opened("method = \"auto\"", true, false)) ||
         (opens_normals && opened("normals = \"auto\"", false, true)) ||
         (opens_method && opens_normals && opened("method = \"auto\" and normals = \"auto\"", true, true));
}

/// A press that the part holds, one that keeps up round its tightest rounding, one that does round anything,
/// and lighter ones, as long as that is for the better: to a lighter touch facets cut in deeper.
bool Trials::try_presses(std::vector<Tried>& tried) const {
  constexpr double a_little_less = 0.99, least_n = 1e-5;  // scenes take a tenth of that
  constexpr int halvings = 3;
  const ContactCase& on = verdict_.cases[i_];
  const double k = a_little_less * on.press.stiffness_n_per_m, radius_m = on.press.finger_radius_m;
  double last_n = on.press.greatest_force_n, last_off = no_tolerance;
  bool keeps = false, is_better = true;
  const auto press = [&](double press_n) {
    if (keeps || !is_better || !(press_n >= least_n && press_n < a_little_less * last_n)) return;
    last_n = floored(press_n);
    Change change{fmt::format("a greatest_force_n of {}", number_text(last_n)), scene_};
    change.scene.contact.greatest_force_n = last_n;
    keeps = try_one(std::move(change), tried);
    const Left& left = tried.back().left;
    is_better = !left.is_facets_alone() || left.tolerances < last_off;
    if (left.is_facets_alone()) last_off = left.tolerances;
  };
  press(k * holds_deep_m(on));
  press(k * ProxyLimits::rounds_deep * (verdict_.chosen().errors[i_].behind_m + radius_m));
  press(k * ProxyLimits::rounds_deep * radius_m);
  for (int halved = 0; halved < halvings; ++halved) press(last_n / 2);
  return keeps;
}

/// Balls that have room in the hollow that is too crowded.
bool Trials::try_radii(std::vector<Tried>& tried) const {
  for (const double share : {0.7, 0.5, 0.3}) {
    const double radius_m = floored(share * verdict_.cases[i_].contact.crowded.radius_m);
    Change change{fmt::format("a finger radius_m of {}", number_text(radius_m)), scene_};
    change.scene.finger.radius_m = radius_m;
    if (try_one(std::move(change), tried)) return true;
  }
  return false;
}

std::vector<Tried> Trials::try_all() const {
  const Unkept unkept = verdict_.unkept_on(i_);
  std::vector<Tried> tried;
  if (try_what_is_insisted_on(tried)) return tried;
  const bool is_crowded = verdict_.cases[i_].contact.crowded.is_too_much();
  if (is_crowded && try_radii(tried)) return tried;
  if (unkept == Unkept::grip || unkept == Unkept::method) try_presses(tried);
  return tried;
}

int Trials::finer_facets(const Tried& beside) const {
  if (!beside.left.is_facets_alone()) return 0;
  for (int times = 2; times <= most_times_finer; times *= 2) {
    // No error falls faster than with the square; the chosen pair's may be a fifth above the least.
    if (1.2 * times * times < beside.left.tolerances) continue;
    if (left_by({"", beside.change.scene, times}).unkept == Unkept::nothing) return times;
  }
  return 0;
}

std::string Trials::tolerances(const Tried& beside) const {
  Change looser = beside.change;
  Left left = left_on(reckoning_.on_all(looser.scene, looser.finer), i_);
  ContactSettings& asked = looser.scene.contact;
  std::vector<std::string> words;
  if (left.force_error < no_tolerance) {
    asked.force_tolerance = rounded(kept_force_tolerance(left.force_error));
    if (!(asked.force_tolerance <= 1)) return {};
    words.push_back("force_tolerance " + number_text(asked.force_tolerance));
    left = left_by(looser);
  }
  if (left.unkept == Unkept::friction) {
    asked.mu_tolerance = rounded(kept_mu_tolerance(asked.mu_tolerance, left.mu_tolerances));
    if (!(asked.mu_tolerance <= 1)) return {};
    words.push_back("mu_tolerance " + number_text(asked.mu_tolerance));
    left = left_by(looser);
  }
  if (left.unkept != Unkept::nothing) return {};
  return fmt::format("{}", fmt::join(words, " and "));
}

constexpr const char* finer_mesh = "a finer mesh";

/// By one change and what that leaves unkept; empty where none does.
std::string mend_by_two(const Trials& trials, const std::vector<Tried>& tried) {
  for (const Tried& one : tried) {
    std::vector<std::string> with;
    if (const std::string kept = trials.tolerances(one); !kept.empty()) with.push_back("with " + kept);
    if (const int times = trials.finer_facets(one); times > 0)
      with.push_back(fmt::format("with {} (facets {} times smaller)", finer_mesh, times));
    if (!with.empty()) return fmt::format("{} would, {}", one.change.words, fmt::join(with, ", or "));
  }
  return {};
}

/// What comes nearer without a finer mesh.
std::string better_words(const std::vector<Tried>& tried, const Left& as_it_is) {
  for (const Tried& one : tried) {
    if (one.left.is_facets_alone() && one.left.tolerances < as_it_is.tolerances)
      return fmt::format(", or {} would do better", one.change.words);
  }
  return {};
}

/// What is still wrong where no change and no two keep it.
std::string not_enough_words(const std::vector<Tried>& tried, const Left& as_it_is) {
  for (const Tried& one : tried) {
    if (one.left.is_facets_alone())
      return fmt::format("{} with facets {} times smaller would not keep it either", one.change.words,
                         most_times_finer);
  }
  if (!tried.empty()) return "no change that was tried would keep it";
  return as_it_is.is_facets_alone()
             ? fmt::format("facets {} times smaller would not keep it either", most_times_finer)
             : "nothing is known that would";
}

}  // namespace

std::string mend_of(const Scene& scene, ContactReckoning& reckoning, const ContactVerdict& verdict,
                    std::size_t i) {
  const Unkept unkept = verdict.unkept_on(i);
  if ((unkept == Unkept::force || unkept == Unkept::friction) &&
      is_of_digits(verdict.cases[i], verdict.chosen().errors[i]))
    return "move it nearer to its origin, and ask again: what is left then is not known before";
  const Trials trials(scene, reckoning, verdict, i);
  const std::vector<Tried> tried = trials.try_all();
  if (!tried.empty() && tried.back().left.unkept == Unkept::nothing)
    return tried.back().change.words + " would";
  const Left as_it_is{unkept, no_tolerance, 0, verdict.chosen().tolerances(verdict.cases, i)};
  if (const int times = trials.finer_facets({{"", scene}, as_it_is}); times > 0)
    return fmt::format("{} would (facets {} times smaller){}", finer_mesh, times,
                       better_words(tried, as_it_is));
  const std::string both = mend_by_two(trials, tried);
  return !both.empty() ? both : not_enough_words(tried, as_it_is);
}

bool is_mended_alike(const ContactVerdict& verdict, std::size_t i, std::size_t j) noexcept {
  const ContactCase &one = verdict.cases[i], &other = verdict.cases[j];
  return &one.contact.part == &other.contact.part && one.mean_tilt_rad == other.mean_tilt_rad &&
         one.press.stiffness_n_per_m == other.press.stiffness_n_per_m &&
         one.contact.has_neighbour == other.contact.has_neighbour;
}

}  // namespace fingerpad
