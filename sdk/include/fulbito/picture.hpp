// Pictures as PNG or SVG: moments of recorded matches, heat maps, paths on a field. Drawn without a screen.
// Component `picture`.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "fulbito/detail/canvas.hpp"
#include "fulbito/detail/field_geometry.hpp"
#include "fulbito/detail/layout.hpp"
#include "fulbito/models.hpp"
#include "fulbito/recording.hpp"

namespace fulbito {

/// One robot's way across the field, for a picture.
struct DrawnPath {
  std::string label;               ///< legend, e.g. "bezier"
  std::string remark;              ///< legend, e.g. "1.94 s, 1.68 m" or "collided"
  std::vector<Vec2> points;        ///< [m] real positions, tick by tick
  std::vector<Pose2> footprints;   ///< poses at which the body is outlined, may be empty
  bool failed = false;             ///< drawn dashed, with a cross at its end unless it `arrived`
  bool arrived = false;            ///< a failed one that came to the goal all the same: no cross there
  std::vector<Vec2> touches = {};  ///< [m] where it touched something; each gets a mark
  std::optional<std::size_t> colour = std::nullopt;  ///< of seriesColour; its own place unless given
  bool hollow = false;  ///< drawn with a dark core: of two paths of one colour the other variant
};

/// Arrows of a heading field.
struct FieldArrows {
  std::string label;          ///< legend
  double length = 0.02;       ///< [m] of each
  std::vector<Pose2> places;  ///< their middles
};

/// A part of the field.
struct FieldWindow {
  Vec2 low, high;  ///< [m] its lower left and upper right corner
};

/// Field, obstacles (moving ones with their path), start, goal, paths and a legend.
struct FieldPicture {
  std::string title;                  ///< in one line
  std::string caption;                ///< below the title, in as many lines as it needs; may be empty
  FieldGeometry field;                ///< that is drawn
  RobotModel robot;                   ///< for outlines of its body
  Layout layout;                      ///< start, goal and obstacles
  std::vector<DrawnPath> paths;       ///< in the order of the legend
  FieldArrows arrows;                 ///< of a heading field, may be empty
  std::optional<FieldWindow> window;  ///< only this part is shown; else the whole field
  int pixels_per_metre = 600;         ///< scale
};

/// Draws it, larger than what it shows of the field: with a header, a scale bar and a legend that is as tall
/// as it needs. Paths that leave the field are cut at its outer edge. Errors: kIo as Canvas; kBadInput for an
/// inconsistent field; kUsage when `pixels_per_metre` is below 1 or makes the picture too large, or for an
/// empty window.
Result<Canvas> drawFieldPicture(const FieldPicture& picture);

/// The constant part of all pictures of a match or trial.
struct MatchPictureSpec {
  int width = 900;                           ///< [px]
  int height = 0;                            ///< [px] 0: as high as the field needs at that width
  PictureTheme theme = PictureTheme::kDark;  ///< dark or light
  FieldGeometry field;                       ///< that is drawn
  RobotModel robot;                          ///< its size
  BallModel ball;                            ///< its size
  std::vector<RecordedBody> bodies;          ///< as in a recording's header
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
  MatchBanner banner;                         ///< the referee's call
  std::vector<BodyTrail> trails;              ///< where bodies came from
  std::span<const RecordedDrawing> drawings;  ///< what teams drew; must stay valid during the call
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
  /// One that was moved from can only be destroyed or assigned to.
  MatchPicture(MatchPicture&&) noexcept;
  MatchPicture& operator=(MatchPicture&&) noexcept;
  ~MatchPicture();

  /// What it was made from.
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

/// One moment as an SVG 1.1 picture: what MatchPicture draws, at any size. Names of any kind are safe in it.
/// Errors: as MatchPicture::create.
Result<std::string> matchSvg(const MatchPictureSpec& spec, const ReplayMoment& moment,
                             const MatchOverlays& overlays = {});

/// The picture specification of a recording: field, robot, ball, names and goals. Size and theme are left
/// at their defaults. Errors: kBadInput when the recording's own texts do not parse.
Result<MatchPictureSpec> pictureSpecOf(const ReplayTimeline& timeline);

/// The wanted overlays.
struct OverlayChoice {
  bool banner = true;          ///< the referee's call
  bool drawings = true;        ///< what teams drew
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
