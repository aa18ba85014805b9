#include "strategies/libero.hpp"

#include <algorithm>
#include <cmath>

#include "strategies/libero_areas.hpp"
#include "strategies/libero_exercise.hpp"
#include "strategies/libero_keeper.hpp"
#include "strategies/libero_restarts.hpp"
#include "strategies/libero_striker.hpp"
#include "strategies/libero_support.hpp"

namespace fulbito {
namespace {

using namespace libero;

class Libero final : public Strategy {
 public:
  explicit Libero(Settings settings) : settings_(settings) {}

  void begin(const MatchInfo& info) override {
    pitch_ = Pitch(info);
    spin_.reset();
    striker_ = -1;
    strike_ = {};
    held_ = 1.0;
  }

  TeamCommand decide(const Observation& observation) override {
    if (observation.since_restart < observation.dt / 2) {
      spin_.reset();
      strike_ = {};
    }
    ball_.compute(pitch_, spin_.update(pitch_, observation.ball));
    const Picture picture{observation, pitch_, settings_, ball_};
    chooseKeeper(picture);
    chooseStriker(picture);
    TeamCommand command;
    int rank = 0;
    for (int i = 0; i < observation.team_size; ++i) {
      if (!picture.ownPresent(i)) continue;
      command.roles[static_cast<std::size_t>(i)] = roleOf(i);
      command.robots[static_cast<std::size_t>(i)] =
          RobotCommand::byTwist(legal(picture, i, play(picture, i, rank)));
    }
    return command;
  }

  std::optional<TeamPlacement> place(const PlacementRequest& request) override {
    return placementAt(pitch_, request);
  }

  std::optional<ExerciseReply> exercise(const Observation& observation, const Exercise& exercise) override {
    const BallState ball = spin_.update(pitch_, observation.ball);
    ExerciseReply reply;
    if (exercise.kind == Exercise::Kind::kPredictBall) {
      // Finer steps than those of the game: nothing else is asked for here.
      constexpr double kFine = 1.0 / 480.0;
      BallState moving = ball;
      for (int i = 0; i < static_cast<int>(exercise.horizon / kFine + 0.5); ++i)
        moving = rolledOn(pitch_, moving, kFine);
      reply.answer = moving.position;
    }
    reply.command.robots[0] = RobotCommand::byTwist(
        exerciseTwist(pitch_, observation.own[0].state, ball.position, exercise, strike_.side));
    return reply;
  }

 private:
  Twist play(const Picture& picture, int robot, int& rank) {
    if (robot == keeper_) return keep(picture, robot);
    const bool ours = inOwnArea(pitch_, ball_.at(0.2), 0.0);
    if (robot == striker_ && !(ours && keeper_ >= 0)) return strike(picture, robot, strike_);
    if (ours && keeper_ >= 0) {
      // The keeper's alone: beside the area, off the way of those who come, ready for what comes out.
      const double side = ball_.now().position.y >= 0.0 ? 1.0 : -1.0;
      Vec2 follower;
      if (rank == 0 && 0 > 0 && followerInArea(picture, follower)) {
        ++rank;
        return passThrough(pitch_, picture.own(robot), follower, pitch_.speed);
      }
      const Vec2 wait = rank++ == 0 ? Vec2{-pitch_.half_length + 0.5, side * 0.45}
                                    : Vec2{-pitch_.half_length + 0.5, -side * 0.3};
      return supportTo(picture, robot, wait);
    }
    Vec2 place = supportPlace(picture, {}, rank++);
    // Nobody crowds the striker's ball.
    const Vec2 from_ball = place - ball_.now().position;
    const double room = 0.22;
    if (squaredNorm(from_ball) < room * room) {
      place = pitch_.inside(ball_.now().position + unitOr(from_ball, {-1.0, 0.0}) * room, 0.06);
    }
    place = outOfOwnArea(pitch_, place, 0.07);
    if (inTheirArea(pitch_, ball_.now().position, 0.1)) place = outOfTheirArea(pitch_, place, 0.08);
    return supportTo(picture, robot, place);
  }

  /// An opponent who follows another into our area, the farther one from the ball: it may not take part.
  bool followerInArea(const Picture& picture, Vec2& place) const {
    int inside = 0;
    double farthest = 0.0;
    for (int i = 0; i < picture.seen.team_size; ++i) {
      if (!picture.opponentPresent(i)) continue;
      const Vec2 body = picture.opponent(i).pose.position;
      if (!inOwnArea(pitch_, body, 0.04)) continue;
      ++inside;
      const double from_ball = squaredNorm(body - ball_.now().position);
      if (from_ball > farthest) farthest = from_ball, place = body;
    }
    return inside >= 2;
  }

  /// 1 keeper, 2 striker, 3 support.
  std::uint8_t roleOf(int robot) const { return robot == keeper_ ? 1 : robot == striker_ ? 2 : 3; }

  Twist legal(const Picture& picture, int robot, Twist wanted) const {
    if (robot == keeper_) return wanted;
    return keptOut(pitch_, picture.own(robot), {keeper_ >= 0, robot != striker_}, wanted);
  }

  /// The first robot on the field keeps goal; a lone one only while a shot comes.
  void chooseKeeper(const Picture& picture) {
    int present = 0;
    keeper_ = -1;
    for (int i = picture.seen.team_size - 1; i >= 0; --i) {
      if (picture.ownPresent(i)) ++present, keeper_ = i;
    }
    if (present == 1 && !mustSave(picture, keeper_)) keeper_ = -1;
  }

  void chooseStriker(const Picture& picture) {
    held_ += picture.seen.dt;
    int best = -1;
    double least = 1e9;
    for (int i = 0; i < picture.seen.team_size; ++i) {
      if (i == keeper_ || !picture.ownPresent(i)) continue;
      const Interception meet = interception(picture, picture.own(i));
      double cost = meet.time;
      if (picture.own(i).pose.position.x > meet.ball.x) cost += 0.3;
      if (i == striker_) cost -= 0.2;
      if (cost < least) least = cost, best = i;
    }
    if (best == striker_) return;
    if (striker_ >= 0 && striker_ != keeper_ && picture.ownPresent(striker_) && held_ < 0.4) return;
    striker_ = best;
    strike_ = {};
    held_ = 0.0;
  }

  Settings settings_;
  Pitch pitch_;
  SpinTracker spin_;
  BallForecast ball_;
  int keeper_ = -1;
  int striker_ = -1;
  double held_ = 1.0;  // [s] since the striker was chosen
  StrikerMemory strike_;
};

}  // namespace

TeamInfo liberoInfo() {
  return {"libero",
          "the flagship: striker, support and keeper who read the game",
          {},
          false,
          {},
          [](const std::vector<Setting>&) -> Result<std::unique_ptr<Strategy>> {
            return std::unique_ptr<Strategy>(std::make_unique<Libero>(Settings{}));
          }};
}

}  // namespace fulbito
