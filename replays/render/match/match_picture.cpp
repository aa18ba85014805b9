#include <algorithm>

#include "fulbito/picture.hpp"
#include "replays/render/field/field_drawing.hpp"
#include "replays/render/match/body_drawing.hpp"
#include "replays/render/match/match_plan.hpp"
#include "replays/render/match/overlay_drawing.hpp"
#include "replays/render/match/score_board.hpp"

namespace fulbito {
namespace {

constexpr int kLeastWidth = 160, kLeastHeight = 120;  // [px]

Result<void> check(const MatchPictureSpec& spec) {
  if (auto valid = validate(spec.field); !valid) return valid;
  if (auto valid = validate(spec.robot); !valid) return valid;
  if (auto valid = validate(spec.ball); !valid) return valid;
  if (spec.width < kLeastWidth || spec.height < kLeastHeight) {
    return fail(ErrorCode::kUsage, "a picture of a match must be at least " + std::to_string(kLeastWidth) +
                                       " x " + std::to_string(kLeastHeight) + " pixels, not " +
                                       std::to_string(spec.width) + " x " + std::to_string(spec.height));
  }
  return {};
}

}  // namespace

struct MatchPicture::Impl {
  Impl(MatchPictureSpec from, const MatchPlan& planned)
      : spec(std::move(from)), plan(planned), style(styleOf(spec.theme)) {}

  Result<Canvas> background(Side blue_side) const;
  void drawBodies(const FieldView& view, const ReplayMoment& moment) const;

  MatchPictureSpec spec;
  MatchPlan plan;
  const MatchStyle& style;
  /// By the side of blue, because the goals have the colours of their teams.
  std::vector<Canvas> backgrounds;
};

Result<Canvas> MatchPicture::Impl::background(Side blue_side) const {
  auto canvas = Canvas::create(spec.width, spec.height, style.page);
  if (!canvas) return canvas;
  FieldColours colours = style.field;
  const bool match = !spec.layout;
  const auto goal = [&](TeamId team) { return match ? style.teams[indexOf(team)].goal : colours.left_goal; };
  const TeamId left = blue_side == Side::kLeft ? TeamId::kBlue : TeamId::kYellow;
  const Colour left_goal = goal(left), right_goal = goal(other(left));
  colours.left_goal = left_goal;
  colours.right_goal = right_goal;
  const FieldView view = plan.view(*canvas);
  drawField(view, spec.field, colours);
  if (spec.layout) drawGoal(view, *spec.layout, style.text);
  drawBoard(*canvas, plan, spec, style);
  drawTimeBar(*canvas, plan, spec, style);
  return canvas;
}

void MatchPicture::Impl::drawBodies(const FieldView& view, const ReplayMoment& moment) const {
  const std::size_t count = std::min(moment.bodies.size(), spec.bodies.size());
  std::size_t obstacle = 0;
  for (std::size_t i = 0; i < count; ++i) {
    if (spec.bodies[i].kind != BodyKind::kObstacle || !spec.layout) continue;
    if (obstacle >= spec.layout->obstacles.size()) break;
    ObstacleSpec shape = spec.layout->obstacles[obstacle++];
    if (!moment.bodies[i]) continue;
    shape.pose = *moment.bodies[i];
    drawObstacleBody(view, shape);
  }
  for (std::size_t i = 0; i < count; ++i) {
    if (spec.bodies[i].kind != BodyKind::kRobot || !moment.bodies[i]) continue;
    drawRobot(view, spec.robot, *moment.bodies[i], spec.bodies[i].id, style);
  }
  for (std::size_t i = 0; i < count; ++i) {
    if (spec.bodies[i].kind != BodyKind::kBall || !moment.bodies[i]) continue;
    drawMatchBall(view, moment.bodies[i]->position, spec.ball.radius, style);
  }
}

MatchPicture::MatchPicture(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
MatchPicture::MatchPicture(MatchPicture&&) noexcept = default;
MatchPicture& MatchPicture::operator=(MatchPicture&&) noexcept = default;
MatchPicture::~MatchPicture() = default;

Result<MatchPicture> MatchPicture::create(const MatchPictureSpec& wanted) {
  MatchPictureSpec spec = wanted;
  if (spec.height == 0) spec.height = matchPictureHeight(spec.field, spec.width);
  if (auto checked = check(spec); !checked) return tl::unexpected<Error>(checked.error());
  const MatchPlan plan = planOf(spec);
  auto impl = std::make_unique<Impl>(std::move(spec), plan);
  for (const Side side : {Side::kLeft, Side::kRight}) {
    auto background = impl->background(side);
    if (!background) return tl::unexpected<Error>(background.error());
    impl->backgrounds.push_back(std::move(*background));
  }
  return MatchPicture(std::move(impl));
}

const MatchPictureSpec& MatchPicture::spec() const { return impl_->spec; }

Result<Canvas> MatchPicture::canvas() const {
  return Canvas::create(impl_->spec.width, impl_->spec.height, impl_->style.page);
}

void MatchPicture::drawFrame(Canvas& canvas, const ReplayMoment& moment,
                             const MatchOverlays& overlays) const {
  const Impl& m = *impl_;
  canvas.copyFrom(m.backgrounds[static_cast<std::size_t>(moment.blue_side)]);
  const FieldView view = m.plan.view(canvas);
  drawTrails(view, m.spec, overlays.trails);
  drawDrawings(view, m.plan, m.spec, overlays.drawings);
  m.drawBodies(view, moment);
  drawBanner(canvas, m.plan, overlays.banner, m.style);
  drawBoardNumbers(canvas, m.plan, m.spec, moment, m.style);
  drawTimeBarNow(canvas, m.plan, m.spec, moment.seconds, m.style);
}

Vec2 MatchPicture::toField(Vec2 pixel) const {
  const Vec2 p = pixel - impl_->plan.centre;
  return Vec2{p.x, -p.y} / impl_->plan.pixels_per_metre;
}

bool MatchPicture::onTimeBar(Vec2 pixel) const {
  return impl_->spec.seconds > 0.0 && pixel.y >= impl_->plan.height - impl_->plan.foot;
}

double MatchPicture::toSeconds(double x) const { return secondsOnBar(impl_->plan, impl_->spec, x); }

}  // namespace fulbito
