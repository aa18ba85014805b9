#include "tournament/tune/spsa.hpp"

#include <cmath>
#include <set>

#include "engine/core/math/random.hpp"
#include "fulbito/detail/math.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/test_stream.hpp"

namespace fulbito {
namespace {

using namespace fulbito::test;

/// Parameters with the range 0 ... 1 and the given start values.
Spsa spsaOf(const std::vector<double>& starts, int iterations, double perturbation = 0.1, double step = 0.2) {
  Spsa spsa;
  spsa.iterations = iterations;
  for (const double start : starts) {
    spsa.parameters.push_back(
        {"p" + std::to_string(spsa.parameters.size()), false, start, 0.0, 1.0, perturbation, step});
  }
  return spsa;
}

/// A smooth strength [logits] with its maximum at `best`.
double strengthOf(const TunePoint& point, const std::vector<double>& best, double steepness) {
  double sum = 0.0;
  for (std::size_t i = 0; i < point.size(); ++i) sum -= (point[i] - best[i]) * (point[i] - best[i]);
  return steepness * sum;
}

double distanceOf(const TunePoint& a, const std::vector<double>& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return std::sqrt(sum);
}

/// Simulates a tuning: the plus version wins each of `games` games per iteration by a logistic law.
TunePoint tuned(const Spsa& spsa, const std::vector<double>& best, double steepness, int games,
                std::uint64_t seed) {
  TunePoint point = startOf(spsa);
  for (int k = 1; k <= spsa.iterations; ++k) {
    const TunePair versions = versionsAt(spsa, point, k);
    const double lead =
        strengthOf(versions.plus, best, steepness) - strengthOf(versions.minus, best, steepness);
    const double share = 1.0 / (1.0 + math::exp(-lead));
    Rng rng(seed, kTestStream, static_cast<std::uint64_t>(k));
    double sum = 0.0;
    for (int i = 0; i < games; ++i) sum += rng.uniform() < share ? 1.0 : -1.0;
    point = nextPoint(spsa, point, k, sum / games);
  }
  return point;
}

/// Root mean square of the distance to the best point, after tunings with several seeds.
double errorAfter(int iterations, double step, int seeds = 40) {
  double sum = 0.0;
  for (int seed = 0; seed < seeds; ++seed) {
    Spsa spsa = spsaOf({0.2, 0.9}, iterations, 0.1, step);
    spsa.seed = static_cast<std::uint64_t>(seed);
    const double distance = distanceOf(tuned(spsa, {0.5, 0.5}, 8.0, 4, spsa.seed), {0.5, 0.5});
    sum += distance * distance;
  }
  return std::sqrt(sum / seeds);
}

}  // namespace

TEST_CASE("gains have Spall's exponents and end at c_end and r_end", "[unit]") {
  const TunedParameter parameter{"p", false, 0.5, 0.0, 1.0, 0.08, 0.25};
  constexpr int kLast = 200;
  const SpsaGain last = gainOf(parameter, kLast, kLast);
  CHECK(last.perturbation == 0.08);
  CHECK(last.move == Approx(0.25 * 0.08));  // r_end perturbations
  for (const int k : {1, 10, 77}) {
    const SpsaGain gain = gainOf(parameter, k, kLast);
    CHECK(gain.perturbation == Approx(0.08 * std::pow(200.0 / k, 0.101)));
    // a_k = move * perturbation falls as (A + k)^-0.602 with A = 20.
    const double gain_ratio = gain.move * gain.perturbation / (last.move * last.perturbation);
    CHECK(gain_ratio == Approx(std::pow(220.0 / (20.0 + k), 0.602)));
  }
}

TEST_CASE("the versions lie around the point, and a win moves towards the winner", "[unit]") {
  const Spsa spsa = spsaOf({0.5, 0.5, 0.5}, 50);
  const TunePoint point = startOf(spsa);
  const TunePair versions = versionsAt(spsa, point, 7);
  const TunePoint won = nextPoint(spsa, point, 7, 1.0), lost = nextPoint(spsa, point, 7, -1.0);
  for (std::size_t i = 0; i < point.size(); ++i) {
    const SpsaGain gain = gainOf(spsa.parameters[i], 7, 50);
    CHECK(std::abs(versions.plus[i] - point[i]) == Approx(gain.perturbation));
    CHECK(versions.plus[i] + versions.minus[i] == Approx(2.0 * point[i]));
    CHECK((won[i] - point[i]) * (versions.plus[i] - point[i]) > 0.0);
    CHECK(std::abs(won[i] - point[i]) == Approx(gain.move));
    CHECK(won[i] + lost[i] == Approx(2.0 * point[i]));
  }
  CHECK(nextPoint(spsa, point, 7, 0.0) == point);
}

TEST_CASE("directions are fair coins of seed, iteration and parameter", "[unit]") {
  Spsa spsa = spsaOf({0.5, 0.5, 0.5, 0.5}, 1000);
  const TunePoint point = startOf(spsa);
  std::vector<int> ups(4);
  int equal = 0;
  std::set<std::vector<bool>> seen;
  for (int k = 1; k <= 1000; ++k) {
    const TunePoint plus = versionsAt(spsa, point, k).plus;
    std::vector<bool> signs;
    for (std::size_t i = 0; i < 4; ++i) {
      signs.push_back(plus[i] > 0.5);
      ups[i] += plus[i] > 0.5 ? 1 : 0;
    }
    equal += signs[0] == signs[1] ? 1 : 0;
    seen.insert(signs);
  }
  // Four standard deviations of the number of heads in 1,000 fair coin tosses.
  for (const int up : ups) CHECK(std::abs(up - 500) < 64);
  CHECK(std::abs(equal - 500) < 64);
  CHECK(seen.size() == 16);
  const TunePair first = versionsAt(spsa, point, 3);
  spsa.seed = 2;
  int other = 0;
  for (int k = 1; k <= 20; ++k) {
    Spsa one = spsa;
    one.seed = 1;
    other += versionsAt(spsa, point, k).plus != versionsAt(one, point, k).plus ? 1 : 0;
  }
  CHECK(other > 10);
  spsa.seed = 1;
  CHECK(versionsAt(spsa, point, 3).plus == first.plus);
}

TEST_CASE("neither versions nor points leave the limits", "[unit]") {
  const Spsa spsa = spsaOf({0.0, 1.0, 0.97}, 20, 0.3, 5.0);
  TunePoint point = startOf(spsa);
  for (int k = 1; k <= 20; ++k) {
    const TunePair versions = versionsAt(spsa, point, k);
    point = nextPoint(spsa, point, k, k % 3 == 0 ? -1.0 : 1.0);
    for (const TunePoint& any : {versions.plus, versions.minus, point}) {
      for (const double share : any) CHECK((share >= 0.0 && share <= 1.0));
    }
    CHECK(versions.plus != versions.minus);
  }
}

TEST_CASE("without noise SPSA finds the best point", "[unit]") {
  const std::vector<double> best{0.3, 0.6, 0.45};
  const Spsa spsa = spsaOf({0.9, 0.1, 0.8}, 400, 0.05, 0.5);
  TunePoint point = startOf(spsa);
  for (int k = 1; k <= spsa.iterations; ++k) {
    const TunePair versions = versionsAt(spsa, point, k);
    const double lead = strengthOf(versions.plus, best, 3.0) - strengthOf(versions.minus, best, 3.0);
    point = nextPoint(spsa, point, k, std::clamp(lead, -1.0, 1.0));
  }
  CHECK(distanceOf(point, best) < 0.01);
}

TEST_CASE("with the noise of matches the error falls with the number of iterations", "[unit]") {
  // The gains keep the total travel for a sure direction: the step decreases as the iterations increase.
  // Spall's rate with these exponents is n^-0.2 or better; near the maximum it is n^-0.5 at best.
  const double start = distanceOf({0.2, 0.9}, {0.5, 0.5});
  const double few = errorAfter(100, 0.2), some = errorAfter(400, 0.1), many = errorAfter(1600, 0.05);
  CHECK(few < 0.5 * start);
  CHECK(some < few);
  CHECK(many < some);
  const double rate = std::log(few / many) / std::log(16.0);
  CHECK(rate > 0.15);
  CHECK(rate < 0.6);
}

TEST_CASE("a parameter without effect stays near its start while another is tuned", "[unit]") {
  double sum = 0.0, error = 0.0;
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    Spsa spsa = spsaOf({0.2, 0.5}, 200, 0.1, 0.1);
    spsa.seed = seed;
    TunePoint point = startOf(spsa);
    for (int k = 1; k <= spsa.iterations; ++k) {
      const TunePair versions = versionsAt(spsa, point, k);
      const double lead =
          strengthOf({versions.plus[0]}, {0.6}, 8.0) - strengthOf({versions.minus[0]}, {0.6}, 8.0);
      const double share = 1.0 / (1.0 + math::exp(-lead));
      Rng rng(seed, kTestStream, static_cast<std::uint64_t>(k));
      point = nextPoint(spsa, point, k, rng.uniform() < share ? 1.0 : -1.0);
    }
    error += std::abs(point[0] - 0.6) / 30;
    sum += (point[1] - 0.5) / 30;
  }
  CHECK(error < 0.2);
  CHECK(std::abs(sum) < 0.1);
}

TEST_CASE("the path is a function of the results: it continues from any of its parts", "[unit]") {
  const Spsa spsa = spsaOf({0.4, 0.7}, 30);
  std::vector<double> results;
  Rng rng(5, kTestStream);
  for (int k = 0; k < 30; ++k) results.push_back(rng.uniform(-1.0, 1.0));
  const std::vector<TunePoint> whole = pathOf(spsa, results);
  REQUIRE(whole.size() == 31);
  CHECK(whole.front() == startOf(spsa));
  for (const std::size_t kept : {std::size_t{0}, std::size_t{1}, std::size_t{17}, std::size_t{30}}) {
    std::vector<TunePoint> path = pathOf(spsa, std::span(results).first(kept));
    CHECK(path.back() == whole[kept]);
    for (std::size_t k = kept; k < results.size(); ++k) {
      path.push_back(nextPoint(spsa, path.back(), static_cast<int>(k) + 1, results[k]));
    }
    CHECK(path == whole);
  }
}

TEST_CASE("a tuning with wrong numbers is refused by the parameter's name", "[unit]") {
  const auto refused = [](auto change) {
    Spsa spsa = spsaOf({0.5, 0.5}, 10);
    spsa.parameters[1].name = "depth";
    change(spsa);
    const auto checked = validate(spsa);
    return !checked && checked.error().code == ErrorCode::kUsage ? checked.error().message : std::string();
  };
  CHECK(validate(spsaOf({0.5}, 10)));
  for (const std::string& message : {refused([](Spsa& s) { s.parameters[1].high = 0.0; }),
                                     refused([](Spsa& s) { s.parameters[1].high = std::nan(""); }),
                                     refused([](Spsa& s) { s.parameters[1].start = 1.5; }),
                                     refused([](Spsa& s) { s.parameters[1].whole = true; }),
                                     refused([](Spsa& s) { s.parameters[1].perturbation = 0.0; }),
                                     refused([](Spsa& s) { s.parameters[1].perturbation = 0.6; }),
                                     refused([](Spsa& s) { s.parameters[1].step = -1.0; }),
                                     refused([](Spsa& s) { s.parameters[0].name = "depth"; })}) {
    CHECK(message.find("'depth'") != std::string::npos);
  }
  CHECK_FALSE(refused([](Spsa& s) { s.parameters.clear(); }).empty());
  CHECK_FALSE(refused([](Spsa& s) { s.iterations = 0; }).empty());
}

}  // namespace fulbito
