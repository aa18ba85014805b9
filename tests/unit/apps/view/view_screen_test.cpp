#include "apps/view/view_screen.hpp"

#include "apps/view/match_stage.hpp"
#include "engine/core/system/text_file.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/unit/apps/view/test_stages.hpp"

namespace fulbito {
namespace {

using namespace fulbito::test;

Viewer shortViewer() {
  std::vector<std::unique_ptr<ViewStage>> stages;
  stages.push_back(replayStage(recorded(shortMatch())));
  return {std::move(stages), {}};
}

/// The number of pixels in which two pictures of the same size differ.
int differences(const Canvas& a, const Canvas& b) {
  int count = 0;
  for (int y = 0; y < a.height(); ++y) {
    for (int x = 0; x < a.width(); ++x) count += a.row(y)[x] != b.row(y)[x] ? 1 : 0;
  }
  return count;
}

}  // namespace

TEST_CASE("a screen follows size, theme and help", "[unit]") {
  Viewer viewer = shortViewer();
  ViewScreen screen, other;
  CHECK(screen.canvas() == nullptr);
  REQUIRE(screen.draw(viewer, 400, 340));
  CHECK(screen.canvas()->width() == 400);
  CHECK_FALSE(viewer.stale());
  REQUIRE(other.draw(viewer, 400, 340));
  CHECK(differences(*screen.canvas(), *other.canvas()) == 0);
  viewer.act(ViewAction::kHelp);
  REQUIRE(other.draw(viewer, 400, 340));
  CHECK(differences(*screen.canvas(), *other.canvas()) > 10000);
  viewer.act(ViewAction::kHelp);
  viewer.act(ViewAction::kTheme);
  REQUIRE(other.draw(viewer, 400, 340));
  CHECK(differences(*screen.canvas(), *other.canvas()) > 100000);
  REQUIRE(screen.draw(viewer, 640, 300));
  CHECK(screen.canvas()->height() == 300);
}

TEST_CASE("a saved picture shows no help and no note", "[unit]") {
  const ScratchFolder folder;
  Viewer viewer = shortViewer();
  ViewScreen screen;
  const std::string plain = folder.path() / "plain.png", saved = folder.path() / "saved.png";
  CHECK_FALSE(screen.save(viewer, plain));  // nothing has been drawn yet
  viewer.act(ViewAction::kPlay);
  REQUIRE(screen.draw(viewer, 320, 240));
  REQUIRE(screen.save(viewer, plain));
  viewer.act(ViewAction::kHelp);
  viewer.notify("hello");
  REQUIRE(screen.draw(viewer, 320, 240));
  REQUIRE(screen.save(viewer, saved));
  CHECK(*readTextFile(saved, 1 << 24) == *readTextFile(plain, 1 << 24));
}

TEST_CASE("the screen always says how fast it plays and that H shows the keys", "[unit]") {
  Viewer viewer = shortViewer();
  ViewScreen screen;
  REQUIRE(screen.draw(viewer, 900, 780));
  const auto inked = [&] {  // pixels at the foot of the board, right of the clock, that differ from its panel
    int count = 0;
    for (int y = 68; y < 82; ++y) {
      for (int x = 700; x < 890; ++x)
        count += screen.canvas()->row(y)[x] != screen.canvas()->row(y)[690] ? 1 : 0;
    }
    return count;
  };
  CHECK(inked() > 200);
}

TEST_CASE("a pointer aims at what the picture shows there", "[unit]") {
  Viewer viewer = shortViewer();
  ViewScreen screen;
  PointerEvent event;
  screen.aim(event, {10.0, 10.0});  // nothing has been drawn yet
  CHECK_FALSE(event.on_bar);
  REQUIRE(screen.draw(viewer, 900, 780));
  const double seconds = viewer.stage().look().seconds;
  screen.aim(event, {450.0, 775.0});
  CHECK(event.on_bar);
  CHECK(event.bar_seconds == Approx(seconds / 2));
  screen.aim(event, {899.0, 775.0});
  CHECK(event.bar_seconds == seconds);
  screen.aim(event, {450.0, 400.0});
  CHECK_FALSE(event.on_bar);
  CHECK(std::abs(event.place.x) < 1e-9);
}

TEST_CASE("an edited match says so on its picture", "[unit]") {
  auto match = Match::create(shortMatch("idle", "idle"));
  REQUIRE(match);
  std::vector<std::unique_ptr<ViewStage>> stages;
  stages.push_back(std::make_unique<MatchStage>(*match));
  Viewer viewer(std::move(stages), {});
  ViewScreen screen, edited;
  REQUIRE(screen.draw(viewer, 900, 780));
  REQUIRE(match->replace(match->placement()));
  viewer.stage().refresh();
  REQUIRE(edited.draw(viewer, 900, 780));
  CHECK(differences(*screen.canvas(), *edited.canvas()) > 300);
}

}  // namespace fulbito
