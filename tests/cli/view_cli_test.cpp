#include "tests/cli/sandbox.hpp"
#include "tests/support/catch.hpp"

using namespace fulbito::test;

namespace {

/// A window that nobody sees, or none at all.
struct Display {
  explicit Display(const char* driver) {
    for (const char* name : {"DISPLAY", "WAYLAND_DISPLAY", "SDL_VIDEODRIVER"}) ::unsetenv(name);
    if (driver != nullptr) ::setenv("SDL_VIDEODRIVER", driver, 1);
  }
  ~Display() { ::unsetenv("SDL_VIDEODRIVER"); }
  Display(const Display&) = delete;
  Display& operator=(const Display&) = delete;
};

const std::string kRecord = "match chaser chaser --half-seconds 3 --record ";

bool mentions(const Output& output, const std::string& text) { return contains(output.err, text); }

/// Whether this program has a window.
bool built() {
  const Display dummy("dummy");
  const Sandbox box;
  return !mentions(box.run("match --view --frames 1"), "FULBITO_VIEW=OFF");
}

}  // namespace

TEST_CASE("without a display, view says what is missing", "[cli]") {
  if (!built()) return;
  const Display none(nullptr);
  const Sandbox box;
  box.works(kRecord + "game.fbr");
  const Output shown = box.run("view game.fbr");
  CHECK(shown.code == 5);
  CHECK(shown.out.empty());
  CHECK(mentions(shown, "neither DISPLAY nor WAYLAND_DISPLAY"));
  const Output played = box.run("match --view --record new.fbr");
  CHECK(played.code == 5);
  CHECK(mentions(played, "DISPLAY"));
  CHECK_FALSE(fs::exists(box.path / "new.fbr"));
}

TEST_CASE("view is told its mistakes", "[cli]") {
  const Display dummy("dummy");
  const Sandbox box;
  box.write("bad.fbr", "no recording");
  box.works(kRecord + "game.fbr");
  CHECK(box.run("view").code == 2);
  CHECK(box.run("view missing.fbr").code == 5);
  const Output bad = box.run("view game.fbr bad.fbr");
  CHECK(bad.code == 3);
  CHECK(mentions(bad, "bad.fbr"));
  CHECK(box.run("match --view -n 2").code == 2);
  CHECK(box.run("match --speed 2").code == 2);  // of what window?
  if (!built()) return;
  for (const char* wrong : {"--speed 3", "--speed 0", "--size 10x10", "--size 900", "--size 900x99999",
                            "--theme red", "--frames -1"}) {
    INFO(wrong);
    const Output output = box.run(std::string("view game.fbr --frames 1 ") + wrong);
    CHECK(output.code == 2);
    CHECK(mentions(output, std::string(wrong).substr(0, std::string(wrong).find(' '))));
  }
}

TEST_CASE("view plays recordings of both kinds and levels, in a window that nobody sees", "[cli]") {
  if (!built()) return;
  const Display dummy("dummy");
  const Sandbox box;
  box.works(kRecord + "game.fbr");
  const Output output = box.run(
      "view game.fbr game.fbr --from 2 --frames 5 --size 400x300 --theme light --json "
      "--screenshot last.png");
  REQUIRE(output.code == 0);
  CHECK(output.err.empty());
  const Json json = Json::parse(output.out);
  CHECK(json["schema_version"] == 1);
  CHECK(json["files"].size() == 2);
  CHECK(json["frames"] == 5);
  CHECK(json["position_s"].get<double>() > 2.0);
  CHECK(json["theme"] == "light");
  CHECK(json["edited"] == false);
  CHECK(contentOf(box.path / "last.png").substr(1, 3) == "PNG");
  const Output nowhere = box.run("view game.fbr --frames 1 --screenshot no/such/folder.png");
  CHECK(nowhere.code == 5);
  CHECK(mentions(nowhere, "no/such"));
}

TEST_CASE("a match in a window is the match without one, and closing it is no failure", "[cli]") {
  if (!built()) return;
  const Display dummy("dummy");
  const Sandbox box;
  const std::string match = "match chaser classic --half-seconds 2 --seed 5 --json";
  Json alone = Json::parse(box.run(match).out);
  const Output output = box.run(match + " --view --speed 16 --frames 60 --record game.fbr");
  CHECK(output.code == 0);
  Json watched = Json::parse(output.out);
  dropMeasured(alone);
  dropMeasured(watched);
  CHECK(watched == alone);
  CHECK(watched["edited"] == false);
  CHECK(box.run("replay verify game.fbr").code == 0);
  const Output early = box.run(match + " --view --frames 3");
  CHECK(early.code == 0);
  CHECK(Json::parse(early.out)["score"]["complete"] == false);
}
