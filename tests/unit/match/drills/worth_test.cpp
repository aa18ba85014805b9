#include "match/drills/worth.hpp"

#include <limits>

#include <nlohmann/json.hpp>

#include "strategies/interface/team_info.hpp"
#include "tests/support/catch.hpp"

namespace fulbito {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// Drives straight on if it may push.
class Pusher final : public Strategy {
 public:
  explicit Pusher(bool pushes) : pushes_(pushes) {}
  void begin(const MatchInfo&) override {}
  TeamCommand decide(const Observation&) override {
    TeamCommand command;
    if (pushes_) command.robots[0] = RobotCommand::byTwist({1.0, 0.0});
    return command;
  }

 private:
  bool pushes_;
};

/// A team with three skills, one of which it cannot do without.
TeamInfo pusherInfo() {
  TeamInfo info;
  info.name = "pusher";
  info.parameters = {{"length", ParameterSpec::Type::kNumber, 1.0, 0.0, 2.0, {}, "m", "of the push"}};
  info.make = [](const std::vector<Setting>& settings) -> Result<std::unique_ptr<Strategy>> {
    bool pushes = true;
    for (const Setting& setting : settings) {
      if (setting.name != kWithoutSetting) continue;
      if (setting.value.find("stand") != std::string::npos) {
        return fail(ErrorCode::kUsage, "pusher: it needs stand");
      }
      pushes = setting.value.find("push") == std::string::npos;
    }
    return std::make_unique<Pusher>(pushes);
  };
  info.skills = {{"keeper", "push", "always: pushes"},
                 {"striker", "push", "always: pushes"},
                 {"striker", "sleep", "never: sleeps"},
                 {"striker", "stand", "always: stands"}};
  return info;
}

struct Fixture {
  TeamCatalogue catalogue = TeamCatalogue::builtIn();
  TeamChoice team;
  Fixture() {
    REQUIRE(catalogue.add(pusherInfo()));
    team = choice("pusher");
  }
  TeamChoice choice(const std::string& text) const {
    auto parsed = catalogue.parse(text);
    if (!parsed) FAIL(parsed.error().message);
    return *parsed;
  }
  std::string errorOf(const TeamChoice& of, const std::string& skill) const {
    const auto left_out = withoutEach(of, {skill}, catalogue);
    return left_out ? "" : left_out.error().message;
  }
};

/// A ball in front of the goal, and a robot right behind it; every second trial is the other way round.
Drill tapIn() {
  auto drill = parseDrill(
      "[drill]\nnumber = 900\nname = \"tap-in\"\nwhat = \"tap in\"\nduration = 2.0\ntrials = 12\n[[start]]\n"
      "ball = [[0.62, 0.0]]\n[[robot]]\nfrom_ball = true\nat = [[-0.08, 0.0]]\nface_ball = true\n"
      "[[success]]\nwhat = \"goal\"\n[[pass]]\nvalue = \"success\"\nstatistic = \"rate\"\nat_least = 0.5\n",
      "test.toml");
  if (!drill) FAIL(drill.error().message);
  return *drill;
}

DrillReport reportOfValues(std::vector<double> values, const std::string& opponent = "") {
  DrillReport report;
  report.drill.match_opponent = opponent;
  report.values = std::move(values);
  return report;
}

}  // namespace

TEST_CASE("each skill is left out once, also of a team with other settings", "[unit]") {
  const Fixture fixture;
  const auto one = withoutEach(fixture.team, {"push"}, fixture.catalogue);
  REQUIRE(one);
  REQUIRE(one->size() == 1);
  CHECK(one->front().team.text == "pusher:without=push");
  const auto more =
      withoutEach(fixture.choice("pusher:without=sleep,length=0.5"), {"push"}, fixture.catalogue);
  REQUIRE(more);
  CHECK(more->front().team.text == "pusher:without=sleep+push,length=0.5");
  const auto set = withoutEach(fixture.choice("pusher:length=0.5"), {"sleep"}, fixture.catalogue);
  REQUIRE(set);
  CHECK(set->front().team.text == "pusher:length=0.5,without=sleep");
}

TEST_CASE("all means every skill that the team can do without", "[unit]") {
  const Fixture fixture;
  const auto all = withoutEach(fixture.team, {"all"}, fixture.catalogue);
  REQUIRE(all);
  REQUIRE(all->size() == 2);
  CHECK((*all)[0].skill == "push");
  CHECK((*all)[1].skill == "sleep");
}

TEST_CASE("a wrong skill is an error that helps", "[unit]") {
  const Fixture fixture;
  CHECK(fixture.errorOf(fixture.team, "pusch") ==
        "--without: pusher has no skill 'pusch'. Did you mean 'push'? It must be all or one of push, sleep, "
        "stand.");
  CHECK(fixture.errorOf(fixture.team, "stand") == "pusher: it needs stand");
  CHECK(fixture.errorOf(*parseTeam("chaser"), "push").starts_with("--without: chaser has no list of skills"));
  CHECK(fixture.errorOf(*parseTeam("chaser"), "push").find("pusher") != std::string::npos);
}

TEST_CASE("worth of trials is the difference of paired rates", "[unit]") {
  const DrillWorth worth =
      worthIn(reportOfValues({1, 1, 1, 0, 1, kNan, 0, 1}), reportOfValues({1, 0, 0, 0, 0, 1, 1, kNan}));
  CHECK(worth.count == 6);
  CHECK(worth.changed == 4);
  CHECK(worth.with == Approx(4.0 / 6));
  CHECK(worth.without == Approx(2.0 / 6));
  CHECK(worth.worth.value == Approx(2.0 / 6));
  // By hand: n = 8, b = 3.5, c = 1.5; centre 2 / 8, half 1.96 sqrt(5 - 4 / 8) / 8.
  CHECK(worth.worth.low == Approx(0.25 - 0.51972).margin(1e-4));
  CHECK(worth.worth.high == Approx(0.25 + 0.51972).margin(1e-4));
}

TEST_CASE("worth of matches is the mean difference of goals ahead, with Student's interval", "[unit]") {
  const DrillWorth worth =
      worthIn(reportOfValues({3, 2, 5, 2}, "chaser"), reportOfValues({2, 0, 2, 2}, "chaser"));
  CHECK(worth.changed == 3);
  CHECK(worth.worth.value == Approx(1.5));
  // By hand: deviation sqrt(5 / 3), t = 3.182 for 3 degrees of freedom.
  CHECK(worth.worth.high == Approx(1.5 + 3.182 * 1.29099 / 2).margin(1e-3));
}

TEST_CASE("no trial that counts gives no worth", "[unit]") {
  CHECK(worthIn(reportOfValues({}), reportOfValues({})).count == 0);
  CHECK(worthIn(reportOfValues({kNan}), reportOfValues({1.0})).count == 0);
}

TEST_CASE("skills are measured on the same trials; the table shows what changes", "[unit]") {
  const Fixture fixture;
  DrillOptions options;
  options.team = fixture.team;
  options.catalogue = fixture.catalogue;
  const auto left_out = withoutEach(fixture.team, {"all"}, fixture.catalogue);
  REQUIRE(left_out);
  std::vector<std::string> names;
  const auto report = measureWorth({tapIn()}, {}, options, *left_out, [&](const std::string& name) {
    names.push_back(name);
    return DrillProgress();
  });
  REQUIRE(report);
  CHECK(names == std::vector<std::string>{"pusher", "pusher:without=push", "pusher:without=sleep"});
  REQUIRE(report->skills.size() == 2);
  const DrillWorth& push = report->skills[0].drills.at(0);
  CHECK(push.count == 12);
  CHECK(push.changed == 12);
  CHECK(push.worth.value == 1.0);
  CHECK(report->skills[1].drills.at(0).changed == 0);
  const std::string table = worthTable(*report, options);
  CHECK(table.find("| push | 900 tap-in | 12 of 12 | 100.0 % | 0.0 % | +100.0 (+") != std::string::npos);
  CHECK(table.find("| helps |") != std::string::npos);
  CHECK(table.ends_with("\nNo trial changes without: sleep.\n"));
  const auto json = nlohmann::json::parse(worthJson(*report, options));
  CHECK(json["team"] == "pusher");
  CHECK(json["skills"][0]["team"] == "pusher:without=push");
  CHECK(json["skills"][0]["drills"][0]["unit"] == "share");
  CHECK(json["skills"][0]["drills"][0]["worth"] == 1.0);
  CHECK(json["skills"][1]["drills"][0]["changed"] == 0);
}

TEST_CASE("drills of whole matches report goals ahead of each match", "[unit]") {
  const auto drill = parseDrill(
      "[drill]\nnumber = 903\nwhat = \"x\"\ntrials = 2\nmatch_opponent = \"idle\"\nhalf_seconds = 10.0\n"
      "[[pass]]\nvalue = \"margin\"\nstatistic = \"mean\"\nat_least = 0.5\n",
      "test.toml");
  REQUIRE(drill);
  DrillOptions options;
  options.team = *parseTeam("chaser");
  const auto reports = runDrills({*drill}, {}, options, {});
  REQUIRE(reports);
  const DrillReport& report = reports->front();
  REQUIRE(report.values.size() == 2);
  CHECK(report.ofMatches());
  CHECK((report.values[0] + report.values[1]) / 2 == Approx(report.verdicts[0].value.value));
}

}  // namespace fulbito
