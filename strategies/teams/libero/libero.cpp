#include <algorithm>
#include <cmath>
#include <utility>

#include "navigation/interface/parameters.hpp"
#include "strategies/interface/team_info.hpp"
#include "strategies/prediction/foresight.hpp"
#include "strategies/skills/quick_twist.hpp"
#include "strategies/teams/libero/drawing.hpp"
#include "strategies/teams/libero/exercise.hpp"
#include "strategies/teams/libero/legal.hpp"
#include "strategies/teams/libero/motion/room.hpp"
#include "strategies/teams/libero/playbook/playbook.hpp"
#include "strategies/teams/libero/restarts.hpp"
#include "strategies/teams/libero/roles.hpp"
#include "strategies/teams/libero/situation/free_balls.hpp"
#include "strategies/teams/libero/situation/stalls.hpp"
#include "strategies/teams/libero/situation/tuning.hpp"

namespace fulbito {
namespace {

using namespace libero;

class Libero final : public Strategy {
 public:
  Libero(const Tuning& tuning, PlayBook play_book, std::optional<NavigatorChoice> navigator)
      : tuning_(tuning), play_book_(std::move(play_book)) {
    if (navigator) navigators_.push_back(std::move(*navigator));
  }

  std::span<const NavigatorChoice> navigators() const override { return navigators_; }

  void begin(const MatchInfo& info) override {
    robot_ = info.robot;
    pitch_ = Pitch(info, tuning_);
    foresight_ = Foresight(info, BallForecast::horizon());
    forgetStriker();
    free_balls_.forget();
    stalls_.forget();
    exercise_ = {};
    dispute_left_ = {};
    kick_off_hand_ = -1.0;
  }

  TeamCommand decide(const Observation& observation) override {
    const Observation& now = foresight_.update(observation);
    if (foresight_.playBegan()) {
      memories_ = {};
      // The robot that is placed at the ball becomes striker, even if another was striker before.
      if (takenAtOnce(now)) forgetStriker();
    }
    ball_.take(foresight_.ballNow(), foresight_.ball());
    watchStuck(now);
    // Before the signal no robot can move, so standing still does not mean that it presses or is caught.
    if (!now.playing) memories_ = {};
    watchTouches(now);
    free_balls_.watch(now, foresight_.playBegan(), 2 * tuning_.patience);
    Picture picture{now, pitch_, ball_, stuck_, dispute_left_, free_balls_.pay()};
    stalls_.watch(picture);
    picture.stall_given_up = stalls_.isGivenUp();
    if (roles_.choose(picture) && picture.striker >= 0)
      memories_[static_cast<std::size_t>(picture.striker)] = {};
    TeamCommand command;
    for (int i = 0; i < now.team_size; ++i) {
      if (!picture.ownPresent(i)) continue;
      const auto robot = static_cast<std::size_t>(i);
      command.roles[robot] = static_cast<std::uint8_t>(roles_.of(i));
      play(picture, i, command.robots[robot]);
    }
    if (observation.wants_drawings) draw(picture, roles_, moves_, command.drawings);
    return command;
  }

  std::optional<TeamProposal> place(const PlacementRequest& request) override {
    if (request.kind == RestartKind::kKickOff) kick_off_hand_ = -kick_off_hand_;
    return placementAt(pitch_, request, kick_off_hand_);
  }

  std::optional<ExerciseReply> exercise(const Observation& observation, const Exercise& exercise) override {
    const Observation& now = foresight_.update(observation);
    ExerciseReply reply;
    BallPrediction way;
    way.predict(foresight_.course(), foresight_.ballNow());
    reply.answer = way.positionAt(exercise.horizon);
    reply.command.robots[0] = RobotCommand::byTwist(
        exerciseTwist(pitch_, now.own[0].state, now.ball.position, exercise, exercise_));
    return reply;
  }

 private:
  void forgetStriker() {
    roles_.forgetStriker();
    memories_ = {};
  }

  /// Measures how long the ball has stayed within a small circle.
  void watchStuck(const Observation& seen) {
    stuck_ += seen.dt;
    if (seen.playing && !foresight_.playBegan() &&
        squaredNorm(seen.ball.position - stuck_at_) < pitch_.stuck_radius * pitch_.stuck_radius)
      return;
    stuck_at_ = seen.ball.position;
    stuck_ = 0.0;
  }

  /// Measures which own robots have touched the ball recently. Referees allow 0.5 s (law 13), in which a
  /// robot has time to stop and to leave a keeper that presses.
  void watchTouches(const Observation& seen) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(seen.team_size); ++i) {
      double& left = dispute_left_[i];
      left = atBall(pitch_, seen.own[i].state, seen.ball.position) ? pitch_.turn_time
                                                                   : std::max(0.0, left - seen.dt);
      if (!seen.playing || !seen.own[i].present) left = 0.0;
    }
  }

  /// Whether one of the field players was placed to be first at the ball. At an own goal kick that is the
  /// keeper, and the other robots keep their roles.
  static bool takenAtOnce(const Observation& seen) {
    return seen.restart != RestartKind::kGoalKick || !seen.restart_is_ours;
  }

  /// Sets the command of one robot: the move of its play book, made legal, or a place for a navigator.
  void play(const Picture& picture, int robot, RobotCommand& command) {
    const auto i = static_cast<std::size_t>(robot);
    moves_[i] = play_book_.decide(roles_.of(robot), picture, robot, memories_[i]);
    const Move& move = moves_[i];
    const bool far = move.place && distance(picture.own(robot).pose.position, *move.place) > pitch_.bodies;
    if (navigators_.empty() || !move.travels || !far) {
      command.kind = RobotCommand::Kind::kWheels;
      command.wheels = wheelsFor(picture, robot, move.twist);
      return;
    }
    GoTo go_to;
    go_to.position = *move.place;
    go_to.stop = true;
    go_to.avoid_ball = true;
    command = RobotCommand::drivingTo(go_to);
  }

  /// The wheel speeds for what is legal of a wanted twist.
  WheelSpeeds wheelsFor(const Picture& picture, int robot, Twist wanted) {
    const RobotCommand command = legal(picture, robot, wanted, memories_[static_cast<std::size_t>(robot)]);
    if (command.kind != RobotCommand::Kind::kTwist) return command.wheels;
    return quickTwist(robot_, picture.own(robot), command.twist, picture.seen.dt).wheels;
  }

  Tuning tuning_;
  RobotModel robot_;
  Pitch pitch_;
  // at most one, for robots without the ball; empty: the team's own skills drive
  std::vector<NavigatorChoice> navigators_;
  Foresight foresight_;
  BallForecast ball_;
  FreeBalls free_balls_;
  Stalls stalls_;
  Roles roles_;
  PlayBook play_book_;
  std::array<Memory, kMaxTeamSize> memories_{};
  ExerciseMemory exercise_;
  std::array<Move, kMaxTeamSize> moves_{};  // by robot, in the last tick
  double kick_off_hand_ = -1.0;  // side of the last kick-off, +1 or -1; kick-offs alternate between the sides
  std::array<double, kMaxTeamSize> dispute_left_{};  // [s]
  Vec2 stuck_at_;
  double stuck_ = 0.0;  // [s]
};

/// The default of `navigator`: the team's own motion skills, at a tenth of the cost of the cheapest
/// navigator.
constexpr const char* kOwnNavigation = "own";

/// Removes the setting `without` and returns the play book that it leaves.
Result<PlayBook> takePlayBook(std::vector<Setting>& settings) {
  Result<PlayBook> play_book;
  for (const Setting& setting : settings) {
    if (setting.name == kWithoutSetting) play_book = PlayBook::without(setting.value);
  }
  std::erase_if(settings, [](const Setting& setting) { return setting.name == kWithoutSetting; });
  return play_book;
}

}  // namespace

TeamInfo liberoInfo() {
  const std::vector<Parameter<Tuning>> parameters = tuningParameters();
  TeamInfo info{"libero",
                "the flagship: striker, support and keeper who read the game",
                specsOf(parameters),
                true,
                kOwnNavigation,
                {},
                false,
                PlayBook::skills()};
  info.make = [parameters](std::vector<Setting> settings) -> Result<std::unique_ptr<Strategy>> {
    std::optional<NavigatorChoice> navigator;
    std::erase_if(settings,
                  [](const Setting& s) { return s.name == "navigator" && s.value == kOwnNavigation; });
    if (std::any_of(settings.begin(), settings.end(),
                    [](const Setting& s) { return s.name == "navigator"; })) {
      auto chosen = takeNavigator(settings, kDefaultNavigator);
      if (!chosen) return tl::unexpected<Error>(chosen.error());
      navigator = std::move(*chosen);
    }
    auto play_book = takePlayBook(settings);
    if (!play_book) return tl::unexpected<Error>(play_book.error());
    Tuning values;
    if (auto done =
            applySettings(parameters, settings, "libero", values, {kNavigatorSetting, kWithoutSetting});
        !done) {
      return tl::unexpected<Error>(done.error());
    }
    return std::unique_ptr<Strategy>(
        std::make_unique<Libero>(values, std::move(*play_book), std::move(navigator)));
  };
  return info;
}

}  // namespace fulbito
