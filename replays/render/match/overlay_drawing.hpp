#pragma once

#include "replays/render/colours/match_style.hpp"
#include "replays/render/field/field_view.hpp"
#include "replays/render/match/match_plan.hpp"

namespace fulbito {

/// The style of a body's trail.
struct TrailLook {
  double first, last;  ///< thickness at the old end of the trail and at the body [m]
  Colour colour;       ///< colour at the body
};
TrailLook lookOf(const RecordedBody& body, const MatchPictureSpec& spec);

/// Draws trails; those of balls lie above those of robots.
void drawTrails(const FieldView& view, const MatchPictureSpec& spec, const std::vector<BodyTrail>& trails);
/// Draws the debug drawings of the teams in their colours, or in a trial those of its navigator.
void drawDrawings(const FieldView& view, const MatchPlan& plan, const MatchPictureSpec& spec,
                  std::span<const RecordedDrawing> drawings);
/// The colour of a drawing.
Colour inkOf(const RecordedDrawing& drawing, const MatchPictureSpec& spec);
/// The words of a drawing as the picture shows them.
struct DrawnWords {
  std::string text;  ///< cut to a share of the picture's width
  Vec2 centre;       ///< [px] their middle: moved into the picture, so that no edge cuts them
  double size;       ///< [px]
};
DrawnWords wordsOf(const FieldView& view, const MatchPlan& plan, const RecordedDrawing& drawing);
/// Draws a banner on a plate over the upper part of the field.
void drawBanner(Canvas& canvas, const MatchPlan& plan, const MatchBanner& banner, const MatchStyle& style);

}  // namespace fulbito
