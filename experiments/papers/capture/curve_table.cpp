#include "experiments/papers/capture/curve_table.hpp"

#include "experiments/papers/capture/paper_tables.hpp"
#include "fulbito/report.hpp"

namespace fulbito::capture {
namespace {

constexpr std::size_t kWays = 4;

CurveDriveSetup setupOf(const RobotModel& robot, std::size_t speed, bool twice, std::size_t way) {
  CurveDriveSetup setup;
  setup.robot = robot;
  setup.speed = PaperTables::kSpeeds[speed];
  setup.radius = twice ? PaperTables::kDoubleRadius : PaperTables::kSingleRadius;
  setup.turn = PaperTables::kTurn;
  setup.twice = twice;
  setup.from_rest = way == 0 || way == 2;
  setup.instant_change = way == 3;
  setup.acceleration = PaperTables::kAcceleration;
  if (way == 0) setup.robot.curve_widening = setup.robot.curve_widening_rise = 0.0;
  return setup;
}

CurveDriveResult& placeOf(CurveRow& row, std::size_t way) {
  if (way == 0) return row.ideal;
  if (way == 3) return row.instant;
  return way == 1 ? row.driven : row.started;
}

constexpr std::array<double, 4> kRadii{1.0, 1.875, 2.6, 3.75};  // [m]

/// The place after `way` [m] on a trace, or its end if the trace is shorter.
Vec2 placeAfter(const std::vector<Pose2>& trace, double way) {
  double driven = 0.0;
  for (std::size_t i = 1; i < trace.size(); ++i) {
    const Vec2 from = trace[i - 1].position, to = trace[i].position;
    const double step = distance(from, to);
    if (driven + step >= way) return from + (to - from) * ((way - driven) / step);
    driven += step;
  }
  return trace.back().position;
}

}  // namespace

double CurveRow::time(double speed) const { return timeOf(driven, speed); }

double timeOf(const CurveDriveResult& drive, double speed) {
  return drive.time + speed / (2 * PaperTables::kAcceleration);
}

Result<CurveTable> driveCurves(const RobotModel& robot, int jobs, const Progress& progress) {
  CurveTable table;
  constexpr std::size_t kDrives = PaperTables::kSpeeds.size() * 2 * kWays;
  WorkProgress work(progress, kDrives);
  const auto done = parallelFor(jobs, kDrives, work, [&](std::size_t i) -> Result<void> {
    const std::size_t speed = i / (2 * kWays), way = i % kWays;
    const bool twice = i / kWays % 2 == 1;
    if (way == 3 && !twice) return {};  // a single curve has no change
    auto result = driveCurve(setupOf(robot, speed, twice, way));
    if (!result) return tl::unexpected<Error>(result.error());
    placeOf(twice ? table.both[speed] : table.single[speed], way) = std::move(*result);
    return {};
  });
  if (!done) return tl::unexpected<Error>(done.error());
  return table;
}

Result<std::vector<CurveError>> driveCurveErrors(const RobotModel& robot) {
  std::vector<CurveError> errors;
  for (const double radius : kRadii) {
    for (const double speed : PaperTables::kSpeeds) {
      CurveDriveSetup setup;
      setup.robot = robot;
      setup.speed = speed;
      setup.radius = radius;
      setup.turn = kErrorWay / radius;
      const auto driven = driveCurve(setup);
      if (!driven) return tl::unexpected<Error>(driven.error());
      const Arc wanted{driven->trace.front(), -1.0 / radius, kErrorWay};
      errors.push_back(
          {radius, speed, distance(placeAfter(driven->trace, kErrorWay), endOf(wanted).position)});
    }
  }
  return errors;
}

}  // namespace fulbito::capture
