#pragma once

#include "fulbito/detail/field_geometry.hpp"
#include "fulbito/picture.hpp"
#include "replays/render/field/field_view.hpp"

namespace fulbito {

/// Layout of a match picture [px].
struct MatchPlan {
  double unit = 1.0;  ///< size of a typographic unit [px]; 1 at 900 x 780
  double width = 0.0, height = 0.0;
  double board = 0.0;  ///< height of the score board at the top
  double foot = 0.0;   ///< height of the time bar at the bottom
  double margin = 0.0;
  Vec2 centre;  ///< centre of the field
  double pixels_per_metre = 1.0;

  FieldView view(Canvas& canvas) const { return {canvas, centre, pixels_per_metre, unit}; }
  /// A text size [px] from units, large enough to be readable in a small picture.
  double text(double size) const;
};

MatchPlan planOf(const MatchPictureSpec& spec);

}  // namespace fulbito
