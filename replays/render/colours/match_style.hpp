#pragma once

#include "fulbito/detail/canvas.hpp"
#include "fulbito/detail/values.hpp"
#include "replays/render/colours/palette.hpp"

namespace fulbito {

/// Colours of a team in one theme.
struct TeamColours {
  Colour body;   ///< robots, trails and marks
  Colour edge;   ///< edge around robots
  Colour badge;  ///< under a robot's number: a disc for blue, a diamond for yellow
  Colour digit;
  Colour nose;  ///< the mark at a robot's front
  Colour goal;  ///< floor of the goal that the team defends
  Colour ink;   ///< debug drawings of the team on the floor
};

/// All colours of a match picture.
struct MatchStyle {
  Colour page, panel, rule, text, dim_text;
  FieldColours field;
  PerTeam<TeamColours> teams;
  TeamColours lone;  ///< robot without a team, in a trial
  Colour ball, ball_edge, ball_light;
  Colour wheel, shadow;
  Colour banner;
};

const MatchStyle& styleOf(PictureTheme theme);

}  // namespace fulbito
