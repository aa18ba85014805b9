#pragma once

#include "fulbito/detail/field_geometry.hpp"
#include "fulbito/picture.hpp"
#include "replays/render/field/field_view.hpp"

namespace fulbito {

/// Where the parts of a match's picture stand [px].
struct MatchPlan {
  double unit = 1.0;  ///< [px] of a typographic unit: 1 at 900 x 780
  double width = 0.0, height = 0.0;
  double board = 0.0;  ///< height of the score board at the top
  double foot = 0.0;   ///< height of the bar of time at the bottom
  double margin = 0.0;
  Vec2 centre;  ///< of the field
  double pixels_per_metre = 1.0;

  FieldView view(Canvas& canvas) const { return {canvas, centre, pixels_per_metre, unit}; }
  /// Letters stay readable in a small picture.
  double text(double size) const;
};

MatchPlan planOf(const MatchPictureSpec& spec);

}  // namespace fulbito
