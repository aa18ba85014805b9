#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "bridge/wire/command_board.hpp"
#include "bridge/wire/messages.hpp"

/// Feeds anything to the readers of the league's datagrams, and what they make of it to the commands in
/// force. The first byte says which reader.
namespace fulbito::wire {
namespace {

[[noreturn]] void flaw(const char* what) {
  std::fprintf(stderr, "%s\n", what);
  std::abort();
}

/// What is read can be written and read again.
template <typename Message>
void readTwice(Result<Message> (*read)(std::string_view), std::string_view bytes) {
  const auto message = read(bytes);
  if (!message && message.error().message.empty()) flaw("a datagram is refused without a reason");
  if (!message) return;
  const std::string written = datagramOf(*message);
  if (written.size() <= kLongestMessage && !read(written)) flaw("a message that was read is written wrongly");
}

void command(std::string_view bytes) {
  const auto packet = readPacket(bytes);
  if (!packet) return;
  constexpr int kTeamSize = 5;
  CommandBoard board(kTeamSize, bytes.size() % 2 == 0);
  OddityLog oddities([] { return std::int64_t{0}; }, {});
  board.take(*packet, 1, oddities);
  board.beginFrame();
  board.take(*packet, 2, oddities);
  for (const TeamId team : kTeams) {
    for (std::size_t i = 0; i < kMaxTeamSize; ++i) {
      const WheelSpeeds wheels = board.wheels(team, i);
      if (!std::isfinite(wheels.left) || !std::isfinite(wheels.right)) flaw("a command is not finite");
      if (i >= kTeamSize && (wheels.left != 0.0 || wheels.right != 0.0)) flaw("an unknown robot is driven");
    }
  }
}

}  // namespace
}  // namespace fulbito::wire

// NOLINTNEXTLINE(readability-identifier-naming): the name that libFuzzer calls
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace fulbito::wire;
  if (size == 0) return 0;
  const std::string_view bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
  constexpr int kReaders = 4;
  switch (data[0] % kReaders) {
    case 0:
      readTwice(readPacket, bytes);
      command(bytes);
      break;
    case 1:
      readTwice(readVision, bytes);
      break;
    case 2:
      readTwice(readRefereeCommand, bytes);
      break;
    default:
      readTwice(readTeamPlaces, bytes);
  }
  return 0;
}
