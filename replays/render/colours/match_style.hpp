#pragma once

#include "fulbito/detail/canvas.hpp"
#include "fulbito/detail/values.hpp"
#include "replays/render/colours/palette.hpp"

namespace fulbito {

/// Colours of a team in one theme.
struct TeamColours {
  Colour body;   ///< of robots, trails and marks
  Colour edge;   ///< around robots
  Colour badge;  ///< under a robot's number: a disc for blue, a diamond for yellow
  Colour digit;
  Colour nose;  ///< the mark at a robot's front
  Colour goal;  ///< floor of the goal that the team defends
  Colour ink;   ///< of what it draws on the floor
};

/// All colours of a match's picture.
struct MatchStyle {
  Colour page, panel, rule, text, dim_text;
  FieldColours field;
  PerTeam<TeamColours> teams;
  TeamColours lone;  ///< of a robot without a team: a trial's
  Colour ball, ball_edge, ball_light;
  Colour wheel, shadow;
  Colour banner;
};

const MatchStyle& styleOf(PictureTheme theme);

}  // namespace fulbito
