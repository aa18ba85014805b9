#pragma once

#include <string>

#include "replays/render/match/match_picture.hpp"

namespace fulbito {

/// One moment as an SVG 1.1 picture: what MatchPicture draws, at any size. Names of any kind are safe in it.
/// Errors: as MatchPicture::create.
Result<std::string> matchSvg(const MatchPictureSpec& spec, const ReplayMoment& moment,
                             const MatchOverlays& overlays = {});

}  // namespace fulbito
