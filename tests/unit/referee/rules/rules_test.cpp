#include <filesystem>
#include <fstream>

#include "engine/core/math/random.hpp"
#include "fulbito/models.hpp"
#include "fulbito/referee.hpp"
#include "referee/restarts/check_places.hpp"
#include "referee/rules/detector_schema.hpp"
#include "referee/rules/rules_schema.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/field_count.hpp"
#include "tests/support/test_stream.hpp"

namespace fulbito {
namespace {

std::string errorOf(const std::string& text) {
  const auto rules = parseRules(text, "x.toml");
  return rules ? "" : rules.error().message;
}

/// Whether each member of `R` is a key of its table.
template <typename R>
void checkEveryMemberIsAKey() {
  R rules;
  CHECK(schemaOf(rules).size() == test::fieldCount<R>());
}

}  // namespace

TEST_CASE("no member of a detector's rules lacks a key", "[unit]") {
  static_assert(test::fieldCount<StuckRules>() > 5);
  checkEveryMemberIsAKey<GoalRules>();
  checkEveryMemberIsAKey<StuckRules>();
  checkEveryMemberIsAKey<AreaRules>();
  checkEveryMemberIsAKey<KeeperRules>();
  checkEveryMemberIsAKey<FoulRules>();
}

TEST_CASE("the embedded profiles load under their names", "[unit]") {
  CHECK(rulesPresetNames() ==
        std::vector<std::string>{"league-program-2021", "training", "vsss-3v3", "vsss-5v5"});
  for (const std::string& name : rulesPresetNames()) {
    const auto rules = loadRules(name);
    REQUIRE(rules);
    CHECK(rules->name == name);
    CHECK(validate(*rules));
  }
}

TEST_CASE("the defaults of the struct are the profile vsss-3v3", "[unit]") {
  CHECK(toToml(*loadRules("vsss-3v3")) == toToml(Rules{}));
}

TEST_CASE("every key of every table is printed for every embedded profile, with its source", "[unit]") {
  Rules rules;
  for (const std::string& name : rulesPresetNames()) {
    const std::string text = *rulesPresetText(name);
    CHECK(text.starts_with("# "));
    for (const RulesTable& table : tablesOf(rules)) {
      CHECK(text.find("\n[" + table.name + "]\n") != std::string::npos);
      for (const SchemaKey& key : table.schema) {
        INFO(name << " " << table.name << "." << key.key);
        const std::size_t line = text.find("\n" + key.key + " = ");
        REQUIRE(line != std::string::npos);
        const std::string shown = text.substr(line + 1, text.find('\n', line + 1) - line - 1);
        CHECK(shown.find("  # ") != std::string::npos);
      }
    }
  }
}

TEST_CASE("a profile printed and read again is the same", "[unit]") {
  for (const std::string& name : rulesPresetNames()) {
    const Rules rules = *loadRules(name);
    const auto again = parseRules(toToml(rules), "printed");
    REQUIRE(again);
    CHECK(toToml(*again) == toToml(rules));
  }
}

TEST_CASE("a profile that lacks keys keeps the defaults, and is named after its file", "[unit]") {
  const auto rules = parseRules("[rules]\n[periods]\nhalf_seconds = 60\n", "folder/mine.toml");
  REQUIRE(rules);
  CHECK(rules->name == "mine");
  CHECK(rules->half_seconds == 60.0);
  CHECK(rules->team_size == 3);
}

TEST_CASE("a bad profile is refused with file, line, key and range", "[unit]") {
  CHECK(errorOf("[periods]\n") == "x.toml:1: the table [rules] is missing");
  CHECK(errorOf("[rules]\n\n[periods]\nhalf_seconds = -3\n") ==
        "x.toml:4: periods.half_seconds = -3 is outside 0.1 ... 7200 s");
  CHECK(errorOf("[rules]\n[periods]\nhalf_second = 3\n") ==
        "x.toml:3: periods.half_second is not a key of [periods]. Did you mean 'half_seconds'?");
  CHECK(errorOf("[rules]\nteam_size = 12\n") == "x.toml:2: rules.team_size = 12 is outside 1 ... 11 robots");
  CHECK(errorOf("[rules]\n[periods]\ntie_break = \"dice\"\n") ==
        "x.toml:3: periods.tie_break = \"dice\" is not one of none, overtime, shoot-out, overtime+shoot-out");
  CHECK(errorOf("[rules]\n[shoot_out]\nkicks = 30\n").find("x.toml:2: shoot_out.max_kicks") == 0);
  CHECK(errorOf("[rules]\n[restart]\nfalse_start_release = 0.5\n") ==
        "x.toml:3: restart.false_start_release = 0.5 must be at most false_start_distance = 0.02");
  CHECK(errorOf("[rules]\n[goal_kick]\ntaker = [[0.1, 0.2], [1, 2], 3]\n")
            .find("x.toml:3: goal_kick.taker[2]") == 0);
  CHECK(errorOf("[rules]\n[goal_kick]\ntaker = [[0.1, nan]]\n").find("x.toml:3: goal_kick.taker[0]") == 0);
  CHECK(errorOf("[rules]\n[referee]\n").find("x.toml:2: 'referee' is not a table of this file.") == 0);
  std::string many = "[rules]\n[kick_off]\ntaker = [[0, 0]";
  for (int i = 0; i < 11; ++i) many += ", [0, 0]";
  CHECK(errorOf(many + "]\n") == "x.toml:3: kick_off.taker has 12 places; at most 11 are allowed");
}

TEST_CASE("a damaged profile is read or refused by line, never worse", "[unit]") {
  int refused = 0;
  for (std::uint64_t i = 0; i < 400; ++i) {
    Rng rng(9, test::kTestStream, i);
    std::string text = *rulesPresetText(rulesPresetNames()[rng.below(4)]);
    for (std::uint32_t damage = rng.below(4); damage < 4; ++damage) {
      const std::size_t at = rng.below(static_cast<std::uint32_t>(text.size()));
      if (rng.below(4) == 0)
        text.erase(at, rng.below(30));
      else
        text[at] = static_cast<char>(rng.below(256));
    }
    const auto rules = parseRules(text, "x.toml");
    if (rules) {
      CHECK(validate(*rules));
    } else {
      ++refused;
      CHECK(rules.error().message.starts_with("x.toml:"));
    }
  }
  CHECK(refused > 50);
}

TEST_CASE("places that the laws do not allow are told, and the embedded profiles have none", "[unit]") {
  for (const std::string& name : rulesPresetNames()) {
    const Rules rules = *loadRules(name);
    CHECK(findBadPlaces(rules, *loadField(rules.field), RobotModel()).empty());
  }
  Rules rules;
  rules.penalty.places.other[2] = {0.1, 0.4};
  rules.goal_kick.places.taker[1] = {0.8, 0.8};
  CHECK(findBadPlaces(rules, FieldGeometry(), RobotModel()) ==
        std::vector<std::string>{"penalty: robot 2 of the other team is not beyond the half-way line",
                                 "goal-kick: robot 1 of the taking team is not on the field"});
}

TEST_CASE("every robot that overlaps is told, not the first alone", "[unit]") {
  Rules rules;
  rules.team_size = 5;
  rules.kick_off.places.taker = {{0.675, 0.0}, {0.2, 0.0}, {0.4, 0.0}, {0.4, 0.02}, {0.4, -0.02}};
  rules.kick_off.places.other = {{0.675, 0.0}, {0.3, 0.0}, {0.4, 0.1}, {0.4, -0.1}, {0.4, -0.3}};
  std::vector<std::string> of_kick_off;
  for (const std::string& flaw : findBadPlaces(rules, FieldGeometry(), RobotModel())) {
    if (flaw.starts_with("kick-off")) of_kick_off.push_back(flaw);
  }
  CHECK(of_kick_off == std::vector<std::string>{"kick-off: robot 3 of the taking team overlaps a robot",
                                                "kick-off: robot 4 of the taking team overlaps a robot"});
}

TEST_CASE("places of another field are told with the profile to begin with", "[unit]") {
  for (const std::string& name : rulesPresetNames()) {
    const Rules rules = *loadRules(name);
    INFO(name);
    CHECK_FALSE(findForeignPlaces(rules, *loadField(rules.field), RobotModel()));
  }
  FieldGeometry large = *loadField("vsss-5v5");
  large.name = "large";
  Rules rules;  // its places are for the field of 1.5 m
  rules.name = "mine";
  const auto note = findForeignPlaces(rules, large, RobotModel());
  REQUIRE(note);
  CHECK(note->find("'mine'") != std::string::npos);
  CHECK(note->find("'large', 2.2 x 1.8 m") != std::string::npos);
  CHECK(note->find("robot 0 is 0.45 m from its goal line") != std::string::npos);
  CHECK(note->ends_with("fulbito rules show vsss-5v5"));
  const auto small = findForeignPlaces(*loadRules("vsss-5v5"), FieldGeometry(), RobotModel());
  REQUIRE(small);
  CHECK(small->find("is not on the field") != std::string::npos);
  CHECK(small->ends_with("fulbito rules show vsss-3v3"));
}

TEST_CASE("an unknown profile is a usage error with a suggestion", "[unit]") {
  const auto rules = loadRules("vsss-3v4");
  REQUIRE_FALSE(rules);
  CHECK(rules.error().code == ErrorCode::kUsage);
  CHECK(rules.error().message.find("Did you mean 'vsss-3v3'?") != std::string::npos);
  const auto file = loadRules("/nowhere/x.toml");
  REQUIRE_FALSE(file);
  CHECK(file.error().code == ErrorCode::kIo);
}

}  // namespace fulbito
