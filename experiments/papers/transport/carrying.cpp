#include "experiments/papers/transport/carrying.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace fulbito {
namespace {

CarrierTimes timesFor(const CarryPlan& plan) {
  CarrierTimes times;
  times.step = plan.step;
  times.delay = plan.radio.delay;
  // Several beats must have a chance to arrive before the run.
  if (!plan.radio.ideal()) times.margin = 3 * times.beat;
  return times;
}

TransportTask slowed(TransportTask task, double share) {
  task.speed *= share;
  task.max_speed *= share;
  return task;
}

/// Both robots, the radio, and the bookkeeping.
class Pair {
 public:
  Pair(const TransportTask& task, const CarryPlan& plan);

  Carrying run();

 private:
  Carrier& robot(CarrierId id) { return robots_[indexOf(id)]; }
  void post(CarrierId from, double now);
  void note(CarrierId from, const Message& message, double now);
  bool deliver(double now);
  bool wakeBoth(double now);
  void settle(double now);
  double nextEvent() const;
  bool over(double now) const;
  void watch(double now);
  void measureRod(double now);
  void startRow(double now);
  void addWay(double now);
  Carrying finish(double now);

  CarryPlan plan_;
  TransportTask task_;
  CarrierTimes times_;
  std::array<Carrier, 2> robots_;
  Radio radio_;
  Carrying work_;
  std::vector<Message> out_;
  std::uint32_t switched_step_ = 0;  // step and hop of the last exchange of roles
  int switched_hop_ = 0;
  std::uint32_t row_step_ = 0;
  double last_ = 0.0;
  std::array<double, 2> last_q_{};
};

Pair::Pair(const TransportTask& task, const CarryPlan& plan)
    : plan_(plan),
      task_(slowed(task, safeSpeedShare(task, timesFor(plan)))),
      times_(timesFor(plan)),
      robots_{Carrier(task_, times_, CarrierId::kLead, plan.habits),
              Carrier(task_, times_, CarrierId::kFollower, plan.habits)},
      radio_(plan.radio, plan.seed, plan.index),
      last_q_{task.lead, task.follower} {
  work_.speed_share = safeSpeedShare(task, times_);
}

void Pair::note(CarrierId from, const Message& message, double now) {
  if (message.kind != MessageKind::kSwitch) return;
  if (message.step == switched_step_ && message.hop <= switched_hop_) return;  // a repeated message
  switched_step_ = message.step;
  switched_hop_ = message.hop;
  work_.switches.push_back({now, message.cause, from, message.speed < 0.0 ? -1.0 : 1.0,
                            robots_[0].placeAt(now).q, robots_[1].placeAt(now).q});
}

void Pair::post(CarrierId from, double now) {
  for (const Message& message : out_) {
    note(from, message, now);
    radio_.send(other(from), message, now);
  }
  out_.clear();
}

bool Pair::deliver(double now) {
  if (radio_.next() > now) return false;
  const Radio::Delivery delivery = radio_.take();
  robot(delivery.to).hear(delivery.message, now, out_);
  post(delivery.to, now);
  return true;
}

bool Pair::wakeBoth(double now) {
  bool any = false;
  for (const CarrierId id : {CarrierId::kLead, CarrierId::kFollower}) {
    if (robot(id).alarm() > now) continue;
    any = true;
    robot(id).wake(now, out_);
    post(id, now);
  }
  return any;
}

// Messages come first, so that one that arrives at the last moment is in time.
void Pair::settle(double now) {
  constexpr int kMostEvents = 10000;
  for (int i = 0; i < kMostEvents && (deliver(now) || wakeBoth(now)); ++i) {
  }
}

double Pair::nextEvent() const { return std::min({radio_.next(), robots_[0].alarm(), robots_[1].alarm()}); }

bool Pair::over(double now) const {
  constexpr double kLongest = 36000.0;  // [s]
  return (robots_[0].ended() && robots_[1].ended()) || now > kLongest;
}

void Pair::measureRod(double now) {
  const RodView view = viewRod(task_.path, robots_[0].placeAt(now), robots_[1].placeAt(now));
  work_.rod_error = std::max(work_.rod_error, std::abs(norm(view.rod) - task_.rod));
}

void Pair::addWay(double now) {
  const std::array<double, 2> q{robots_[0].placeAt(now).q, robots_[1].placeAt(now).q};
  work_.lead_way += std::abs(q[0] - last_q_[0]);
  work_.follower_way += std::abs(q[1] - last_q_[1]);
  last_q_ = q;
}

void Pair::startRow(double now) {
  if (!robots_[0].running() || !robots_[1].running() || robots_[0].step() == row_step_) return;
  row_step_ = robots_[0].step();
  ++work_.steps;
  if (!plan_.keep_rows) return;
  work_.rows.push_back({now, robots_[0].placeAt(now), robots_[1].placeAt(now), robots_[0].speed(),
                        robots_[1].speed(), robots_[0].master() ? CarrierId::kLead : CarrierId::kFollower});
}

void Pair::watch(double now) {
  addWay(now);
  measureRod(now);
  startRow(now);
  for (const Carrier& robot : robots_) work_.peak_speed = std::max(work_.peak_speed, std::abs(robot.speed()));
}

Carrying Pair::finish(double now) {
  work_.end = robots_[0].reason() != StopReason::kNone ? robots_[0].reason() : robots_[1].reason();
  work_.seconds = now;
  work_.lead = last_q_[0];
  work_.follower = last_q_[1];
  work_.messages = radio_.sent();
  work_.lost = radio_.lost();
  for (const Carrier& robot : robots_) work_.aborts += robot.aborts(), work_.timeouts += robot.timeouts();
  return std::move(work_);
}

Carrying Pair::run() {
  robots_[1].begin(out_);
  post(CarrierId::kFollower, 0.0);
  double now = 0.0;
  for (;; now = std::max(now, nextEvent())) {
    if (robots_[0].running() || robots_[1].running()) work_.moving += now - last_;
    last_ = now;
    settle(now);
    watch(now);
    if (over(now)) return finish(now);
  }
}

}  // namespace

double safeSpeedShare(const TransportTask& task, const CarrierTimes& times) {
  constexpr double kAlone = 0.0006;  // [m]
  return std::min(1.0, kAlone / (task.max_speed * (times.patience + times.delay)));
}

Carrying carry(const TransportTask& task, const CarryPlan& plan) { return Pair(task, plan).run(); }

}  // namespace fulbito
