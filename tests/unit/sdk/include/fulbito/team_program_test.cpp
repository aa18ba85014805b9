#include "fulbito/team_program.hpp"

#include <cmath>
#include <fstream>
#include <limits>

#include "bridge/lines/line_codec.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/piped_team.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/unit/bridge/lines/session.hpp"

namespace fulbito {
namespace {

using namespace fulbito::test;
namespace t = fulbito::team;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// A team that keeps the values it gets and gives the answers that a test sets.
class Probe final : public t::Team {
 public:
  Probe() : Team("probe", "3") {
    number("depth", depth, 0.05, 0.3, "m", "of the keeper");
    takesNavigator("bspline-time");
  }
  void begin(const t::Info& info) override { infos.push_back(info); }
  t::Commands decide(const t::Observation& now) override {
    seen.push_back(now);
    return commands;
  }
  std::optional<t::Placement> place(const t::PlacementRequest& request) override {
    requests.push_back(request);
    return wishes;
  }
  void stopped(const t::Stop& stop) override { stops.push_back(stop); }
  void ready(const t::Observation& now) override { readies.push_back(now); }
  void ended(const t::End& end) override { ends.push_back(end); }
  std::optional<t::ExerciseReply> exercise(const t::Observation&, const t::Exercise& task) override {
    tasks.push_back(task);
    return reply;
  }

  double depth = 0.1;
  std::vector<t::Info> infos;
  std::vector<t::Observation> seen, readies;
  std::vector<t::PlacementRequest> requests;
  std::vector<t::Stop> stops;
  std::vector<t::End> ends;
  std::vector<t::Exercise> tasks;
  t::Commands commands;
  std::optional<t::Placement> wishes;
  std::optional<t::ExerciseReply> reply;
};

/// A probe and the conversation that owns it.
struct Talk {
  Talk() : Talk(std::make_unique<Probe>()) {}
  explicit Talk(std::unique_ptr<Probe> team) : probe(team.get()), conversation(std::move(team)) {}

  std::string take(const std::string& line) {
    std::string out;
    conversation.take(line, out);
    return out;
  }
  /// The simulator's reading of the answer to a line.
  TeamReply replyTo(const std::string& line) {
    LineCodec codec;
    TeamReply reply_read;
    const std::string answer = take(line);
    const auto read = codec.read(answer, reply_read);
    INFO(answer << (read ? "" : read.error().message));
    REQUIRE(read);
    return reply_read;
  }
  /// The whole sample session.
  std::vector<std::string> takeSession() {
    LineCodec codec;
    std::vector<std::string> answers;
    std::uint64_t id = 0;
    for (const SessionMessage& message : sessionMessages()) {
      std::string line;
      message.write(codec, message.request ? ++id : 0, line);
      answers.push_back(take(line));
      CHECK(answers.back().empty() == !message.request);
    }
    return answers;
  }

  Probe* probe;
  t::program::Conversation conversation;
};

std::string decideLine() {
  LineCodec codec;
  Observation seen;
  seen.team_size = 5;
  std::string line;
  codec.decide(9, seen, line);
  return line;
}

}  // namespace

TEST_CASE("a C++ program's team answers the greeting of the sample session, with its settings taken",
          "[unit]") {
  Talk talk;
  const Probe& probe = *talk.probe;
  const auto answers = talk.takeSession();
  CHECK(
      answers[0] ==
      "{\"type\":\"hello\",\"id\":1,\"protocol\":\"fulbito-team/1\",\"name\":\"probe\",\"version\":\"3\"}\n");
  CHECK(answers[1] == "{\"type\":\"begin\",\"id\":2,\"navigators\":[\"bezier:clearance=0.03\"]}\n");
  CHECK(probe.depth == 0.125);
}

TEST_CASE("a C++ program's team learns of the sample session's match and restarts", "[unit]") {
  Talk talk;
  const Probe& probe = *talk.probe;
  talk.takeSession();
  REQUIRE(probe.infos.size() == 1);
  const t::Info& info = probe.infos[0];
  CHECK(info.colour == t::Colour::kYellow);
  CHECK_FALSE(info.left);
  CHECK(info.dt == 1.0 / 60.0);
  CHECK(info.seed == 18446744073709551615u);
  CHECK(info.observation_age == 2.0 / 60.0);
  CHECK(info.heading_noise == 0.01);
  CHECK(info.dropout == 0.005);
  REQUIRE(info.decision_time);
  CHECK(info.decision_time->held == 30);

  REQUIRE(probe.requests.size() == 3);
  CHECK(probe.requests[0].ours);
  CHECK(probe.requests[0].cause.clause.empty());
  CHECK_FALSE(probe.requests[0].opponents);
  CHECK(probe.requests[0].defaults[2]->position == t::Vec2{-0.4, 0.3});
  CHECK_FALSE(probe.requests[0].defaults[3]);
  CHECK(probe.requests[1].opponents);
  CHECK(probe.requests[1].cause.clause == "goal");
  CHECK(probe.requests[1].now.own_score == 1);
  CHECK(probe.requests[2].kind == t::Restart::kGoalKick);
  CHECK(probe.requests[2].ball == t::Vec2{-0.6, 0.35});
  REQUIRE(probe.stops.size() == 1);
  CHECK(probe.stops[0].cause.robot == 1);
  CHECK(probe.stops[0].cause.team == t::Colour::kYellow);
  CHECK(probe.readies.size() == 1);
  REQUIRE(probe.ends.size() == 1);
  CHECK(probe.ends[0].winner == t::Colour::kYellow);
  CHECK(probe.ends[0].cause.clause == "full-time");
  CHECK_FALSE(probe.ends[0].cause.robot);
}

TEST_CASE("a C++ program's team sees the sample session's field and tasks", "[unit]") {
  Talk talk;
  const Probe& probe = *talk.probe;
  talk.takeSession();
  REQUIRE(probe.seen.size() == 3);
  const t::Observation& now = probe.seen[2];
  CHECK(now.tick == 90);
  CHECK(now.dt == 1.0 / 60.0);
  CHECK(now.team_size == 3);
  CHECK(now.wants_drawings);
  CHECK(now.own[1].present);
  CHECK(now.own[1].position == t::Vec2{-0.4, -0.2});
  CHECK(now.own[1].angular_velocity == -1.0 / 3.0);
  CHECK(now.own[1].wheels.right == 4.25);
  CHECK(now.sent[1].right == 4.26);
  CHECK_FALSE(now.own[3].present);
  CHECK_FALSE(now.opponents[2].present);
  CHECK(now.opponents[1].heading == -3.141592653589793);
  CHECK(std::signbit(now.ball.velocity.y));
  REQUIRE(probe.tasks.size() == 3);
  CHECK(probe.tasks[0].target == t::Vec2{0.25, -0.125});
  CHECK(probe.tasks[1].kind == t::Exercise::Kind::kPredictBall);
  CHECK(probe.tasks[1].horizon == 0.5);
}

TEST_CASE("what a C++ program's team commands arrives", "[unit]") {
  Talk talk;
  t::Commands& commands = talk.probe->commands;
  commands.wheels(0, 1.5, -2.0);
  commands.twist(1, 0.25, -0.0);
  commands.goTo(2, {{0.1, 0.2}, 1.0, true, 0.5, true, false, false, 0.01, false, 3});
  commands.goTo(3, {{0.3, 0.4}, {}});
  commands.roles = {0, 2, 0, 0, 4};
  commands.line({0, 1}, {2, 3});
  commands.circle({4, 5}, 6);
  commands.circle({kNaN, 5}, 6);
  commands.text({7, 8}, "quoted \"word\"");
  const TeamReply reply = talk.replyTo(decideLine());
  CHECK(reply.id == 9);
  const auto& robots = reply.command.robots;
  CHECK(robots[0].wheels.right == -2.0);
  CHECK(robots[1].kind == RobotCommand::Kind::kTwist);
  CHECK(std::signbit(robots[1].twist.angular));
  const GoTo& far = robots[2].go_to;
  CHECK((far.position == Vec2{0.1, 0.2} && far.heading == 1.0 && far.stop && far.speed_limit == 0.5));
  CHECK((far.avoid_ball && !far.avoid_mates && !far.avoid_opponents && far.tolerance == 0.01));
  CHECK((!far.either_front && far.navigator == 3));
  const GoTo& plain = robots[3].go_to;
  CHECK((!plain.heading && !plain.stop && std::isinf(plain.speed_limit) && plain.avoid_mates));
  CHECK(reply.command.roles[4] == 4);
  REQUIRE(reply.command.drawings.size() == 3);
  CHECK(reply.command.drawings[1].radius == 6.0);
  CHECK(reply.command.drawings[2].text == "quoted \"word\"");
}

TEST_CASE("numbers that are none arrive as such, so that the match counts them", "[unit]") {
  Talk talk;
  t::Commands& commands = talk.probe->commands;
  commands.wheels(0, kNaN, 0.0);
  commands.twist(1, std::numeric_limits<double>::infinity(), 0.0);
  commands.goTo(2, {{0.0, 0.0}, kNaN});
  commands.robots[3].kind = t::Command::Kind::kGoTo;
  commands.robots[3].go_to.speed_limit = kNaN;
  const TeamReply reply = talk.replyTo(decideLine());
  CHECK(std::isnan(reply.command.robots[0].wheels.left));
  CHECK(std::isnan(reply.command.robots[1].twist.linear));
  CHECK(std::isnan(reply.command.robots[2].go_to.position.x));
  CHECK(std::isnan(reply.command.robots[3].go_to.position.x));
}

TEST_CASE("what a C++ program's team wishes and answers in exercises arrives", "[unit]") {
  Talk talk;
  talk.probe->wishes.emplace();
  talk.probe->wishes->robots[1] = t::Pose{{-0.1, 0.2}, 1.0};
  talk.probe->wishes->ball = t::Vec2{-0.6, 0.3};
  talk.probe->reply.emplace();
  talk.probe->reply->commands.wheels(0, 1.0, 2.0);
  talk.probe->reply->answer = {0.5, 0.25};
  const auto answers = talk.takeSession();
  LineCodec codec;
  TeamReply reply;
  REQUIRE(codec.read(answers[2], reply));
  REQUIRE(reply.proposal);
  CHECK_FALSE(reply.proposal->robots[0]);
  CHECK(reply.proposal->robots[1]->heading == 1.0);
  CHECK(reply.proposal->ball == Vec2{-0.6, 0.3});
  REQUIRE(codec.read(answers[11], reply));
  REQUIRE(reply.exercise);
  CHECK(reply.exercise->command.robots[0].wheels.right == 2.0);
  CHECK(reply.exercise->answer == Vec2{0.5, 0.25});
}

TEST_CASE("a C++ program's team refuses settings that it lacks", "[unit]") {
  const auto refused = [](const TeamHello& hello) {
    LineCodec codec;
    TeamReply reply;
    std::string line;
    codec.hello(1, hello, line);
    const auto read = codec.read(Talk().take(line), reply);
    return read ? std::string() : read.error().message;
  };
  CHECK(refused({"f", {{"depth", "0.2"}}}).empty());
  CHECK(refused({"f", {{"speed", "1"}}}) == "the team reports: 'probe' has no parameter 'speed'");
  CHECK(refused({"f", {{"depth", "1"}}}) ==
        "the team reports: parameter 'depth': '1' is not a number from 0.05 to 0.3 m");
  const std::string other =
      Talk().take(R"({"type":"hello","id":1,"protocol":"fulbito-team/2","settings":{}})");
  CHECK(other == "{\"type\":\"hello\",\"id\":1,\"error\":\"this team speaks fulbito-team/1\"}\n");
}

TEST_CASE("a C++ program's team says which message it does not understand", "[unit]") {
  Talk talk;
  CHECK_THROWS_WITH(talk.take("Hello!"), "the simulator's message is not understood: not an object");
  CHECK_THROWS_WITH(talk.take(R"({"type":"decide","id":1,"now":{"own":[{"x":"far"}]}})"),
                    "the simulator's message is not understood: now.own[0].x: not a number");
  CHECK(talk.take(R"({"type":"weather","rain":true})").empty());
}

TEST_CASE("what a C++ program prints is not in the protocol, and an exception ends it with a message",
          "[unit]") {
  const ScratchFolder folder;
  const std::string words = (folder.path() / "stderr").string();
  PipedProgram program({"sh", "-c", "exec " FULBITO_LOUD_PROGRAM " 2>" + words});
  LineCodec codec;
  Observation seen;
  std::string line, answer;
  codec.decide(1, seen, line);
  program.send(line);
  REQUIRE(program.receive(answer));
  TeamReply reply;
  CHECK(codec.read(answer, reply));
  seen.tick = 60;
  line.clear();
  codec.decide(2, seen, line);
  program.send(line);
  answer.clear();
  CHECK_FALSE(program.receive(answer));
  CHECK(program.finish() == 1);
  std::ifstream in(words);
  const std::string said{std::istreambuf_iterator<char>(in), {}};
  for (const char* part : {"made\n", "said by cout\n", "said by printf\n", "said by log\n", "no idea\n"}) {
    CAPTURE(said, part);
    CHECK(said.find(part) != std::string::npos);
  }
}

}  // namespace fulbito
