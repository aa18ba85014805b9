#include "experiments/papers/localization/cleaning_run.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

#include "experiments/papers/localization/cleaning_route.hpp"
#include "experiments/papers/localization/first_fix.hpp"

namespace fulbito::localization {
namespace {

constexpr double kSlack = 1.5;          // time limit, relative to the expected time
constexpr double kSlackSeconds = 60.0;  // [s] added to that limit

Knowledge knowledgeOf(const CleaningTask& task, const FirstFix& fix) {
  Knowledge known;
  known.room = {task.field.length, task.field.width};
  known.body = bodyOf(task.rover);
  known.axle_track = task.rover.robot.axle_track;
  known.pose = fix.start.pose;
  known.echo_speed = fix.start.axis.echo_speed;
  known.gyro_bias = fix.gyro_bias;
  known.range_sigma = task.spread.range_noise;
  known.cone = task.rover.sonar.sonars.front().half_cone;
  return known;
}

EkfSettings ekfSettings(const SensorSpread& spread, const FirstFix& fix) {
  EkfSettings settings;
  settings.start = fix.start.covariance;
  settings.start_bias = spread.gyro_noise / std::sqrt(static_cast<double>(kStandstillPings * kTicksPerPing));
  settings.encoder_scale = spread.wheel_scale;
  settings.slip = spread.wheel_slip;
  settings.gyro_noise = spread.gyro_noise;
  settings.gyro_drift = spread.gyro_drift;
  settings.gyro_scale = spread.gyro_scale;
  return settings;
}

ThresholdSettings thresholdSettings(const Rover& rover) {
  ThresholdSettings settings;
  settings.least = rover.sonar.sonars.front().least;
  settings.greatest = rover.sonar.sonars.front().greatest;
  return settings;
}

std::unique_ptr<PoseEstimator> estimatorFor(Scheme scheme, const CleaningTask& task, const FirstFix& fix) {
  const Knowledge known = knowledgeOf(task, fix);
  if (scheme == Scheme::kEkf) return std::make_unique<EkfEstimator>(known, ekfSettings(task.spread, fix));
  if (scheme == Scheme::kThreshold)
    return std::make_unique<ThresholdEstimator>(known, thresholdSettings(task.rover));
  return std::make_unique<DeadReckoning>(known);
}

/// Compares the robot's estimate with the truth, in the frame that the robot chose.
class Judge {
 public:
  Judge(const Room& room, bool turned, const std::vector<Vec2>& route)
      : room_(room), turned_(turned), route_(route) {}

  Pose2 seen(const Pose2& truth) const { return turned_ ? halfTurned(truth, room_) : truth; }

  /// [m] from the present part or the previous one, at whose end the robot turns.
  double deviation(Vec2 truth, std::size_t part) const {
    const double now = distanceFromPart(truth, route_[part], route_[part + 1]);
    if (part == 0) return now;
    return std::min(now, distanceFromPart(truth, route_[part - 1], route_[part]));
  }

  void note(double deviation, double heading_error) {
    greatest_ = std::max(greatest_, deviation);
    squares_ += deviation * deviation;
    heading_ = std::max(heading_, std::abs(heading_error));
    ++notes_;
  }

  void write(CleaningResult& result) const {
    result.max_deviation = greatest_;
    result.rms_deviation = notes_ > 0 ? std::sqrt(squares_ / notes_) : 0.0;
    result.max_heading_error = heading_;
  }

 private:
  Room room_;
  bool turned_;
  const std::vector<Vec2>& route_;
  double greatest_ = 0.0, squares_ = 0.0, heading_ = 0.0;
  int notes_ = 0;
};

/// Length [m] of the route up to the point of a part that is nearest to `place`.
double wayUntil(const std::vector<Vec2>& route, std::size_t part, Vec2 place) {
  double sum = 0.0;
  for (std::size_t i = 1; i <= part; ++i) sum += distance(route[i - 1], route[i]);
  const Vec2 along = unitOr(route[part + 1] - route[part], {1.0, 0.0});
  return sum + std::clamp(dot(place - route[part], along), 0.0, distance(route[part], route[part + 1]));
}

class CleaningDrive {
 public:
  CleaningDrive(Rig& rig, const Room& room, std::vector<Vec2> route, PoseEstimator& estimator,
                double echo_speed, CleaningResult& result, bool with_moments)
      : rig_(rig),
        estimator_(estimator),
        driver_(std::move(route), rig.rover().limits),
        judge_(room, result.turned_frame, driver_.points()),
        result_(result),
        with_moments_(with_moments),
        echo_speed_(echo_speed) {}

  void run(double time_limit) {
    while (true) {
      const Twist wanted = driver_.drive(estimator_.pose());
      if (driver_.finished()) break;
      tick(wanted);
      if (rig_.touchesWall()) return end(CleaningOutcome::kHitWall);
      if (rig_.seconds() > time_limit) return end(CleaningOutcome::kTimeOut);
    }
    end(CleaningOutcome::kFinished);
  }

 private:
  void tick(Twist wanted) {
    estimator_.advance(rig_.step(wanted));
    EchoTimes times;
    if (rig_.pingDue()) estimator_.observe(times = rig_.ping());
    const Pose2 truth = judge_.seen(rig_.truth()), estimate = estimator_.pose();
    const double deviation = judge_.deviation(truth.position, driver_.part());
    judge_.note(deviation, math::wrapAngle(estimate.heading - truth.heading));
    if (with_moments_ && rig_.pingDue()) keep(truth, estimate, deviation, times);
  }

  void keep(const Pose2& truth, const Pose2& estimate, double deviation, const EchoTimes& times) {
    CleaningMoment moment{rig_.seconds(),
                          wayUntil(driver_.points(), driver_.part(), truth.position),
                          driver_.part(),
                          truth,
                          estimate,
                          deviation,
                          {}};
    for (std::size_t i = 0; i < times.size(); ++i) {
      if (times[i]) moment.ranges[i] = *times[i] * echo_speed_;
    }
    result_.moments.push_back(moment);
  }

  void end(CleaningOutcome outcome) {
    result_.outcome = outcome;
    result_.seconds = rig_.seconds();
    const Pose2 truth = judge_.seen(rig_.truth());
    result_.final_error = distance(truth.position, estimator_.pose().position);
    if (const auto* filter = dynamic_cast<const EkfEstimator*>(&estimator_))
      result_.squared_error = filter->squaredError(truth);
    judge_.write(result_);
    if (with_moments_) result_.route = driver_.points();
  }

  Rig& rig_;
  PoseEstimator& estimator_;
  RouteDriver driver_;
  Judge judge_;
  CleaningResult& result_;
  bool with_moments_;
  double echo_speed_;  // [m/s] for the ranges of the moments
};

/// Expected time [s] of a route: its parts, and a turn with deceleration and acceleration at each point.
double timeFor(const CleaningRoute& route, const DriveLimits& limits) {
  const double per_turn = math::kPi / limits.turn_rate + 2 * limits.speed / limits.deceleration + 2.0;
  return lengthOf(route) / limits.speed + static_cast<double>(route.points.size()) * per_turn;
}

void judgeStart(const Rig& rig, const Room& room, const CleaningTask& task, const FirstFix& fix,
                CleaningResult& result) {
  const Pose2 truth = rig.truth(), found = fix.start.pose;
  result.turned_frame = std::abs(math::wrapAngle(truth.heading - found.heading)) > math::kPi / 2;
  const Pose2 seen = result.turned_frame ? halfTurned(truth, room) : truth;
  result.heading_error = math::wrapAngle(seen.heading - found.heading);
  result.level_centre_error = math::wrapAngle(result.heading_error + fix.level_centre);
  result.shortest_echo_error = math::wrapAngle(result.heading_error + fix.shortest_echo);
  result.start_error = distance(seen.position, found.position);
  result.echo_speed = fix.start.axis.echo_speed;
  const double echo_speed = speedOfSound(task.celsius) / 2;
  result.echo_speed_error = result.echo_speed / echo_speed - 1.0;
  if (std::abs(result.heading_error) > math::kPi / 4) result.outcome = CleaningOutcome::kWrongAxis;
}

}  // namespace

Result<CleaningResult> runCleaning(const CleaningTask& task, Scheme scheme, bool with_moments) {
  auto rig = Rig::create(task.field, task.rover, task.start, task.celsius, task.seed, task.index);
  if (!rig) return tl::unexpected<Error>(rig.error());
  const Room room{task.field.length, task.field.width};
  CleaningResult result;
  const auto fix = findStart(*rig, room, task.spread.range_noise);
  if (!fix) {
    result.reason = fix.error().message;
    result.seconds = rig->seconds();
    return result;
  }
  result.outcome = CleaningOutcome::kFinished;
  judgeStart(*rig, room, task, *fix, result);
  if (result.outcome == CleaningOutcome::kWrongAxis) return result;
  const CleaningRoute route = cleaningRoute(room, fix->start.pose, task.rover.margin, task.rover.spacing);
  result.route_length = lengthOf(route);
  const auto estimator = estimatorFor(scheme, task, *fix);
  rig->setAir(task.celsius + task.warming);
  CleaningDrive drive(*rig, room, route.points, *estimator, result.echo_speed, result, with_moments);
  drive.run(rig->seconds() + kSlack * timeFor(route, task.rover.limits) + kSlackSeconds);
  return result;
}

}  // namespace fulbito::localization
