#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/core/models/ball_model.hpp"
#include "engine/core/models/field_geometry.hpp"
#include "engine/core/models/layout.hpp"
#include "engine/core/models/robot_model.hpp"
#include "replays/render/canvas/canvas.hpp"
#include "replays/render/colours/picture_theme.hpp"
#include "replays/timeline.hpp"

namespace fulbito {

/// The constant part of all pictures of a match or trial.
struct MatchPictureSpec {
  int width = 900;  ///< [px]
  int height = 0;   ///< [px] 0: as high as the field needs at that width
  PictureTheme theme = PictureTheme::kDark;
  FieldGeometry field;
  RobotModel robot;
  BallModel ball;
  std::vector<RecordedBody> bodies;  ///< as in a recording's header
  /// Of the teams; of a trial the first is its title and the second its remark.
  PerTeam<std::string> names;
  std::optional<Layout> layout;   ///< of a trial: its goal, and the shapes of its obstacles
  double seconds = 0.0;           ///< length of the bar of time at the foot; 0: no bar
  std::vector<ReplayGoal> goals;  ///< marks on that bar
};

/// A referee's call, shown over the field.
struct MatchBanner {
  std::string title;           ///< empty: no banner
  std::string detail;          ///< may be empty
  std::optional<TeamId> team;  ///< team whose colour it has
};

/// The trail of a body.
struct BodyTrail {
  std::size_t body = 0;      ///< index in `MatchPictureSpec::bodies`
  std::vector<Vec2> points;  ///< [m] oldest first
  bool fading = true;        ///< false: a thin line of one colour
  double strength = 1.0;     ///< 0...1 of such a line's opacity
};

/// Optional overlays.
struct MatchOverlays {
  MatchBanner banner;
  std::vector<BodyTrail> trails;
  std::span<const RecordedDrawing> drawings;
};

/// Height [px] of a picture of that width which the field fills.
int matchPictureHeight(const FieldGeometry& field, int width);

/// Draws the moments of a match or trial, whether recorded or being played: field, bodies with team mark,
/// number and heading, score board, clock, banner. The field is drawn once and copied for each picture.
/// Positions are drawn to fractions of a pixel; equal calls give equal pixels.
class MatchPicture {
 public:
  /// Errors: kBadInput for an inconsistent field, robot or ball; kUsage for a size out of 160 x 120 ...
  /// Canvas's limits; as Canvas::create.
  static Result<MatchPicture> create(const MatchPictureSpec& spec);
  MatchPicture(MatchPicture&&) noexcept;
  MatchPicture& operator=(MatchPicture&&) noexcept;
  ~MatchPicture();

  const MatchPictureSpec& spec() const;
  /// An empty canvas to draw on. Each thread needs its own. Errors: as Canvas::create.
  Result<Canvas> canvas() const;
  /// Draws a moment over all of `canvas`, which must come from `canvas()`.
  void drawFrame(Canvas& canvas, const ReplayMoment& moment, const MatchOverlays& overlays = {}) const;
  /// The place [m] of a pixel, for what a user points at.
  Vec2 toField(Vec2 pixel) const;
  /// Whether a pixel is on the bar of time, or near enough to mean it.
  bool onTimeBar(Vec2 pixel) const;
  /// The time [s] for which a column of the bar of time stands; beyond its ends: the nearest one.
  double toSeconds(double x) const;

 private:
  struct Impl;
  explicit MatchPicture(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace fulbito
