#include "trials/trial_recorder.hpp"

#include "fulbito/experiment.hpp"
#include "fulbito/recording.hpp"
#include "tests/support/catch.hpp"

namespace fulbito {
namespace {

TrialConfig movingTrial(const std::string& navigator) {
  TrialConfig config;
  config.layout = (*findSuite("moving"))->layout(2015, 3);
  config.field = *loadField(config.layout.field);
  config.robot = *loadRobot("jung-lee-2015");
  config.physics = *loadPhysics("standard");
  config.navigator = *parseNavigator(navigator);
  config.sensors.position_noise = 0.002;
  config.index = 3;
  return config;
}

}  // namespace

TEST_CASE("a recorded trial holds what happened, and recording changes nothing", "[unit]") {
  const TrialConfig config = movingTrial("limit-cycle");
  std::string bytes;
  auto recorder = TrialRecorder::create(
      [&bytes](std::string_view more) -> Result<void> {
        bytes.append(more);
        return {};
      },
      config);
  REQUIRE(recorder);
  const auto watched = runTrial(config, nullptr, &*recorder), alone = runTrial(config, nullptr);
  REQUIRE(watched);
  CHECK(watched->final_hash == alone->final_hash);
  const auto reader = RecordingReader::parse(bytes, "trial");
  REQUIRE(reader);
  CHECK(reader->finished());
  CHECK(reader->header().kind == RecordingKind::kTrial);
  CHECK(reader->header().bodies.size() == 1 + config.layout.obstacles.size());
  CHECK(reader->header().recipe.navigator == config.navigator.text);
  CHECK(reader->header().recipe.vision.at(0).position_noise == 0.002);
  CHECK(reader->ticks() + 1 == static_cast<Tick>(watched->trace.size()));
  CHECK(reader->result()->final_hash == watched->final_hash);
  CHECK(reader->result()->outcome == nameOf(watched->score.outcome));
  std::size_t row = 0;
  for (std::size_t i = 0; i < reader->chunkCount(); ++i) {
    const auto chunk = reader->chunk(i);
    REQUIRE(chunk);
    for (const WheelSpeeds& command : chunk->commands) {
      ++row;
      REQUIRE(command.left == watched->trace[row].command.left);
      REQUIRE(command.right == watched->trace[row].command.right);
    }
  }
}

TEST_CASE("a recording that cannot be written fails the trial", "[unit]") {
  const TrialConfig config = movingTrial("straight");
  CHECK(TrialRecorder::create("/nonexistent-folder/x.fbr", config).error().code == ErrorCode::kIo);
  int writes = 0;
  auto recorder = TrialRecorder::create(
      [&writes](std::string_view) -> Result<void> {
        if (++writes > 2) return fail(ErrorCode::kIo, "disk full");
        return {};
      },
      config);
  REQUIRE(recorder);
  const auto result = runTrial(config, nullptr, &*recorder);
  REQUIRE_FALSE(result);
  CHECK(result.error().message == "disk full");
}

}  // namespace fulbito
