#pragma once

#include "fulbito/match.hpp"
#include "fulbito/picture.hpp"

namespace fulbito {

/// Draws the present moment of a match.
class MatchPainter {
 public:
  /// @param width  [px]. Errors: as `MatchPicture::create`.
  static Result<MatchPainter> create(const MatchConfig& config, int width);

  int width() const { return picture_.spec().width; }
  /// Errors: as `MatchPicture::canvas`.
  Result<Canvas> draw(const Match& match) const;

 private:
  explicit MatchPainter(MatchPicture picture) : picture_(std::move(picture)) {}

  MatchPicture picture_;
};

}  // namespace fulbito
