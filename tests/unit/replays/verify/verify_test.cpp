#include "replays/verify/verify.hpp"

#include "fulbito/detail/state_hash.hpp"
#include "replays/verify/resimulate.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/test_recordings.hpp"

namespace fulbito {
namespace {

using namespace fulbito::test;

/// Simulates a recording again and writes it with changes.
class Forger final : public ReplayVisitor {
 public:
  using Change = std::function<void(Tick, RecordingTick&, WorldState&, std::vector<WheelSpeeds>&)>;

  Forger(const RecordingHeader& header, std::string& bytes, Change change)
      : writer_(*RecordingWriter::create(into(bytes), header)), change_(std::move(change)) {}
  bool playBegins(const ReplayedPlay& play) override {
    writer_.beginPlay(*play.recorded);
    return true;
  }
  bool ticked(const ReplayedTick& tick) override {
    WorldState world = tick.world->state();
    std::vector<WheelSpeeds> commands(tick.commands.begin(), tick.commands.end());
    RecordingTick forged{&world, commands, tick.hash, true};
    change_(tick.tick, forged, world, commands);
    forged.commands = commands;
    writer_.add(forged);
    last_ = forged.hash;
    return true;
  }
  void finish() {
    RecordingResult result;
    result.final_hash = last_;
    REQUIRE(writer_.finish(result));
  }

 private:
  RecordingWriter writer_;
  Change change_;
  std::uint64_t last_ = 0;
};

std::string forged(const RecordingReader& original, const Forger::Change& change,
                   const RecordingHeader* header = nullptr) {
  std::string bytes;
  Forger forger(header != nullptr ? *header : original.header(), bytes, change);
  REQUIRE(resimulate(original, forger));
  forger.finish();
  return bytes;
}

/// A team whose robots drive slowly, and stay far from each other if they start in two columns.
const TestEntry& slowTeam() {
  static const TestEntry slow([](const Observation&) { return allWheels({3.0, 3.5}); });
  return slow;
}

void unchanged(Tick, RecordingTick&, WorldState&, std::vector<WheelSpeeds>&) {}

/// One that stands, one that the robot pushes, and one that moves.
Layout threeObstacles() {
  Layout layout;
  layout.start = {{-0.6, 0.0}, 0.3};
  layout.goal = {0.5, 0.1};
  ObstacleSpec still, pushed, moving;
  still.pose = {{0.2, -0.3}, 0.0};
  pushed.motion = ObstacleMotion::kPushable;
  pushed.pose = {{-0.3, 0.02}, 0.0};
  moving.motion = ObstacleMotion::kPath;
  moving.path = {{0.0, 0.3}, {0.2, 0.3}};
  moving.pose.position = moving.path.front();
  layout.obstacles = {still, pushed, moving};
  return layout;
}

RecordingHeader trialHeader(const Layout& layout, const RobotPreset& robot, const PhysicsProfile& physics,
                            const FieldGeometry& field) {
  RecordingHeader header;
  header.kind = RecordingKind::kTrial;
  header.bodies = {{BodyKind::kRobot, {}}};
  header.bodies.resize(1 + layout.obstacles.size(), {BodyKind::kObstacle, {}});
  header.recipe.navigator = "bezier:clearance=0.03";
  header.recipe.layout = toToml(layout);
  header.recipe.physics = toToml(physics);
  header.recipe.robot = toToml(robot);
  header.recipe.field = toToml(field);
  return header;
}

}  // namespace

TEST_CASE("a recorded match verifies, bit for bit, at both levels", "[unit]") {
  const MatchConfig config = shortMatch("chaser", "chaser", 40.0);
  for (const RecordingLevel level : {RecordingLevel::kFull, RecordingLevel::kRecipe}) {
    const RecordingReader reader = readerOf(recorded(config, level));
    const auto verification = verify(reader);
    REQUIRE(verification);
    CHECK(verification->same());
    CHECK(verification->same_build);
    CHECK(verification->finished);
    CHECK(verification->ticks == reader.ticks());
    CHECK(verification->plays > 1);
    CHECK(verification->final_hash == reader.result()->final_hash);
  }
}

TEST_CASE("matches of other physics and with unrounded commands verify too", "[unit]") {
  MatchConfig config = shortMatch("chaser", "chaser", 20.0);
  config.physics.control_rate = 100;
  config.physics.substeps = 1;
  const auto coarse = verify(readerOf(recorded(config)));
  REQUIRE(coarse);
  CHECK(coarse->same());
  config.physics.wheel_command_step = 0.0;
  const auto exact = verify(readerOf(recorded(config)));
  REQUIRE(exact);
  CHECK(exact->same());
}

TEST_CASE("a forged command is found at its tick, with the robot", "[unit]") {
  MatchConfig config = shortMatch("chaser", "chaser", 4.0);
  config.teams = {slowTeam().choice(), slowTeam().choice()};
  config.start = twoColumns();
  const RecordingReader reader = readerOf(recorded(config));
  REQUIRE(verify(readerOf(forged(reader, unchanged)))->same());
  const auto verification =
      verify(readerOf(forged(reader, [](Tick tick, RecordingTick&, WorldState&, auto& commands) {
        if (tick == 102) commands[4] = {-commands[4].left - 1.0, 3.0};
      })));
  REQUIRE(verification);
  REQUIRE_FALSE(verification->same());
  CHECK(verification->divergence->tick == 102);
  REQUIRE(verification->divergence->body == 4u);
  CHECK(verification->divergence->body_name == "yellow 1");
  CHECK(verification->divergence->body_tick <= 120);
  CAPTURE(verification->divergence->text);
  CHECK(verification->divergence->text.find("differs from tick 102 on") == 0);
  CHECK(verification->divergence->text.find("yellow 1") != std::string::npos);
}

TEST_CASE("without samples the hashes of a second name the body", "[unit]") {
  MatchConfig config = shortMatch("chaser", "chaser", 2.0);
  config.teams = {slowTeam().choice(), slowTeam().choice()};
  config.start = twoColumns();
  const RecordingReader reader = readerOf(recorded(config, RecordingLevel::kRecipe));
  const auto verification =
      verify(readerOf(forged(reader, [](Tick tick, RecordingTick&, WorldState&, auto& commands) {
        if (tick == 57) commands[2] = {-commands[2].left - 1.0, 3.0};
      })));
  REQUIRE(verification);
  REQUIRE_FALSE(verification->same());
  CHECK(verification->divergence->tick == 57);
  CHECK(verification->divergence->body_tick == 60);
  CHECK(verification->divergence->body_name == "blue 2");
  CHECK(verification->divergence->bodies == 1);
  CHECK(verification->divergence->field == "place");
}

TEST_CASE("the hashes of a second alone tell that a body is another", "[unit]") {
  const RecordingReader reader = readerOf(recorded(shortMatch("chaser", "chaser", 4.0)));
  const auto verification = verify(readerOf(forged(reader, [](Tick tick, auto&, WorldState& world, auto&) {
    if (tick == 120) world.robots[1].wheels.left += 1e-12;
  })));
  REQUIRE(verification);
  REQUIRE_FALSE(verification->same());
  CHECK(verification->divergence->tick == 120);
  CHECK(verification->divergence->body_name == "blue 1");
  CHECK(verification->divergence->bodies == 1);
  CHECK(verification->divergence->field == "motion");
}

TEST_CASE("a sampled state that was moved is named with its coordinate", "[unit]") {
  const RecordingReader reader = readerOf(recorded(shortMatch("chaser", "chaser", 20.0)));
  const auto verification =
      verify(readerOf(forged(reader, [](Tick tick, RecordingTick& forged_tick, WorldState& world, auto&) {
        if (tick != 300) return;
        world.balls[0].position.y += 0.01;
        forged_tick.hash ^= 1;
      })));
  REQUIRE(verification);
  REQUIRE_FALSE(verification->same());
  CHECK(verification->divergence->tick == 300);
  CHECK(verification->divergence->body_name == "ball");
  CHECK(verification->divergence->field == "y");
  CHECK(verification->divergence->recorded - verification->divergence->replayed == Approx(0.01).margin(3e-4));
}

TEST_CASE("another recipe than the recorded one is noticed", "[unit]") {
  MatchConfig config = shortMatch("chaser", "chaser", 10.0);
  config.rules.restart.delay = 0.0;  // otherwise nothing moves before the signal, whatever the recipe says
  const RecordingReader reader = readerOf(recorded(config));
  RecordingHeader header = reader.header();
  RobotPreset robot = *parseRobot(header.recipe.robot, "robot");
  robot.robot.wheel_acceleration *= 1.001;
  header.recipe.robot = toToml(robot);
  const auto verification = verify(readerOf(forged(reader, unchanged, &header)));
  REQUIRE(verification);
  REQUIRE_FALSE(verification->same());
  CHECK(verification->divergence->tick <= 2);
  header.recipe.robot = "[robot]\nmass = -1\n";
  const auto impossible = verify(readerOf(forged(reader, unchanged, &header)));
  REQUIRE_FALSE(impossible);
  CHECK(impossible.error().code == ErrorCode::kBadInput);
}

TEST_CASE("a cut recording verifies as far as it goes", "[unit]") {
  const std::string bytes = recorded(shortMatch("chaser", "chaser", 20.0));
  const ScratchFolder folder;
  const std::string file = folder.write("cut.fbr", bytes.substr(0, bytes.size() / 2));
  const auto verification = verifyRecording(file);
  REQUIRE(verification);
  CHECK(verification->same());
  CHECK_FALSE(verification->finished);
  CHECK(verification->ticks > 300);
  CHECK(verifyRecording(file + "x").error().code == ErrorCode::kIo);
}

TEST_CASE("a navigation trial is recorded and verified by the same means", "[unit]") {
  const Layout layout = threeObstacles();
  const RobotPreset robot = *loadRobot("vsss");
  const PhysicsProfile physics = *loadPhysics("standard");
  const FieldGeometry field = *loadField("vsss-3v3");

  const RecordingHeader header = trialHeader(layout, robot, physics, field);

  std::string bytes;
  auto writer = RecordingWriter::create(into(bytes), header);
  REQUIRE(writer);
  RecordedPlay play;
  play.starts.push_back({true, layout.start, {}, 0.0, {}});
  for (const ObstacleSpec& obstacle : layout.obstacles)
    play.starts.push_back({true, obstacle.pose, {}, 0.0, {}});
  writer->beginPlay(play);
  WorldConfig config{field, physics, {{robot.robot, layout.start, {}, 0.0}}, {}, layout.obstacles};
  auto world = World::create(config);
  REQUIRE(world);
  StateHash hash;
  for (int tick = 0; tick < 400; ++tick) {
    const WheelSpeeds command =
        roundedTo({20.0 + 0.01 * tick, 18.0 + 0.023 * tick}, physics.wheel_command_step);
    world->step({&command, 1});
    hash.add(world->state());
    writer->add(RecordingTick{&world->state(), {&command, 1}, hash.value(), true});
  }
  RecordingResult result;
  result.outcome = "collided";
  result.final_hash = hash.value();
  result.figures = {{"time", 400.0 / 60.0}};
  REQUIRE(writer->finish(result));

  const RecordingReader reader = readerOf(bytes);
  CHECK(reader.header().recipe.navigator == header.recipe.navigator);
  CHECK(reader.result()->outcome == "collided");
  CHECK(bodyName(reader.header(), 0) == "robot");
  CHECK(bodyName(reader.header(), 3) == "obstacle 2");
  const auto verification = verify(reader);
  REQUIRE(verification);
  CHECK(verification->same());
  CHECK(verification->ticks == 400);
  // The robot has pushed the obstacle, so the obstacle's motion has been compared too.
  const auto chunk = reader.chunk(0);
  REQUIRE(chunk);
  const Vec2 pushed = layout.obstacles[1].pose.position;
  CHECK(distance(chunk->samples.back().poses[2].position, pushed) > 0.05);
}

}  // namespace fulbito
