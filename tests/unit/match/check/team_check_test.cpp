#include "match/check/team_check.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <memory>

#include "tests/support/catch.hpp"
#include "tests/support/test_teams.hpp"

namespace fulbito {
namespace {

using namespace fulbito::test;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr std::int64_t kMillisecond = 1'000'000;

/// A clock that only the test moves.
struct FakeClock {
  std::shared_ptr<std::int64_t> time = std::make_shared<std::int64_t>(0);
  MatchClock reader() const {
    return [time = time] { return *time; };
  }
};

TeamReport reportOf(const TeamChoice& team, const FakeClock& clock = {}) {
  TeamCheckOptions options;
  options.team = team;
  options.quick = true;
  options.jobs = 1;
  options.clock = clock.reader();
  const auto report = checkTeam(options);
  REQUIRE(report);
  return *report;
}

const TeamCheck& checkOf(const TeamReport& report, const std::string& name) {
  const auto found = std::find_if(report.checks.begin(), report.checks.end(),
                                  [&](const TeamCheck& check) { return check.name == name; });
  INFO(name);
  REQUIRE(found != report.checks.end());
  return *found;
}

/// The names of all checks with that verdict.
std::vector<std::string> namesOf(const TeamReport& report, CheckVerdict verdict) {
  std::vector<std::string> names;
  for (const TeamCheck& check : report.checks) {
    if (check.verdict == verdict) names.push_back(check.name);
  }
  return names;
}

using Names = std::vector<std::string>;

/// Drives every robot forward, as `info` says.
class Colourful final : public Strategy {
 public:
  void begin(const MatchInfo& info) override { team_ = info.team; }
  TeamCommand decide(const Observation&) override {
    return allWheels(team_ == TeamId::kBlue ? WheelSpeeds{5.0, 5.0} : WheelSpeeds{4.0, 4.0});
  }

 private:
  TeamId team_ = TeamId::kBlue;
};

}  // namespace

TEST_CASE("no check of a built-in team fails", "[unit]") {
  for (const char* name : {"idle", "chaser", "classic", "libero"}) {
    const TeamReport report = reportOf(*parseTeam(name));
    INFO(teamCheckTable(report));
    CHECK(namesOf(report, CheckVerdict::kFailed) == Names{});
    CHECK(report.verdict() != CheckVerdict::kFailed);
  }
}

TEST_CASE("a team that commands NaN fails with its values, not as random", "[unit]") {
  const TestEntry team([](const Observation& seen) {
    TeamCommand command = allWheels({1.0, 1.0});
    if (seen.tick > 10) command.robots[1] = RobotCommand::byWheels({kNaN, 1.0});
    return command;
  });
  const TeamReport report = reportOf(team.choice());
  CHECK(namesOf(report, CheckVerdict::kFailed) == Names{"values"});
  CHECK(checkOf(report, "values").finding.find("kick-off, ours (as blue)") != std::string::npos);
}

TEST_CASE("a team with memory beyond its match is not deterministic", "[unit]") {
  const auto counter = std::make_shared<int>(0);
  const TestEntry team([counter](const Observation&) {
    const double speed = 1.0 + (++*counter % 1000) * 0.001;
    return allWheels({speed, speed});
  });
  const TeamReport report = reportOf(team.choice());
  CHECK(namesOf(report, CheckVerdict::kFailed) == Names{"determinism"});
  CHECK(checkOf(report, "seat").verdict == CheckVerdict::kWarning);
}

TEST_CASE("a team that plays otherwise as yellow fails", "[unit]") {
  const TeamReport report =
      reportOf(TeamChoice::own("colourful", [] { return std::make_unique<Colourful>(); }));
  CHECK(namesOf(report, CheckVerdict::kFailed) == Names{"seat"});
  CHECK(checkOf(report, "mirror").verdict == CheckVerdict::kOk);
}

TEST_CASE("a team that always turns left gets a warning", "[unit]") {
  const TestEntry team([](const Observation&) { return allWheels({3.0, 5.0}); });
  const TeamReport report = reportOf(team.choice());
  CHECK(namesOf(report, CheckVerdict::kFailed) == Names{});
  CHECK(checkOf(report, "mirror").verdict == CheckVerdict::kWarning);
}

TEST_CASE("a team that is always beyond the motors gets a warning", "[unit]") {
  const TestEntry team([](const Observation&) { return allWheels({1e6, 1e6}); });
  const TeamReport report = reportOf(team.choice());
  CHECK(namesOf(report, CheckVerdict::kFailed) == Names{});
  CHECK(checkOf(report, "motors").verdict == CheckVerdict::kWarning);
  CHECK(checkOf(report, "motors").figures[1].second == 1.0);
}

TEST_CASE("a slow team fails by the clock it is given", "[unit]") {
  const FakeClock clock;
  const auto slow = [&](std::int64_t milliseconds) {
    const TestEntry team([time = clock.time, milliseconds](const Observation&) {
      *time += milliseconds * kMillisecond;
      return allWheels({1.0, 1.0});
    });
    return reportOf(team.choice(), clock);
  };
  CHECK(namesOf(slow(19), CheckVerdict::kFailed) == Names{});
  CHECK(namesOf(slow(21), CheckVerdict::kFailed) == Names{"time"});
  const TeamReport report = slow(150);  // beyond the bank
  CHECK(namesOf(report, CheckVerdict::kFailed) == Names{"time"});
  CHECK(checkOf(report, "time").finding.find("late") != std::string::npos);
}

TEST_CASE("drawings that nobody wants and bad places get warnings", "[unit]") {
  const TestEntry team(
      [](const Observation&) {
        TeamCommand command = allWheels({1.0, 1.0});
        command.drawings.emplace_back();
        return command;
      },
      [](const PlacementRequest&) {
        TeamPlacement poses;
        poses[0] = Pose2{{5.0, 0.0}, 0.0};  // beyond the walls
        return TeamProposal(poses);
      });
  const TeamReport report = reportOf(team.choice());
  CHECK(namesOf(report, CheckVerdict::kFailed) == Names{});
  CHECK(checkOf(report, "drawings").verdict == CheckVerdict::kWarning);
  CHECK(checkOf(report, "placement").verdict == CheckVerdict::kWarning);
}

TEST_CASE("a check stops when its progress says so", "[unit]") {
  TeamCheckOptions options;
  options.team = *parseTeam("idle");
  options.quick = true;
  options.clock = FakeClock().reader();
  options.progress = [](std::size_t done, std::size_t) { return done < 2; };
  const auto report = checkTeam(options);
  REQUIRE_FALSE(report);
  CHECK(report.error().code == ErrorCode::kInterrupted);
}

}  // namespace fulbito
