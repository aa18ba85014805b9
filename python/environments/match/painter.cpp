#include "python/environments/match/painter.hpp"

#include <algorithm>
#include <utility>

#include "fulbito/recorder.hpp"

namespace fulbito {

Result<MatchPainter> MatchPainter::create(const MatchConfig& config, int width) {
  MatchPictureSpec spec;
  spec.width = width;
  spec.field = config.field;
  spec.robot = config.robot.robot;
  spec.ball = config.robot.ball;
  spec.bodies = recordingHeader(config, RecordingLevel::kFull).bodies;
  spec.names = {config.teams[0].text, config.teams[1].text};
  auto picture = MatchPicture::create(spec);
  if (!picture) return tl::unexpected<Error>(picture.error());
  return MatchPainter(std::move(*picture));
}

Result<Canvas> MatchPainter::draw(const Match& match) const {
  auto canvas = picture_.canvas();
  if (!canvas) return canvas;
  const RefereeState& referee = match.referee();
  ReplayMoment moment;
  moment.seconds = match.seconds();
  moment.tick = match.tick();
  moment.period = referee.period;
  moment.play_seconds = static_cast<double>(referee.play_ticks) * match.config().physics.controlPeriod();
  moment.playing = referee.playing;
  moment.score = referee.score;
  moment.blue_side = referee.blue_side;
  for (const RecordedBody& body : picture_.spec().bodies) {
    auto& pose = moment.bodies.emplace_back();
    if (!body.id) {
      pose = Pose2{match.world().balls.front().position, 0.0};
      continue;
    }
    const auto ids = match.ids();
    const auto found = std::find(ids.begin(), ids.end(), *body.id);
    if (found != ids.end()) pose = match.world().robots[static_cast<std::size_t>(found - ids.begin())].pose;
  }
  picture_.drawFrame(*canvas, moment);
  return canvas;
}

}  // namespace fulbito
