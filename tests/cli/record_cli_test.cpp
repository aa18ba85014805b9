#include "tests/cli/sandbox.hpp"
#include "tests/support/free_ports.hpp"

// `fulbito record` and `fulbito replay send`, over real sockets on the loopback interface.
namespace fulbito::test {
namespace {

/// Bash: ports of this test alone, and the commands at them, each in place of its shell.
const std::string kWire = "W=\"--port-base " + std::to_string(freePortBase()) +
                          " --interface 127.0.0.1\"\n"
                          "record() { exec \"$F\" record \"$@\" $W --wait 60; }\n"
                          "send() { exec \"$F\" replay send \"$@\" $W; }\n"
                          "waiting() { until grep -q 'waiting for vision' $1; do sleep 0.05; done; }\n";

}  // namespace

TEST_CASE("a match of clients is recorded by who listens", "[cli]") {
  const Sandbox box;
  const Output output =
      box.shell(kWire +
                "record heard.fbr --blue B --yellow Y --json >heard.json 2>notes & r=$!\n"
                "waiting notes\n"
                "\"$F\" client chaser --colour blue $W >/dev/null & \"$F\" client chaser --colour yellow $W "
                ">/dev/null &\n"
                "\"$F\" serve $W --speed 5 --half-seconds 3 --record truth.fbr >/dev/null || exit 1\n"
                "wait $r\n");
  INFO(output.err);
  REQUIRE(output.code == 0);
  const Json heard = Json::parse(box.read("heard.json"));
  CHECK(contains(box.read("notes"), "recording heard.fbr"));
  CHECK(heard["end"] == "halt");
  CHECK(heard["malformed"] == 0);
  CHECK(heard["strangers"] == 0);
  const Json truth = Json::parse(box.works("replay info truth.fbr --json").out);
  CHECK(heard["frames"].get<int>() + heard["lost"].get<int>() >= truth["ticks"].get<int>() - 10);
  const Json info = Json::parse(box.works("replay info heard.fbr --json").out);
  CHECK(info["heard"] == true);
  CHECK(info["end"] == "finished");
  CHECK(info["restarts"]["kick-off"].get<int>() >= 2);
  CHECK(info["events"]["half"] == 1);
  CHECK(info["recipe"]["teams"] == Json({"B", "Y"}));
  const Output verified = box.run("replay verify heard.fbr");
  CHECK(verified.code == 6);
  CHECK(contains(verified.out, "another program's motion, which cannot be simulated again"));
  CHECK(box.run("replay verify heard.fbr truth.fbr").code == 6);
  CHECK(box.run("rules compare vsss-3v3 league-program-2021 heard.fbr").code == 3);
  box.works("replay export heard.fbr --png one.png --at 1 --html game.html --csv game.csv");
}

TEST_CASE("what is recorded and sent is recorded the same", "[cli]") {
  const Sandbox box;
  box.works("match chaser chaser --half-seconds 3 --record game.fbr");
  const Output output = box.shell(kWire +
                                  "for leg in 'game first' 'first second'; do set -- $leg\n"
                                  "  record $2.fbr 2>notes$1 >$2.txt & r=$!\n"
                                  "  waiting notes$1\n"
                                  "  (send $1.fbr --speed 4 --json >$1.json) || exit 1\n"
                                  "  wait $r || exit 2\n"
                                  "done\n"
                                  "\"$F\" replay diff first.fbr second.fbr\n");
  INFO(output.out << output.err);
  CHECK(output.code == 0);
  CHECK(contains(output.out, "are identical, bit for bit"));
  const Json game = Json::parse(box.read("game.json"));
  CHECK(game["exact"] == true);
  CHECK(game["unsent"] == 0);
  CHECK(game["frames"] == Json::parse(box.works("replay info game.fbr --json").out)["ticks"]);
  CHECK(contains(box.read("second.txt"), "the referee halted the match"));
}

TEST_CASE("a part is sent again and again until Ctrl-C, and a killed recorder leaves what it heard",
          "[cli]") {
  const Sandbox box;
  box.works("match chaser idle --half-seconds 4 --record game.fbr");
  const Output output = box.shell(
      kWire +
      "record short.fbr --seconds 1 2>notes1 >short.txt & a=$!\n"
      "record stopped.fbr 2>notes2 >stopped.txt & b=$!\n"
      "record killed.fbr 2>notes3 >/dev/null & c=$!\n"
      "for n in 1 2 3; do waiting notes$n; done\n"
      "send game.fbr --from 1 --to 2 --speed 20 --loop --json >sent.json & s=$!\n"
      "wait $a || exit 1\n"
      "until [ \"$(stat -c %s killed.fbr)\" -gt 10000 ] || ! kill -0 $c; do sleep 0.1; done\n"
      "kill -KILL $c; wait $c; kill -INT $b; wait $b; echo record $?\n"
      "kill -INT $s; wait $s; echo send $?\n"
      "\"$F\" replay repair killed.fbr mended.fbr && \"$F\" replay info mended.fbr --json >mended.json\n");
  INFO(output.out << output.err);
  CHECK(contains(output.out, "record 130"));
  CHECK(contains(output.out, "send 130"));
  CHECK(contains(box.read("short.txt"), "as long as asked for"));
  CHECK(contains(box.read("stopped.txt"), "; stopped"));
  CHECK(Json::parse(box.works("replay info stopped.fbr --json").out)["end"] == "stopped");
  CHECK(Json::parse(box.read("mended.json"))["simulated_s"].get<double>() >= 6.0);
  const Json sent = Json::parse(box.read("sent.json"));
  CHECK(sent["rounds"].get<int>() > 1);
  CHECK(sent["from_s"] == 1.0);
}

TEST_CASE("a recorder says what keeps it from recording", "[cli]") {
  const Sandbox box;
  box.write("old.fbr", "something else");
  box.fails("record old.fbr", 2, "old.fbr' exists");
  box.fails("record game.png", 2, "is the name of a PNG picture");
  box.fails("record a.fbr --interface nowhere", 2, "interface 'nowhere' is no address such as 127.0.0.1");
  box.fails("record a.fbr --seconds 0", 2, "--seconds");
  box.fails("record a.fbr --rules nothing", 2, "nothing");
  Output output = box.shell(kWire + "\"$F\" record a.fbr $W --wait 0.2\n");
  CHECK(output.code == 5);
  CHECK(contains(output.err, "waiting for vision on 224.0.0.1:"));
  CHECK(contains(output.err, "no vision came within 0.2 s"));
  box.works("match idle idle --half-seconds 3 --record game.fbr");
  output = box.shell(kWire +
                     "record a.fbr --rules vsss-5v5 2>notes & r=$!\n"
                     "waiting notes; (send game.fbr --speed 10 >/dev/null); wait $r; echo $?; cat notes\n"
                     "[ ! -e a.fbr ] && echo none\n");
  CHECK(contains(output.out, "2\n"));
  CHECK(contains(output.out, "that of the rules vsss-5v5 is 2.20 x 1.80 m; choose others with --rules"));
  CHECK(contains(output.out, "none"));
}

TEST_CASE("a sender says what keeps it from sending", "[cli]") {
  const Sandbox box;
  box.works("match idle idle --half-seconds 1 --record game.fbr");
  box.works("run --layout corner:0 --record trial.fbr");
  const std::string bytes = box.read("game.fbr");
  std::string damaged = bytes;
  damaged[bytes.size() / 2] ^= 1;
  box.write("damaged.fbr", damaged);
  box.fails("replay send none.fbr", 5, "none.fbr");
  box.fails("replay send damaged.fbr", 3, "damaged.fbr: ");
  box.fails("replay send trial.fbr", 3, "trial.fbr: it is not a match");
  box.fails("replay send game.fbr --speed 50", 2, "--speed");
  box.fails("replay send game.fbr --from 99", 2, "--from 99: the recording lasts from 0 to");
  box.fails("replay send game.fbr --from 1 --to 0.5", 2, "there is no frame from");
  box.fails("replay send game.fbr --interface nowhere", 2, "interface 'nowhere'");
}

}  // namespace fulbito::test
