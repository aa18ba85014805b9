#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "fulbito/detail/vec2.hpp"

namespace fulbito {

/// The coverage of each pixel by a shape. It is collected from several pieces and painted once, so that
/// translucent colours do not add up where pieces overlap. Edges are anti-aliased by the distance of the
/// pixel's centre to the shape's edge, which SDL's software renderer cannot do. Coordinates are pixels, y
/// down. Pieces that are not finite or more than 1e6 pixels away are left out.
class CoverageMask {
 public:
  CoverageMask(int width, int height);

  void addRectangle(Vec2 corner, double width, double height);
  void addDisc(Vec2 centre, double radius);
  void addRing(Vec2 centre, double radius, double thickness);
  /// A straight stroke with round ends.
  void addStroke(Vec2 a, Vec2 b, double thickness);
  /// One end of a stroke whose thickness and opacity change along its length.
  struct TaperEnd {
    Vec2 place;
    double thickness = 0.0;
    double share = 1.0;  ///< opacity 0...1 of the stroke
  };
  void addTaper(const TaperEnd& a, const TaperEnd& b);
  /// A simple polygon (no crossing edges), convex or not.
  void addPolygon(std::span<const Vec2> points);
  /// A convex polygon of up to 16 corners, clockwise or counterclockwise.
  void addConvex(std::span<const Vec2> points);

  /// Calls `paint(x, y, coverage)` with coverage 1...255 for each covered pixel and empties the mask.
  template <typename Paint>
  void drain(Paint paint) {
    for (int y = dirty_.top; y < dirty_.bottom; ++y) {
      for (int x = dirty_.left; x < dirty_.right; ++x) {
        std::uint8_t& covered = at(x, y);
        if (covered != 0) paint(x, y, covered);
        covered = 0;
      }
    }
    dirty_ = {width_, height_, 0, 0};
  }

 private:
  struct Box {
    int left, top, right, bottom;  // right and bottom are one past the end
  };

  /// A pixel's centre is dot(inward, centre) + offset - 0.5 pixels inside of the edge.
  struct ConvexEdge {
    Vec2 inward;
    double offset;
  };

  void addConvexRow(int y, const Box& box, std::span<const ConvexEdge> edges);
  std::uint8_t& at(int x, int y) {
    return covered_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                    static_cast<std::size_t>(x)];
  }
  /// The pixels between two corners with a margin, clipped to the picture. Also extends the area that `drain`
  /// visits.
  Box touch(Vec2 low, Vec2 high, double margin);
  template <typename Coverage>
  void add(Box box, Coverage coverage);
  void addShortStroke(Vec2 a, Vec2 b, double thickness);

  int width_;
  int height_;
  Box dirty_;
  std::vector<std::uint8_t> covered_;
};

}  // namespace fulbito
