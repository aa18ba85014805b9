#include <algorithm>

#include <fmt/format.h>

#include "engine/core/base/match_clock.hpp"
#include "engine/core/base/xml_text.hpp"
#include "fulbito/picture.hpp"
#include "replays/render/canvas/text_fit.hpp"
#include "replays/render/colours/match_style.hpp"
#include "replays/render/colours/palette.hpp"
#include "replays/render/field/field_drawing.hpp"
#include "replays/render/match/body_drawing.hpp"
#include "replays/render/match/match_plan.hpp"
#include "replays/render/match/overlay_drawing.hpp"
#include "replays/render/match/score_board.hpp"
#include "replays/render/match/svg_field.hpp"
#include "replays/render/match/svg_trail.hpp"

namespace fulbito {
namespace {

/// Writes one picture as SVG. A temporary canvas measures the texts.
class SvgScene {
 public:
  SvgScene(const MatchPictureSpec& spec, Canvas& measure)
      : spec_(spec), style_(styleOf(spec.theme)), plan_(planOf(spec)), view_(plan_.view(measure)) {}

  std::string draw(const ReplayMoment& moment, const MatchOverlays& overlays) {
    svg_.raw(
        fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" version=\"1.1\" width=\"{0}\" height=\"{1}\" "
                    "viewBox=\"0 0 {0} {1}\" font-family=\"DejaVu Sans, Verdana, sans-serif\">",
                    spec_.width, spec_.height));
    svg_.raw(fmt::format("<title>{} {} : {} {}, {}</title>", escapedXml(spec_.names[0]), moment.score[0],
                         moment.score[1], escapedXml(spec_.names[1]), clockText(moment.play_seconds)));
    svg_.rectangle({0, 0}, plan_.width, plan_.height, style_.page);
    field(moment.blue_side);
    for (const BodyTrail& path : overlays.trails) trail(path);
    for (const RecordedDrawing& drawn : overlays.drawings) drawing(drawn);
    bodies(moment);
    board(moment);
    banner(overlays.banner);
    svg_.raw("</svg>");
    return svg_.str();
  }

 private:
  void field(Side blue_side) {
    FieldColours colours = style_.field;
    if (!spec_.layout) {
      const TeamId left = blue_side == Side::kLeft ? TeamId::kBlue : TeamId::kYellow;
      colours.left_goal = style_.teams[indexOf(left)].goal;
      colours.right_goal = style_.teams[indexOf(other(left))].goal;
    }
    svgField(svg_, plan_, spec_.field, colours);
    if (!spec_.layout) return;
    const Vec2 goal = pixelOf(plan_, spec_.layout->goal);
    svg_.ring(goal, view_.px(spec_.layout->goal_tolerance), 1.6 * plan_.unit, style_.text);
    svg_.circle(goal, 3.2 * plan_.unit, style_.text);
  }

  void trail(const BodyTrail& path) {
    if (path.body >= spec_.bodies.size()) return;
    const RecordedBody& body = spec_.bodies[path.body];
    std::vector<Vec2> points;
    points.reserve(path.points.size());
    for (const Vec2 p : path.points) points.push_back(pixelOf(plan_, p));
    const TrailLook look = lookOf(body, spec_);
    if (path.fading)
      return svgFadingLine(svg_, points, view_.px(look.first), view_.px(look.last), look.colour);
    svg_.polyline(points, 2.0 * plan_.unit, look.colour);
  }

  void mark(Vec2 centre, double size, TeamId team, Colour colour) {
    if (team == TeamId::kBlue) return svg_.circle(centre, size, colour);
    const Vec2 x{size, 0}, y{0, size};
    svg_.polygon(std::array<Vec2, 4>{centre + x, centre + y, centre - x, centre - y}, colour);
  }

  void robot(const Pose2& pose, std::optional<RobotId> id) {
    const TeamColours& colours = coloursOf(id, style_);
    const RobotShape shape = shapeOf(view_, spec_.robot, pose);
    svg_.polygon(shape.shadow, style_.shadow);
    svg_.polygon(shape.edge, colours.edge);
    svg_.polygon(shape.body, colours.body);
    for (const auto& wheel : shape.wheels) svg_.polygon(wheel, style_.wheel);
    svg_.polygon(shape.nose, colours.nose);
    if (!id) return;
    mark(shape.badge, shape.badge_size * markFactor(id->team), id->team, colours.badge);
    svg_.text(shape.badge + Vec2{0.0, kDigitDrop * shape.digit_size}, std::to_string(id->number),
              {shape.digit_size, colours.digit, TextAlign::kCentre, true});
  }

  void obstacle(const ObstacleSpec& shape, const Pose2& pose) {
    const Colour colour = obstacleColour(shape);
    if (shape.shape == ObstacleShape::kDisc) {
      return svg_.circle(pixelOf(plan_, pose.position), view_.px(shape.radius), colour);
    }
    std::array<Vec2, 4> corners = bodyCorners(pose, shape.length, shape.width);
    for (Vec2& p : corners) p = pixelOf(plan_, p);
    svg_.polygon(corners, colour);
  }

  void bodies(const ReplayMoment& moment) {
    const std::size_t count = std::min(spec_.bodies.size(), moment.bodies.size());
    std::size_t obstacles = 0;
    for (std::size_t i = 0; i < count; ++i) {
      if (spec_.bodies[i].kind != BodyKind::kObstacle || !spec_.layout) continue;
      if (obstacles >= spec_.layout->obstacles.size()) break;
      const ObstacleSpec& shape = spec_.layout->obstacles[obstacles++];
      if (moment.bodies[i]) obstacle(shape, *moment.bodies[i]);
    }
    for (std::size_t i = 0; i < count; ++i) {
      if (spec_.bodies[i].kind == BodyKind::kRobot && moment.bodies[i])
        robot(*moment.bodies[i], spec_.bodies[i].id);
    }
    for (std::size_t i = 0; i < count; ++i) {
      if (spec_.bodies[i].kind != BodyKind::kBall || !moment.bodies[i]) continue;
      const Vec2 centre = pixelOf(plan_, moment.bodies[i]->position);
      const double r = std::max(2.0, view_.px(spec_.ball.radius));
      svg_.circle(centre, r, style_.ball_edge);
      svg_.circle(centre, 0.9 * r, style_.ball);
      svg_.circle(centre - Vec2{0.28, 0.3} * r, 0.26 * r, style_.ball_light);
    }
  }

  void drawing(const RecordedDrawing& drawn) {
    const Colour colour = inkOf(drawn, spec_);
    const Vec2 from = pixelOf(plan_, drawn.from);
    const double thickness = 1.6 * plan_.unit;
    if (drawn.kind == RecordedDrawing::Kind::kLine) {
      svg_.polyline(std::array<Vec2, 2>{from, pixelOf(plan_, drawn.to)}, thickness, colour);
    } else if (drawn.kind == RecordedDrawing::Kind::kCircle) {
      svg_.ring(from, view_.px(drawn.radius), thickness, colour);
    }
    const DrawnWords words = wordsOf(view_, plan_, drawn);
    svg_.text(words.centre + Vec2{0.0, 0.33 * words.size}, words.text,
              {words.size, colour, TextAlign::kCentre, false});
  }

  void board(const ReplayMoment& moment) {
    const double u = plan_.unit, y = plan_.board / 2, name = plan_.text(26), room = 0.26 * plan_.width;
    svg_.rectangle({0, 0}, plan_.width, plan_.board, style_.panel);
    const bool match = !spec_.layout;
    for (const TeamId team : kTeams) {
      const bool blue = team == TeamId::kBlue;
      const double edge = blue ? 22 * u : plan_.width - 22 * u, side = blue ? 1.0 : -1.0, size = 11 * u;
      if (match)
        mark({edge + side * size, y}, size * (blue ? 1.0 : 1.2), team, style_.teams[indexOf(team)].body);
      const std::string text = fitted(view_.canvas, spec_.names[indexOf(team)], name, room);
      svg_.text({edge + side * (match ? 3.2 * size : 0.0), y + 0.36 * name}, text,
                {name, style_.text, blue ? TextAlign::kLeft : TextAlign::kRight, true});
    }
    const double middle = plan_.width / 2, clock = plan_.text(15), score = plan_.text(42);
    const std::string foot =
        match ? periodName(moment.period) + "  " + clockText(moment.play_seconds) : std::string();
    const std::string head = match ? fmt::format("{} : {}", moment.score[0], moment.score[1])
                                   : fmt::format("{:.2f} s", moment.play_seconds);
    svg_.text({middle, plan_.board * 0.56}, head, {score, style_.text, TextAlign::kCentre, true});
    svg_.text({middle, plan_.board * 0.87}, foot, {clock, style_.dim_text, TextAlign::kCentre, false});
  }

  void banner(const MatchBanner& call) {
    if (call.title.empty()) return;
    const double u = plan_.unit, size = plan_.text(18), height = 38 * u;
    const std::string text = call.detail.empty() ? call.title : call.title + "  " + call.detail;
    const std::string shown = fitted(view_.canvas, text, size, 0.6 * plan_.width);
    const double width =
        view_.canvas.labelWidth(shown, {size, style_.text, TextAlign::kLeft, true}) + 3 * height;
    const Vec2 centre{plan_.width / 2, plan_.board + plan_.margin + 1.4 * height};
    const Vec2 half{(width - height) / 2, 0};
    svg_.polyline(std::array<Vec2, 2>{centre - half, centre + half}, height, style_.banner);
    if (call.team) {
      mark(centre - half, 0.24 * height, *call.team, style_.teams[indexOf(*call.team)].body);
    }
    svg_.text(centre + Vec2{call.team ? 0.3 * height : 0.0, 0.36 * size}, shown,
              {size, style_.text, TextAlign::kCentre, true});
  }

  const MatchPictureSpec& spec_;
  const MatchStyle& style_;
  const MatchPlan plan_;
  const FieldView view_;
  SvgText svg_;
};

}  // namespace

Result<std::string> matchSvg(const MatchPictureSpec& wanted, const ReplayMoment& moment,
                             const MatchOverlays& overlays) {
  auto picture = MatchPicture::create(wanted);  // checks the spec and fills in its size
  if (!picture) return tl::unexpected<Error>(picture.error());
  auto measure = Canvas::create(1, 1, {});
  if (!measure) return tl::unexpected<Error>(measure.error());
  return SvgScene(picture->spec(), *measure).draw(moment, overlays);
}

}  // namespace fulbito
