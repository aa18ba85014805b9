#include "experiments/papers/transport/step_plan.hpp"

#include <algorithm>
#include <cmath>

namespace fulbito {
namespace {

constexpr double kTouching = 1e-9;           // [m]
constexpr double kShortestRepair = 0.01;     // [s]
constexpr double kSpeedRounding = 1 - 1e-9;  // keeps the speed below the limit despite rounding

class Planner {
 public:
  Planner(const TransportTask& task, const StepQuestion& question) : task_(task), ask_(question) {}

  StepPlan plan();

 private:
  double masterDuration() const;
  double relation() const;
  double endAfter(double speed, double duration) const;
  StepPlan repair() const;
  void stopAtPathEnd(StepPlan& plan) const;
  bool tooFast(const StepPlan& plan) const;
  bool leavesPart(const StepPlan& plan) const;

  const TransportTask& task_;
  const StepQuestion& ask_;
};

double Planner::masterDuration() const {
  const std::size_t part = ask_.master.part;
  const double end = ask_.master_speed > 0.0 ? task_.path.to(part) : task_.path.from(part);
  return std::clamp((end - ask_.master.q) / ask_.master_speed, 0.0, ask_.step);
}

double Planner::relation() const {
  const bool leads = ask_.slave == CarrierId::kLead;
  const RodView view =
      leads ? viewRod(task_.path, ask_.own, ask_.master) : viewRod(task_.path, ask_.master, ask_.own);
  return leads ? slaveSpeed(ask_.master_speed, view.follower, view.lead)
               : slaveSpeed(ask_.master_speed, view.lead, view.follower);
}

double Planner::endAfter(double speed, double duration) const {
  const PartPlace slave{ask_.own.part, ask_.own.q + speed * duration};
  if (!ask_.project) return slave.q;
  const double master = ask_.master.q + ask_.master_speed * duration;
  return onRod(task_.path, task_.path.pose(ask_.master.part, master).position, slave, task_.rod);
}

// The master waits while the slave moves to where the rod fits.
StepPlan Planner::repair() const {
  StepPlan plan;
  plan.target = endAfter(0.0, 0.0);
  plan.duration = std::max(kShortestRepair, 2 * std::abs(plan.target - ask_.own.q) / task_.max_speed);
  return plan;
}

// If the lead is the slave and reaches the path's end, both robots stop there.
void Planner::stopAtPathEnd(StepPlan& plan) const {
  const double end = task_.path.length();
  if (ask_.slave != CarrierId::kLead || plan.target <= end) return;
  plan.duration *= (end - ask_.own.q) / (plan.target - ask_.own.q);
  plan.target = std::min(endAfter(plan.speed, plan.duration), end);
}

bool Planner::tooFast(const StepPlan& plan) const {
  const double driven = std::abs(plan.target - ask_.own.q) / plan.duration;
  return std::max(std::abs(plan.speed), driven) > task_.max_speed * kSpeedRounding;
}

bool Planner::leavesPart(const StepPlan& plan) const {
  return plan.target > task_.path.to(ask_.own.part) + kTouching ||
         plan.target < task_.path.from(ask_.own.part) - kTouching;
}

StepPlan Planner::plan() {
  if (ask_.master_speed == 0.0) return repair();
  StepPlan plan;
  plan.duration = masterDuration();
  plan.speed = relation();
  if (!(std::abs(plan.speed) <= task_.max_speed * kSpeedRounding)) {
    plan.cause = SwitchCause::kSpeed;
    return plan;
  }
  plan.target = endAfter(plan.speed, plan.duration);
  stopAtPathEnd(plan);
  if (tooFast(plan)) plan.cause = SwitchCause::kSpeed;
  if (leavesPart(plan)) plan.cause = SwitchCause::kPartEnd;
  return plan;
}

}  // namespace

StepPlan planStep(const TransportTask& task, const StepQuestion& question) {
  return Planner(task, question).plan();
}

}  // namespace fulbito
