#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "experiments/map/paper_map.hpp"
#include "replays/render/field/tile_map.hpp"

namespace fulbito {
namespace {

constexpr const char* kLetters = "SE";  // initials of kPaperTargets, in order

std::string centimetres(double metres) { return fmt::format("{:.4g}", 100 * metres); }

std::string startText(StartHeading heading) {
  switch (heading) {
    case StartHeading::kLayout:
      return "start facing the goal";
    case StartHeading::kRandom:
      return "start facing anywhere";
    case StartHeading::kAway:
      break;
  }
  return "start facing away";
}

MapTile tileOf(const PaperMap& map, std::size_t index) {
  const MapCell& cell = map.cells[index];
  MapTile tile;
  tile.left = cell.cut.length.value, tile.right = cell.cut.time.value;
  tile.left_below = cell.raw.length.value, tile.right_below = cell.raw.time.value;
  tile.share = cell.safe.value;
  tile.pale = cell.cut.pairs < kLeastMapPairs;
  for (const MapFinding& finding : map.findings) {
    const bool inside =
        std::find(finding.region.begin(), finding.region.end(), index) != finding.region.end();
    tile.framed = tile.framed || inside;
    if (finding.suite != cell.suite || finding.with_hung || std::isnan(finding.off) ||
        finding.nearest != index)
      continue;
    const auto same = [&](const PaperTarget& t) { return t.length == finding.target.length; };
    const auto place = std::find_if(kPaperTargets.begin(), kPaperTargets.end(), same) - kPaperTargets.begin();
    tile.badge += kLetters[place];
  }
  return tile;
}

std::vector<std::pair<std::string, std::string>> badgesOf(const PaperMap& map, const std::string& suite) {
  std::vector<std::pair<std::string, std::string>> badges;
  for (const MapFinding& finding : map.findings) {
    if (finding.with_hung || finding.suite != suite) continue;
    const std::string where = std::isnan(finding.off)
                                  ? "no cell has enough pairs"
                                  : fmt::format("the nearest cell, {:.1f} points off", 100 * finding.off);
    badges.emplace_back(
        std::string(1, kLetters[badges.size()]),
        fmt::format("the paper's {}, {:+.1f} % distance and {:+.1f} % time: {}", finding.target.name,
                    100 * finding.target.length, 100 * finding.target.time, where));
  }
  return badges;
}

TileMap tileMapOf(const PaperMap& map, const std::string& suite, bool classic) {
  const MapConfig& config = map.config;
  TileMap picture;
  picture.title = fmt::format("Savings of the Bezier method over a ring field: {} runs, {} law", suite,
                              classic ? "classic" : "preview");
  picture.caption = fmt::format(
      "Suite {}, {} layouts per seed, {} seeds, robot {}. Each tile is one ring. Both methods use the {} law "
      "on "
      "the same layouts; only layouts that both solved count.",
      suite, config.base.trials, config.seeds, map.comparison.robot.robot.name,
      classic ? "classic" : "preview");
  for (double radius : config.radii) picture.columns.push_back(centimetres(radius));
  for (double width : config.widths) picture.rows.push_back(centimetres(width));
  picture.column_axis = "radius of the ring [cm]";
  picture.row_axis = "width [cm]";
  const std::size_t each = config.radii.size() * config.widths.size();
  for (std::size_t first = 0; first < map.cells.size(); first += each) {
    const MapCell& cell = map.cells[first];
    if (cell.suite != suite || cell.classic != classic) continue;
    TilePanel panel{fmt::format("{:.1f} m/s, {}", cell.speed, startText(cell.heading)), {}};
    for (std::size_t i = 0; i < each; ++i) panel.tiles.push_back(tileOf(map, first + i));
    picture.panels.push_back(std::move(panel));
  }
  picture.key = {
      "distance",
      "time",
      "small figures, if different: including pairs with a hung run (over 4 T*)",
      "bar: share of the ring's runs that arrive without contact; the tick marks half",
      fmt::format("without colour: fewer than {} pairs", kLeastMapPairs),
      fmt::format(
          "frame: matches both of the paper's figures within {:.0f} points, with or without hung runs",
          100 * kTargetTolerance),
      badgesOf(map, suite)};
  return picture;
}

}  // namespace

Result<std::vector<std::string>> writeMapPictures(const PaperMap& map, const std::string& folder) {
  std::vector<std::string> files;
  for (const std::string& suite : map.config.suites) {
    for (const std::string& law : map.config.laws) {
      const std::string name = fmt::format("map-{}-{}.png", suite, law);
      const auto canvas = drawTileMap(tileMapOf(map, suite, law == "classic"));
      if (!canvas) return tl::unexpected<Error>(canvas.error());
      if (auto written = canvas->writePng(fmt::format("{}/{}", folder, name)); !written) {
        return tl::unexpected<Error>(written.error());
      }
      files.push_back(name);
    }
  }
  return files;
}

}  // namespace fulbito
