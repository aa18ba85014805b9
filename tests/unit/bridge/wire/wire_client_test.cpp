#include "bridge/wire/wire_client.hpp"

#include "bridge/wire/wire_settings.hpp"
#include "tests/support/catch.hpp"
#include "tests/unit/bridge/wire/test_client.hpp"

namespace fulbito::wire {
namespace {

/// Waits until the system stamps datagrams as they arrive: for the first sockets that ask for it, it
/// begins a moment later, and stamps at the look until then. @return whether it does
bool awaitStamps(WireListener& listener, UdpSender& referee, UdpSender& vision) {
  constexpr int kTries = 1000;
  for (int i = 0; i < kTries; ++i) {
    if (!referee.send(datagramOf(RefereeCommand{})) || !vision.send(datagramOf(Vision{}))) return false;
    const Heard heard = listener.listen(1.0);
    if (heard.frames.size() == 1 && heard.frames[0].commands == 1) return true;
    waitForAny({}, 0.005);
  }
  return false;
}

}  // namespace

TEST_CASE("a listener that looks late still tells which commands came before which frame", "[unit]") {
  const int port = test::freePortBase();
  auto listener = WireListener::open(port, test::kLoopback);
  auto vision = UdpSender::open({kVisionGroup, port + kVisionOffset}, test::kLoopback);
  auto referee = UdpSender::open({kRefereeGroup, port + kRefereeOffset}, test::kLoopback);
  REQUIRE(listener);
  REQUIRE(vision);
  REQUIRE(referee);
  REQUIRE(awaitStamps(*listener, *referee, *vision));
  RefereeCommand command;
  Vision frame;
  for (const Foul foul : {Foul::kKickOff, Foul::kStop, Foul::kGameOn}) {
    command.foul = foul;
    REQUIRE(referee->send(datagramOf(command)));
    for (int i = 0; i < 2; ++i) {
      frame.step += 16;
      REQUIRE(vision->send(datagramOf(frame)));
    }
  }
  const Heard heard = listener->listen(5.0);
  REQUIRE(heard.commands.size() == 3);
  REQUIRE(heard.frames.size() == 6);
  for (std::size_t i = 0; i < heard.frames.size(); ++i) CHECK(heard.frames[i].commands == i / 2 + 1);
}

}  // namespace fulbito::wire
