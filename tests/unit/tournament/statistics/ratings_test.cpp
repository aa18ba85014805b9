#include "tournament/statistics/ratings.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <numeric>

#include "engine/core/math/random.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/test_stream.hpp"
#include "tournament/statistics/davidson.hpp"
#include "tournament/statistics/elo.hpp"

using namespace fulbito;

namespace {

using Meetings = std::vector<MeetingCounts>;

MeetingCounts meeting(std::size_t a, std::size_t b, std::array<std::int64_t, kPairOutcomes> counts) {
  return {a, b, {counts}};
}

double pointsOfMatch(Rng& rng, const MatchChances& chances) {
  const double u = rng.uniform();
  return u < chances.win ? 1.0 : u < chances.win + chances.draw ? 0.5 : 0.0;
}

/// Meetings of a round robin, with independent matches drawn from Davidson's model.
Meetings roundRobin(const std::vector<double>& elo, double nu, int pairs, Rng& rng) {
  Meetings meetings;
  for (std::size_t a = 0; a < elo.size(); ++a) {
    for (std::size_t b = a + 1; b < elo.size(); ++b) {
      meetings.push_back(meeting(a, b, {}));
      const MatchChances chances = davidsonChances((elo[a] - elo[b]) * std::log(10.0) / 400, nu);
      for (int i = 0; i < pairs; ++i) {
        meetings.back().pairs.add(pointsOfMatch(rng, chances), pointsOfMatch(rng, chances));
      }
    }
  }
  return meetings;
}

/// Ratings spread evenly around 0 over `width`.
std::vector<double> spreadElo(std::size_t entrants, double width) {
  std::vector<double> elo;
  for (std::size_t i = 0; i < entrants; ++i) {
    elo.push_back(width * (static_cast<double>(i) / static_cast<double>(entrants - 1) - 0.5));
  }
  return elo;
}

double seconds(std::chrono::steady_clock::time_point begin) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

}  // namespace

TEST_CASE("without draws two entrants are as far apart as the Elo of their score", "[unit]") {
  const Ratings ratings = rate(2, Meetings{meeting(0, 1, {4, 0, 0, 20, 0, 16})}, 1);
  CHECK(ratings.elo[0].value - ratings.elo[1].value == Approx(eloOf(52.0 / 80.0)));
  CHECK(ratings.elo[0].value == Approx(-ratings.elo[1].value));
  CHECK(ratings.draw_share == 0.0);
  CHECK_FALSE(ratings.prior);
}

TEST_CASE("with draws two entrants have Davidson's closed form", "[unit]") {
  const Ratings ratings = rate(2, Meetings{meeting(0, 1, {1, 2, 3, 4, 5, 6})}, 1);
  const double wins = 21.0, draws = 13.0, losses = 8.0, nu = draws / std::sqrt(wins * losses);
  const double lead = ratings.elo[0].value - ratings.elo[1].value;
  CHECK(lead == Approx(400 * std::log10(wins / losses)));
  CHECK(ratings.draw_share == Approx(nu / (2 + nu)));
  CHECK(expectedPoints(lead, ratings.draw_share) == Approx((wins + draws / 2) / 42.0));
}

TEST_CASE("expected points are those of Elo without draws, and one half for equals", "[unit]") {
  CHECK(expectedPoints(200.0, 0.0) == Approx(scoreOf(200.0)));
  CHECK(expectedPoints(0.0, 0.4) == Approx(0.5));
  CHECK(expectedPoints(200.0, 0.5) + expectedPoints(-200.0, 0.5) == Approx(1.0));
  CHECK(expectedPoints(200.0, 0.5) < scoreOf(200.0));
  CHECK(expectedPoints(200.0, 1.0) == 0.5);
}

TEST_CASE("superiority of two entrants is that of the score's estimate", "[unit]") {
  for (const std::array<std::int64_t, 6>& counts : {std::array<std::int64_t, 6>{10, 22, 20, 16, 22, 10},
                                                    {9, 20, 20, 16, 25, 14},
                                                    {0, 0, 90, 0, 0, 3},
                                                    {20, 0, 0, 40, 0, 26},
                                                    {14, 25, 36, 0, 15, 10}}) {
    const Meetings meetings{meeting(0, 1, counts)};
    const double expected = estimateElo(meetings[0].pairs.scores()).superiority;
    const Ratings ratings = rate(2, meetings, 7, 4000);
    const double spread = std::sqrt(expected * (1 - expected) / 4000);
    INFO(expected);
    // The normal approximation of a skewed mean has an error of about 1 % itself.
    if (counts[0] + counts[1] > 0) {
      CHECK(ratings.superiority[0][1] == Approx(expected).margin(4 * spread + 0.012));
    } else {
      CHECK(ratings.superiority[0][1] > expected - 0.1);
    }
    CHECK(ratings.superiority[0][1] + ratings.superiority[1][0] == Approx(1.0));
    CHECK(ratings.superiority[0][0] == 0.5);
  }
}

TEST_CASE("the interval of two entrants is that of the score's estimate", "[unit]") {
  const Meetings meetings{meeting(0, 1, {20, 0, 0, 80, 0, 30})};  // without draws both scales agree
  const Interval expected = estimateElo(meetings[0].pairs.scores()).elo;
  const Ratings ratings = rate(2, meetings, 7, 4000);
  CHECK(2 * ratings.elo[0].low == Approx(expected.low).margin(3.0));
  CHECK(2 * ratings.elo[0].high == Approx(expected.high).margin(3.0));
}

TEST_CASE("known ratings are recovered, and 95 % of the intervals cover them", "[unit]") {
  struct Case {
    std::size_t entrants;
    double nu;
    int pairs, tournaments;
    double bias;  // largest bias [Elo]: with few matches, estimated strengths are too far apart
  };
  for (const Case& c : {Case{8, 0.8, 20, 100, 4.0}, Case{8, 0.0, 8, 100, 6.0}, Case{20, 0.8, 1, 30, 12.0},
                        Case{20, 2.0, 6, 15, 4.0}}) {
    const std::vector<double> truth = spreadElo(c.entrants, 400.0);
    int covered = 0, all = 0;
    double bias = 0.0, draw_share = 0.0;
    for (int t = 0; t < c.tournaments; ++t) {
      Rng rng(static_cast<std::uint64_t>(t), test::kTestStream, c.entrants);
      const Ratings ratings = rate(c.entrants, roundRobin(truth, c.nu, c.pairs, rng), 3, 400);
      draw_share += ratings.draw_share / c.tournaments;
      for (std::size_t i = 0; i < c.entrants; ++i, ++all) {
        covered += ratings.elo[i].low <= truth[i] && truth[i] <= ratings.elo[i].high ? 1 : 0;
        bias += (ratings.elo[i].value - truth[i]) * (truth[i] > 0 ? 1 : -1);
      }
    }
    const double share = covered / static_cast<double>(all);
    std::printf(
        "%zu entrants, nu %.1f, %d pairs: %.1f %% of %d intervals cover, bias %+.1f Elo, draws %.3f\n",
        c.entrants, c.nu, c.pairs, 100 * share, all, bias / all, draw_share);
    // Three standard deviations of independent intervals, plus the error of the resamples.
    CHECK(share == Approx(0.95).margin(3 * std::sqrt(0.95 * 0.05 / all) + 0.01));
    CHECK(bias / all == Approx(0.0).margin(c.bias));
    CHECK(draw_share == Approx(c.nu / (2 + c.nu)).margin(0.02));
  }
}

TEST_CASE("who wins everything has a finite rating from the prior, with a wide interval", "[unit]") {
  const Meetings meetings{meeting(0, 1, {0, 0, 0, 0, 0, 10}), meeting(0, 2, {0, 0, 0, 0, 0, 10}),
                          meeting(1, 2, {2, 0, 2, 4, 0, 2})};
  const Ratings ratings = rate(3, meetings, 1);
  CHECK(ratings.prior);
  CHECK(ratings.elo[0].value > 300.0);
  CHECK(std::isfinite(ratings.elo[0].high));
  CHECK(ratings.elo[0].high > ratings.elo[0].value + 100.0);
  CHECK(ratings.elo[0].low < ratings.elo[0].value - 50.0);
  CHECK(ratings.superiority[0][1] > 0.999);
  CHECK(ratings.superiority[1][2] == Approx(0.5).margin(0.06));
}

TEST_CASE("only draws, and pairs that cancel, are equal strength without an interval", "[unit]") {
  for (const std::array<std::int64_t, 6>& counts :
       {std::array<std::int64_t, 6>{0, 0, 10, 0, 0, 0}, {0, 0, 5, 7, 0, 0}}) {
    const Ratings ratings = rate(2, Meetings{meeting(0, 1, counts)}, 1);
    CHECK(ratings.elo[0].value == Approx(0.0).margin(1e-9));
    CHECK(ratings.elo[0].low == Approx(0.0).margin(1e-9));
    CHECK(ratings.elo[0].high == Approx(0.0).margin(1e-9));
    CHECK(ratings.superiority[0][1] == 0.5);
  }
}

TEST_CASE("groups that never met have ratings of their own", "[unit]") {
  const Meetings apart{meeting(0, 3, {2, 0, 0, 8, 0, 4}), meeting(1, 2, {0, 3, 0, 5, 4, 0})};
  const Ratings ratings = rate(5, apart, 1);
  CHECK(ratings.component == std::vector<int>{0, 1, 1, 0, 2});
  CHECK(ratings.elo[0].value + ratings.elo[3].value == Approx(0.0).margin(1e-9));
  CHECK(ratings.elo[1].value + ratings.elo[2].value == Approx(0.0).margin(1e-9));
  CHECK(ratings.superiority[0][1] == 0.5);
  CHECK(ratings.superiority[0][3] > 0.5);
  CHECK(ratings.elo[4].value == 0.0);
  CHECK(std::isinf(ratings.elo[4].low));
  CHECK(std::isinf(ratings.elo[4].high));
  CHECK_FALSE(ratings.prior);
}

TEST_CASE("without a pair nothing is known", "[unit]") {
  const Ratings ratings = rate(3, Meetings{meeting(0, 1, {}), meeting(2, 2, {1, 0, 0, 0, 0, 1})}, 1);
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(ratings.elo[i].value == 0.0);
    CHECK(ratings.elo[i].high == std::numeric_limits<double>::infinity());
    for (std::size_t j = 0; j < 3; ++j) CHECK(ratings.superiority[i][j] == 0.5);
  }
  CHECK_FALSE(ratings.prior);
  CHECK(rate(0, {}, 1).elo.empty());
}

TEST_CASE("the order of meetings and of their sides changes nothing", "[unit]") {
  Rng rng(5, test::kTestStream);
  const Meetings meetings = roundRobin(spreadElo(6, 300.0), 1.0, 6, rng);
  Meetings other(meetings.rbegin(), meetings.rend());
  std::swap(other[3].a, other[3].b);
  std::reverse(other[3].pairs.counts.begin(), other[3].pairs.counts.end());
  std::swap(other[3].pairs.counts[2], other[3].pairs.counts[3]);  // kDD and kWL keep their places
  // One meeting is split into two.
  other.push_back(other.front());
  for (std::size_t i = 0; i < kPairOutcomes; ++i) {
    other.back().pairs.counts[i] /= 2;
    other.front().pairs.counts[i] -= other.back().pairs.counts[i];
  }
  const Ratings first = rate(6, meetings, 9, 200), second = rate(6, other, 9, 200);
  CHECK(first.superiority == second.superiority);
  for (std::size_t i = 0; i < 6; ++i) {
    CHECK(first.elo[i].value == second.elo[i].value);
    CHECK(first.elo[i].low == second.elo[i].low);
    CHECK(first.elo[i].high == second.elo[i].high);
  }
}

TEST_CASE("other numbers of the entrants change the ratings' order only", "[unit]") {
  Rng rng(6, test::kTestStream);
  const Meetings meetings = roundRobin(spreadElo(6, 300.0), 1.0, 20, rng);
  const std::vector<std::size_t> moved{3, 5, 0, 1, 4, 2};
  Meetings other = meetings;
  for (MeetingCounts& m : other) m.a = moved[m.a], m.b = moved[m.b];
  const Ratings first = rate(6, meetings, 9, 2000), second = rate(6, other, 9, 2000);
  for (std::size_t i = 0; i < 6; ++i) {
    CHECK(second.elo[moved[i]].value == Approx(first.elo[i].value).margin(1e-7));
    // Resamples differ, so a wide margin.
    CHECK(second.elo[moved[i]].low == Approx(first.elo[i].low).margin(4.0));
    CHECK(second.elo[moved[i]].high == Approx(first.elo[i].high).margin(4.0));
    for (std::size_t j = 0; j < 6; ++j) {
      CHECK(second.superiority[moved[i]][moved[j]] == Approx(first.superiority[i][j]).margin(0.05));
    }
  }
}

TEST_CASE("four times the pairs give the same ratings with half the intervals", "[unit]") {
  Rng rng(8, test::kTestStream);
  const Meetings meetings = roundRobin(spreadElo(5, 300.0), 0.6, 25, rng);
  Meetings more = meetings;
  for (MeetingCounts& m : more) {
    for (std::int64_t& count : m.pairs.counts) count *= 4;
  }
  const Ratings few = rate(5, meetings, 1, 3000), many = rate(5, more, 1, 3000);
  for (std::size_t i = 0; i < 5; ++i) {
    CHECK(many.elo[i].value == Approx(few.elo[i].value).margin(1e-7));
    CHECK((few.elo[i].high - few.elo[i].low) / (many.elo[i].high - many.elo[i].low) ==
          Approx(2.0).margin(0.2));
  }
}

TEST_CASE("one pair per meeting still gives intervals", "[unit]") {
  Rng rng(3, test::kTestStream);
  const Ratings ratings = rate(12, roundRobin(spreadElo(12, 200.0), 1.0, 1, rng), 1);
  for (const Interval& elo : ratings.elo) CHECK(elo.high - elo.low > 60.0);
}

TEST_CASE("without resamples ratings have no interval", "[unit]") {
  const Ratings ratings = rate(2, Meetings{meeting(0, 1, {4, 0, 0, 20, 0, 16})}, 1, 0);
  CHECK(ratings.elo[0].value > 0.0);
  CHECK(std::isinf(ratings.elo[0].low));
  CHECK(ratings.superiority[0][1] == 0.5);
}

TEST_CASE("results within a unit are not independent", "[unit]") {
  // In half of the units the first beats all others, in the other half it loses to all. So its rating is as
  // uncertain as with one opponent.
  std::vector<UnitResult> alone, together;
  for (std::size_t unit = 0; unit < 100; ++unit) {
    const double points = unit % 2 == 0 ? 1.0 : 0.0;
    alone.push_back({unit, 0, 1, points});
    for (std::size_t other = 1; other <= 4; ++other) together.push_back({unit, other, 0, 1.0 - points});
  }
  const Ratings one = rateUnits(2, 100, alone, 1), four = rateUnits(5, 100, together, 1);
  const auto lead_width = [](const Ratings& r, std::size_t others) {
    // The others are equal, so the lead over one of them is the first's rating times (others + 1) / others.
    return (r.elo[0].high - r.elo[0].low) * static_cast<double>(others + 1) / static_cast<double>(others);
  };
  CHECK(lead_width(four, 4) == Approx(lead_width(one, 1)).margin(0.1));
  CHECK(four.elo[0].value == Approx(0.0).margin(1e-9));
}

TEST_CASE("units with one meeting each are as good as single matches", "[unit]") {
  std::vector<UnitResult> results;
  for (std::size_t unit = 0; unit < 100; ++unit) results.push_back({unit, 1, 0, unit < 25 ? 0.0 : 1.0});
  const Ratings ratings = rateUnits(2, 100, results, 1);
  CHECK(ratings.elo[1].value - ratings.elo[0].value == Approx(eloOf(0.75)));
}

TEST_CASE("a thousand resamples of 8 and of 40 entrants take little time", "[unit]") {
  Rng rng(4, test::kTestStream);
  const Meetings few = roundRobin(spreadElo(8, 400.0), 0.8, 50, rng);
  const Meetings many = roundRobin(spreadElo(40, 400.0), 0.8, 50, rng);
  auto begin = std::chrono::steady_clock::now();
  rate(8, few, 1);
  const double eight = seconds(begin);
  begin = std::chrono::steady_clock::now();
  rate(40, many, 1);
  const double forty = seconds(begin);
  std::printf("1,000 resamples: %.3f s for 8 entrants, %.3f s for 40\n", eight, forty);
  CHECK(eight < 3.0);  // ten times the goals of 0.3 s and 2 s, for slow and busy machines
  CHECK(forty < 20.0);
}
