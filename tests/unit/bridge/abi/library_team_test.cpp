#include "bridge/abi/library_team.hpp"

#include <fenv.h>
#include <thread>
#include <xmmintrin.h>

#include <fmt/format.h>

#include "navigation/library/mapped_length.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/test_teams.hpp"

namespace fulbito {
namespace {

using namespace fulbito::test;

std::string libraryFile(const std::string& name) { return FULBITO_TEST_LIBRARIES "/" + name + ".so"; }

/// Collects the lines that a team logs.
struct Lines {
  std::string text;
  PluginLog log() {
    return [this](std::string_view line) { text.append(line).append("\n"); };
  }
};

TeamChoice choiceOf(const std::string& library, std::vector<Setting> settings = {}) {
  auto info = loadTeamLibrary(libraryFile(library), [](std::string_view) {});
  REQUIRE(info);
  return {std::make_shared<const TeamInfo>(std::move(*info)), library, std::move(settings), {}};
}

std::unique_ptr<Strategy> teamOf(
    const std::string& library, const std::vector<Setting>& settings = {},
    PluginLog log = [](std::string_view) {}) {
  auto info = loadTeamLibrary(libraryFile(library), std::move(log));
  REQUIRE(info);
  auto team = info->make(settings);
  if (!team) FAIL(team.error().message);
  return std::move(*team);
}

/// A match in which a team may fail this often.
MatchInfo limited(int failures) {
  MatchInfo info;
  info.decision_time = DecisionTime{};
  info.decision_time->failures = failures;
  return info;
}

Observation threeRobots() {
  Observation seen;
  for (std::size_t i = 0; i < 3; ++i) seen.own[i].present = true;
  seen.own[2].state.pose.position = {0.25, 0.5};
  seen.ball.position = {0.125, 0.0};
  return seen;
}

void checkRefused(const std::string& name, ErrorCode code, const std::string& reason) {
  CAPTURE(name);
  const auto info = loadTeamLibrary(libraryFile(name));
  REQUIRE_FALSE(info);
  CAPTURE(info.error().message);
  CHECK(info.error().code == code);
  CHECK(info.error().message.find(libraryFile(name)) != std::string::npos);
  CHECK(info.error().message.find(reason) != std::string::npos);
}

MatchInfo seededInfo(std::uint64_t seed) {
  MatchInfo info;
  info.seed = seed;
  info.robot.curve_widening = 0.25;
  info.robot.curve_widening_rise = 0.5;
  return info;
}

}  // namespace

TEST_CASE("a port of chaser in a shared library plays the built-in chaser's matches", "[unit]") {
  for (std::uint64_t seed : {1u, 2u, 3u}) {
    MatchConfig built_in = shortMatch("chaser", "chaser", 30.0);
    built_in.seed = seed;
    MatchConfig loaded = built_in;
    loaded.teams = {choiceOf("ported_chaser"), choiceOf("ported_chaser")};
    CHECK(hashOf(loaded) == hashOf(built_in));
    CHECK(hashOf(loaded) != 0);
  }
}

TEST_CASE("the loader says which file is wrong, and how", "[unit]") {
  checkRefused("broken_symbol", ErrorCode::kBadInput, "no symbol 'fulbito_library_entry'");
  checkRefused("broken_entry", ErrorCode::kBadInput, "returns null or throws");
  checkRefused("throwing_entry", ErrorCode::kBadInput, "returns null or throws");
  checkRefused("broken_version", ErrorCode::kBadInput,
               "version 77 of the interface; this simulator takes version 1");
  checkRefused("broken_size", ErrorCode::kBadInput, "a table of 40 bytes instead of 96");
  checkRefused("broken_name", ErrorCode::kBadInput, "no name");
  checkRefused("broken_team", ErrorCode::kBadInput, "has no team");
  checkRefused("navigators", ErrorCode::kBadInput, "has no team");
  checkRefused("broken_parameters", ErrorCode::kBadInput, "no parameters, although it counts 1");
  checkRefused("broken_count", ErrorCode::kBadInput, "100000 parameters; 256 are the most");
  checkRefused("broken_range", ErrorCode::kBadInput, "parameter 'gain' has no range");
  checkRefused("broken_default", ErrorCode::kBadInput, "parameter 'gain' has a default outside its range");
  checkRefused("broken_type", ErrorCode::kBadInput, "parameter 'gain' has an unknown type");
  checkRefused("broken_choices", ErrorCode::kBadInput, "parameter 'gain' has no choices");
  checkRefused("broken_parameter_name", ErrorCode::kBadInput, "parameter 'ga=in' has no proper name");
  checkRefused("no-such-file", ErrorCode::kIo, "No such file or directory");
}

TEST_CASE("a file that is no library is refused", "[unit]") {
  const ScratchFolder folder;
  const std::string text = folder.write("text.so", "not a library");
  const auto info = loadTeamLibrary(text);
  REQUIRE_FALSE(info);
  CHECK(info.error().code == ErrorCode::kBadInput);
  CHECK(info.error().message.find("cannot load the library '" + text + "'") == 0);
  const auto of_folder = loadTeamLibrary(folder.path().string());
  REQUIRE_FALSE(of_folder);
  CHECK(of_folder.error().message.find("is no regular file") != std::string::npos);
}

TEST_CASE("a library that was cut is refused, wherever the cut is", "[unit]") {
  const ScratchFolder folder;
  const std::string whole = contentOf(libraryFile("plain_c"));
  // Behind the mapped part there are only debug sections, which a truncated file may lack.
  const std::size_t mapped = mappedLength(libraryFile("plain_c"));
  REQUIRE(loadTeamLibrary(folder.write("mapped.so", whole.substr(0, mapped))));
  for (const std::size_t kept : {std::size_t{100}, std::size_t{1000}, mapped / 2, mapped - 1}) {
    const auto info = loadTeamLibrary(folder.write("cut.so", whole.substr(0, kept)));
    REQUIRE_FALSE(info);
    CHECK(info.error().code == ErrorCode::kBadInput);
    CHECK(info.error().message.find(fmt::format("is cut: it has {} of ", kept)) != std::string::npos);
  }
  const auto header = loadTeamLibrary(folder.write("header.so", whole.substr(0, 30)));
  REQUIRE_FALSE(header);
  CHECK(header.error().message.find("cannot load the library") == 0);
}

TEST_CASE("a team that refuses to be made says why", "[unit]") {
  Lines lines;
  const auto info = loadTeamLibrary(libraryFile("broken_refusal"), lines.log());
  REQUIRE(info);
  const auto team = info->make({});
  REQUIRE_FALSE(team);
  CHECK(team.error().code == ErrorCode::kUsage);
  CHECK(team.error().message ==
        "the team of '" + libraryFile("broken_refusal") + "' refuses to be made: not today");
}

TEST_CASE("a library's entry has its name, summary and parameters", "[unit]") {
  const auto info = loadTeamLibrary(libraryFile("plain_c"));
  REQUIRE(info);
  CHECK(info->name == "plain-c");
  CHECK(info->summary == "a team in C");
  CHECK(info->takes_navigator);
  CHECK(info->default_navigator == "bezier");
  REQUIRE(info->parameters.size() == 4);
  CHECK(info->parameters[0].name == "gain");
  CHECK(info->parameters[0].unit == "1/s");
  CHECK(info->parameters[0].doc == "how strongly it turns");
  CHECK(info->parameters[0].default_value == 2.5);
  CHECK(info->parameters[0].maximum == 10.0);
  CHECK(info->parameters[1].type == ParameterSpec::Type::kInteger);
  CHECK(info->parameters[2].type == ParameterSpec::Type::kFlag);
  CHECK(info->parameters[2].maximum == 1.0);
  CHECK(info->parameters[3].choices == std::vector<std::string>{"calm", "wild"});
}

TEST_CASE("a team in plain C gets its settings and gives commands", "[unit]") {
  Lines lines;
  const auto team = teamOf("plain_c",
                           {{"gain", "0.5"},
                            {"offset", "7"},
                            {"eager", "off"},
                            {"style", "calm"},
                            {"navigator", "bezier:clearance=0.03+follower=classic"}},
                           lines.log());
  team->begin(seededInfo(7));
  CHECK(lines.text == "plain-c: ready\n");
  REQUIRE(team->navigators().size() == 1);
  CHECK(team->navigators()[0].text == "bezier:clearance=0.03,follower=classic");
  CHECK(team->navigators()[0].classic_follower);

  Observation seen = threeRobots();
  TeamCommand command = team->decide(seen);
  CHECK(command.robots[0].wheels.left == 0.5);
  CHECK(command.robots[0].wheels.right == 0.0);
  CHECK(command.robots[1].kind == RobotCommand::Kind::kTwist);
  CHECK(command.robots[1].twist.linear == 0.125);
  CHECK(command.robots[2].go_to.position == Vec2{0.25, 0.5});
  CHECK(command.robots[2].go_to.tolerance == 5.25);
  CHECK(command.roles[0] == 7);
  CHECK(command.drawings.empty());
  seen.wants_drawings = true;
  command = team->decide(seen);
  REQUIRE(command.drawings.size() == 1);
  CHECK(command.drawings[0].text == "here");
}

TEST_CASE("a team in plain C places, does exercises and hears notices", "[unit]") {
  Lines lines;
  const auto team = teamOf("plain_c", {}, lines.log());
  const MatchInfo info = seededInfo(7);
  team->begin(info);
  Observation seen = threeRobots();
  PlacementRequest request;
  request.kind = RestartKind::kGoalKick;
  request.defaults[1] = Pose2{{0.5, 0.0}, 0.0};
  request.delay = 0.75;
  const auto proposal = team->place(request);
  REQUIRE(proposal);
  REQUIRE(proposal->robots[1]);
  CHECK(proposal->robots[1]->position.x == Approx(0.4));
  CHECK_FALSE(proposal->robots[0]);
  CHECK(proposal->ball->y == 0.75);

  Exercise task{Exercise::Kind::kPredictBall, {}, 0.25, 0.0, 2.0};
  seen.ball.velocity = {0.5, 0.0};
  const auto reply = team->exercise(seen, task);
  REQUIRE(reply);
  CHECK(reply->answer.x == Approx(1.125));
  CHECK(reply->answer.y == 0.25);
  CHECK(reply->command.robots[0].wheels.left == info.dt());
  task.kind = Exercise::Kind::kTurn;
  CHECK_FALSE(team->exercise(seen, task));

  GameEvent call;
  call.clause = "goal";
  team->stopped({call, seen});
  team->stopped({call, seen});
  team->ready(seen);
  team->ended({});
  CHECK(lines.text == "plain-c: ready\nplain-c: ended after 0000002 stops\n");
}

TEST_CASE("a team in plain C has the same stream for the same seed, and another for another", "[unit]") {
  const auto team = teamOf("plain_c", {}, [](std::string_view) {});
  const auto drawn = [&](std::uint64_t seed) {
    team->begin(seededInfo(seed));
    return team->decide(threeRobots()).robots[1].twist.angular;
  };
  const double first = drawn(7);
  CHECK(drawn(7) == first);
  CHECK(drawn(8) != first);
}

TEST_CASE("settings of a library are checked as those of built-in teams", "[unit]") {
  const auto info = loadTeamLibrary(libraryFile("plain_c"), [](std::string_view) {});
  REQUIRE(info);
  CHECK(info->make({{"gain", "11"}}).error().message ==
        "parameter 'gain': '11' is not a number from 0 to 10 1/s");
  CHECK(info->make({{"gian", "1"}}).error().message ==
        "'" + libraryFile("plain_c") + "' has no parameter 'gian'. Did you mean 'gain'?");
  CHECK(info->make({{"gain", "10"}}).error().message.find("a gain of 10 is too much") != std::string::npos);
  CHECK(info->make({{"style", "odd"}}).error().code == ErrorCode::kUsage);
  TeamCatalogue catalogue = TeamCatalogue::builtIn();
  REQUIRE(catalogue.add(*info));
  CHECK(catalogue.parse("plain-c:gain=1,navigator=bezier"));
  CHECK_FALSE(catalogue.parse("plain-c:gain=x"));
}

TEST_CASE("a team that asks for an unknown navigator stops the match from starting", "[unit]") {
  MatchConfig config = shortMatch();
  config.teams[0] = choiceOf("plain_c", {{"navigator", "bezir"}});
  const auto match = Match::create(config);
  REQUIRE_FALSE(match);
  CHECK(match.error().message == "blue team: there is no navigator 'bezir'. Did you mean 'bezier'?");
}

TEST_CASE("exceptions of a team are caught, counted and logged", "[unit]") {
  for (const std::string where : {"begin", "decide", "place", "stopped", "ended", "exercise"}) {
    CAPTURE(where);
    Lines lines;
    const auto team = teamOf("throwing", {{"where", where}}, lines.log());
    team->begin(limited(1));
    team->decide(threeRobots());
    team->place({});
    team->stopped({});
    team->exercise({}, {});
    team->ended({});
    CHECK(lines.text == "throwing: exception: out of ideas\n");
    const bool notice = where == "stopped" || where == "ended";
    CHECK(team->condition().failures == (where == "ended" ? 0 : 1));
    if (where == "ended") continue;
    CHECK(team->condition().reason == "throwing: '" + where + "' fails with 1");
    CHECK(team->condition().state == TeamCondition::State::kLost);
    CHECK((notice || team->navigators().empty()));
  }
  Lines lines;
  const auto odd = teamOf("throwing", {{"where", "decide"}, {"odd", "on"}}, lines.log());
  odd->begin(limited(1));
  odd->decide(threeRobots());
  CHECK(lines.text.find("an exception of an unknown type") != std::string::npos);
}

TEST_CASE("after a failed decision a new team starts with the next one", "[unit]") {
  const auto team = teamOf("throwing", {{"where", "decide"}});
  team->begin(limited(3));
  Observation seen = threeRobots();
  CHECK(team->decide(seen).robots[0].wheels.right == 0.0);
  CHECK(team->condition().state == TeamCondition::State::kDown);
  seen.tick = 1;
  CHECK(team->decide(seen).robots[0].wheels.right == 2.0);
  CHECK(team->condition().state == TeamCondition::State::kWell);
  CHECK(team->condition().failures == 1);
}

TEST_CASE("a team that fails too often is asked no more", "[unit]") {
  const auto team = teamOf("broken_decision");
  team->begin(limited(4));
  for (int i = 0; i < 10; ++i) team->decide(threeRobots());
  CHECK(team->condition().state == TeamCondition::State::kLost);
  CHECK(team->condition().failures == 4);
  CHECK(team->condition().reason == "broken: 'decide' fails with 42");
  CHECK_FALSE(team->place({}));
}

TEST_CASE("a team that moves its room for drawings away draws nothing", "[unit]") {
  const auto team = teamOf("broken_drawings");
  team->begin({});
  Observation seen = threeRobots();
  CHECK(team->decide(seen).drawings.empty());
  seen.wants_drawings = true;
  CHECK(team->decide(seen).drawings.size() == kMostDrawings);
}

TEST_CASE("a command of an unknown kind is a fault of the team", "[unit]") {
  MatchConfig config = shortMatch("idle", "idle", 1.0);
  config.teams[0] = choiceOf("broken_kind");
  auto match = Match::create(config);
  REQUIRE(match);
  while (match->step()) {
  }
  CHECK(match->faults().teams[0].not_finite > 0);
  const TeamCommand command = teamOf("broken_kind")->decide(threeRobots());
  CHECK(command.roles[1] == 255);
}

TEST_CASE("no library changes the floating-point mode of the thread", "[unit]") {
  const unsigned before = _mm_getcsr() & 0xffc0u;
  for (const std::string name : {"float_modes", "fast_math"}) {
    CAPTURE(name);
    const auto unchanged = [&] { return (_mm_getcsr() & 0xffc0u) == before && fegetround() == FE_TONEAREST; };
    auto team = teamOf(name);
    CHECK(unchanged());
    team->begin({});
    CHECK(unchanged());
    for (int i = 0; i < 3; ++i) {
      // The call has the simulator's floating-point mode, although the team leaves another one behind.
      CHECK(team->decide(threeRobots()).robots[0].wheels.left == 0x1f80);
      CHECK(unchanged());
    }
    team->place({});
    CHECK(unchanged());
    team.reset();
    CHECK(unchanged());
  }
}

TEST_CASE("a match of a library that changes the mode has the hash of the same commands without", "[unit]") {
  MatchConfig expected = shortMatch("idle", "chaser", 10.0);
  MatchConfig loaded = expected;
  TeamCommand same;
  same.robots[0] = RobotCommand::byWheels({0x1f80, 0.0});
  expected.teams[0] = TestEntry([&](const Observation&) { return same; }).choice();
  for (const std::string name : {"float_modes", "fast_math"}) {
    loaded.teams[0] = choiceOf(name);
    CHECK(hashOf(loaded) == hashOf(expected));
  }
}

TEST_CASE("two libraries with a class of the same name stay apart", "[unit]") {
  const auto a = loadTeamLibrary(libraryFile("same_class_a"));
  const auto b = loadTeamLibrary(libraryFile("same_class_b"));
  REQUIRE(a);
  REQUIRE(b);
  CHECK(a->name == "a");
  CHECK(b->name == "b");
  CHECK(b->parameters[0].name == "b-gain");
  auto first = *a->make({}), second = *b->make({{"b-gain", "0.25"}});
  first->begin({});
  second->begin({});
  CHECK(first->decide(threeRobots()).robots[0].wheels.right == 1.0);
  CHECK(second->decide(threeRobots()).robots[0].wheels.right == 2.0);
  CHECK(second->decide(threeRobots()).robots[0].wheels.left == 0.25);
}

TEST_CASE("a library stays loaded as long as a team of it lives", "[unit]") {
  const auto team = teamOf("ported_chaser");  // the entry is gone by now
  team->begin({});
  CHECK(team->decide(threeRobots()).robots[0].kind == RobotCommand::Kind::kTwist);
}

TEST_CASE("teams of one library play in several threads at once", "[unit]") {
  MatchConfig config = shortMatch("chaser", "chaser", 5.0);
  config.teams = {choiceOf("ported_chaser"), choiceOf("ported_chaser")};
  const std::uint64_t expected = hashOf(config);
  std::array<std::uint64_t, 4> hashes{};
  std::vector<std::thread> threads;
  for (std::uint64_t& hash : hashes) threads.emplace_back([&] { hash = hashOf(config); });
  for (std::thread& thread : threads) thread.join();
  for (std::uint64_t hash : hashes) CHECK(hash == expected);
}

}  // namespace fulbito
