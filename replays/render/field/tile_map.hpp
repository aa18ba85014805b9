#pragma once

#include <limits>
#include <string>
#include <vector>

#include "fulbito/detail/canvas.hpp"

namespace fulbito {

/// One tile: two ratios side by side (-0.25 is drawn as -25 %), each measured in two ways, and a share.
struct MapTile {
  double left = std::numeric_limits<double>::quiet_NaN();  ///< NaN: no value
  double right = std::numeric_limits<double>::quiet_NaN();
  double left_below = std::numeric_limits<double>::quiet_NaN();  ///< the second measure, in small figures
  double right_below = std::numeric_limits<double>::quiet_NaN();
  double share = 0.0;   ///< 0 ... 1, drawn as a bar at the bottom of the tile
  bool pale = false;    ///< drawn without colour, because the values have little meaning
  bool framed = false;  ///< drawn with a frame that makes the tile stand out
  std::string badge;    ///< one or two letters in the tile's corner; empty: none
};

/// The tiles of one case, row by row from the top.
struct TilePanel {
  std::string title;
  std::vector<MapTile> tiles;
};

/// The texts that explain letters, frames and bars.
struct TileKey {
  std::string left, right;  ///< meaning of the two halves, e.g. "distance"
  std::string below;        ///< meaning of the small figures
  std::string share;        ///< meaning of the bar at the bottom
  std::string pale;
  std::string framed;
  std::vector<std::pair<std::string, std::string>> badges;  ///< letter and meaning
};

/// Small maps side by side that share their axes and colours.
struct TileMap {
  std::string title;
  std::string caption;               ///< one or more sentences, broken into lines as needed
  std::vector<std::string> columns;  ///< labels
  std::vector<std::string> rows;
  std::string column_axis, row_axis;  ///< axis labels with units
  std::vector<TilePanel> panels;      ///< each with rows x columns tiles
  TileKey key;
};

/// Draws the map, as large as it needs to be. Blue stands for negative ratios, orange for positive ones; both
/// scales differ in lightness, for grey prints and colour-blind readers. Errors: kIo as `Canvas`; kUsage if
/// the map is too large or a panel has a wrong number of tiles.
Result<Canvas> drawTileMap(const TileMap& map);

}  // namespace fulbito
