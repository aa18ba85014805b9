#include <algorithm>

#include "experiments/paper_report/scene_picture.hpp"
#include "fulbito/report.hpp"
#include "tests/support/catch.hpp"

namespace fulbito {
namespace {

const ScenePath* pathOf(const ReportScene& scene, const std::string& label) {
  const auto found = std::find_if(scene.paths.begin(), scene.paths.end(),
                                  [&](const ScenePath& path) { return path.label == label; });
  return found == scene.paths.end() ? nullptr : &*found;
}

/// The direction [rad] of a drawn arrow.
double bearingOf(const ScenePath& arrow) { return math::angleOf(arrow.points.back() - arrow.points.front()); }

}  // namespace

TEST_CASE("the figures of the method are drawn by its parts, one still picture each", "[unit]") {
  const std::vector<ReportScene> pictures = hybridPictures();
  REQUIRE(pictures.size() == 7);
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    CHECK(pictures[i].name == "fig-" + std::to_string(i + 1));
    CHECK(pictures[i].isStill());
    CHECK(pictures[i].paths.size() > 0);
    CHECK(ScenePicture(pictures[i], 300).drawWhole());
  }
  CHECK(pathOf(pictures[0], "free walking area") != nullptr);
  CHECK(pictures[1].caption.find("LS1") != std::string::npos);
  CHECK(pictures[2].caption.find("LS2") != std::string::npos);
  CHECK(pathOf(pictures[3], "section of the obstacle") != nullptr);
  CHECK(pathOf(pictures[4], "clockwise") != nullptr);
  // Up to I1 the robot turns away from obstacles on its left. Beyond I1 it averages the goal's direction and
  // the table's.
  for (const std::size_t i : {5U, 6U}) {
    const ScenePath *goal = pathOf(pictures[i], "toward the goal"),
                    *way = pathOf(pictures[i], "direction of the table");
    REQUIRE(goal);
    REQUIRE(way);
    CHECK(bearingOf(*way) < bearingOf(*goal));
    CHECK((bearingOf(*way) < -0.9) == (i == 5));
  }
}

}  // namespace fulbito
