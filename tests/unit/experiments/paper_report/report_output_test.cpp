#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "experiments/paper_report/scene_picture.hpp"
#include "fulbito/report.hpp"
#include "replays/html/html_page.hpp"
#include "replays/render/colours/palette.hpp"

namespace fulbito {
namespace {

ExperimentReport smallReport() {
  ExperimentReport report;
  report.name = "small", report.title = "A small report";
  report.figures = {
      {"radius", "Table 5", "radius at 0.3 m/s", "m", 2, 4.37, 4.40, 4.31, 4.43, ""},
      {"share", "text", "captures", "", 0, std::nullopt, 90.0, 95.0, 100.0, "grip is lost"},
      {"free", "Fig. 3", "without a band", "s", 1, 2.0, -0.01, -1.0 / 0.0, 1.0 / 0.0, ""},
  };
  report.tables = {{"runs", "All runs", {{"run", 0}, {"end", 3}, {"why", 0}}, {}, 1}};
  report.tables[0].rows = {{1.0, 0.1, std::string("ok, \"fine\"")}, {2.0, 0.0 / 0.0, std::string("lost")}};
  report.notes = {"One sentence."};
  return report;
}

/// A robot drives 1 m to the right within one second.
ReportScene drivingScene() {
  ReportScene scene;
  scene.name = "drive", scene.caption = "A robot drives.";
  scene.labels = {"robot"};
  scene.paths = {{"reference", {{-0.5, 0.2}, {0.5, 0.2}}, true}};
  scene.page.title = "Drive";
  scene.page.rate = 10.0;
  PageBody robot;
  robot.box = true, robot.length = 0.1, robot.width = 0.1;
  scene.page.bodies = {robot};
  for (Tick tick = 0; tick <= 10; ++tick) {
    scene.page.rows.push_back({tick, {{{-0.5 + 0.1 * static_cast<double>(tick), 0.0}, 0.0}}});
  }
  finishScene(scene);
  return scene;
}

int pixelsOf(const Canvas& canvas, Colour colour) {
  int count = 0;
  for (int y = 0; y < canvas.height(); ++y) {
    for (int x = 0; x < canvas.width(); ++x) {
      const Colour pixel = canvas.pixel(x, y);
      count += pixel.r == colour.r && pixel.g == colour.g && pixel.b == colour.b;
    }
  }
  return count;
}

TEST_CASE("experiment text: figures stand beside the paper's with band and verdict; long tables are cut") {
  const std::string text = experimentText(smallReport());
  INFO(text);
  CHECK(text.find("| Table 5 | radius at 0.3 m/s | 4.37 m | 4.40 m | 4.31 to 4.43 m | yes |  |") !=
        std::string::npos);
  CHECK(text.find("| text | captures | - | 90 | 95 to 100 | no | grip is lost |") != std::string::npos);
  CHECK(text.find("| Fig. 3 | without a band | 2.0 s | 0.0 s | - | - |  |") != std::string::npos);
  CHECK(text.find("1 of 2 rows; runs.csv has all.") != std::string::npos);
  CHECK(text.find("One sentence.") != std::string::npos);
}

TEST_CASE("experiment CSV: all rows and digits, quoted where needed, nothing for a missing value") {
  CHECK(tableCsv(smallReport().tables[0]) == "run,end,why\n1,0.1,\"ok, \"\"fine\"\"\"\n2,,lost\n");
}

TEST_CASE("experiment JSON: figures with their bands, null for what is missing") {
  ExperimentRequest request;
  request.seed = 7;
  request.settings = {{"step", "0.1"}};
  const auto json = nlohmann::json::parse(experimentJson(smallReport(), request));
  CHECK(json["schema_version"] == 1);
  CHECK(json["seed"] == 7);
  CHECK(json["settings"]["step"] == "0.1");
  CHECK(json["figures"][0]["inside"] == true);
  CHECK(json["figures"][1]["inside"] == false);
  CHECK(json["figures"][1]["paper"].is_null());
  CHECK(json["figures"][2]["low"].is_null());
  CHECK(json["tables"][0]["rows"][1][1].is_null());
}

TEST_CASE("experiment scene: the body stands where its row says, the trail only in the whole picture") {
  const ReportScene scene = drivingScene();
  const ScenePicture picture(scene, 600);
  const auto first = picture.draw(0), whole = picture.drawWhole();
  REQUIRE(first);
  REQUIRE(whole);
  const Colour robot = seriesColour(0);
  CHECK(pixelsOf(*first, robot) > 800);
  CHECK(pixelsOf(*whole, robot) > 800);
  // Both pictures have the reference path, in the next colour.
  CHECK(pixelsOf(*first, seriesColour(1)) > 50);
  CHECK(first->width() == whole->width());
  CHECK(pixelsOf(*whole, theme::kFloor) < pixelsOf(*first, theme::kFloor));
}

TEST_CASE("experiment scene: a soccer field has lines, a floor has none") {
  ReportScene scene = drivingScene();
  const auto field = ScenePicture(scene, 600).draw(0);
  scene.page.field = plainFloor("floor", 2.2, 1.1);
  const auto floor = ScenePicture(scene, 600).draw(0);
  REQUIRE(field);
  REQUIRE(floor);
  CHECK(pixelsOf(*field, theme::kFieldLine) > 500);
  CHECK(pixelsOf(*floor, theme::kFieldLine) == 0);
}

TEST_CASE("experiment scene: a dashed path shows above the trail that covers it") {
  ReportScene scene = drivingScene();
  scene.page.field = plainFloor("floor", 2.0, 1.0);
  scene.paths = {{"plan", {{-0.5, 0.0}, {0.5, 0.0}}, true}};
  const auto whole = ScenePicture(scene, 600).drawWhole();
  REQUIRE(whole);
  scene.paths.front().points = {{-0.5, 0.3}, {0.5, 0.3}};
  const auto apart = ScenePicture(scene, 600).drawWhole();
  REQUIRE(apart);
  // The body at its end covers the rest.
  CHECK(pixelsOf(*whole, seriesColour(1)) > 0.7 * pixelsOf(*apart, seriesColour(1)));
}

TEST_CASE("experiment scene: moments stand out, in the colours of the roles that bodies have then") {
  ReportScene scene = drivingScene();
  scene.page.field = plainFloor("floor", 2.0, 1.0);
  scene.outlines_every = -1.0;
  scene.first_trail = 1;
  const auto plain = ScenePicture(scene, 600).drawWhole();
  scene.roles.names = {"master", "slave"};
  for (std::size_t i = 0; i < scene.page.rows.size(); ++i)
    scene.roles.rows.push_back({static_cast<std::uint8_t>(i < 5 ? 1 : 0)});
  scene.moments = {{2, "1"}, {7, ""}};
  const auto whole = ScenePicture(scene, 600).drawWhole();
  REQUIRE(plain);
  REQUIRE(whole);
  const int body = pixelsOf(*plain, seriesColour(0));  // at the end and in the legend
  CHECK(pixelsOf(*whole, seriesColour(0)) > 1.6 * body);
  CHECK(pixelsOf(*whole, seriesColour(1)) > 0.5 * body);
}

TEST_CASE("experiment scene: the viewer's page takes it") {
  const auto page = htmlPage({PageKind::kRaces, "Scenes", {drivingScene().page}});
  REQUIRE(page);
  CHECK(page->find("Drive") != std::string::npos);
  CHECK(page->find("[\"Robot 1\",\"robot\"]") != std::string::npos);
}

}  // namespace
TEST_CASE("columns are words with their decimals, or with the usual ones", "[unit]") {
  const auto columns = columnsOf("time_s:1 who  radius_m:12\nreason:0");
  REQUIRE(columns.size() == 4);
  CHECK(columns[0].name == "time_s");
  CHECK(columns[0].decimals == 1);
  CHECK(columns[1].name == "who");
  CHECK(columns[1].decimals == ReportColumn{}.decimals);
  CHECK(columns[2].decimals == 12);
  CHECK(columns[3].name == "reason");
  CHECK(columns[3].decimals == 0);
}

}  // namespace fulbito
