#include "replays/render/field/tile_map.hpp"

#include "tests/support/catch.hpp"
#include "tests/unit/replays/render/samples.hpp"

namespace fulbito {
namespace {

using namespace test;

constexpr Colour kMark{178, 34, 52}, kLess{8, 48, 107};

TileMap sample() {
  TileMap map;
  map.title = "Title";
  map.caption = "A caption.";
  map.columns = {"8", "10"};
  map.rows = {"2"};
  map.column_axis = "radius [cm]";
  map.row_axis = "width [cm]";
  map.panels = {{"one", std::vector<MapTile>(2)}, {"two", std::vector<MapTile>(2)}};
  map.key = {"distance", "time", "hung", "safe", "pale", "framed", {{"S", "nearest"}}};
  return map;
}

Canvas drawn(const TileMap& map) {
  auto canvas = drawTileMap(map);
  REQUIRE(canvas);
  return std::move(*canvas);
}

}  // namespace

TEST_CASE("a tile's halves have their values' colours, and a pale one has none", "[unit]") {
  TileMap map = sample();
  const int before = count(drawn(map), kLess);
  map.panels[0].tiles[0].left = map.panels[0].tiles[0].right = -0.7;  // beyond the end of the scale
  const int both = count(drawn(map), kLess);
  CHECK(both > before + 2000);
  map.panels[0].tiles[0].right = -0.01;
  CHECK(count(drawn(map), kLess) < before + (both - before) * 6 / 10);
  map.panels[0].tiles[0].pale = true;
  CHECK(count(drawn(map), kLess) == before);
}

TEST_CASE("frames and badges stand out", "[unit]") {
  TileMap map = sample();
  const int plain = count(drawn(map), kMark);
  map.panels[1].tiles[1].framed = true;
  const int framed = count(drawn(map), kMark);
  CHECK(framed > plain + 500);
  map.panels[0].tiles[0].badge = "S";
  CHECK(count(drawn(map), kMark) > framed + 60);
}

TEST_CASE("the bar at the foot is as long as the share", "[unit]") {
  TileMap map = sample();
  const Colour ink{30, 35, 42};
  const auto inked = [&](double share) {
    map.panels[0].tiles[0].share = share;
    return count(drawn(map), ink);
  };
  const int none = inked(0.0), half = inked(0.5), whole = inked(1.0);
  CHECK(whole - none > 300);
  CHECK(half - none == Approx((whole - none) / 2.0).margin(25));
}

TEST_CASE("a panel with the wrong number of tiles and a map too large are refused", "[unit]") {
  TileMap map = sample();
  map.panels[1].tiles.pop_back();
  const auto refused = drawTileMap(map);
  REQUIRE_FALSE(refused);
  CHECK_THAT(refused.error().message, Catch::Contains("panel 'two' has 1 tiles for 1 rows and 2 columns"));
  map = sample();
  map.panels.resize(1000, map.panels[0]);
  CHECK(drawTileMap(map).error().code == ErrorCode::kUsage);
  CHECK(drawTileMap(TileMap{}));
}

}  // namespace fulbito
