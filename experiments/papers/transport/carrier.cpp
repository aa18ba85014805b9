#include "experiments/papers/transport/carrier.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "experiments/papers/transport/constraint_curve.hpp"

namespace fulbito {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();
constexpr double kAtJoint = 1e-9;        // [m]
constexpr double kArrivedWithin = 1e-5;  // [m]
constexpr double kRodFits = 1e-4;        // [m] the slave corrects a larger error before the next run
constexpr int kHopsOfImpasse = 2;
constexpr int kMostHops = 6;  // exchanges of roles without motion that count as a deadlock

// Share of the slave's speed limit. The slave's speed changes during the run, so after each two further
// exchanges the share is halved.
double easyShare(int hop) {
  double share = 0.9;
  for (int i = kHopsOfImpasse + 2; i <= hop; i += 2) share /= 2;
  return share;
}

}  // namespace

Carrier::Carrier(const TransportTask& task, const CarrierTimes& times, CarrierId id,
                 const CarrierHabits& habits)
    : task_(&task),
      times_(times),
      id_(id),
      master_(id == CarrierId::kLead),
      habits_(habits),
      sign_(travelSign(task)) {
  const double q = id == CarrierId::kLead ? task.lead : task.follower;
  own_ = {task.path.partAt(q), q};
}

double Carrier::resendPeriod() const {
  return out_of_contact_ ? times_.timeout / 4 : 2 * times_.delay + 2 * times_.patience;
}

void Carrier::say(Message message, std::vector<Message>& out) {
  message.step = step_;
  message.hop = hop_;
  out.push_back(message);
  if (message.kind != MessageKind::kBeat) last_ = message;
}

void Carrier::wait(State state, double now) {
  state_ = state;
  waits_from_ = now;
  next_resend_ = now + resendPeriod();
}

void Carrier::begin(std::vector<Message>& out) {
  if (!master_) askForStep(0.0, out);
}

void Carrier::endWith(StopReason reason, std::vector<Message>& out) {
  state_ = State::kEnded;
  reason_ = reason;
  Message message;
  message.kind = MessageKind::kStop;
  message.reason = reason;
  say(message, out);
}

bool Carrier::arrived() const {
  return id_ == CarrierId::kLead && own_.q >= task_->path.length() - kArrivedWithin;
}

void Carrier::askForStep(double now, std::vector<Message>& out) {
  ++step_;
  hop_ = 0;
  Message message;
  message.kind = MessageKind::kStart;
  message.place = own_;
  say(message, out);
  wait(State::kAwaitVelocity, now);
}

void Carrier::answerStart(const Message& message, double now, std::vector<Message>& out) {
  if (running()) {
    ++aborts_;
    halt(now);
  }
  step_ = message.step;
  hop_ = 0;
  other_ = message.place;
  lead(MessageKind::kVelocity, SwitchCause::kNone, now, out);
}

// The sign makes both robots follow the constraint curve in the same direction. In an impasse either robot as
// the slave would leave its part or be too fast, and only a slower master helps.
double Carrier::masterSpeed() const {
  const bool leads = id_ == CarrierId::kLead;
  const RodView view = leads ? viewRod(task_->path, own_, other_) : viewRod(task_->path, other_, own_);
  if (habits_.project && std::abs(norm(view.rod) - task_->rod) > kRodFits) return 0.0;
  const double own = leads ? view.lead : view.follower, others = leads ? view.follower : view.lead;
  double speed = task_->speed;
  if (habits_.slow && hop_ >= kHopsOfImpasse)
    speed = std::min(speed, easyShare(hop_) * task_->max_speed * std::abs(others / own));
  return std::copysign(speed, sign_ * others);
}

// Lets a master enter the next part. Returns false if the path has none.
bool Carrier::enterPart() {
  const PartPath& path = task_->path;
  if (speed_ > 0.0 && own_.q >= path.to(own_.part) - kAtJoint) {
    if (own_.part + 1 == path.size()) return false;
    ++own_.part;
  } else if (speed_ < 0.0 && own_.q <= path.from(own_.part) + kAtJoint) {
    if (own_.part == 0) return false;
    --own_.part;
  }
  return true;
}

void Carrier::lead(MessageKind kind, SwitchCause cause, double now, std::vector<Message>& out) {
  speed_ = masterSpeed();
  if (!enterPart()) return endWith(StopReason::kOffPath, out);
  Message message;
  message.kind = kind;
  message.place = own_;
  message.speed = speed_;
  message.cause = cause;
  say(message, out);
  wait(State::kAwaitRuntime, now);
}

void Carrier::takeOver(SwitchCause cause, double now, std::vector<Message>& out) {
  if (++hop_ > kMostHops) return endWith(StopReason::kDeadlock, out);
  master_ = true;
  lead(MessageKind::kSwitch, cause, now, out);
}

void Carrier::arm(double begin, double duration, double target) {
  state_ = State::kArmed;
  begin_ = begin;
  end_ = begin + duration;
  target_ = target;
  rate_ = (target - own_.q) / duration;
}

void Carrier::follow(double master_speed, double now, std::vector<Message>& out) {
  const StepPlan plan = planStep(*task_, {id_, own_, other_, master_speed, times_.step, habits_.project});
  if (plan.cause != SwitchCause::kNone) return takeOver(plan.cause, now, out);
  arm(now + 2 * times_.delay + times_.margin, plan.duration, plan.target);
  heard_beat_ = -kNever;
  next_beat_ = now + times_.beat;
  Message message;
  message.kind = MessageKind::kRuntime;
  message.begin = begin_;
  message.duration = plan.duration;
  say(message, out);
}

void Carrier::hearSwitch(const Message& message, double now, std::vector<Message>& out) {
  hop_ = message.hop;
  other_ = message.place;
  master_ = false;
  follow(message.speed, now, out);
}

void Carrier::hearRuntime(const Message& message, double now, std::vector<Message>& out) {
  arm(message.begin, message.duration, own_.q + speed_ * message.duration);
  heard_beat_ = now;
  beat(now, out);
}

void Carrier::hear(const Message& message, double now, std::vector<Message>& out) {
  if (message.kind == MessageKind::kStop && !ended()) {
    halt(now);
    state_ = State::kEnded;
    reason_ = message.reason;
  }
  if (ended()) {
    if (message.kind != MessageKind::kStop) out.push_back(last_);
    return;
  }
  heard_ = now;
  out_of_contact_ = false;
  const bool due = message.step == step_ && message.hop == hop_;
  switch (message.kind) {
    case MessageKind::kStart:
      if (master_ && message.step > step_) answerStart(message, now, out);
      break;
    case MessageKind::kVelocity:
      if (!due || state_ != State::kAwaitVelocity) break;
      other_ = message.place;
      follow(message.speed, now, out);
      break;
    case MessageKind::kSwitch:
      if (message.step == step_ && message.hop == hop_ + 1 && state_ == State::kAwaitRuntime)
        hearSwitch(message, now, out);
      break;
    case MessageKind::kRuntime:
      if (due && state_ == State::kAwaitRuntime) hearRuntime(message, now, out);
      break;
    case MessageKind::kDone:
      if (message.step == step_ && state_ == State::kAwaitDone) askForStep(now, out);
      break;
    case MessageKind::kBeat:
      if (message.step == step_) heard_beat_ = now;
      break;
    case MessageKind::kStop:
      break;
  }
}

double Carrier::alarm() const {
  switch (state_) {
    case State::kEnded:
      return kNever;
    case State::kArmed:
      return std::min(begin_, next_beat_);
    case State::kRunning:
      return std::min({end_, next_beat_, lastMoment()});
    default:
      return next_resend_;
  }
}

PartPlace Carrier::placeAt(double now) const {
  if (!running()) return own_;
  return {own_.part, now >= end_ ? target_ : own_.q + rate_ * (now - begin_)};
}

void Carrier::beat(double now, std::vector<Message>& out) {
  Message message;
  message.kind = MessageKind::kBeat;
  say(message, out);
  next_beat_ = now + times_.beat;
}

void Carrier::halt(double now) { own_ = placeAt(now); }

void Carrier::startOrHold(double now, std::vector<Message>& out) {
  if (now <= lastMoment()) {
    state_ = State::kRunning;
    begin_ = now;
    return beat(now, out);
  }
  if (master_) return wait(State::kAwaitStart, now);
  askForStep(now, out);
}

void Carrier::finishRun(double now, std::vector<Message>& out) {
  halt(now);
  if (arrived()) return endWith(StopReason::kArrived, out);
  if (!master_) return wait(State::kAwaitDone, now);
  Message message;
  message.kind = MessageKind::kDone;
  say(message, out);
  wait(State::kAwaitStart, now);
}

void Carrier::breakOff(double now, std::vector<Message>& out) {
  ++aborts_;
  halt(now);
  if (master_) return wait(State::kAwaitStart, now);
  askForStep(now, out);
}

// Sends the last message again. A slave that hears no kDone continues without it.
void Carrier::stillWaiting(double now, std::vector<Message>& out) {
  if (now - heard_ > times_.silence) return endWith(StopReason::kSilence, out);
  if (!out_of_contact_ && now - std::max(heard_, waits_from_) > times_.timeout) {
    out_of_contact_ = true;
    ++timeouts_;
  }
  next_resend_ = now + resendPeriod();
  if (state_ == State::kAwaitDone) return askForStep(now, out);
  if (state_ != State::kAwaitStart) out.push_back(last_);
}

void Carrier::wake(double now, std::vector<Message>& out) {
  switch (state_) {
    case State::kEnded:
      return;
    case State::kArmed:
      return now >= begin_ ? startOrHold(now, out) : beat(now, out);
    case State::kRunning:
      if (now >= end_) return finishRun(now, out);
      return now >= lastMoment() ? breakOff(now, out) : beat(now, out);
    default:
      return stillWaiting(now, out);
  }
}

}  // namespace fulbito
