#pragma once

#include "fulbito/detail/canvas.hpp"

namespace fulbito {

/// Maps world coordinates to a canvas, and scales letters and strokes.
struct FieldView {
  Canvas& canvas;
  Vec2 centre;  ///< centre of the field [px]
  double pixels_per_metre;
  double unit;  ///< size of one typographic unit [px]; text is 14 units high

  Vec2 at(Vec2 world) const {
    return {centre.x + world.x * pixels_per_metre, centre.y - world.y * pixels_per_metre};
  }
  double px(double metres) const { return metres * pixels_per_metre; }
};

}  // namespace fulbito
