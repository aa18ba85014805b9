#pragma once

#include <limits>
#include <string>
#include <vector>

#include "fulbito/detail/canvas.hpp"

namespace fulbito {

/// One tile: two ratios side by side (-0.25 is drawn as -25 %), each in two ways, and a share.
struct MapTile {
  double left = std::numeric_limits<double>::quiet_NaN();  ///< NaN: no value
  double right = std::numeric_limits<double>::quiet_NaN();
  double left_below = std::numeric_limits<double>::quiet_NaN();  ///< the second way, in small figures
  double right_below = std::numeric_limits<double>::quiet_NaN();
  double share = 0.0;   ///< 0 ... 1, a bar at the tile's foot
  bool pale = false;    ///< its values mean little: without colour
  bool framed = false;  ///< stands out
  std::string badge;    ///< a letter or two in its corner; empty: none
};

/// Tiles of one case, row by row from the top.
struct TilePanel {
  std::string title;
  std::vector<MapTile> tiles;
};

/// What the letters, frames and bars mean.
struct TileKey {
  std::string left, right;  ///< of the two halves, e.g. "distance"
  std::string below;        ///< of the small figures
  std::string share;        ///< of the bar at the foot
  std::string pale;
  std::string framed;
  std::vector<std::pair<std::string, std::string>> badges;  ///< letter, meaning
};

/// Small maps side by side that share their axes and colours.
struct TileMap {
  std::string title;
  std::string caption;               ///< one sentence or more, broken into lines as needed
  std::vector<std::string> columns;  ///< labels
  std::vector<std::string> rows;
  std::string column_axis, row_axis;  ///< with units
  std::vector<TilePanel> panels;      ///< each with rows x columns tiles
  TileKey key;
};

/// Draws it, as large as it needs. Blue is less than nothing, orange more; the steps of both differ in
/// lightness, for grey prints and colour-blind readers. Errors: kIo as Canvas; kUsage when it is too large
/// or a panel has another number of tiles.
Result<Canvas> drawTileMap(const TileMap& map);

}  // namespace fulbito
