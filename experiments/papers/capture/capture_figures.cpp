#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "experiments/papers/capture/capture_results.hpp"
#include "experiments/papers/capture/fig18.hpp"
#include "experiments/papers/capture/paper_tables.hpp"
#include "experiments/papers/capture/sightings.hpp"
#include "experiments/papers/capture/slip_fit.hpp"
#include "fulbito/models.hpp"

namespace fulbito::capture {
namespace {

constexpr double kDegree = math::kPi / 180;

// [m] bands of the radii: the residuals of the fit to all 15 of them, rounded up. Printed radii of the same
// drive differ by up to 0.09 m.
constexpr double kBandOfTable5 = 0.06, kBandOfTable6 = 0.11;
constexpr const char* kCalibrated = "calibration: slip is fitted to these radii";

// Effect of radii that are kBandOfTable6 larger on the double curve: the path is 0.21 m longer and ends 0.28
// m away.
constexpr double kDistanceOfTable6 = 0.21, kErrorOfTable6 = 0.28;
constexpr const char* kContradiction =
    "from 0.3 m/s on, the paper's times and distances contradict each other: table times-and-distances";

/// Adds one figure.
struct Adder {
  std::vector<PaperFigure>& figures;

  void operator()(PaperFigure figure) const { figures.push_back(std::move(figure)); }
};

std::string id(const char* what, double speed) { return fmt::format("{}-{:.1f}", what, speed); }

void addGeometry(const Adder& add) {
  CurveDriveSetup single;
  const Vec2 end = idealEnd(single);
  add({"table-1-distance", "Table 1", "length of the single curve", "m", 2, PaperTables::kDistance,
       PaperTables::kSingleRadius * PaperTables::kTurn, 7.17, 7.19});
  add({"table-1-end-x", "Table 1", "end of the single curve, x", "m", 2, 5.0, end.x, 5.0, 5.02});
  add({"table-1-end-y", "Table 1", "end of the single curve, y", "m", 2, 4.0, end.y, 3.52, 3.54,
       "an arc of 3.75 m and 109.65 degrees ends there; one through (5, 4) has a radius of 4.10 m"});
}

void addTable4(const CaptureResults& results, const Adder& add) {
  for (std::size_t i = 0; i < PaperTables::kSpeeds.size(); ++i) {
    const double v = PaperTables::kSpeeds[i];
    add({id("table-4-time", v), "Table 4", fmt::format("time at {:.1f} m/s without slip", v), "s", 1,
         PaperTables::kComputed[i].time, results.curves.single[i].ideal.time,
         PaperTables::kComputed[i].time - 0.05, PaperTables::kComputed[i].time + 0.15,
         "the paper cuts digits off"});
  }
}

void addTable5(const CaptureResults& results, const Adder& add) {
  for (std::size_t i = 0; i < PaperTables::kSpeeds.size(); ++i) {
    const double v = PaperTables::kSpeeds[i];
    const CurveRow& row = results.curves.single[i];
    const PaperTables::Single& paper = PaperTables::kSingle[i];
    add({id("table-5-radius", v), "Table 5", fmt::format("radius at {:.1f} m/s", v), "m", 2, paper.radius,
         row.driven.radius1, paper.radius - kBandOfTable5, paper.radius + kBandOfTable5, kCalibrated});
    add({id("table-5-time", v), "Table 5", fmt::format("time at {:.1f} m/s", v), "s", 1, paper.time,
         row.time(v), paper.time - 0.5, paper.time + 0.5});
    add({id("table-5-distance", v), "Table 5", fmt::format("distance at {:.1f} m/s", v), "m", 2,
         paper.distance, row.driven.distance, paper.distance - 0.1, paper.distance + 0.1});
  }
}

void addTable6(const CaptureResults& results, const Adder& add) {
  for (std::size_t i = 0; i < PaperTables::kSpeeds.size(); ++i) {
    const double v = PaperTables::kSpeeds[i];
    const CurveRow& row = results.curves.both[i];
    const PaperTables::Double& paper = PaperTables::kDouble[i];
    add({id("table-6-radius-1", v), "Table 6", fmt::format("first radius at {:.1f} m/s", v), "m", 2,
         paper.radius1, row.driven.radius1, paper.radius1 - kBandOfTable6, paper.radius1 + kBandOfTable6,
         kCalibrated});
    add({id("table-6-radius-2", v), "Table 6", fmt::format("second radius at {:.1f} m/s", v), "m", 2,
         paper.radius2, row.driven.radius2, paper.radius2 - kBandOfTable6, paper.radius2 + kBandOfTable6,
         kCalibrated});
    add({id("table-6-time", v), "Table 6", fmt::format("time at {:.1f} m/s", v), "s", 1, paper.time,
         row.time(v), paper.time - 1.2, paper.time + 1.2});
    add({id("table-6-distance", v), "Table 6", fmt::format("distance at {:.1f} m/s", v), "m", 2,
         paper.distance, row.driven.distance, paper.distance - kDistanceOfTable6,
         paper.distance + kDistanceOfTable6, v > 0.25 ? kContradiction : ""});
    add({id("table-6-error", v), "Table 6", fmt::format("error of the end at {:.1f} m/s", v), "m", 2,
         paper.error, row.driven.end_error, paper.error - kErrorOfTable6, paper.error + kErrorOfTable6,
         fmt::format("ours over the paper's: {:.2f}", row.driven.end_error / paper.error)});
    // The columns of the paper's tables hold different quantities, so the paper has no such ratio.
    add({id("end-error-ratio", v), "Tables 5, 6",
         fmt::format("end error, double over single, at {:.1f} m/s", v), "", 2, std::nullopt,
         row.driven.end_error / results.curves.single[i].driven.end_error, 1.7,
         std::numeric_limits<double>::infinity()});
  }
}

/// Cross-validation: the slip fitted to one table predicts the radii of the other.
void addCrossValidation(const Adder& add) {
  const char* const reason = "two radii of one drive differ by up to 0.09 m in print";
  const auto five = radiiOfTable5(), six = radiiOfTable6();
  add({"slip-of-5-on-6", "Tables 5, 6", "radii of Table 6 by the slip of Table 5: largest error", "m", 3,
       std::nullopt, judgedOn(fitWidening(five), six).worst, 0.0, kBandOfTable6, reason});
  add({"slip-of-6-on-5", "Tables 5, 6", "radii of Table 5 by the slip of Table 6: largest error", "m", 3,
       std::nullopt, judgedOn(fitWidening(six), five).worst, 0.0, kBandOfTable5, reason});
}

/// The heading of the paper's object by (21) as printed and by the corrected triangle.
void addHeading(const Adder& add) {
  const auto sighting = [](double time) {
    const Vec2 to = fig18Object().at(time) - fig18Robot().position;
    return Sighting{time, fig18Robot().position, math::angleOf(to), norm(to)};
  };
  const Sighting first = sighting(0.0), second = sighting(2.0);
  const SightingTriangle triangle = triangleOf(first, second);
  const double pan = second.bearing - fig18Robot().heading;
  const double printed = math::wrapAngle(triangle.theta2 + triangle.theta3 + pan - math::kPi / 2) / kDegree;
  add({"heading-of-object", "(20), (21)", "heading of the object from two exact sightings 2 s apart",
       "degrees", 1, printed, headingByTriangle(first, second) / kDegree, 39.99, 40.01,
       "\"paper\" is (21) as printed; it holds for a decreasing bearing only, and here it increases"});
}

/// The plan that follows from the paper's values, without slip and with a known object.
void addPrintedPlan(const Adder& add) {
  const auto plan = printedPlan();
  if (!plan) return;
  add({"printed-plan-time", "Fig. 18", "time of the plan whose top speed is the printed 0.546 m/s", "s", 1,
       30.2, plan->motion.duration(), 29.7, 30.7,
       "0.546 m/s is a first turn of 84.2 degrees; with r = 2.6 and 2.4 m the rest follows: table plans"});
  add({"printed-plan-gap", "Fig. 18", "its gap between the middles", "m", 3, std::nullopt, plan->gap});
}

/// Spread of time and gap over other errors of the sightings.
void addSpread(const CaptureResults& results, const Adder& add) {
  std::vector<double> times, gaps;
  for (const PursuitResult& run : results.again) times.push_back(run.time), gaps.push_back(run.gap);
  if (times.empty()) return;
  std::sort(times.begin(), times.end());
  const std::string over = fmt::format("over {} draws of the sightings", times.size());
  add({"capture-time-least", "Fig. 18", "shortest time " + over, "s", 2, 30.2, times.front(), 27.0, 31.5,
       "the estimate before the start sets the first turn: table sightings-again"});
  add({"capture-time-median", "Fig. 18", "median time " + over, "s", 2, 30.2, quantile(times, 0.5), 27.0,
       31.5});
  add({"capture-time-most", "Fig. 18", "longest time " + over, "s", 2, 30.2, times.back(), 27.0, 31.5,
       "a speed seen 0.004 m/s too low moves the place 30 s ahead by half the gap"});
  const auto [near, far] = std::minmax_element(gaps.begin(), gaps.end());
  add({"capture-gap-spread", "Fig. 18", "largest minus smallest gap " + over, "m", 3, std::nullopt,
       *far - *near});
}

void addCapture(const CaptureResults& results, const Adder& add) {
  const PursuitResult& run = results.runs[kTracked].result;
  add({"capture-time", "Fig. 18", "time of the capture", "s", 2, 30.2, run.time, 27.0, 31.5,
       "the paper does not say how far behind the object its robot ends; 0.24 m is ours"});
  add({"capture-gap", "Fig. 18", "gap at the end, between the middles", "m", 3, std::nullopt, run.gap, 0.15,
       0.33});
  add({"capture-speed", "Fig. 18", "speed of the robot at the end", "m/s", 3, 0.3, run.speed, 0.29, 0.31});
  add({"capture-heading", "Fig. 18", "heading of the robot at the end", "degrees", 2, 40.0,
       run.heading / kDegree, 38.0, 42.0});
}

void addRandom(const CaptureResults& results, const Adder& add) {
  const auto& captures = results.random.captures;
  if (captures.empty()) return;
  const auto caught =
      std::count_if(captures.begin(), captures.end(), [](const RandomCapture& c) { return c.caught(); });
  add({"random-captures", "section V.3",
       fmt::format("caught of {} random captures with a plan", captures.size()), "%", 0, std::nullopt,
       100.0 * static_cast<double>(caught) / static_cast<double>(captures.size()), 95.0, 100.0});
}

}  // namespace

void addFigures(const CaptureResults& results, ExperimentReport& report) {
  const Adder add{report.figures};
  addGeometry(add);
  addTable4(results, add);
  addTable5(results, add);
  addTable6(results, add);
  addCrossValidation(add);
  addHeading(add);
  addPrintedPlan(add);
  addCapture(results, add);
  addSpread(results, add);
  addRandom(results, add);
}

}  // namespace fulbito::capture
