#include "study/choice_price.hpp"

#include <algorithm>
#include <numeric>
#include <tuple>

#include "touch/rate_choice.hpp"

namespace fingerpad {
namespace {

/// Loads that differ by less are alike.
constexpr double alike_load = 1.1;

/// Errors below are rounding, which is not to choose.
constexpr double rounding = 1e-6;

/// What a choice loses, to put one before another: ruptures first, then the contact's force, then friction.
auto loss(const ChoicePrice& price) {
  return std::tuple(price.choice.events == Events::tick, std::max(rounding, price.figures.contact_99_share),
                    std::max(rounding, price.figures.mu_error_share + price.rate.held_mu_share));
}

}  // namespace

double mean_tick_ns(std::vector<float> tick_ns) {
  if (tick_ns.empty()) return 0;
  const std::size_t kept = tick_ns.size() - tick_ns.size() / 1000;
  std::nth_element(tick_ns.begin(), tick_ns.begin() + static_cast<std::ptrdiff_t>(kept - 1), tick_ns.end());
  return std::accumulate(tick_ns.begin(), tick_ns.begin() + static_cast<std::ptrdiff_t>(kept), 0.0) /
         static_cast<double>(kept);
}

std::vector<std::string> broken_promises(const ForceFigures& figures, const RateFigures& rate,
                                         const Promises& promises) {
  std::vector<std::string> broken = broken_promises(figures, promises);
  std::string hidden = friction_hidden_because({rate.held_mu_share, rate.unseen_teeth_share},
                                               promises.mu_tolerance, rate.rate_hz);
  if (!hidden.empty()) broken.push_back(std::move(hidden));
  return broken;
}

const ChoicePrice& cheapest(const std::vector<ChoicePrice>& prices) {
  const auto is_cheaper = [](const ChoicePrice& a, const ChoicePrice& b) {
    // One that keeps its promises before one that does not, whatever it costs.
    return std::tuple(!a.keeps(), a.load()) < std::tuple(!b.keeps(), b.load());
  };
  const ChoicePrice& least = *std::min_element(prices.begin(), prices.end(), is_cheaper);
  if (!least.keeps()) {
    return *std::min_element(prices.begin(), prices.end(), [](const ChoicePrice& a, const ChoicePrice& b) {
      return std::tuple(a.broken.size(), loss(a), a.load()) < std::tuple(b.broken.size(), loss(b), b.load());
    });
  }
  const ChoicePrice* best = &least;
  for (const ChoicePrice& price : prices) {
    if (price.keeps() && price.load() <= alike_load * least.load() && loss(price) < loss(*best))
      best = &price;
  }
  return *best;
}

const ChoicePrice* next_cheaper(const std::vector<ChoicePrice>& prices, const ChoicePrice& chosen) {
  const ChoicePrice* next = nullptr;
  for (const ChoicePrice& price : prices) {
    if (price.load() * alike_load >= chosen.load()) continue;
    if (next == nullptr || price.load() > next->load()) next = &price;
  }
  return next;
}

}  // namespace fingerpad
