#include "apps/league/told_recording.hpp"

#include "bridge/wire/wire_client.hpp"
#include "replays/verify/diff.hpp"
#include "tests/support/test_recordings.hpp"
#include "tests/unit/apps/league/heard.hpp"
#include "tests/unit/bridge/wire/test_client.hpp"

namespace fulbito {
namespace {

using namespace fulbito::test;
using wire::Foul;
using wire::Half;

ToldRecording told(const RecordingReader& reader) {
  auto read = ToldRecording::read(reader);
  INFO((read ? std::string() : read.error().message));
  REQUIRE(read);
  return std::move(*read);
}

/// A match with all that a server may do: gaps, an absent robot, goals, restarts, halves.
RecordingReader eventfulMatch() {
  HeardMatch match;
  auto kick_off = command(Foul::kKickOff);
  kick_off.team = TeamId::kBlue;
  match.recorder.take(kick_off);
  match.see(16, 160);
  match.recorder.take(command(Foul::kStop));
  match.see(176, 320);
  match.recorder.take(command(Foul::kGameOn));
  match.see(16 * 21, 16 * 60);
  match.see(16 * 65, 16 * 80);
  for (std::uint32_t i = 81; i <= 100; ++i) {
    wire::Vision vision = visionAt(16 * i);
    vision.goals = {0, 1};
    vision.robots[0].pop_back();
    CHECK(match.see(vision));
  }
  match.recorder.take(command(Foul::kPenaltyKick, Half::kOvertimeFirst));
  match.recorder.take(command(Foul::kStop, Half::kOvertimeFirst));
  for (std::uint32_t i = 101; i <= 130; ++i) {
    wire::Vision vision = visionAt(16 * i);
    vision.goals = {0, 1};
    CHECK(match.see(vision));
  }
  match.recorder.take(command(Foul::kHalt, Half::kOvertimeSecond));
  return match.finish();
}

/// Lets a recorder hear all that a recording tells.
RecordingReader heardAgain(const ToldRecording& from) {
  HeardMatch match;
  auto next = from.commands().begin();
  for (Tick tick = 1; tick <= from.ticks() + 1; ++tick) {
    for (; next != from.commands().end() && next->frame <= tick; ++next) match.recorder.take(next->command);
    if (tick > from.ticks()) break;
    auto vision = from.frame(tick);
    if (!vision) continue;
    vision->step = static_cast<std::uint32_t>(tick) * 16;
    const auto read = wire::readVision(datagramOf(*vision));
    REQUIRE(read);
    CHECK(match.see(*read));
  }
  return match.finish();
}

void checkSame(const RecordingReader& a, const RecordingReader& b) {
  const auto found = diff(a, b);
  REQUIRE(found);
  CHECK(found->same());
  const ReplayTimeline ta = timelineOf(a), tb = timelineOf(b);
  CHECK(clausesOf(ta) == clausesOf(tb));
  for (std::size_t i = 0; i < std::min(ta.events().size(), tb.events().size()); ++i) {
    INFO(ta.events()[i].clause);
    CHECK(ta.events()[i].tick == tb.events()[i].tick);
    CHECK(ta.events()[i].value == tb.events()[i].value);
    CHECK(ta.events()[i].team == tb.events()[i].team);
    CHECK(ta.events()[i].period == tb.events()[i].period);
    CHECK(ta.events()[i].play_time == tb.events()[i].play_time);
  }
}

}  // namespace

TEST_CASE("what was heard and is told again is heard the same", "[unit]") {
  const RecordingReader first = eventfulMatch();
  const ToldRecording from = told(first);
  CHECK(from.ticks() == 130);
  CHECK_FALSE(from.frame(62));
  CHECK(from.frame(81)->goals == PerTeam<std::uint32_t>{0, 1});
  CHECK(from.frame(90)->robots[0].size() == 2);
  CHECK(from.commands().back().command.half == Half::kOvertimeSecond);
  CHECK(from.frame(50)->ball.velocity.x == Approx(0.3 * 0.96).margin(1e-3));
  checkSame(first, heardAgain(from));
}

TEST_CASE("a recorded match is told exactly, with what its referee said", "[unit]") {
  struct Worlds : MatchObserver {
    std::vector<WorldState> worlds;
    void onTick(const MatchTick& tick) override { worlds.push_back(*tick.world); }
  } truth;
  MatchConfig config = shortMatch("chaser", "idle", 20.0);
  config.rules.periods.swap_sides = true;
  for (const RecordingLevel level : {RecordingLevel::kFull, RecordingLevel::kRecipe}) {
    truth.worlds.clear();
    const RecordingReader reader = readerOf(recorded(config, level, &truth));
    const ToldRecording from = told(reader);
    CHECK(from.exact());
    REQUIRE(from.ticks() == static_cast<Tick>(truth.worlds.size()));
    for (Tick tick = 1; tick <= from.ticks(); ++tick) {
      const auto vision = from.frame(tick);
      REQUIRE(vision);
      const WorldState& world = truth.worlds[static_cast<std::size_t>(tick - 1)];
      const double turn = tick <= from.ticks() / 2 - 300 ? 1.0 : tick > from.ticks() / 2 + 300 ? -1.0 : 0.0;
      if (turn == 0.0) continue;
      CHECK(vision->ball.position == world.balls[0].position * turn);
      CHECK(vision->ball.velocity == world.balls[0].velocity * turn);
      CHECK(vision->robots[0][1].state.pose.position == world.robots[1].pose.position * turn);
    }
    REQUIRE(from.commands().size() >= 4);
    CHECK(from.commands()[0].command.foul == Foul::kKickOff);
    CHECK(from.commands()[0].command.team.has_value());
    CHECK(from.commands()[1].command.foul == Foul::kStop);
    CHECK(from.commands()[1].frame == 1);
    CHECK(from.commands()[2].command.foul == Foul::kGameOn);
    CHECK(from.commands().back().command.foul == Foul::kHalt);
    CHECK(from.commands().back().frame == from.ticks() + 1);
    const ReplayTimeline again = timelineOf(heardAgain(from));
    CHECK(again.at(again.seconds()).score == reader.result()->score);
    CHECK(again.at(again.seconds()).period == 2);
  }
}

TEST_CASE("over sockets a listener hears what is told", "[unit]") {
  const int port = wire::test::freePortBase();
  auto listener = wire::WireListener::open(port, wire::test::kLoopback);
  REQUIRE(listener);
  auto vision =
      wire::UdpSender::open({wire::kVisionGroup, port + wire::kVisionOffset}, wire::test::kLoopback);
  auto referee =
      wire::UdpSender::open({wire::kRefereeGroup, port + wire::kRefereeOffset}, wire::test::kLoopback);
  REQUIRE(vision);
  REQUIRE(referee);
  const RecordingReader first = eventfulMatch();
  const ToldRecording from = told(first);
  HeardMatch match;
  CHECK(vision->send("no message"));
  const auto hear = [&] {
    const wire::Heard heard = listener->listen(5.0);
    for (const wire::RefereeCommand& said : heard.commands) match.recorder.take(said);
    for (const wire::HeardFrame& frame : heard.frames) CHECK(match.see(frame.vision, frame.sender));
    return heard;
  };
  CHECK(hear().malformed == 1);
  auto next = from.commands().begin();
  for (Tick tick = 1; tick <= from.ticks() + 1; ++tick) {
    for (; next != from.commands().end() && next->frame <= tick; ++next) {
      CHECK(referee->send(datagramOf(next->command)));
      hear();
    }
    if (tick > from.ticks()) break;
    auto frame = from.frame(tick);
    if (!frame) continue;
    frame->step = static_cast<std::uint32_t>(tick) * 16;
    CHECK(vision->send(datagramOf(*frame)));
    CHECK(hear().frames.size() == 1);
  }
  checkSame(first, match.finish());
}

TEST_CASE("a trial has no vision", "[unit]") {
  RecordingHeader header;
  header.kind = RecordingKind::kTrial;
  header.bodies = {{BodyKind::kRobot, {}}, {BodyKind::kBall, {}}};
  std::string bytes;
  auto writer = RecordingWriter::create(into(bytes), header);
  REQUIRE(writer);
  REQUIRE(writer->finish({}));
  const auto read = ToldRecording::read(readerOf(bytes));
  REQUIRE_FALSE(read);
  CHECK(read.error().code == ErrorCode::kBadInput);
}

}  // namespace fulbito
