#include <algorithm>
#include <cmath>
#include <utility>

#include "navigation/interface/parameters.hpp"
#include "strategies/interface/team_info.hpp"
#include "strategies/prediction/foresight.hpp"
#include "strategies/skills/area_projection.hpp"
#include "strategies/teams/libero/attack/meet.hpp"
#include "strategies/teams/libero/attack/striker.hpp"
#include "strategies/teams/libero/attack/support.hpp"
#include "strategies/teams/libero/defence/keeper.hpp"
#include "strategies/teams/libero/drawing.hpp"
#include "strategies/teams/libero/exercise.hpp"
#include "strategies/teams/libero/motion/bounds.hpp"
#include "strategies/teams/libero/motion/room.hpp"
#include "strategies/teams/libero/restarts.hpp"

namespace fulbito {
namespace {

using namespace libero;

class Libero final : public Strategy {
 public:
  Libero(Settings settings, std::optional<NavigatorChoice> navigator) : settings_(settings) {
    if (navigator) navigators_.push_back(std::move(*navigator));
  }

  std::span<const NavigatorChoice> navigators() const override { return navigators_; }

  void begin(const MatchInfo& info) override {
    pitch_ = Pitch(info);
    foresight_ = Foresight(info);
    forgetStriker();
    exercise_ = {};
    dispute_left_ = {};
    kick_off_hand_ = -1.0;
  }

  TeamCommand decide(const Observation& observation) override {
    const Observation& now = foresight_.update(observation);
    if (foresight_.playBegan()) {
      strike_ = {};
      // The robot that is placed at the ball becomes striker, even if another was striker before.
      if (takenAtOnce(now)) forgetStriker();
    }
    ball_.take(foresight_.ballNow(), foresight_.ball());
    watchStuck(now);
    // Before the signal no robot can move, so standing still does not mean that it presses or is caught.
    if (!now.playing) strike_ = {};
    watchTouches(now);
    const Picture picture{now, pitch_, settings_, ball_, stuck_, dispute_left_};
    chooseKeeper(picture);
    chooseStriker(picture);
    TeamCommand command;
    int rank = 0;
    for (int i = 0; i < now.team_size; ++i) {
      if (!picture.ownPresent(i)) continue;
      const auto robot = static_cast<std::size_t>(i);
      roles_[robot] = roleOf(i);
      command.roles[robot] = static_cast<std::uint8_t>(roles_[robot]);
      command.robots[robot] = play(picture, i, rank);
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
    reply.answer = foresight_.ball().positionAt(exercise.horizon);
    reply.command.robots[0] = RobotCommand::byTwist(
        exerciseTwist(pitch_, now.own[0].state, now.ball.position, exercise, exercise_));
    return reply;
  }

 private:
  void forgetStriker() {
    striker_ = -1;
    strike_ = {};
    held_ = 1.0;
  }

  /// Measures how long the ball has stayed within a small circle.
  void watchStuck(const Observation& seen) {
    constexpr double kCircle = 0.10;  // [m]
    stuck_ += seen.dt;
    if (seen.playing && !foresight_.playBegan() &&
        squaredNorm(seen.ball.position - stuck_at_) < kCircle * kCircle)
      return;
    stuck_at_ = seen.ball.position;
    stuck_ = 0.0;
  }

  /// Measures which own robots have touched the ball recently.
  void watchTouches(const Observation& seen) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(seen.team_size); ++i) {
      double& left = dispute_left_[i];
      left =
          atBall(pitch_, seen.own[i].state, seen.ball.position) ? kDisputes : std::max(0.0, left - seen.dt);
      if (!seen.playing || !seen.own[i].present) left = 0.0;
    }
  }

  /// Whether one of the field players was placed to be first at the ball. At an own goal kick that is the
  /// keeper, and the other robots keep their roles.
  static bool takenAtOnce(const Observation& seen) {
    return seen.restart != RestartKind::kGoalKick || !seen.restart_is_ours;
  }

  /// Whether only the keeper may play the ball: it will be in or near the own area in 0.3 s. Opponents would
  /// push a field player that follows it into the area.
  bool ballIsKeepers() const {
    constexpr double kAhead = 0.3;    // [s]
    constexpr double kMargin = 0.06;  // [m]
    const Vec2 ball = ball_.at(kAhead);
    return keeper_ >= 0 && isInArea(pitch_.field, ball, true, kMargin) && std::abs(ball.y) < pitch_.area_half;
  }

  /// The command of one robot: the twist of its skill, made legal, or a place for a navigator.
  RobotCommand play(const Picture& picture, int robot, int& rank) {
    Move& move = moves_[static_cast<std::size_t>(robot)];
    if (robot == keeper_) {
      move = keep(picture, robot);
      return RobotCommand::byTwist(move.twist);
    }
    const bool keepers = ballIsKeepers();
    if (robot == striker_ && !keepers) {
      move = strike(picture, robot, strike_);
      // A free ball lies at the area's edge, and a robot that avoids the edge would come late.
      if (disputesFreeBall(picture.seen))
        return clearOfKeeper(picture, robot, move.twist).value_or(RobotCommand::byTwist(move.twist));
      return legal(picture, robot, move.twist);
    }
    if (!keepers && supportMayBlock(picture, robot)) {
      ++rank;
      move = blockDribble(picture, picture.own(robot));
      return legal(picture, robot, move.twist);
    }
    const Vec2 place = keepers ? waitingPlace(picture, rank) : supportPlace(picture, robot, rank);
    ++rank;
    move = {{}, keepers ? "wait" : "", place, {}, {}};
    if (!navigators_.empty() && distance(picture.own(robot).pose.position, place) > 0.1) {
      GoTo go_to;
      go_to.position = place;
      go_to.stop = true;
      go_to.avoid_ball = true;
      return RobotCommand::drivingTo(go_to);
    }
    move.twist = supportTo(picture, robot, place);
    return legal(picture, robot, move.twist);
  }

  /// Whether a robot other than the striker blocks an opponent that dribbles toward the own goal. Near the
  /// goal it does not, since it would be pushed into the area.
  bool supportMayBlock(const Picture& picture, int robot) const {
    const RobotState& self = picture.own(robot);
    return self.pose.position.x > -pitch_.half_length + 0.45 && canBlockDribble(picture, self);
  }

  Role roleOf(int robot) const {
    return robot == keeper_ ? Role::kKeeper : robot == striker_ ? Role::kStriker : Role::kSupport;
  }

  /// The last step: only the keeper may enter the own area. In three-a-side matches only the striker may
  /// enter the opponents' area.
  RobotCommand legal(const Picture& picture, int robot, Twist wanted) const {
    // In five-a-side matches a second attacker in their area gains more than the resulting goal kicks cost.
    const bool theirs = !pitch_.isLarge() && (robot != striker_ || mateIsIn(picture));
    if (!theirs) {
      if (const auto off = clearOfKeeper(picture, robot, wanted)) return *off;
    }
    const RobotCommand kept = keptOut(picture, robot, {keeper_ >= 0, theirs}, wanted);
    // A robot that must leave their area must not push the keeper aside.
    if (theirs && isInArea(pitch_.field, picture.own(robot).pose.position, false, pitch_.robot_corner)) {
      if (const auto off = clearOfKeeper(picture, robot, twistOf(pitch_, kept))) return *off;
    }
    return kept;
  }

  /// The twist that a robot command asks for.
  static Twist twistOf(const Pitch& pitch, const RobotCommand& command) {
    if (command.kind == RobotCommand::Kind::kTwist) return command.twist;
    const double left = command.wheels.left * pitch.wheel_radius;
    const double right = command.wheels.right * pitch.wheel_radius;
    return {(left + right) / 2, (right - left) / (2 * pitch.half_track)};
  }

  /// Whether the striker is outside the opponents' area and another own robot is inside: a second one inside
  /// is a foul.
  bool mateIsIn(const Picture& picture) const {
    if (distanceToArea(pitch_.field, picture.own(striker_).pose.position, false) < pitch_.robot_half)
      return false;
    for (int i = 0; i < picture.seen.team_size; ++i) {
      if (i == striker_ || !picture.ownPresent(i)) continue;
      if (distanceToArea(pitch_.field, picture.own(i).pose.position, false) < pitch_.robot_corner + 0.004)
        return true;
    }
    return false;
  }

  /// The first present robot is the keeper. If it is alone, it is the keeper only while a shot comes.
  void chooseKeeper(const Picture& picture) {
    int present = 0;
    keeper_ = -1;
    for (int i = picture.seen.team_size - 1; i >= 0; --i) {
      if (picture.ownPresent(i)) ++present, keeper_ = i;
    }
    if (present == 1 && !mustSave(picture, keeper_)) keeper_ = -1;
  }

  /// The striker is the robot that reaches the ball first. The present one stays unless another is clearly
  /// better.
  void chooseStriker(const Picture& picture) {
    if (picture.seen.playing) held_ += picture.seen.dt;
    // [s] advantage of a striker in their area, which the next one may enter only after it has left
    constexpr double kStays = 0.5;
    // [s] smaller differences are rounding errors, which differ between the two sides
    constexpr double kAlike = 1e-9;
    int best = -1;
    double least = 1e9;
    for (int i = 0; i < picture.seen.team_size; ++i) {
      if (i == keeper_ || !picture.ownPresent(i)) continue;
      const libero::Interception meet = interception(picture, picture.own(i));
      double cost = meet.time;
      if (picture.own(i).pose.position.x > meet.ball.x) cost += 0.3;
      if (i == striker_)
        cost -= isInArea(pitch_.field, picture.own(i).pose.position, false, 0.05) ? kStays : 0.2;
      if (cost < least - kAlike) least = cost, best = i;
    }
    if (best == striker_) return;
    if (striker_ >= 0 && striker_ != keeper_ && picture.ownPresent(striker_) && held_ < 0.4) return;
    striker_ = best;
    strike_ = {};
    held_ = 0.0;
  }

  Settings settings_;
  Pitch pitch_;
  // at most one, for robots without the ball; empty: the team's own skills drive
  std::vector<NavigatorChoice> navigators_;
  Foresight foresight_;
  BallForecast ball_;
  int keeper_ = -1;
  int striker_ = -1;
  double held_ = 1.0;  // [s] since the striker was chosen
  StrikerMemory strike_;
  ExerciseMemory exercise_;
  std::array<Role, kMaxTeamSize> roles_{};  // by robot, in the last tick
  std::array<Move, kMaxTeamSize> moves_{};
  double kick_off_hand_ = -1.0;  // side of the last kick-off, +1 or -1; kick-offs alternate between the sides
  std::array<double, kMaxTeamSize> dispute_left_{};  // [s]
  Vec2 stuck_at_;
  double stuck_ = 0.0;  // [s]
};

/// The default of `navigator`: the team's own motion skills, at a tenth of the cost of the cheapest
/// navigator.
constexpr const char* kOwnNavigation = "own";

}  // namespace

TeamInfo liberoInfo() {
  const std::vector<Parameter<Settings>> parameters = {
      number("aggression", &Settings::aggression, 0.0, 1.0, "",
             "how early the support goes forward: 0 only when the ball is deep in their half")};
  TeamInfo info{"libero",
                "the flagship: striker, support and keeper who read the game",
                specsOf(parameters),
                true,
                kOwnNavigation,
                {},
                false};
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
    Settings values;
    if (auto done = applySettings(parameters, settings, "libero", values); !done) {
      return tl::unexpected<Error>(done.error());
    }
    return std::unique_ptr<Strategy>(std::make_unique<Libero>(values, std::move(navigator)));
  };
  return info;
}

}  // namespace fulbito
