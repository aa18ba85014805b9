#include <cstdlib>

#include "fulbito/recording.hpp"
#include "replays/chunks/block.hpp"
#include "replays/chunks/chunk.hpp"
#include "replays/header/header_json.hpp"
#include "replays/recording_salvage.hpp"

/// Feeds anything to the reader of recordings. The first byte says to which part, as checksums would keep
/// all else from the inner ones.
namespace fulbito {
namespace {

RecordingHeader headerOf(RecordingLevel level, double command_step) {
  RecordingHeader header;
  header.level = level;
  header.chunk_ticks = 40;
  header.control_rate = 10;
  header.sample_every = 3;
  header.command_step = command_step;
  for (std::uint8_t i = 0; i < 4; ++i) header.bodies.push_back({BodyKind::kRobot, RobotId{TeamId::kBlue, i}});
  header.bodies.push_back({BodyKind::kBall, {}});
  header.bodies.push_back({BodyKind::kObstacle, {}});
  return header;
}

void readAll(const RecordingReader& reader) {
  for (std::size_t i = 0; i < reader.chunkCount(); ++i) (void)reader.chunk(i);
  (void)reader.sizeByPart();
}

void feed(unsigned part, std::string bytes) {
  switch (part % 6) {
    case 0: {
      const auto reader = RecordingReader::parse(std::move(bytes), "fuzz", {true});
      if (reader) readAll(*reader);
      return;
    }
    case 1:
      (void)readChunk(bytes, headerOf(RecordingLevel::kFull, 0.01));
      return;
    case 2:
      (void)readChunk(bytes, headerOf(RecordingLevel::kRecipe, 0.0));
      return;
    case 3:
      if (const auto header = headerFromJson(bytes)) (void)toJson(*header);
      return;
    case 4:
      if (const auto result = resultFromJson(bytes)) (void)toJson(*result);
      return;
    default:
      (void)salvage(std::move(bytes), "fuzz");
  }
}

}  // namespace
}  // namespace fulbito

// NOLINTNEXTLINE(readability-identifier-naming): the name that libFuzzer calls
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  fulbito::feed(data[0], std::string(reinterpret_cast<const char*>(data) + 1, size - 1));
  return 0;
}
