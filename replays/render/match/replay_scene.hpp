#pragma once

#include <string>

#include "replays/render/match/match_picture.hpp"
#include "replays/timeline.hpp"

namespace fulbito {

/// The picture specification of a recording: field, robot, ball, names and goals. Size and theme are left
/// at their defaults. Errors: kBadInput when the recording's own texts do not parse.
Result<MatchPictureSpec> pictureSpecOf(const ReplayTimeline& timeline);

/// The wanted overlays.
struct OverlayChoice {
  bool banner = true;
  bool drawings = true;
  double trail_seconds = 1.0;  ///< 0: no trails
};

/// Finds the overlays for each moment of a recording: the referee's call, trails, drawings.
class ReplayDirector {
 public:
  /// Refers to `timeline`.
  ReplayDirector(const ReplayTimeline& timeline, OverlayChoice choice)
      : timeline_(&timeline), choice_(choice) {}

  /// Fills `overlays` for the moment; its memory is used again.
  void direct(const ReplayMoment& moment, MatchOverlays& overlays);

 private:
  void addTrails(const ReplayMoment& moment, MatchOverlays& overlays);

  const ReplayTimeline* timeline_;
  OverlayChoice choice_;
  ReplayMoment scratch_;
};

/// The paths of robots and balls between two times [s]: a line per body and play.
std::vector<BodyTrail> pathsBetween(const ReplayTimeline& timeline, double from, double to);

/// Small pictures of some times [s] side by side, four in a row, on a canvas of the width of `spec`.
/// Errors: as MatchPicture::create.
Result<Canvas> drawContactSheet(const ReplayTimeline& timeline, const MatchPictureSpec& spec,
                                const std::vector<double>& times, OverlayChoice overlays);

/// The call to show at a moment: one of the last seconds, or the one that the restart waits for.
MatchBanner bannerAt(const ReplayTimeline& timeline, const ReplayMoment& moment);

/// A call in words, e.g. "Penalty" and "ball stuck in the area", in the colour of the team that gains by it
/// (see `CallWords`); empty if the call needs no banner.
MatchBanner bannerOf(const RecordedEvent& event, const RecordingRecipe& recipe);
/// A restart in words, for restarts without a call; empty for a placed state.
MatchBanner bannerOf(const RecordedPlay& play, const RecordingRecipe& recipe);

}  // namespace fulbito
