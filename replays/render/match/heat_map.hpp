#pragma once

#include <string>
#include <vector>

#include "replays/render/match/match_picture.hpp"
#include "replays/timeline.hpp"

namespace fulbito {

/// Bodies and time range of a heat map.
struct HeatMapChoice {
  std::vector<std::size_t> bodies;  ///< indices in the recording's header
  std::string label;                ///< "the ball", "libero"
  double from = 0.0, to = 0.0;      ///< [s] of the recording
};

/// The time that the bodies spent at each place during play, in seconds per square decimetre, smoothed over
/// 2.5 cm. Halves are turned so that blue attacks to the right. Errors: as MatchPicture::create.
Result<Canvas> drawHeatMap(const ReplayTimeline& timeline, const MatchPictureSpec& spec,
                           const HeatMapChoice& choice);

}  // namespace fulbito
