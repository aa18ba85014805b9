#include "replays/render/field/tile_map.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "replays/render/canvas/text_wrap.hpp"

namespace fulbito {
namespace {

constexpr Colour kPaper{252, 252, 250}, kInk{30, 35, 42}, kDimInk{88, 97, 108};
constexpr Colour kEmpty{232, 234, 236}, kPale{244, 245, 245}, kBarGround{214, 218, 222};
constexpr Colour kMark{178, 34, 52}, kWhite{255, 255, 255};
// The darkest colours of the two scales, for negative and positive ratios.
constexpr Colour kLess{8, 48, 107}, kMore{140, 45, 4};
constexpr double kMost = 0.5;  // absolute ratio at the ends of the scales

// Sizes of the map's parts [px].
constexpr double kMargin = 36, kTileWidth = 84, kTileHeight = 52, kTileGap = 3, kBar = 7;
constexpr double kRowLabel = 84, kPanelTitle = 30, kColumnLabel = 44, kPanelGap = 34;
constexpr double kTitleText = 24, kText = 14, kLine = 20, kFigure = 14, kSmallFigure = 11;
constexpr double kKeyTile = 40, kScaleWidth = 420, kScaleHeight = 14;
constexpr std::size_t kPanelsPerRow = 2;

/// Layout of the map [px].
struct Plan {
  std::vector<std::string> caption;
  double panel_width, panel_height, top, key_top, width, height;

  Vec2 panel(std::size_t index) const {
    const auto column = static_cast<double>(index % kPanelsPerRow);
    const std::size_t down = index / kPanelsPerRow;
    const auto row = static_cast<double>(down);
    return {kMargin + column * (panel_width + kPanelGap), top + row * panel_height};
  }
};

std::size_t keyRows(const TileKey& key) { return 5 + key.badges.size(); }

Plan makePlan(const Canvas& measure, const TileMap& map) {
  Plan plan;
  plan.panel_width = kRowLabel + static_cast<double>(map.columns.size()) * kTileWidth;
  plan.panel_height =
      kPanelTitle + static_cast<double>(map.rows.size()) * kTileHeight + kColumnLabel + kPanelGap;
  const double across =
      static_cast<double>(std::min(kPanelsPerRow, std::max<std::size_t>(map.panels.size(), 1)));
  plan.width = std::max(900.0, 2 * kMargin + across * plan.panel_width + (across - 1) * kPanelGap);
  plan.caption = wrapped(measure, map.caption, kText, plan.width - 2 * kMargin);
  plan.top = 66 + kLine * static_cast<double>(plan.caption.size()) + 18;
  const std::size_t down = (map.panels.size() + kPanelsPerRow - 1) / kPanelsPerRow;
  plan.key_top = plan.top + static_cast<double>(down) * plan.panel_height;
  plan.height = plan.key_top + 96 + kLine * 1.3 * static_cast<double>(keyRows(map.key)) + kMargin;
  return plan;
}

Colour mixed(Colour from, Colour to, double share) {
  const auto part = [share](std::uint8_t a, std::uint8_t b) {
    return static_cast<std::uint8_t>(std::lround(a + (b - a) * share));
  };
  return {part(from.r, to.r), part(from.g, to.g), part(from.b, to.b)};
}

Colour colourOf(double value) {
  const double share = std::clamp(std::abs(value) / kMost, 0.0, 1.0);
  return mixed(kWhite, value < 0.0 ? kLess : kMore, share);
}

Colour inkOn(Colour ground) {
  return 0.299 * ground.r + 0.587 * ground.g + 0.114 * ground.b < 140 ? kWhite : kInk;
}

/// A ratio as a whole percentage, without a sign for 0.
std::string figure(double value) {
  const long percent = std::lround(100.0 * value);
  return percent < 0 ? fmt::format("\u2212{}", -percent) : percent > 0 ? fmt::format("+{}", percent) : "0";
}

void drawHalf(Canvas& canvas, Vec2 corner, double width, double height, double value, double below,
              bool pale) {
  if (std::isnan(value)) {
    canvas.fillRectangle(corner, width, height, kEmpty);
    canvas.text(corner + Vec2{width / 2, height / 2 + 5}, "\u2013", kFigure, kDimInk, TextAlign::kCentre);
    return;
  }
  const Colour ground = pale ? kPale : colourOf(value), ink = pale ? kDimInk : inkOn(ground);
  canvas.fillRectangle(corner, width, height, ground);
  const bool two = !std::isnan(below) && figure(below) != figure(value);
  canvas.text(corner + Vec2{width / 2, height / 2 + (two ? -1.0 : 5.0)}, figure(value), kFigure, ink,
              TextAlign::kCentre);
  if (two)
    canvas.text(corner + Vec2{width / 2, height / 2 + 15}, figure(below), kSmallFigure, ink,
                TextAlign::kCentre);
}

void drawBadge(Canvas& canvas, Vec2 centre, const std::string& letter) {
  canvas.fillCircle(centre, 9.5, kPaper);
  canvas.fillCircle(centre, 8.5, kMark);
  canvas.text(centre + Vec2{0, 4}, letter, 11, kWhite, TextAlign::kCentre);
}

void drawTile(Canvas& canvas, Vec2 corner, const MapTile& tile) {
  const double width = kTileWidth - kTileGap, height = kTileHeight - kTileGap;
  const double half = width / 2;
  drawHalf(canvas, corner, half - 0.5, height - kBar, tile.left, tile.left_below, tile.pale);
  drawHalf(canvas, corner + Vec2{half + 0.5, 0}, half - 0.5, height - kBar, tile.right, tile.right_below,
           tile.pale);
  const Vec2 bar = corner + Vec2{0, height - kBar + 1};
  canvas.fillRectangle(bar, width, kBar - 1, kBarGround);
  canvas.fillRectangle(bar, width * std::clamp(tile.share, 0.0, 1.0), kBar - 1, kInk);
  canvas.fillRectangle(bar + Vec2{half - 0.5, 0}, 1, kBar - 1, tile.share > 0.5 ? kPaper : kInk);
  if (tile.framed) {
    for (const auto& [from, w, h] : {std::tuple{corner - Vec2{2, 2}, width + 4, 3.0},
                                     std::tuple{corner + Vec2{-2, height - 1}, width + 4, 3.0},
                                     std::tuple{corner - Vec2{2, 2}, 3.0, height + 4},
                                     std::tuple{corner + Vec2{width - 1, -2}, 3.0, height + 4}}) {
      canvas.fillRectangle(from, w, h, kMark);
    }
  }
}

void drawPanel(Canvas& canvas, const Plan& plan, const TileMap& map, std::size_t index) {
  const TilePanel& panel = map.panels[index];
  const Vec2 corner = plan.panel(index), tiles = corner + Vec2{kRowLabel, kPanelTitle};
  canvas.text(corner + Vec2{kRowLabel, 18}, panel.title, 16, kInk);
  const auto at = [&](std::size_t row, std::size_t column) {
    return tiles + Vec2{static_cast<double>(column) * kTileWidth, static_cast<double>(row) * kTileHeight};
  };
  for (std::size_t r = 0; r < map.rows.size(); ++r) {
    canvas.text(at(r, 0) + Vec2{-8, kTileHeight / 2 + 3}, map.rows[r], kText, kInk, TextAlign::kRight);
    for (std::size_t c = 0; c < map.columns.size(); ++c) {
      drawTile(canvas, at(r, c), panel.tiles[r * map.columns.size() + c]);
    }
  }
  for (std::size_t c = 0; c < map.columns.size(); ++c) {
    canvas.text(at(map.rows.size(), c) + Vec2{kTileWidth / 2, 14}, map.columns[c], kText, kInk,
                TextAlign::kCentre);
  }
  canvas.text(at(map.rows.size(), 0) + Vec2{0, 34}, map.column_axis, 13, kDimInk);
  canvas.text(corner + Vec2{kRowLabel - 8, 18}, map.row_axis, 13, kDimInk, TextAlign::kRight);
  for (std::size_t i = 0; i < panel.tiles.size(); ++i) {  // badges are drawn after, and so above, all frames
    const MapTile& tile = panel.tiles[i];
    if (tile.badge.empty()) continue;
    for (std::size_t letter = 0; letter < tile.badge.size(); ++letter) {
      drawBadge(canvas,
                at(i / map.columns.size(), i % map.columns.size()) +
                    Vec2{4 + 18.0 * static_cast<double>(letter), 3},
                std::string(1, tile.badge[letter]));
    }
  }
}

void drawScale(Canvas& canvas, Vec2 corner) {
  for (int x = 0; x < static_cast<int>(kScaleWidth); ++x) {
    const double value = kMost * (2.0 * (x + 0.5) / kScaleWidth - 1.0);
    canvas.fillRectangle(corner + Vec2{static_cast<double>(x), 0}, 1, kScaleHeight, colourOf(value));
  }
  for (double value : {-kMost, -kMost / 2, 0.0, kMost / 2, kMost}) {
    const double x = (value / kMost + 1.0) / 2.0 * kScaleWidth;
    canvas.fillRectangle(corner + Vec2{x - 0.5, kScaleHeight}, 1, 5, kInk);
    canvas.text(corner + Vec2{x, kScaleHeight + 19}, figure(value) + " %", 13, kInk, TextAlign::kCentre);
  }
}

void drawKey(Canvas& canvas, const Plan& plan, const TileMap& map) {
  const Vec2 corner{kMargin + 10, plan.key_top};
  drawScale(canvas, corner + Vec2{14, 0});
  Vec2 pen = corner + Vec2{0, 74};
  const double text = kKeyTile + kTileWidth;
  const auto row = [&](const std::string& label) {
    canvas.text(pen + Vec2{text, 5}, label, kText, kInk);
    pen.y += 1.3 * kLine;
  };
  MapTile sample;
  sample.left = -0.19, sample.right = -0.31, sample.left_below = -0.21, sample.right_below = -0.38;
  sample.share = 0.76;
  drawTile(canvas, pen + Vec2{10, 4}, sample);
  row(fmt::format("left half: {}; right half: {} [%]", map.key.left, map.key.right));
  row(map.key.below);
  row(map.key.share);
  canvas.fillRectangle(pen + Vec2{10, -9}, kTileWidth - kTileGap, 16, kPale);
  canvas.text(pen + Vec2{10 + kTileWidth / 2, 4}, "\u221212", 12, kDimInk, TextAlign::kCentre);
  row(map.key.pale);
  canvas.fillRectangle(pen + Vec2{10, -9}, kTileWidth - kTileGap, 16, kMark);
  canvas.fillRectangle(pen + Vec2{13, -6}, kTileWidth - kTileGap - 6, 10, kPaper);
  row(map.key.framed);
  for (const auto& [letter, meaning] : map.key.badges) {
    drawBadge(canvas, pen + Vec2{10 + kTileWidth / 2, 0}, letter);
    row(meaning);
  }
}

}  // namespace

Result<Canvas> drawTileMap(const TileMap& map) {
  for (const TilePanel& panel : map.panels) {
    if (panel.tiles.size() != map.rows.size() * map.columns.size()) {
      return fail(ErrorCode::kUsage,
                  fmt::format("panel '{}' has {} tiles for {} rows and {} columns", panel.title,
                              panel.tiles.size(), map.rows.size(), map.columns.size()));
    }
  }
  const auto measure = Canvas::create(1, 1, kPaper);
  if (!measure) return tl::unexpected<Error>(measure.error());
  const Plan plan = makePlan(*measure, map);
  auto canvas = Canvas::create(static_cast<int>(std::min(plan.width, 1e6)),
                               static_cast<int>(std::min(plan.height, 1e6)), kPaper);
  if (!canvas) return canvas;
  canvas->text({kMargin, 46}, map.title, kTitleText, kInk);
  for (std::size_t i = 0; i < plan.caption.size(); ++i) {
    canvas->text({kMargin, 72 + kLine * static_cast<double>(i)}, plan.caption[i], kText, kDimInk);
  }
  for (std::size_t i = 0; i < map.panels.size(); ++i) drawPanel(*canvas, plan, map, i);
  drawKey(*canvas, plan, map);
  return canvas;
}

}  // namespace fulbito
