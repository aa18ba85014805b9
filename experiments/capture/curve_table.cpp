#include "experiments/capture/curve_table.hpp"

#include "engine/core/system/worker_threads.hpp"
#include "experiments/capture/paper_tables.hpp"

namespace fulbito::capture {
namespace {

constexpr std::size_t kWays = 3;

CurveDriveSetup setupOf(const RobotModel& robot, std::size_t speed, bool twice, std::size_t way) {
  CurveDriveSetup setup;
  setup.robot = robot;
  setup.speed = PaperTables::kSpeeds[speed];
  setup.radius = twice ? PaperTables::kDoubleRadius : PaperTables::kSingleRadius;
  setup.turn = PaperTables::kTurn;
  setup.twice = twice;
  setup.from_rest = way != 1;
  setup.acceleration = PaperTables::kAcceleration;
  if (way == 0) setup.robot.curve_widening = setup.robot.curve_widening_rise = 0.0;
  return setup;
}

CurveDriveResult& placeOf(CurveRow& row, std::size_t way) {
  if (way == 0) return row.ideal;
  return way == 1 ? row.driven : row.started;
}

}  // namespace

double CurveRow::time(double speed) const { return driven.time + speed / (2 * PaperTables::kAcceleration); }

Result<CurveTable> driveCurves(const RobotModel& robot, int jobs, const Progress& progress) {
  CurveTable table;
  constexpr std::size_t kDrives = PaperTables::kSpeeds.size() * 2 * kWays;
  WorkProgress work(progress, kDrives);
  const auto done = parallelFor(jobs, kDrives, work, [&](std::size_t i) -> Result<void> {
    const std::size_t speed = i / (2 * kWays), way = i % kWays;
    const bool twice = i / kWays % 2 == 1;
    auto result = driveCurve(setupOf(robot, speed, twice, way));
    if (!result) return tl::unexpected<Error>(result.error());
    placeOf(twice ? table.both[speed] : table.single[speed], way) = std::move(*result);
    return {};
  });
  if (!done) return tl::unexpected<Error>(done.error());
  return table;
}

}  // namespace fulbito::capture
