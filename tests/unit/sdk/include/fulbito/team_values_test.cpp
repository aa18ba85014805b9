#include "bridge/abi/team_values.hpp"

#include <map>
#include <string>
#include <variant>

#include <fmt/format.h>

#include "bridge/lines/line_codec.hpp"
#include "engine/core/config/schemas.hpp"
#include "fulbito/detail/lines/read_values.hpp"
#include "navigation/library/plugin_host.hpp"
#include "referee/rules/rules_schema.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/field_count.hpp"

// Every value reaches a team, both as a shared library and as a program. The tests walk over the members of
// the SDK, so they cover new members too.
namespace fulbito {
namespace {

namespace t = fulbito::team;

/// A value's members by name, as text in which different numbers differ.
using Members = std::map<std::string, std::string>;

/// @{ The text of one member.
template <typename T>
  requires std::is_arithmetic_v<T>
std::string textOf(T value) {
  return fmt::format("{}", value);
}
template <typename T>
  requires std::is_enum_v<T>
std::string textOf(T value) {
  return textOf(static_cast<int>(value));
}
std::string textOf(const std::string& value) { return value; }
std::string textOf(t::Vec2 v) { return fmt::format("{} {}", v.x, v.y); }
std::string textOf(Vec2 v) { return fmt::format("{} {}", v.x, v.y); }
std::string textOf(t::Wheels w) { return fmt::format("{} {}", w.left, w.right); }
std::string textOf(const t::Pose& p) { return textOf(p.position) + " " + textOf(p.heading); }
template <typename T>
  requires requires(T& value) { t::detail::abiOf(value); }
std::string textOf(const T& value);
template <typename T, std::size_t n>
std::string textOf(const std::array<T, n>& list);
template <typename T>
std::string textOf(const std::optional<T>& value) {
  return value ? textOf(*value) : "none";
}
template <typename T, std::size_t n>
std::string textOf(const std::array<T, n>& list) {
  std::string text;
  for (const T& item : list) text += "(" + textOf(item) + ")";
  return text;
}
/// @}

template <typename T>
Members membersOf(T value) {
  Members found;
  decltype(t::detail::abiOf(value)) unused{};
  int nameless = 0;
  t::detail::members(value, unused, [&](std::string_view name, auto& member, auto&&) {
    const std::string key = name.empty() ? fmt::format("#{}", ++nameless) : std::string(name);
    REQUIRE(found.emplace(key, textOf(member)).second);
  });
  if constexpr (std::is_same_v<T, t::Observation>) {
    found["own"] = textOf(value.own), found["opponents"] = textOf(value.opponents);
    found["sent"] = textOf(value.sent);
  }
  return found;
}

template <typename T>
  requires requires(T& value) { t::detail::abiOf(value); }
std::string textOf(const T& value) {
  std::string text;
  for (const auto& [name, member] : membersOf(value)) text += name + "=" + member + "; ";
  return text;
}

/// Sets each key of a configuration table to a value of its own. @return the values by key
class Filler {
 public:
  Members fill(const Schema& schema, const std::string& prefix = "") {
    Members values;
    for (const SchemaKey& key : schema)
      values[prefix + key.key] = std::visit([&](const auto& target) { return set(target); }, key.target);
    return values;
  }

 private:
  double next() { return 100.0 + 0.25 * ++count_; }
  std::string set(double* number) { return textOf(*number = next()); }
  std::string set(int* number) { return textOf(*number = 100 + ++count_); }
  std::string set(bool* flag) { return textOf(*flag = !*flag); }
  std::string set(std::string* text) { return *text = fmt::format("text {}", ++count_); }
  std::string set(const Label& label) { return set(label.text); }
  std::string set(Vec2* point) { return textOf(*point = {next(), next()}); }
  std::string set(std::vector<Vec2>*) { return ""; }
  std::string set(const Angle& angle) { return set(angle.radians); }
  std::string set(const Heading& heading) { return set(heading.radians); }
  std::string set(const OptionalHeading&) { return ""; }
  std::string set(const Choice& choice) {
    choice.set((choice.get() + 1) % static_cast<int>(choice.names.size()));
    return textOf(choice.get());
  }
  int count_ = 0;
};

/// A match in which all numbers differ, and its numbers by table.
struct Numbered {
  Numbered() {
    Filler filler;
    field = filler.fill(schemaOf(info.field));
    robot = filler.fill(schemaOf(info.robot));
    ball = filler.fill(schemaOf(info.ball));
    physics = filler.fill(schemaOf(info.physics));
    for (const RulesTable& table : tablesOf(info.rules))
      rules.merge(filler.fill(table.schema, table.name == "rules" ? "" : table.name + "."));
    info.rules.areas.attackers = info.rules.areas.defenders = info.rules.keeper.holding = true;
    rules["text"] = toToml(info.rules);
    info.team = TeamId::kYellow;
    info.side = Side::kRight;
    info.observation_age = 0.5;
    info.position_noise = 0.25;
    info.heading_noise = 0.125;
    info.dropout = 0.0625;
    info.decision_time = DecisionTime{0.75, 3.0, 12};
    info.seed = 0xfedcba9876543210u;
  }
  MatchInfo info;
  Members field, robot, ball, physics, rules;
};

t::Info throughLibrary(const MatchInfo& match) {
  t::Info info = t::detail::from<t::Info>(abiOf<fulbito_match_info>(match));
  PluginHost host("a test", {});
  host.know(wideningToAbi(match.robot));
  t::detail::takeCurveWidening(*host.table(), info.robot);
  info.rules.text = toToml(match.rules);  // a text of its own in the C interface
  return info;
}

t::Info throughLines(const MatchInfo& match) {
  LineCodec codec;
  std::string line;
  codec.begin(1, match, line);
  json::Reader in(line);
  t::Info info;
  t::program::readObject(in,
                         [&](std::string_view name) { return t::program::readInfoMember(in, name, info); });
  INFO(in.message());
  CHECK(in.ok());
  return info;
}

/// Each member of `got` has the value of the same name in `sent`.
template <typename T>
void checkMembers(const T& got, const Members& sent) {
  for (const auto& [name, value] : membersOf(got)) {
    INFO(name);
    REQUIRE(sent.contains(name));
    CHECK(value == sent.at(name));
  }
}

/// The `now` of a message, as a team of each kind gets it.
template <typename T>
std::pair<Members, Members> bothWays(const std::string& line, std::string_view member,
                                     const auto& structure) {
  T read;
  json::Reader in(line);
  t::program::readObject(in, [&](std::string_view name) {
    if (name == member) return t::program::read(in, read), true;
    if (member.empty()) return t::program::readMember(in, name, read);
    return false;
  });
  INFO(in.message());
  CHECK(in.ok());
  return {membersOf(read), membersOf(t::detail::from<T>(structure))};
}

Observation numberedObservation() {
  Observation seen;
  double next = 0.0;
  const auto number = [&] { return 10.0 + 0.25 * ++next; };
  const auto point = [&] { return Vec2{number(), number()}; };
  for (std::size_t i = 0; i < 5; ++i) {
    seen.own[i] = {i != 1, {{point(), number()}, point(), number(), {number(), number()}}};
    seen.opponents[i] = {i != 2, {{point(), number()}, point(), number(), {}}};
    if (i != 1) seen.sent[i] = {number(), number()};
  }
  seen.tick = 77;
  seen.team_size = 5;
  seen.ball = {point(), point(), {}};
  seen.playing = false;
  seen.restart = RestartKind::kGoalKick;
  seen.restart_is_ours = seen.wants_drawings = true;
  seen.since_restart = number();
  seen.period = 3;
  seen.remaining = number();
  seen.own_score = 41;
  seen.opponent_score = 42;
  seen.shoot_out_lead = -2;
  return seen;
}

GameEvent numberedCall() {
  GameEvent call;
  call.tick = 1001, call.play_time = 1002.5, call.period = 2, call.clause = "goal-kick.attackers";
  call.law = "8.2", call.team = TeamId::kYellow, call.robot = 4, call.place = {1003.5, 1004.5};
  call.value = 1005.5, call.threshold = 1006.5, call.margin = 1007.5;
  return call;
}

}  // namespace

TEST_CASE("every value of a match reaches a team under its name, by both ways", "[unit]") {
  const Numbered sent;
  for (const t::Info& info : {throughLibrary(sent.info), throughLines(sent.info)}) {
    checkMembers(info.field, sent.field);
    checkMembers(info.robot, sent.robot);
    checkMembers(info.ball, sent.ball);
    checkMembers(info.physics, sent.physics);
    checkMembers(info.rules, sent.rules);
    CHECK(membersOf(info.field).size() == sent.field.size());
    CHECK(membersOf(info.ball).size() == sent.ball.size());
    CHECK(membersOf(info.physics).size() == sent.physics.size());
    CHECK(info.colour == t::Colour::kYellow);
    CHECK_FALSE(info.left);
    CHECK(info.dt == sent.info.dt());
    CHECK(info.observation_age == 0.5);
    CHECK(info.position_noise == 0.25);
    CHECK(info.heading_noise == 0.125);
    CHECK(info.dropout == 0.0625);
    REQUIRE(info.decision_time);
    CHECK(info.decision_time->decision == 0.75);
    CHECK(info.decision_time->bank == 3.0);
    CHECK(info.decision_time->held == 12);
    CHECK(info.seed == 0xfedcba9876543210u);
  }
}

TEST_CASE("no member of what a team sees and answers lacks its row in sdk/values/values.toml", "[unit]") {
  // The tables of a match are compared above; shared libraries lack eight keys of a robot. An observation is
  // generated from its rows.
  CHECK(test::fieldCount<MatchInfo>() == 13);
  CHECK(test::fieldCount<RobotState>() == 4);
  CHECK(test::fieldCount<PlacementRequest>() == 8);
  CHECK(test::fieldCount<GameEvent>() == 11);
  CHECK(test::fieldCount<MatchEnd>() == 6);
  CHECK(test::fieldCount<Exercise>() == 5);
  CHECK(test::fieldCount<GoTo>() == 10);
}

TEST_CASE("limits that are switched off reach a team as none, by both ways", "[unit]") {
  MatchInfo match;
  match.rules.areas.attackers = match.rules.areas.defenders = match.rules.keeper.holding = false;
  for (const t::Info& info : {throughLibrary(match), throughLines(match)}) {
    CHECK(info.rules.attackers_max == -1);
    CHECK(info.rules.big_attackers_max == -1);
    CHECK(info.rules.defenders_max == -1);
    CHECK(info.rules.big_defenders_max == -1);
    CHECK(info.rules.keeper_hold_seconds == 0.0);
    CHECK_FALSE(info.decision_time);
  }
}

TEST_CASE("observations, requests and notices reach a team alike by both ways", "[unit]") {
  LineCodec codec;
  const auto same = [](const std::pair<Members, Members>& ways) { CHECK(ways.first == ways.second); };
  std::string line;
  const Observation seen = numberedObservation();
  codec.ready(seen, line);
  auto observation = abiOf<fulbito_observation>(seen);
  observation.dt = t::Observation{}.dt;  // a program has it from `begin`
  same(bothWays<t::Observation>(line, "now", observation));

  PlacementRequest request;
  request.kind = RestartKind::kPenalty;
  request.ours = true;
  request.ball = {0.5, 0.75};
  request.defaults[0] = Pose2{{1.5, 1.75}, 2.0};
  request.defaults[4] = Pose2{{2.5, 2.75}, 3.0};
  request.cause = numberedCall();
  request.delay = 3.5;
  request.now = seen;
  for (const bool known : {false, true}) {
    if (known) request.opponents = TeamPlacement{Pose2{{4.5, 4.75}, 1.0}};
    codec.place(1, request, line = {});
    auto structure = abiOf<fulbito_placement_request>(request);
    structure.now.dt = observation.dt;
    same(bothWays<t::PlacementRequest>(line, "", structure));
  }

  const MatchEnd end{MatchEnd::Reason::kInterrupted, numberedCall(), 1234, 5, 6, TeamId::kYellow};
  codec.ended(end, line = {});
  same(bothWays<t::End>(line, "", abiOf<fulbito_end>(end)));
  codec.ended(MatchEnd{}, line = {});
  same(bothWays<t::End>(line, "", abiOf<fulbito_end>(MatchEnd{})));

  const Exercise exercise{Exercise::Kind::kPush, {1.5, 2.5}, 3.5, 4.5, 5.5};
  codec.exercise(1, seen, exercise, line = {});
  same(bothWays<t::Exercise>(line, "exercise", abiOf<fulbito_exercise>(exercise)));
}

TEST_CASE("what a team learns in a tick is what the match knows", "[unit]") {
  const Observation seen = numberedObservation();
  const auto got = t::detail::from<t::Observation>(abiOf<fulbito_observation>(seen));
  const Members members = membersOf(got);
  CHECK(members.at("tick") == "77");
  CHECK(members.at("period") == "3");
  CHECK(got.remaining == seen.remaining);
  CHECK(got.since_restart == seen.since_restart);
  CHECK(members.at("restart") == textOf(t::Restart::kGoalKick));
  CHECK((!got.playing && got.restart_is_ours && got.wants_drawings));
  CHECK((got.own_score == 41 && got.opponent_score == 42 && got.shoot_out_lead == -2));
  CHECK(textOf(got.ball.position) == textOf(seen.ball.position));
  CHECK(textOf(got.ball.velocity) == textOf(seen.ball.velocity));
  CHECK_FALSE(got.own[1].present);
  CHECK(textOf(got.own[1].position) == "0 0");
  CHECK_FALSE(got.opponents[2].present);
  const RobotState& robot = seen.own[4].state;
  CHECK(textOf(got.own[4].position) == textOf(robot.pose.position));
  CHECK(got.own[4].heading == robot.pose.heading);
  CHECK(textOf(got.own[4].velocity) == textOf(robot.velocity));
  CHECK(got.own[4].angular_velocity == robot.angular_velocity);
  CHECK(got.own[4].wheels.right == robot.wheels.right);
  CHECK(got.sent[4].left == seen.sent[4].left);
  const auto call = membersOf(t::detail::from<t::Call>(abiOf<fulbito_call>(numberedCall())));
  CHECK(call == Members{{"clause", "goal-kick.attackers"},
                        {"law", "8.2"},
                        {"team", "1"},
                        {"robot", "4"},
                        {"x", "1003.5"},
                        {"y", "1004.5"},
                        {"tick", "1001"},
                        {"period", "2"},
                        {"play_time", "1002.5"},
                        {"value", "1005.5"},
                        {"threshold", "1006.5"},
                        {"margin", "1007.5"}});
}

}  // namespace fulbito
