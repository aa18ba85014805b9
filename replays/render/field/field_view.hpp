#pragma once

#include "fulbito/detail/canvas.hpp"

namespace fulbito {

/// Where world coordinates land on a canvas, and how large letters and strokes are there.
struct FieldView {
  Canvas& canvas;
  Vec2 centre;  ///< [px] of the field's centre
  double pixels_per_metre;
  double unit;  ///< [px] of one typographic unit: text is 14 of them high

  Vec2 at(Vec2 world) const {
    return {centre.x + world.x * pixels_per_metre, centre.y - world.y * pixels_per_metre};
  }
  double px(double metres) const { return metres * pixels_per_metre; }
};

}  // namespace fulbito
