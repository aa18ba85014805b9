#pragma once

#include "replays/render/colours/match_style.hpp"
#include "replays/render/field/field_view.hpp"
#include "replays/render/match/match_plan.hpp"

namespace fulbito {

/// What the trail of a body looks like.
struct TrailLook {
  double first, last;  ///< [m] thickness at its old end and at the body
  Colour colour;       ///< at the body
};
TrailLook lookOf(const RecordedBody& body, const MatchPictureSpec& spec);

/// Trails of balls lie over those of robots.
void drawTrails(const FieldView& view, const MatchPictureSpec& spec, const std::vector<BodyTrail>& trails);
/// What the teams drew, in their colours; of a trial, what its navigator wanted.
void drawDrawings(const FieldView& view, const MatchPlan& plan, const MatchPictureSpec& spec,
                  std::span<const RecordedDrawing> drawings);
/// The colour of a drawing.
Colour inkOf(const RecordedDrawing& drawing, const MatchPictureSpec& spec);
/// A plate over the upper part of the field.
void drawBanner(Canvas& canvas, const MatchPlan& plan, const MatchBanner& banner, const MatchStyle& style);

}  // namespace fulbito
