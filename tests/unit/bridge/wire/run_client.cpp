// A client of the league for tests: run_client COLOUR PORT_BASE [FRAMES]
// Drives straight on. After so many frames it ends with exit code 3.

#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "bridge/wire/wire_client.hpp"

/// Sanitizers look for leaks by means that the sandbox refuses.
extern "C" const char* __asan_default_options();  // NOLINT(bugprone-reserved-identifier): their name
extern "C" const char* __asan_default_options() {
  return "detect_leaks=0";
}  // NOLINT(bugprone-reserved-identifier)

int main(int argc, char** argv) {
  using namespace fulbito;
  if (argc < 3) return 2;
  const TeamId team = std::string_view(argv[1]) == "yellow" ? TeamId::kYellow : TeamId::kBlue;
  const int most = argc > 3 ? std::atoi(argv[3]) : -1;
  auto wire = wire::WireClient::open("127.0.0.1", std::atoi(argv[2]), "127.0.0.1");
  if (!wire) {
    std::fputs(wire.error().message.c_str(), stderr);
    return 1;
  }
  std::printf("a client of %s at %s\n", argv[1], argv[2]);
  std::fflush(stdout);
  for (int frames = 0; frames != most;) {
    const wire::Heard heard = wire->listen(0.1);
    for (const wire::RefereeCommand& command : heard.commands) {
      if (command.foul < wire::Foul::kStop) wire->send(wire::TeamPlaces{team, {}});
    }
    if (heard.frames.empty()) continue;
    ++frames;
    wire::Packet packet;
    for (std::uint32_t i = 0; i < 3; ++i) packet.commands.push_back({i, team, {4.0, 4.0}});
    wire->send(packet);
  }
  std::fputs("it leaves\n", stderr);
  return 3;
}
