#include "replays/verify/diff.hpp"

#include <algorithm>

#include "replays/verify/cut.hpp"
#include "tests/support/test_recordings.hpp"

namespace fulbito {
namespace {

using namespace fulbito::test;

/// Two teams that drive straight on; one robot changes its command at some tick.
MatchConfig driving(const TestEntry& yellow, const TestEntry& blue) {
  MatchConfig config = shortMatch("chaser", "chaser", 3.0);
  config.teams = {blue.choice(), yellow.choice()};
  config.start = twoColumns();
  return config;
}

}  // namespace

TEST_CASE("a recording is the same as itself, at any level", "[unit]") {
  const MatchConfig config = shortMatch("chaser", "chaser", 10.0);
  const auto found = diff(readerOf(recorded(config)), readerOf(recorded(config, RecordingLevel::kRecipe)));
  REQUIRE(found);
  CHECK(found->same());
}

TEST_CASE("what differs in the recipe is named, and where play parts", "[unit]") {
  MatchConfig config = shortMatch("chaser", "chaser", 10.0);
  const RecordingReader a = readerOf(recorded(config));
  config.seed += 1;
  config.physics.substeps += 1;
  const auto found = diff(a, readerOf(recorded(config)));
  REQUIRE(found);
  CHECK_FALSE(found->same());
  std::vector<std::string> names;
  for (const RecipeDifference& d : found->recipe) names.push_back(d.name);
  CHECK(names == std::vector<std::string>{"seed", "physics"});
  CHECK(found->recipe[1].a.find("substeps") == 0);
  REQUIRE(found->tick);
  CHECK(*found->tick == 0);
  CHECK(found->start);
  REQUIRE_FALSE(found->bodies.empty());
}

TEST_CASE("the first tick that differs is found with the command that did it", "[unit]") {
  const TestEntry steady([](const Observation&) { return allWheels({3.0, 3.5}); });
  const TestEntry turning([](const Observation& seen) {
    TeamCommand command = allWheels({3.0, 3.5});
    if (seen.tick >= 50) command = allWheels({3.0, 3.6});
    return command;
  });
  const RecordingReader a = readerOf(recorded(driving(steady, steady)));
  RecordingReader b = readerOf(recorded(driving(turning, steady)));
  const auto found = diff(a, b);
  REQUIRE(found);
  REQUIRE(found->tick);
  CHECK(*found->tick == 51);
  CHECK(found->play == 0);
  CHECK_FALSE(found->start);
  REQUIRE(found->bodies.size() >= 4);
  CHECK(found->bodies[0].body_name == "yellow 0");
  CHECK(found->bodies[0].field == "command right");
  CHECK(found->bodies[0].a == Approx(3.5));
  CHECK(found->bodies[0].b == Approx(3.6));
  const bool moved = std::any_of(found->bodies.begin(), found->bodies.end(), [](const BodyDifference& d) {
    return d.field == "angular velocity" && d.body_name == "yellow 2" && d.a != d.b;
  });
  CHECK(moved);
}

TEST_CASE("the beginning of a recording is the same but shorter; other bodies cannot be compared", "[unit]") {
  const RecordingReader whole = readerOf(recorded(shortMatch("chaser", "chaser", 30.0)));
  const auto bytes = cutPlays(whole, {0, 1});
  REQUIRE(bytes);
  const RecordingReader begin = readerOf(*bytes);
  const auto found = diff(whole, begin);
  REQUIRE(found);
  CHECK_FALSE(found->tick);
  CHECK_FALSE(found->same());
  CHECK(found->ticks_b < found->ticks_a);
  MatchConfig larger = shortMatch("chaser", "chaser", 2.0);
  larger.rules = *loadRules("vsss-5v5");
  larger.rules.half_seconds = 2.0;
  larger.field = *loadField(larger.rules.field);
  const auto other = diff(whole, readerOf(recorded(larger)));
  REQUIRE(other);
  CHECK_FALSE(other->comparable);
  CHECK_FALSE(other->same());
}

}  // namespace fulbito
