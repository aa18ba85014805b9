#include "bridge/wire/wire_settings.hpp"

#include <string>

#include "tests/support/catch.hpp"
#include "tests/unit/bridge/wire/test_client.hpp"

namespace fulbito::wire {

TEST_CASE("a specification of a team of the wire has a colour, maybe ports, maybe settings", "[unit]") {
  const auto plain = parseWire("wire:yellow");
  REQUIRE(plain);
  CHECK(plain->colour == TeamId::kYellow);
  CHECK(plain->settings == WireSettings{});
  const auto full =
      parseWire("wire:blue@20000:interface=127.0.0.1,speed=2.5,lockstep=on,wait=0,lock=true,team_ports=on");
  REQUIRE(full);
  CHECK(full->colour == TeamId::kBlue);
  WireSettings expected;
  expected.port_base = 20000;
  expected.interface = "127.0.0.1";
  expected.speed = 2.5;
  expected.lockstep = true;
  expected.wait = 0.0;
  expected.lock = true;
  expected.team_ports = true;
  CHECK(full->settings == expected);
}

TEST_CASE("a command stands at the end, and a client that is started need not have a colour", "[unit]") {
  const auto runs = [](const char* specification, TeamId colour, const char* command) {
    CAPTURE(specification);
    const auto seat = parseWire(specification);
    REQUIRE(seat);
    CHECK(seat->colour == colour);
    CHECK(seat->run == command);
    return seat->settings;
  };
  CHECK(runs("wire:run=a b", TeamId::kBlue, "a b") == WireSettings{});
  CHECK(runs("wire:yellow:run=a run=3,x:y", TeamId::kYellow, "a run=3,x:y") == WireSettings{});
  CHECK(runs("wire:lockstep=on:run=a", TeamId::kBlue, "a").lockstep);
  CHECK(runs("wire:speed=2,run=a", TeamId::kBlue, "a").speed == 2.0);
  CHECK(runs("wire:yellow@11000:speed=2,run=a", TeamId::kYellow, "a").port_base == 11000);
}

TEST_CASE("the default ports are the league's", "[unit]") {
  CHECK(kDefaultPortBase + kVisionOffset == 10002);
  CHECK(kDefaultPortBase + kRefereeOffset == 10003);
  CHECK(kDefaultPortBase + kPlacementOffset == 10004);
  CHECK(kDefaultPortBase + kCommandOffset == 20011);
  CHECK(kDefaultPortBase + kYellowOffset == 20012);
  CHECK(kDefaultPortBase + kBlueOffset == 20013);
}

TEST_CASE("ports of a test belong to it until it ends, and are not the default ones", "[unit]") {
  const int first = test::freePortBase(), second = test::freePortBase();
  for (const int offset : {kVisionOffset, kPlacementOffset, kCommandOffset, kBlueOffset}) {
    CHECK(first + kVisionOffset != second + offset);
    CHECK(first + kCommandOffset != second + offset);
    CHECK(kDefaultPortBase + kVisionOffset != first + offset);
    CHECK(kDefaultPortBase + kCommandOffset != first + offset);
    // Linux gives ports from here on to sockets that name none.
    CHECK(first + offset < 32'768);
  }
}

TEST_CASE("only specifications that begin with `wire` are of the wire", "[unit]") {
  CHECK(isWire("wire"));
  CHECK(isWire("wire:green"));
  CHECK_FALSE(isWire("wires"));
  CHECK_FALSE(isWire("libero:wire=1"));
}

TEST_CASE("a wrong specification is refused with what is wrong", "[unit]") {
  const std::pair<const char*, const char*> cases[] = {
      {"wire", "'' is neither blue nor yellow"},
      {"wire:green", "'green' is neither blue nor yellow"},
      {"wire:green:run=a", "'green' is neither blue nor yellow"},
      {"wire:yellow:run=", "run= has no command"},
      {"wire:blue@", "'' is no first port, 1 ... 55524"},
      {"wire:blue@0", "'0' is no first port"},
      {"wire:blue@55525", "'55525' is no first port"},
      {"wire:blue@1x", "'1x' is no first port"},
      {"wire:blue:speed", "speed"},
      {"wire:blue:speed=100", "speed"},
      {"wire:blue:sped=1", "speed"},
      {"wire:blue:lockstep=perhaps", "'perhaps' is not true or false"},
  };
  for (const auto& [specification, words] : cases) {
    CAPTURE(specification);
    const auto parsed = parseWire(specification);
    REQUIRE_FALSE(parsed);
    CHECK(parsed.error().code == ErrorCode::kUsage);
    CHECK(parsed.error().message.find(words) != std::string::npos);
  }
}

}  // namespace fulbito::wire
