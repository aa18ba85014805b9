// Pictures as PNG or SVG: moments of recorded matches, heat maps, paths on a field. They need no screen.
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

/// One robot's path across the field, for a picture.
struct DrawnPath {
  std::string label;                                 ///< legend, e.g. "bezier"
  std::string remark;                                ///< legend, e.g. "1.94 s, 1.68 m" or "collided"
  std::vector<Vec2> points;                          ///< [m] true positions, one per tick
  std::vector<Pose2> footprints;                     ///< poses with an outline of the body; may be empty
  bool failed = false;                               ///< dashed, with a cross at its end unless it `arrived`
  bool arrived = false;                              ///< a failed path that reached the goal: no cross
  std::vector<Vec2> touches = {};                    ///< [m] contact points, each with a mark
  std::optional<std::size_t> colour = std::nullopt;  ///< index of seriesColour; default: its index in `paths`
  bool hollow = false;  ///< with a dark core, to distinguish two paths of one colour
};

/// Arrows of a heading field.
struct FieldArrows {
  std::string label;          ///< legend
  double length = 0.02;       ///< [m] length of each arrow
  std::vector<Pose2> places;  ///< middles and headings of the arrows
};

/// A part of the field.
struct FieldWindow {
  Vec2 low, high;  ///< [m] its lower left and upper right corners
};

/// Field, obstacles (moving ones with their path), start, goal, paths and a legend.
struct FieldPicture {
  std::string title;                  ///< one line
  std::string caption;                ///< below the title, as many lines as needed; may be empty
  FieldGeometry field;                ///< the field
  RobotModel robot;                   ///< for outlines of its body
  Layout layout;                      ///< start, goal and obstacles
  std::vector<DrawnPath> paths;       ///< in the order of the legend
  FieldArrows arrows;                 ///< arrows of a heading field; may be empty
  std::optional<FieldWindow> window;  ///< the visible part; empty: the whole field
  int pixels_per_metre = 600;         ///< scale
};

/// Draws the picture: the field, a header, a scale bar and a legend as tall as needed. The outer edge of the
/// field cuts paths that leave it. Errors: kIo as Canvas; kBadInput for an inconsistent field; kUsage for an
/// empty window, or for a `pixels_per_metre` below 1 or with too large a picture.
Result<Canvas> drawFieldPicture(const FieldPicture& picture);

/// The constant part of all pictures of a match or trial.
struct MatchPictureSpec {
  int width = 900;                           ///< [px]
  int height = 0;                            ///< [px] 0: the height that the field needs at that width
  PictureTheme theme = PictureTheme::kDark;  ///< dark or light
  FieldGeometry field;                       ///< the field
  RobotModel robot;                          ///< for the size of robots
  BallModel ball;                            ///< for the size of the ball
  std::vector<RecordedBody> bodies;          ///< as in a recording's header
  /// Names of the teams; for a trial, its title and its remark.
  PerTeam<std::string> names;
  std::optional<Layout> layout;   ///< for a trial: its goal, and the shapes of its obstacles
  double seconds = 0.0;           ///< [s] length of the time bar at the bottom; 0: no bar
  std::vector<ReplayGoal> goals;  ///< marks on that bar
};

/// A referee's call, shown over the field.
struct MatchBanner {
  std::string title;           ///< empty: no banner
  std::string detail;          ///< may be empty
  std::optional<TeamId> team;  ///< the team that gives its colour
};

/// The trail of a body.
struct BodyTrail {
  std::size_t body = 0;      ///< index in `MatchPictureSpec::bodies`
  std::vector<Vec2> points;  ///< [m] oldest first
  bool fading = true;        ///< false: a thin line of one colour
  double strength = 1.0;     ///< opacity of such a line, 0 ... 1
};

/// Optional overlays.
struct MatchOverlays {
  MatchBanner banner;                         ///< the referee's call
  std::vector<BodyTrail> trails;              ///< trails of the bodies
  std::span<const RecordedDrawing> drawings;  ///< drawings of the teams; must stay valid during the call
};

/// Height [px] at which the field fills a picture of that width.
int matchPictureHeight(const FieldGeometry& field, int width);

/// Draws moments of a recorded or live match or trial: field, bodies with team mark, number and heading,
/// score board, clock, banner. It draws the field once and copies it to each picture. Positions are exact to
/// fractions of a pixel; equal calls give equal pixels.
class MatchPicture {
 public:
  /// Errors: kBadInput for an inconsistent field, robot or ball; kUsage for a size out of 160 x 120 ...
  /// Canvas's limits; as Canvas::create.
  static Result<MatchPicture> create(const MatchPictureSpec& spec);
  /// A moved-from picture can only be destroyed or assigned to.
  MatchPicture(MatchPicture&&) noexcept;
  MatchPicture& operator=(MatchPicture&&) noexcept;
  ~MatchPicture();

  /// The specification given to `create`.
  const MatchPictureSpec& spec() const;
  /// An empty canvas to draw on. Each thread needs its own. Errors: as Canvas::create.
  Result<Canvas> canvas() const;
  /// Draws a moment over all of `canvas`, which must come from `canvas()`.
  void drawFrame(Canvas& canvas, const ReplayMoment& moment, const MatchOverlays& overlays = {}) const;
  /// The position [m] on the field under a pixel, for mouse input.
  Vec2 toField(Vec2 pixel) const;
  /// Whether a pixel is on the time bar, or close enough for a click on it.
  bool onTimeBar(Vec2 pixel) const;
  /// The time [s] of a column of the time bar, clamped to its ends.
  double toSeconds(double x) const;

 private:
  struct Impl;
  explicit MatchPicture(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

/// One moment as an SVG 1.1 picture: the same content as MatchPicture, at any size. Names may contain any
/// characters. Errors: as MatchPicture::create.
Result<std::string> matchSvg(const MatchPictureSpec& spec, const ReplayMoment& moment,
                             const MatchOverlays& overlays = {});

/// The picture specification of a recording: field, robot, ball, names and goals. Size and theme keep their
/// defaults. Errors: kBadInput if the recording's own texts do not parse.
Result<MatchPictureSpec> pictureSpecOf(const ReplayTimeline& timeline);

/// The wanted overlays.
struct OverlayChoice {
  bool banner = true;          ///< the referee's call
  bool drawings = true;        ///< drawings of the teams
  double trail_seconds = 1.0;  ///< [s] length of trails; 0: no trails
};

/// Finds the overlays for each moment of a recording: the referee's call, trails, drawings.
class ReplayDirector {
 public:
  /// Keeps a reference to `timeline`, which must outlive the director.
  ReplayDirector(const ReplayTimeline& timeline, OverlayChoice choice)
      : timeline_(&timeline), choice_(choice) {}

  /// Fills `overlays` for the moment and reuses its memory.
  void direct(const ReplayMoment& moment, MatchOverlays& overlays);

 private:
  void addTrails(const ReplayMoment& moment, MatchOverlays& overlays);

  const ReplayTimeline* timeline_;
  OverlayChoice choice_;
  ReplayMoment scratch_;
};

/// The paths of robots and balls between two times [s], with one line per body and play.
std::vector<BodyTrail> pathsBetween(const ReplayTimeline& timeline, double from, double to);

/// Small pictures of some times [s], four per row, on a canvas of the width of `spec`. Errors: as
/// MatchPicture::create.
Result<Canvas> drawContactSheet(const ReplayTimeline& timeline, const MatchPictureSpec& spec,
                                const std::vector<double>& times, OverlayChoice overlays);

/// The banner of a moment: the call of the last seconds, or that of the restart that waits for its signal.
MatchBanner bannerAt(const ReplayTimeline& timeline, const ReplayMoment& moment);

/// A call in words, e.g. "Penalty" and "ball stuck in the area", in the colour of the team that benefits (see
/// `CallWords`). Empty if the call needs no banner.
MatchBanner bannerOf(const RecordedEvent& event, const RecordingRecipe& recipe);
/// A restart in words, for restarts without a call; empty for a placed state.
MatchBanner bannerOf(const RecordedPlay& play, const RecordingRecipe& recipe);

/// Bodies and time range of a heat map.
struct HeatMapChoice {
  std::vector<std::size_t> bodies;  ///< indices in the recording's header
  std::string label;                ///< "the ball", "libero"
  double from = 0.0, to = 0.0;      ///< [s] of the recording
};

/// Draws the time of the bodies at each place during play, in seconds per square decimetre, smoothed over 2.5
/// cm. Halves are rotated so that blue attacks to the right. Errors: as MatchPicture::create.
Result<Canvas> drawHeatMap(const ReplayTimeline& timeline, const MatchPictureSpec& spec,
                           const HeatMapChoice& choice);

}  // namespace fulbito
