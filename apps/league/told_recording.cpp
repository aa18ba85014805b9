#include "apps/league/told_recording.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "apps/league/heard_events.hpp"
#include "bridge/wire/referee_words.hpp"
#include "fulbito/detail/math.hpp"
#include "fulbito/referee.hpp"
#include "replays/verify/expand.hpp"
#include "replays/verify/resimulate.hpp"
#include "strategies/interface/team_frame.hpp"

namespace fulbito::app {
namespace {

using wire::Foul;

/// Checks that there is a match to tell. Errors: kBadInput.
Result<void> checkMatch(const RecordingHeader& header) {
  const bool named = std::all_of(header.bodies.begin(), header.bodies.end(), [](const RecordedBody& body) {
    return body.kind != BodyKind::kRobot || body.id.has_value();
  });
  if (header.kind == RecordingKind::kMatch && named && countOf(header, BodyKind::kBall) == 1) return {};
  return fail(ErrorCode::kBadInput, "it is not a match, so there is no vision of it");
}

Result<ReplayTimeline> timelineOf(const RecordingReader& recording) {
  if (recording.header().level == RecordingLevel::kFull) return ReplayTimeline::read(recording);
  const auto full = expanded(recording);
  if (!full) return tl::unexpected<Error>(full.error());
  return ReplayTimeline::read(*full);
}

/// The whole number in a value of an event, from 0 to `most`.
Tick wholeOf(double value, Tick most) {
  return value > 0.0 ? static_cast<Tick>(std::min(value, static_cast<double>(most))) : 0;
}

/// The part of overtime that is played at a tick.
int partAt(const ReplayTimeline& timeline, Tick tick) {
  int part = 1;
  for (const RecordedEvent& event : timeline.events()) {
    if (event.clause == "overtime" && event.tick <= tick) part = event.value > 1.0 ? 2 : 1;
  }
  return part;
}

}  // namespace

/// Takes over the states of a recording that is played again, up to the first that differs.
class ToldRecording::Collector final : public ReplayVisitor {
 public:
  explicit Collector(ToldRecording& told) : told_(told) {}

  bool playBegins(const ReplayedPlay& play) override {
    side_ = play.recorded->blue_side;
    return true;
  }
  bool ticked(const ReplayedTick& tick) override {
    if (!asRecorded(tick)) return false;
    told_.addMoment(tick.chunk->playing[tick.row] != 0);
    for (std::size_t i = 0; i < tick.bodies.size(); ++i) {
      Body& body = told_.body(tick.tick, tick.bodies[i]);
      body.present = true;
      const BodyKind kind = told_.header_.bodies[tick.bodies[i]].kind;
      if (kind == BodyKind::kRobot) {
        body.state = inTeamFrame(side_, tick.state->robots[i]);
      } else if (kind == BodyKind::kBall) {
        const BallState ball = inTeamFrame(side_, tick.state->balls.front());
        body.state = {{ball.position, 0.0}, ball.velocity, 0.0, {}};
      }
    }
    if (told_.header_.heard) told_.moveFromBefore(tick.tick);
    return true;
  }

 private:
  ToldRecording& told_;
  Side side_ = Side::kLeft;
};

/// Velocities from the motion since the last tick, for states without.
void ToldRecording::moveFromBefore(Tick tick) {
  if (tick == 1) return;
  for (std::size_t i = 0; i < header_.bodies.size(); ++i) {
    const Body& before = body(tick - 1, i);
    Body& now = body(tick, i);
    if (!before.present || !now.present) continue;
    now.state.velocity = (now.state.pose.position - before.state.pose.position) * header_.control_rate;
    now.state.angular_velocity =
        math::wrapAngle(now.state.pose.heading - before.state.pose.heading) * header_.control_rate;
  }
}

Result<ToldRecording> ToldRecording::read(const RecordingReader& recording) {
  if (auto match = checkMatch(recording.header()); !match) return tl::unexpected<Error>(match.error());
  ToldRecording told;
  told.header_ = recording.header();
  auto field = parseField(told.header_.recipe.field, "recorded field");
  auto robot = parseRobot(told.header_.recipe.robot, "recorded robot");
  if (!field) return fail(ErrorCode::kBadInput, field.error().message);
  if (!robot) return fail(ErrorCode::kBadInput, robot.error().message);
  told.field_ = std::move(*field);
  told.ball_radius_ = robot->ball.radius;
  const auto timeline = timelineOf(recording);
  if (!timeline) return tl::unexpected<Error>(timeline.error());
  Collector collector(told);
  // What cannot be simulated again by this build still has its samples.
  const auto played = resimulate(recording, collector);
  if (!played && played.error().code == ErrorCode::kInterrupted) return tl::unexpected<Error>(played.error());
  told.addRest(*timeline);
  told.addScore(*timeline);
  if (told.header_.heard) {
    told.addHeard(*timeline);
  } else {
    told.addCalled(*timeline);
  }
  return told;
}

void ToldRecording::addRest(const ReplayTimeline& timeline) {
  exact_ = ticks() == timeline.ticks();
  ReplayMoment moment;
  for (Tick tick = ticks() + 1; tick <= timeline.ticks(); ++tick) {
    timeline.at(timeline.secondsAt(tick), moment);
    addMoment(moment.playing);
    for (std::size_t i = 0; i < moment.bodies.size(); ++i) {
      if (!moment.bodies[i]) continue;
      body(tick, i) = {true, {inTeamFrame(moment.blue_side, *moment.bodies[i]), {}, 0.0, {}}};
    }
    moveFromBefore(tick);
  }
}

/// A goal shows in the frame of its tick.
void ToldRecording::addScore(const ReplayTimeline& timeline) {
  auto play = timeline.plays().begin();
  auto event = timeline.events().begin();
  PerTeam<int> score = play->score;
  for (Tick tick = 1; tick <= ticks(); ++tick) {
    while (std::next(play) != timeline.plays().end() && std::next(play)->tick < tick) {
      score = (++play)->score;
    }
    for (; event != timeline.events().end() && event->tick <= tick; ++event) {
      if (event->clause == "goal" && event->team && event->tick > play->tick) ++score[indexOf(*event->team)];
    }
    PerTeam<std::uint32_t>& goals = moments_[static_cast<std::size_t>(tick - 1)].goals;
    for (std::size_t i = 0; i < goals.size(); ++i) {
      goals[i] = static_cast<std::uint32_t>(std::max(score[i], 0));
    }
  }
}

void ToldRecording::addHeard(const ReplayTimeline& timeline) {
  int part = 1;
  for (const RecordedEvent& event : timeline.events()) {
    if (event.clause == "overtime") part = event.value > 1.0 ? 2 : 1;
    if (event.clause == kVisionLost) {
      const Tick end = std::min(event.tick, ticks() + 1);
      for (Tick tick = std::max<Tick>(1, end - wholeOf(event.value, ticks())); tick < end; ++tick) {
        moments_[static_cast<std::size_t>(tick - 1)].lost = true;
      }
      continue;
    }
    const auto* const known = std::find(std::begin(kToldEvents), std::end(kToldEvents), event.clause);
    if (known == std::end(kToldEvents)) continue;
    wire::RefereeCommand command;
    command.foul = static_cast<Foul>(known - std::begin(kToldEvents));
    command.team = event.team;
    command.quadrant = static_cast<int>(wholeOf(event.value, 4));
    command.seconds = event.play_time;
    command.half = wire::halfOf(event.period, part);
    commands_.push_back({event.tick + 1, command});
  }
  std::stable_sort(commands_.begin(), commands_.end(),
                   [](const ToldCommand& a, const ToldCommand& b) { return a.frame < b.frame; });
}

/// What a server says in such a match: a foul, and STOP as soon as all are placed.
void ToldRecording::addCalled(const ReplayTimeline& timeline) {
  for (auto play = timeline.plays().begin(); play != timeline.plays().end(); ++play) {
    const Tick end = std::next(play) == timeline.plays().end() ? ticks() : std::next(play)->tick;
    wire::RefereeCommand command;
    command.half = wire::halfOf(play->period, partAt(timeline, play->tick));
    Tick played = play->play_ticks;
    const auto say = [&](Foul foul, Tick tick) {
      command.foul = foul;
      command.seconds = static_cast<double>(played) / header_.control_rate;
      commands_.push_back({tick, command});
    };
    if (play->kind == RestartKind::kFreeBall) {
      command.quadrant = wire::quadrantOf(inTeamFrame(play->blue_side, play->ball));
    } else if (play->kind != RestartKind::kGiven) {
      command.team = play->team;
    }
    if (play->kind != RestartKind::kGiven) say(wire::foulOf(play->kind), play->tick + 1);
    command.team.reset();
    command.quadrant = 0;
    say(Foul::kStop, play->tick + 1);
    bool playing = false;
    for (Tick tick = play->tick + 1; tick <= end; ++tick) {
      const bool now = moments_[static_cast<std::size_t>(tick - 1)].playing;
      if (now != playing) say(now ? Foul::kGameOn : Foul::kStop, tick);
      playing = now;
      played += now ? 1 : 0;
    }
  }
  const auto& result = timeline.result();
  if (result && result->complete) commands_.push_back({ticks() + 1, wire::RefereeCommand{}});
}

std::optional<wire::Vision> ToldRecording::frame(Tick tick) const {
  const Moment& moment = moments_[static_cast<std::size_t>(tick - 1)];
  if (moment.lost) return std::nullopt;
  wire::Vision vision;
  vision.field = field_;
  vision.ball_height = ball_radius_;
  vision.goals = moment.goals;
  const std::size_t first = static_cast<std::size_t>(tick - 1) * header_.bodies.size();
  for (std::size_t i = 0; i < header_.bodies.size(); ++i) {
    const Body& body = bodies_[first + i];
    const RecordedBody& what = header_.bodies[i];
    if (!body.present) continue;
    if (what.kind == BodyKind::kBall) {
      vision.ball = {body.state.pose.position, body.state.velocity, {}};
    } else if (what.id) {
      vision.robots[indexOf(what.id->team)].push_back({what.id->number, body.state});
    }
  }
  return vision;
}

}  // namespace fulbito::app
