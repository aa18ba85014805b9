#include "tests/cli/sandbox.hpp"
#include "tests/support/free_ports.hpp"

// `fulbito serve` and the sample clients, over real sockets on the loopback interface.
namespace fulbito::test {
namespace {

/// Bash: ports of this test alone in $P, and functions that start the sample clients.
const std::string kClients =
    "P=" + std::to_string(freePortBase()) +
    "\n"
    "cpp() { '" FULBITO_CHASER_CLIENT
    "' $1 --port-base $P --interface 127.0.0.1 & }\n"
    "python() { PYTHONPATH='" FULBITO_CLIENT_MESSAGES "' '" FULBITO_PYTHON "' '" FULBITO_SOURCE_DIR
    "/examples/clients/chaser_client.py' $1 --port-base $P --interface 127.0.0.1 & }\n"
    "serve() { \"$F\" serve --port-base $P --interface 127.0.0.1 \"$@\"; }\n";

Json resultOf(const Output& output) {
  INFO(output.err);
  REQUIRE(output.code == 0);
  return Json::parse(output.out);
}

}  // namespace

TEST_CASE("the sample clients play a whole match unattended, and its recording verifies", "[cli]") {
  const Sandbox box;
  const Output output =
      box.shell(kClients +
                "cpp blue; python yellow\n"
                "serve --lockstep --answer 20 --half-seconds 3 --record game.fbr --json || exit 1\n"
                "wait\n"  // the clients end with the match
                "\"$F\" replay verify game.fbr >verified.txt || exit 2\n");
  const Json result = resultOf(output);
  CHECK(result["score"]["complete"] == true);
  CHECK(result["teams"].dump().find("wire:blue@") != std::string::npos);
  CHECK(contains(output.err, "waiting for a client of "));
  for (const char* team : {"blue", "yellow"}) {
    INFO(result.dump(1));
    CHECK(result["stats"][team]["distance_m"].get<double>() > 0.5);
    CHECK(result["stats"][team]["commands"]["late"] == 0);
  }
}

TEST_CASE("a client plays against a team of ours, in other commands, too", "[cli]") {
  const Sandbox box;
  const Json result = resultOf(
      box.shell(kClients +
                "cpp yellow\n"
                "\"$F\" match libero wire:yellow@$P:interface=127.0.0.1,speed=20 --half-seconds 2 --json\n"
                "code=$?; wait; exit $code\n"));
  CHECK(result["score"]["complete"] == true);
}

TEST_CASE("teams of ours play as clients, and end with the match", "[cli]") {
  const Sandbox box;
  const Json result = resultOf(box.shell(
      kClients +
      "\"$F\" client libero --colour blue --port-base $P --interface 127.0.0.1 --json >blue.json & b=$!\n"
      "\"$F\" client chaser --colour yellow --port-base $P --interface 127.0.0.1 >yellow.txt & y=$!\n"
      "serve --speed 10 --half-seconds 3 --json || exit 1\n"
      "wait $b && wait $y\n"));
  CHECK(result["stats"]["blue"]["distance_m"].get<double>() > 0.2);
  CHECK(result["stats"]["yellow"]["distance_m"].get<double>() > 0.2);
  const Json blue = Json::parse(box.read("blue.json"));
  CHECK(blue["halted"] == true);
  CHECK(blue["play_s"] == Approx(6.0).margin(0.5));
  CHECK(blue["placements"].get<int>() >= 2);
  CHECK(blue["frames"].get<int>() > 100);
  CHECK(blue["malformed"] == 0);
  CHECK(contains(box.read("yellow.txt"), "chaser played yellow for "));
}

TEST_CASE("a team that is started as a client does in lockstep what it does at home", "[cli]") {
  const Sandbox box;
  const auto drilled = [&](const std::string& team) {
    Json report = resultOf(box.shell("\"$F\" drill " + team + " --drill empty-goal --trials 4 --json"));
    report.erase("team");
    return report;
  };
  const Json away = drilled(
      "\"wire:lockstep=on,answer=20:run=$F client libero --latency 0 --robot vsss --colour {colour} "
      "--port-base "
      "{port_base} "
      "--interface 127.0.0.1\"");
  CHECK(away == drilled("libero"));
}

TEST_CASE("the sample clients play in networks of their own, where both can be blue", "[cli]") {
  const Sandbox box;
  const std::string words = " {colour} --port-base {port_base} --interface 127.0.0.1\" ";
  const Json result =
      resultOf(box.shell(
          "mkdir client && cp '" FULBITO_SOURCE_DIR
          "/examples/clients/chaser_client.py' '" FULBITO_CLIENT_MESSAGES "'/*_pb2.py client || exit 1\n"
          "\"$F\" match \"wire:lockstep=on,answer=20:run='" FULBITO_PYTHON "' client/chaser_client.py" +
          words + "\"wire:lockstep=on,answer=20:run='" FULBITO_CHASER_CLIENT "'" + words +
          "--half-seconds 2 --json\n"));
  INFO(result.dump(1));
  CHECK(result["score"]["complete"] == true);
  for (const char* team : {"blue", "yellow"}) {
    CHECK(result["stats"][team]["distance_m"].get<double>() > 0.5);
    CHECK(result["stats"][team]["commands"]["failures"] == 0);
  }
}

TEST_CASE("clients that tournaments start play each other and are ranked", "[cli]") {
  const Sandbox box;
  const std::string client =
      "'" FULBITO_CHASER_CLIENT "' {colour} --port-base {port_base} --interface 127.0.0.1";
  const Output output = box.shell("\"$F\" tournament run \"wire:lockstep=on,answer=20:run=" + client +
                                  "\" \"wire:yellow:lockstep=on,answer=20:run=" + client +
                                  "\" chaser --half-seconds 1 --jobs 2 --json");
  const Json result = resultOf(output);
  INFO(result.dump(1));
  REQUIRE(result["standings"].size() == 3);
  for (const Json& row : result["standings"]) CHECK(row["matches"] == 4);
}

TEST_CASE("a match of clients shows in a window", "[cli]") {
  const Sandbox box;
  const Output output = box.shell(kClients +
                                  "export SDL_VIDEODRIVER=dummy\n"
                                  "cpp yellow\n"
                                  "serve --blue libero --speed 4 --half-seconds 2 --view --frames 20 "
                                  "--screenshot seen.png --json >result.json\n"
                                  "code=$?; kill %1; exit $code\n");
  if (contains(output.err, "FULBITO_VIEW=OFF")) return;
  INFO(output.err);
  CHECK(output.code == 0);
  CHECK(box.read("seen.png").starts_with("\x89PNG"));
  CHECK(Json::parse(box.read("result.json"))["score"]["complete"] == false);
}

TEST_CASE("a client says what keeps it from playing", "[cli]") {
  const Sandbox box;
  box.fails("client libero --host nowhere", 2, "address 'nowhere' is no address such as 127.0.0.1");
  box.fails("client nobody --interface 127.0.0.1", 2, "nobody");
  const Output output =
      box.shell(kClients +
                "\"$F\" client libero --rules vsss-5v5 --port-base $P --interface 127.0.0.1 & c=$!\n"
                "serve --yellow idle --wait 2 --half-seconds 1 --speed 20 >/dev/null\n"
                "wait $c; echo code $?\n");
  CHECK(contains(output.out, "code 2"));
  CHECK(contains(output.err, "that of the rules vsss-5v5 is 2.20 x 1.80 m; choose others with --rules"));
}

TEST_CASE("a client plays a pair of matches, in either seat with its own colour", "[cli]") {
  const Sandbox box;
  const Output output = box.shell(
      kClients +
      "T=\"wire:yellow@$P:interface=127.0.0.1,speed=20\"\n"
      "\"$F\" client chaser --colour yellow --stay --port-base $P --interface 127.0.0.1 >played.txt & c=$!\n"
      "\"$F\" match idle $T -n 1 --jobs 1 --half-seconds 2 --json; code=$?\n"
      "kill $c; wait $c; exit $code\n");
  const Json result = resultOf(output);
  REQUIRE(result["matches"].size() == 2);
  // A forfeit would cost a goal less than none.
  for (const Json& match : result["matches"]) CHECK(match["goals_b"].get<int>() >= 0);
  CHECK(contains(box.read("played.txt"), "chaser played yellow for "));
}

TEST_CASE("a robot that a frame has more than once gets one command", "[cli]") {
  const Sandbox box;
  box.write("server.py", R"(import socket, sys
import simulator_pb2 as sim
port = int(sys.argv[1])
vision = sim.Environment()
vision.field.length, vision.field.width = 1.5, 1.3
for i in range(100):
    vision.frame.robots_blue.add(robot_id=i % 3, x=-0.1 * (i % 3))
ear = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
ear.bind(("127.0.0.1", port + 10009))
ear.settimeout(0.05)
mouth = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
mouth.setsockopt(socket.IPPROTO_IP, socket.IP_MULTICAST_IF, socket.inet_aton("127.0.0.1"))
while True:
    mouth.sendto(vision.SerializeToString(), ("224.0.0.1", port))
    try:
        packet = sim.Packet.FromString(ear.recv(65536))
    except TimeoutError:
        continue
    print([command.id for command in packet.cmd.robot_commands])
    break
)");
  const Output output =
      box.shell(kClients +
                "\"$F\" client chaser --port-base $P --interface 127.0.0.1 --patience 0.2 >/dev/null & c=$!\n"
                "PYTHONPATH='" FULBITO_CLIENT_MESSAGES "' '" FULBITO_PYTHON "' server.py $P; wait $c\n");
  CHECK(output.out == "[0, 1, 2]\n");
}

TEST_CASE("Ctrl-C ends a server with a summary and the recording up to there", "[cli]") {
  const Sandbox box;
  const Output output =
      box.shell(kClients +
                "cpp yellow\n"
                "client=$!\n"
                "\"$F\" serve --port-base $P --interface 127.0.0.1 --blue idle --lockstep "
                "--answer 20 --record game.fbr --events events.jsonl --json >summary.json &\n"
                "server=$!\n"
                "until [ -s events.jsonl ] || ! kill -0 $server; do sleep 0.1; done\n"
                "kill -INT $server; wait $server; echo code $?\n"
                "kill $client 2>/dev/null\n"
                "\"$F\" replay verify game.fbr\n");
  CHECK(contains(output.out, "code 130"));
  CHECK(contains(output.out, "identical, bit for bit"));
  const Json summary = Json::parse(box.read("summary.json"));
  CHECK(summary["score"]["complete"] == false);
  CHECK(summary["stats"]["yellow"]["commands"]["late"] == 0);
}

TEST_CASE("without a referee clients drive, and whoever asks moves robots and ball", "[cli]") {
  const Sandbox box;
  box.write("referee.py", R"(import socket, sys
import simulator_pb2 as sim
port = int(sys.argv[1])
ear = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
ear.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
ear.bind(("224.0.0.1", port))
ear.setsockopt(socket.IPPROTO_IP, socket.IP_ADD_MEMBERSHIP, socket.inet_aton("224.0.0.1") + socket.inet_aton("127.0.0.1"))
ear.settimeout(20)
mouth = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
packet = sim.Packet()
packet.replace.ball.SetInParent()
packet.replace.ball.y = 0.4
packet.replace.robots.add(yellowteam=True, turnon=False).position.robot_id = 2
sim.Environment.FromString(ear.recv(2048))
mouth.sendto(packet.SerializeToString(), ("127.0.0.1", port + 10009))
while True:
    seen = sim.Environment.FromString(ear.recv(2048))
    if len(seen.frame.robots_yellow) == 2 and seen.frame.ball.y > 0.3:
        break
)");
  const Output output = box.shell(kClients +
                                  "cpp blue; c=$!\n"
                                  "PYTHONPATH='" FULBITO_CLIENT_MESSAGES "' '" FULBITO_PYTHON
                                  "' referee.py $P & r=$!\n"
                                  "\"$F\" serve --no-referee --seconds 60 --team-ports --port-base $P "
                                  "--interface 127.0.0.1 --json >alone.json & s=$!\n"
                                  "wait $r; echo seen $?\n"
                                  "kill -INT $s; wait $s; echo code $?\n"
                                  "kill $c\n");
  INFO(output.err);
  CHECK(contains(output.out, "seen 0"));
  CHECK(contains(output.out, "code 130"));
  CHECK(contains(output.err, "; no referee"));
  const Json alone = Json::parse(box.read("alone.json"));
  CHECK(alone["replacements"] == 2);
  CHECK(alone["frames"].get<int>() > 1);
  CHECK(alone["malformed"] == 0);
}

TEST_CASE("without a referee the server ends after its simulated time", "[cli]") {
  const Sandbox box;
  const Output output = box.shell(kClients + "serve --no-referee --seconds 2 --speed 20\n");
  INFO(output.err);
  CHECK(output.code == 0);
  CHECK(contains(output.out, "simulated 2.0 s without a referee: frames 120, commands 0, replacements 0\n"));
  CHECK(contains(output.out, "\nignored: malformed datagrams 0, "));
}

TEST_CASE("without a referee there is no match to play or record", "[cli]") {
  const Sandbox box;
  box.fails("serve --no-referee --blue libero", 2, "fulbito client libero --colour blue");
  box.fails("serve --no-referee --record a.fbr", 2, "fulbito record listens to vision");
  box.fails("serve --no-referee --half-seconds 3", 2, "--half-seconds excludes --no-referee");
  box.fails("serve --seconds 3", 2, "--seconds requires --no-referee");
  box.fails("serve --no-referee --seconds 0", 2, "--seconds");
}

TEST_CASE("a server says what keeps it from starting", "[cli]") {
  const Sandbox box;
  box.fails("serve --blue libero --yellow idle", 2, "no team is left for a client");
  box.fails("serve --interface nowhere", 2, "interface 'nowhere' is no address such as 127.0.0.1");
  box.fails("serve --port-base 60000", 2, "--port-base");
  box.fails("serve --speed 2 --lockstep", 2, "--speed");
  box.fails("match idle wire:green", 2, "'green' is neither blue nor yellow");
}

}  // namespace fulbito::test
