#include "study/choice_price.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "scene/scene.hpp"

namespace fingerpad::choice_price_test {
namespace {

/// A choice at 1 kHz that costs this much, with this error of the contact's force.
ChoicePrice price_of(double tick_ns, double share, bool keeps) {
  ChoicePrice price;
  price.tick_ns = tick_ns;
  price.figures.contact_99_share = share;
  if (!keeps) price.broken.emplace_back("a promise");
  return price;
}

TEST(Cheapest, IsTheLeastLoadThatKeepsItsPromises) {
  const std::vector<ChoicePrice> prices{price_of(100, 0.5, false), price_of(400, 0.001, true),
                                        price_of(200, 0.02, true)};
  EXPECT_EQ(&cheapest(prices), &prices[2]);
  EXPECT_EQ(next_cheaper(prices, prices[2]), &prices[0]);
  EXPECT_EQ(next_cheaper(prices, prices[0]), nullptr);
}

TEST(Cheapest, CountsTicksAsWellAsTheirTime) {
  std::vector<ChoicePrice> prices{price_of(100, 0.01, true), price_of(200, 0.01, true)};
  prices[1].choice.rate_hz = 250;
  EXPECT_EQ(&cheapest(prices), &prices[1]);
  EXPECT_DOUBLE_EQ(prices[1].load(), 5e-5);
}

TEST(Cheapest, OfThoseThatCostAlikeIsTheMostExact) {
  std::vector<ChoicePrice> prices{price_of(200, 0.02, true), price_of(215, 0.001, true),
                                  price_of(230, 0, true)};
  EXPECT_EQ(&cheapest(prices), &prices[1]);
  // One that looks for ruptures at ticks only comes after one that finds them all.
  prices[1].choice.events = Events::tick;
  EXPECT_EQ(&cheapest(prices), &prices[0]);
  // Rounding decides nothing: the first in the table does.
  prices[0].figures.contact_99_share = 2e-16;
  prices[1] = price_of(200, 1e-16, true);
  EXPECT_EQ(&cheapest(prices), &prices[0]);
}

TEST(Cheapest, WhereNoneKeepsIsTheOneThatBreaksLeast) {
  std::vector<ChoicePrice> prices{price_of(100, 0.5, false), price_of(200, 0.2, false),
                                  price_of(300, 0.1, false)};
  prices[2].broken.emplace_back("another");
  EXPECT_EQ(&cheapest(prices), &prices[1]);
}

TEST(MeanTick, LeavesOutTheSlowestInAThousand) {
  std::vector<float> ticks(2000, 100);
  ticks[5] = ticks[1999] = 1e6F;
  EXPECT_EQ(mean_tick_ns(ticks), 100);
  ticks[7] = 1e6F;
  EXPECT_GT(mean_tick_ns(ticks), 500);
  EXPECT_EQ(mean_tick_ns({}), 0);
}

TEST(RateFigures, AreThoseOfTheModelHeldFromTickToTick) {
  // A coefficient that rises evenly from 0.2 to 0.3 in teeth of 1 ms, at 40 kHz, held at 1 kHz: always 0.2.
  StretchRun model;
  model.rate_hz = 40000;
  for (int k = 0; k < 4000; ++k) {
    const double mu = 0.2 + 0.1 * (k % 40) / 40;
    model.force_W_n.emplace_back(mu, 0, 1);
    model.friction_W_n.emplace_back(mu, 0, 0);
    model.normal_n.push_back(1);
    model.broke.push_back(k % 40 == 0 ? 1 : 0);
  }
  const RateFigures figures = rate_figures({model}, 1000);
  EXPECT_NEAR(figures.held_mu_share, 0.1 / std::sqrt(3) / 0.25, 0.01);  // 40 steps a tooth
  EXPECT_NEAR(figures.held_force_share, 0.1 / std::sqrt(3) / std::sqrt(1.0633), 0.002);
  EXPECT_EQ(figures.unseen_teeth_share, 1);  // one tick a tooth
  EXPECT_EQ(rate_figures({model}, 2000).unseen_teeth_share, 0);
  EXPECT_EQ(rate_figures({model}, 40000).held_mu_share, 0);
  const Promises promises{ContactSettings()};
  EXPECT_EQ(broken_promises({}, figures, promises).size(), 1u);
  EXPECT_EQ(broken_promises({}, RateFigures{1000, 0.09, 1, 0.09}, promises).size(), 0u);
  EXPECT_EQ(broken_promises({}, RateFigures{1000, 0.09, 1, 0.11}, promises).size(), 1u);
}

}  // namespace
}  // namespace fingerpad::choice_price_test
