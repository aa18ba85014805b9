#include "experiments/map/paper_map.hpp"

#include <cmath>

#include <nlohmann/json.hpp>

#include "experiments/comparison/summary.hpp"
#include "tests/support/catch.hpp"

namespace fulbito {
namespace {

MapConfig small() {
  MapConfig config;
  config.base.suite = "close-range";
  config.base.speeds = {1.0};
  config.base.trials = 4;
  config.seeds = 2;
  config.fresh = 0;
  config.radii = {0.06, 0.10};
  config.widths = {0.2};
  config.laws = {"classic"};
  config.headings = {"goal", "random"};
  return config;
}

PaperMap ran(const MapConfig& config) {
  auto map = planMap(config);
  REQUIRE(map);
  REQUIRE(runMap(*map, {}));
  return std::move(*map);
}

MapCell cellWith(double length, double time, int pairs = 50, double safe = 0.5) {
  MapCell cell;
  cell.cut = {pairs, {length, length, length}, {time, time, time}};
  cell.raw = cell.cut;
  cell.safe.value = safe;
  return cell;
}

}  // namespace

TEST_CASE("a cell is as far from the paper as the worse of its two figures", "[unit]") {
  const PaperTarget target{"t", -0.25, -0.20};
  CHECK(distanceTo(target, cellWith(-0.24, -0.20).cut) == Approx(0.01));
  CHECK(distanceTo(target, cellWith(-0.24, -0.30).cut) == Approx(0.10));
  CHECK(std::isnan(distanceTo(target, cellWith(-0.25, -0.20, kLeastMapPairs - 1).cut)));
}

TEST_CASE("the region holds the cells in which both figures are near, nearest first", "[unit]") {
  const PaperTarget target{"t", -0.25, -0.20};
  std::vector<MapCell> cells = {cellWith(-0.25, -0.40), cellWith(-0.265, -0.20), cellWith(-0.25, -0.205),
                                cellWith(-0.25, -0.20, 3), cellWith(-0.271, -0.20)};
  const MapFinding found = findTarget(cells, "", target, false);
  CHECK(found.region == std::vector<std::size_t>{2, 1});
  CHECK(found.nearest == 2);
  CHECK(found.off == Approx(0.005));
  // With the hung runs the values are different.
  cells[2].raw.time.value = -0.35;
  CHECK(findTarget(cells, "", target, true).nearest == 1);
  cells[1].suite = "corner";
  CHECK(findTarget(cells, "corner", target, false).region == std::vector<std::size_t>{1});
}

TEST_CASE("an empty region names the nearest cell, and none where no cell counts", "[unit]") {
  const PaperTarget target{"t", -0.25, -0.20};
  const MapFinding far = findTarget({cellWith(0.0, 0.0), cellWith(-0.20, -0.20)}, "", target, false);
  CHECK(far.region.empty());
  CHECK(far.nearest == 1);
  CHECK(far.off == Approx(0.05));
  CHECK(std::isnan(findTarget({cellWith(-0.25, -0.20, 2)}, "", target, false).off));
  CHECK(std::isnan(findTarget({}, "", target, false).off));
}

TEST_CASE("the safest ring is chosen by its own runs, never by the gap", "[unit]") {
  std::vector<MapCell> cells = {cellWith(-0.4, -0.4, 50, 0.6), cellWith(0.0, 0.0, 50, 0.9),
                                cellWith(-0.3, -0.3, 50, 0.9), cellWith(-0.5, -0.5, 50, 0.2)};
  cells[1].time_ratio_all = 2.0, cells[2].time_ratio_all = 1.9;
  cells[3].classic = true;
  CHECK(safestCells(cells) == std::vector<std::size_t>{2, 3});
  for (MapCell& cell : cells) cell.suite = "corner", cell.radius = cell.safe.value;
  cells[0].time_ratio_all = 3.0, cells[3].time_ratio_all = 7.0;
  const RingRecord best = bestRing(cells, "corner");
  CHECK(best.radius == 0.9);
  CHECK(best.time_ratio_all == Approx(1.95));
  CHECK(best.least_safe == 0.9);
}

TEST_CASE("cells pool the layouts of all seeds and compare under one law", "[unit]") {
  const PaperMap map = ran(small());
  REQUIRE(map.cells.size() == 4);
  CHECK(map.cells[0].radius == 0.06);
  CHECK(map.cells[1].radius == 0.10);
  CHECK(map.cells[2].heading == StartHeading::kRandom);
  int pairs = 0, safe = 0;
  double bezier = 0.0, ring = 0.0;
  for (std::size_t block : {0, 1}) {
    CHECK(map.comparison.blocks[block].seed == 2015 + block);
    CHECK(map.comparison.blocks[block].navigators[0].classic_follower);
    CHECK(map.comparison.blocks[block].navigators[2].classic_follower);
    for (std::size_t i = 0; i < 4; ++i) {
      const TrialScore &a = recordsOf(map.comparison, block, 0)[i].score,
                       &b = recordsOf(map.comparison, block, 2)[i].score;
      safe += b.success() ? 1 : 0;
      if (!a.success() || !b.success()) continue;
      ++pairs;
      bezier += a.length, ring += b.length;
    }
  }
  const MapCell& cell = map.cells[1];
  CHECK(cell.trials == 8);
  CHECK(cell.safe.value == Approx(safe / 8.0));
  CHECK(cell.raw.pairs == pairs);
  CHECK(cell.cut.pairs <= pairs);
  CHECK(cell.raw.length.value == Approx(bezier / ring - 1.0));
  CHECK(map.findings.size() == 4);
}

TEST_CASE("a map is the same on any number of threads, as text, CSV and JSON", "[unit]") {
  MapConfig config = small();
  config.base.jobs = 1;
  const PaperMap one = ran(config);
  config.base.jobs = 3;
  const PaperMap three = ran(config);
  CHECK(mapReport(one) == mapReport(three));
  CHECK(mapCsv(one) == mapCsv(three));
  const auto json = nlohmann::json::parse(mapJson(one, 1.0));
  CHECK(mapJson(one, 1.0) == mapJson(three, 1.0));
  for (const char* key : {"schema_version", "kind", "suites", "seed", "build", "config", "cells", "findings",
                          "safest", "wall_seconds"}) {
    CHECK(json.contains(key));
  }
  CHECK(json["cells"].size() == 4);
  CHECK(json["cells"][0]["cut"].contains("distance_low"));
  const std::string csv = mapCsv(one);
  CHECK(std::count(csv.begin(), csv.end(), '\n') == 5);
}

TEST_CASE("the nearest cells run again on layouts that had no part in choosing them", "[unit]") {
  MapConfig config = small();
  config.base.trials = 8;
  config.headings = {"random"};
  config.fresh = 5;
  const PaperMap map = ran(config);
  std::vector<std::size_t> nearest;
  for (const MapFinding& finding : map.findings) {
    if (!std::isnan(finding.off)) nearest.push_back(finding.nearest);
  }
  REQUIRE_FALSE(nearest.empty());
  REQUIRE_FALSE(map.fresh.empty());
  for (std::size_t cell : nearest) {
    CHECK(std::count_if(map.fresh.begin(), map.fresh.end(),
                        [&](const FreshCell& f) { return f.cell == cell; }) == 1);
  }
  // A comparison of the same two methods on the same layouts must give the same values.
  const FreshCell& fresh = map.fresh.front();
  const MapCell& cell = map.cells[fresh.cell];
  MapConfig again = config;
  again.base.seed = config.base.seed + kFreshSeedOffset;
  again.base.trials = config.fresh;
  again.seeds = kFreshSeeds;
  again.fresh = 0;
  again.radii = {cell.radius};
  const PaperMap other = ran(again);
  CHECK(other.cells.front().raw.pairs == fresh.raw.pairs);
  CHECK(other.cells.front().cut.length.value == fresh.cut.length.value);
  CHECK(other.cells.front().safe.value == fresh.safe.value);
  CHECK(mapReport(map).find("on fresh layouts") != std::string::npos);
  CHECK(mapReport(other).find("on fresh layouts") == std::string::npos);
  CHECK(nlohmann::json::parse(mapJson(map, 1.0))["fresh"].size() == map.fresh.size());
}

TEST_CASE("the paper's own comparison is mapped on long and short runs", "[unit]") {
  MapConfig config = small();
  config.base.suite = "jung-lee-2015";
  const auto map = planMap(config);
  REQUIRE(map);
  CHECK(map->config.suites == std::vector<std::string>{"corner", "close-range"});
  CHECK(map->comparison.blocks.size() == 8);
}

TEST_CASE("wrong questions about the map are refused before anything runs", "[unit]") {
  const auto message = [](auto change) {
    MapConfig config = small();
    change(config);
    const auto map = planMap(config);
    REQUIRE_FALSE(map);
    CHECK(map.error().code == ErrorCode::kUsage);
    return map.error().message;
  };
  CHECK(message([](MapConfig& c) { c.radii = {1.5}; }) == "--radii: 1.5 is outside 0 ... 1 m");
  CHECK(message([](MapConfig& c) { c.widths = {-0.1}; }) == "--widths: -0.1 is outside 0 ... 1 m");
  CHECK(message([](MapConfig& c) { c.laws = {"clasic"}; }).find("Did you mean 'classic'?") !=
        std::string::npos);
  CHECK(message([](MapConfig& c) {
          c.headings = {"up"};
        }).find("--headings: 'up' must be one of goal, random, away") == 0);
  CHECK(message([](MapConfig& c) { c.fresh = -1; }) == "--fresh: -1 is outside 0 ... 100000");
  CHECK(message([](MapConfig& c) { c.seeds = 0; }) == "--seeds: 0 is outside 1 ... 100");
  CHECK(message([](MapConfig& c) { c.base.suite = "cornr"; }).find("Did you mean 'corner'?") !=
        std::string::npos);
}

TEST_CASE("a map can be stopped", "[unit]") {
  auto map = planMap(small());
  REQUIRE(map);
  const auto stopped = runMap(*map, [](std::size_t, std::size_t) { return false; });
  REQUIRE_FALSE(stopped);
  CHECK(stopped.error().code == ErrorCode::kInterrupted);
}

}  // namespace fulbito
