#include "tournament/gate/gate.hpp"

#include <nlohmann/json.hpp>

#include "tests/support/catch.hpp"
#include "tests/support/test_teams.hpp"

using namespace fulbito;
using namespace fulbito::test;

namespace {

GateConfig gateOf(const std::string& a, const std::string& b, int pairs) {
  GateConfig config;
  config.series.match = shortMatch(a, b, 15.0);
  config.series.pairs = pairs;
  config.series.jobs = 2;
  return config;
}

}  // namespace

TEST_CASE("a much stronger team passes and a much weaker one fails, long before the last pair", "[unit]") {
  const auto better = runGate(gateOf("chaser", "idle", 200));
  REQUIRE(better);
  CHECK(better->sprt.verdict() == SprtVerdict::kPass);
  CHECK(better->series.pairs.size() < 100);
  CHECK(static_cast<std::size_t>(better->sprt.counts().pairs()) == better->series.pairs.size());
  CHECK_FALSE(better->series.interrupted);
  const auto worse = runGate(gateOf("idle", "chaser", 200));
  REQUIRE(worse);
  CHECK(worse->sprt.verdict() == SprtVerdict::kFail);
}

TEST_CASE("a team against itself draws every pair, and few pairs prove nothing", "[unit]") {
  const auto gate = runGate(gateOf("chaser", "chaser", 5));
  REQUIRE(gate);
  CHECK(gate->sprt.verdict() == SprtVerdict::kInconclusive);
  CHECK(gate->sprt.counts().counts == std::array<std::int64_t, 5>{0, 0, 5, 0, 0});
  CHECK(gateText(*gate).find("chaser against chaser: inconclusive, no verdict after 5 pairs") !=
        std::string::npos);
}

TEST_CASE("the number of jobs changes neither verdict nor report", "[unit]") {
  GateConfig config = gateOf("chaser", "random", 60);
  const auto json_of = [&](int jobs) {
    config.series.jobs = jobs;
    const auto gate = runGate(config);
    REQUIRE(gate);
    return gateJson(*gate);
  };
  const std::string alone = json_of(1);
  CHECK(alone == json_of(2));
  CHECK(alone == json_of(7));
  const auto json = nlohmann::json::parse(alone);
  CHECK(json["pairs"] == json["counts"][0].get<int>() + json["counts"][1].get<int>() +
                             json["counts"][2].get<int>() + json["counts"][3].get<int>() +
                             json["counts"][4].get<int>());
  CHECK(json["bounds"] == nlohmann::json{-50.0, 0.0});
}

TEST_CASE("bounds and error rates that make no test are refused by name", "[unit]") {
  GateConfig config = gateOf("chaser", "idle", 1);
  config.bounds = {10.0, -10.0, 0.05, 0.05};
  CHECK(runGate(config).error().message.find("bounds: ") == 0);
  config.bounds = {0.0, 5000.0, 0.05, 0.05};
  CHECK(runGate(config).error().code == ErrorCode::kUsage);
  config.bounds = {0.0, 10.0, 0.0, 0.05};
  CHECK(runGate(config).error().message.find("alpha: ") == 0);
  config.bounds = {0.0, 10.0, 0.05, 0.6};
  CHECK(runGate(config).error().message.find("beta: ") == 0);
}
