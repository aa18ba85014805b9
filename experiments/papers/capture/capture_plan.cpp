#include "experiments/papers/capture/capture_plan.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "fulbito/models.hpp"
#include "fulbito/report.hpp"

namespace fulbito::capture {
namespace {

constexpr double kTurnStep = 1.5 * math::kPi / 180;  // [rad] step of the search for roots over the first turn
constexpr int kRadii1 = 8, kRadii3 = 4;              // number of radii that are tried
constexpr int kHalvings = 48;
// [rad] least angle between the lines; at smaller angles small errors of the estimate move their crossing
// far.
constexpr double kFlattest = 0.25;
constexpr double kGapError = 1e-4;    // [m] greatest error of a root; jumps of the gap fail this test
constexpr double kRadiusCost = 0.01;  // metres of gap per metre of the last radius, in the cost of a plan
constexpr double kTouchCost = 10.0;   // [m] cost of a path too near to the object, higher than all others
constexpr double kCheckStep = 0.25;   // [s] between checks of hall and clearance

/// Keeps the refusal nearest to a plan, which is the later one in the enumeration.
void note(CaptureAnswer& answer, CaptureRefusal refusal) {
  answer.refusal = std::max(answer.refusal, refusal);
}

/// Whether `holds(time, place)` is true along the whole plan from `from` [s] on.
bool allAlong(const CapturePlan& plan, double from, const auto& holds) {
  const int checks = static_cast<int>((plan.motion.duration() - from) / kCheckStep);
  for (int i = 0; i <= checks; ++i) {
    const double time = from + i * kCheckStep;
    if (!holds(time, plan.motion.at(time).pose.position)) return false;
  }
  return true;
}

bool inHall(const CaptureLimits& limits, const CapturePlan& plan) {
  return allAlong(plan, 0.0, [&](double, Vec2 p) {
    return std::abs(p.x) <= limits.half_hall && std::abs(p.y) <= limits.half_hall;
  });
}

/// Whether the distance between the centres stays above the clearance from `from` [s] on.
bool keepsClear(const CaptureLimits& limits, const ObjectMotion& object, const CapturePlan& plan,
                double from) {
  return allAlong(plan, from,
                  [&](double time, Vec2 p) { return distance(p, object.at(time)) >= limits.clearance; });
}

/// Takes a plan with the right gap if it is allowed and faster than the best plan so far.
void offer(const CaptureLimits& limits, const CaptureTask& task, const CapturePlan& plan,
           CaptureAnswer& answer) {
  if (plan.motion.duration() > limits.longest || !inHall(limits, plan)) {
    note(answer, CaptureRefusal::kTooLong);
  } else if (!keepsClear(limits, task.object, plan, 0.0)) {
    note(answer, CaptureRefusal::kCollides);
  } else if (!answer.plan || plan.motion.duration() < answer.plan->motion.duration()) {
    answer.plan = plan;
  }
}

/// All first turns of one side and radius, from the largest to the smallest.
struct Starts {
  double side, radius1;
  std::vector<double> turns;
  std::vector<CaptureStart> motions;
};

Starts startsOf(const CaptureLimits& limits, const Pose2& robot, double side, double radius1) {
  Starts starts{side, radius1, {}, {}};
  const double most = limits.largestTurn(radius1);
  for (int i = 0; i * kTurnStep < most; ++i) {
    const double turn = most - i * kTurnStep;
    starts.turns.push_back(turn);
    starts.motions.push_back(captureStart(limits, robot, side, radius1, turn));
  }
  return starts;
}

std::optional<CapturePlan> labelled(std::optional<CapturePlan> plan, const CaptureStart& start, double side,
                                    double radius1, double turn1) {
  if (plan) plan->side = side, plan->radius1 = radius1, plan->turn1 = turn1, plan->time1 = start.time;
  return plan;
}

/// Bisects between the turns `low` and `high`, whose gaps are on both sides of the wanted one. Empty if the
/// gap jumps over it.
std::optional<CapturePlan> rootBetween(const CaptureLimits& limits, const CaptureTask& task,
                                       const Starts& starts, double radius3, double low, double high,
                                       bool low_is_less) {
  std::optional<CapturePlan> plan;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = (low + high) / 2;
    plan = capturePlan(limits, task, starts.side, starts.radius1, middle, radius3);
    if (!plan || std::abs(plan->gap - task.gap) < kGapError) return plan;
    ((plan->gap < task.gap) == low_is_less ? low : high) = middle;
  }
  return std::nullopt;
}

/// Searches all roots for a robot that brakes at the start of the line.
void searchRoots(const CaptureLimits& limits, const CaptureTask& task, const Starts& starts, double radius3,
                 CaptureAnswer& answer) {
  std::optional<double> before;  // [m] gap of the previous turn
  for (std::size_t i = 0; i < starts.turns.size(); ++i) {
    const CaptureStart& start = starts.motions[i];
    const auto plan = captureEnd(limits, start.motion, start.top_speed, task.object, radius3);
    const bool less = plan && plan->gap < task.gap;
    if (plan) note(answer, less ? CaptureRefusal::kTooEarly : CaptureRefusal::kTooLate);
    if (plan && before && less != (*before < task.gap)) {
      const auto root =
          rootBetween(limits, task, starts, radius3, starts.turns[i], starts.turns[i - 1], less);
      if (root) offer(limits, task, *root, answer);
    }
    before = plan ? std::optional(plan->gap) : std::nullopt;
  }
}

/// The plan that brakes where its gap becomes the wanted one, or as near to it as possible. The gap is linear
/// in `early`.
std::optional<CapturePlan> withGap(const CaptureLimits& limits, const MotionProfile& motion, double speed,
                                   const ObjectMotion& object, double radius, double gap) {
  auto late = captureEnd(limits, motion, speed, object, radius, 0.0);
  const auto early = captureEnd(limits, motion, speed, object, radius, 1.0);
  if (!late || !early || late->gap == early->gap) return late;
  const double share = std::clamp((late->gap - gap) / (late->gap - early->gap), 0.0, 1.0);
  return captureEnd(limits, motion, speed, object, radius, share);
}

/// Searches all plans of a robot that brakes where the gap becomes the wanted one.
void searchLater(const CaptureLimits& limits, const CaptureTask& task, const Starts& starts, double radius3,
                 CaptureAnswer& answer) {
  for (std::size_t i = 0; i < starts.turns.size(); ++i) {
    const CaptureStart& start = starts.motions[i];
    const auto plan = withGap(limits, start.motion, start.top_speed, task.object, radius3, task.gap);
    if (!plan || std::abs(plan->gap - task.gap) > kGapError) continue;
    offer(limits, task, *labelled(plan, start, starts.side, starts.radius1, starts.turns[i]), answer);
  }
}

double between(double low, double high, int i, int count) { return low + (high - low) * i / (count - 1); }

/// The starts of all first radii, to both sides.
std::vector<Starts> allStarts(const CaptureLimits& limits, const Pose2& robot) {
  std::vector<Starts> all;
  for (const double side : {-1.0, 1.0}) {
    for (int i = 0; i < kRadii1; ++i) {
      const double radius1 = between(limits.least_radius1, limits.largestFirstRadius(), i, kRadii1);
      all.push_back(startsOf(limits, robot, side, radius1));
    }
  }
  return all;
}

/// Calls `search` for every start and last radius.
void searchAll(const CaptureLimits& limits, const std::vector<Starts>& starts, const auto& search) {
  for (const Starts& of_radius : starts) {
    for (int k = 0; k < kRadii3; ++k) {
      search(of_radius, between(limits.least_radius3, limits.greatest_radius3, k, kRadii3));
    }
  }
}

/// Speeds and lengths of a plan's line.
struct Line {
  double speed, object_speed;  // [m/s]
  double braking;              // [s]
  double cruise, early;        // [m] spare length, and the share of it driven before braking
};

/// Appends the line and the last curve, which has the curvature `bend` [1/m] and the length `length` [m].
void appendEnd(const Line& line, double bend, double length, MotionProfile& motion) {
  const Twist fast{line.speed, 0.0}, slow{line.object_speed, 0.0};
  motion.append({line.early * line.cruise / line.speed, fast, fast});
  motion.append({line.braking, fast, slow});
  motion.append({(1.0 - line.early) * line.cruise / line.object_speed, slow, slow});
  const Twist last{line.object_speed, line.object_speed * bend};
  motion.append({length / line.object_speed, last, last});
}

}  // namespace

double CaptureLimits::largestFirstRadius() const {
  return track / 2 * (speed / (acceleration * straighten) - 1.0);
}

double CaptureLimits::largestTurn(double radius) const {
  const double outer = radius + track / 2;
  // The time until the outer wheel reaches its top speed, or until straightening needs all of its time.
  const double time = std::min(speed / acceleration, 2.0 * straighten * outer / track);
  return acceleration * time * time / (2.0 * outer);
}

CaptureStart captureStart(const CaptureLimits& limits, const Pose2& robot, double side, double radius,
                          double turn) {
  const double outer = radius + limits.track / 2;
  CaptureStart start;
  start.time = std::sqrt(2.0 * outer * turn / limits.acceleration);
  const double yaw = limits.acceleration * start.time / outer;
  start.top_speed = yaw * radius;
  start.motion = MotionProfile(robot);
  start.motion.append({start.time, {}, {start.top_speed, side * yaw}});
  // The wheels differ by yaw * track, and both change toward their mean.
  const double straighten = yaw * limits.track / (2.0 * limits.acceleration);
  start.motion.append({straighten, {start.top_speed, side * yaw}, {start.top_speed, 0.0}});
  return start;
}

std::optional<CapturePlan> captureEnd(const CaptureLimits& limits, const MotionProfile& motion, double speed,
                                      const ObjectMotion& object, double radius, double early) {
  const Pose2 from = motion.end().pose;
  const double object_speed = norm(object.velocity), began = motion.duration();
  if (!(object_speed > 0.0)) return std::nullopt;
  const Vec2 line = object.velocity / object_speed, ahead = math::unit(from.heading);
  const double turn = math::wrapAngle(math::angleOf(line) - from.heading);
  const double rise = cross(line, ahead);  // growth of the distance to the object's line per distance driven
  if (std::abs(turn) < kFlattest || std::abs(rise) < kFlattest || speed < object_speed) return std::nullopt;
  const double bend = std::copysign(1.0 / radius, turn);
  const Vec2 end = endOf(Arc{from, bend, radius * std::abs(turn)}).position;
  const double straight = -cross(line, end - object.position) / rise;
  const double braking = (speed - object_speed) / limits.acceleration;
  const double cruise = straight - (speed + object_speed) / 2 * braking;
  if (cruise < 0.0) return std::nullopt;
  CapturePlan plan;
  plan.radius3 = radius, plan.turn3 = turn, plan.line = straight, plan.top_speed = speed;
  plan.straight_from = began;
  plan.motion = motion;
  appendEnd({speed, object_speed, braking, cruise, early}, bend, radius * std::abs(turn), plan.motion);
  const double time = plan.motion.duration();
  plan.gap = dot(object.at(time) - plan.motion.end().pose.position, line);
  return plan;
}

std::optional<CapturePlan> capturePlan(const CaptureLimits& limits, const CaptureTask& task, double side,
                                       double radius1, double turn1, double radius3) {
  const CaptureStart start = captureStart(limits, task.robot, side, radius1, turn1);
  return labelled(captureEnd(limits, start.motion, start.top_speed, task.object, radius3), start, side,
                  radius1, turn1);
}

CaptureAnswer planCapture(const CaptureLimits& limits, const CaptureTask& task) {
  CaptureAnswer answer;
  const double widest = limits.largestFirstRadius();
  const double object_speed = norm(task.object.velocity);
  if (object_speed >= limits.speed * widest / (widest + limits.track / 2) || object_speed == 0.0) {
    answer.refusal = CaptureRefusal::kTooFast;
    return answer;
  }
  answer.refusal = CaptureRefusal::kNoLine;
  const std::vector<Starts> starts = allStarts(limits, task.robot);
  searchAll(limits, starts, [&](const Starts& of_radius, double radius3) {
    searchRoots(limits, task, of_radius, radius3, answer);
  });
  if (answer.plan) return answer;
  searchAll(limits, starts, [&](const Starts& of_radius, double radius3) {
    searchLater(limits, task, of_radius, radius3, answer);
  });
  return answer;
}

std::optional<CapturePlan> replanEnd(const CaptureLimits& limits, const MotionProfile& motion, double speed,
                                     const ObjectMotion& object, double radius, double gap) {
  constexpr int kTried = 60;
  std::optional<CapturePlan> best;
  double best_cost = 0.0;
  for (int i = 0; i <= kTried; ++i) {
    const double tried =
        i == 0 ? radius : between(limits.least_radius3, 2.0 * limits.greatest_radius3, i - 1, kTried);
    const auto plan = withGap(limits, motion, speed, object, tried, gap);
    if (!plan || plan->motion.duration() > limits.longest) continue;
    const bool clear = keepsClear(limits, object, *plan, plan->straight_from);
    const double cost =
        std::abs(plan->gap - gap) + kRadiusCost * std::abs(tried - radius) + (clear ? 0.0 : kTouchCost);
    if (best && cost >= best_cost) continue;
    best = plan;
    best_cost = cost;
  }
  return best;
}

std::string nameOf(CaptureRefusal refusal) {
  constexpr std::array<const char*, 6> kNames = {"object too fast, or at rest", "no line to the object's",
                                                 "arrives too early",           "arrives too late",
                                                 "too long or out of the hall", "too near on the way"};
  return kNames[static_cast<std::size_t>(refusal)];
}

}  // namespace fulbito::capture
