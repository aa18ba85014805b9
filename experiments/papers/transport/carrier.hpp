#pragma once

#include <cstdint>
#include <vector>

#include "experiments/papers/transport/message.hpp"
#include "experiments/papers/transport/radio.hpp"
#include "experiments/papers/transport/step_plan.hpp"
#include "experiments/papers/transport/transport_task.hpp"

namespace fulbito {

/// The times by which robots exchange messages; alike for both.
struct CarrierTimes {
  double step = 0.05;       ///< [s] longest run
  double beat = 0.001;      ///< [s] between beats
  double patience = 0.005;  ///< [s] a robot that has heard nothing for this long, plus the delay, stops
  double delay = 0.0;       ///< [s] longest time of a message on its way
  double margin = 0.0;      ///< [s] between the arrival of kRuntime and the run
  double timeout = 0.25;    ///< [s] without a message that counts as loss of contact
  double silence = 30.0;    ///< [s] without a message after which a robot gives up
};

/// What both robots do beyond the printed algorithm.
struct CarrierHabits {
  bool project = true;  ///< a slave ends each run at a rod's length from where the master ends
  bool slow = true;     ///< after two exchanges of roles without motion the master lets the slave keep up
};

/// One of the two robots: a state machine that only messages and its own clock move. It has the path, knows
/// its own place exactly, and drives along the path at the speed that it sets. Both clocks agree.
///
/// A step: the slave sends kStart, the master answers kVelocity, the slave plans and answers kRuntime, both
/// run, the master sends kDone. A slave that cannot follow answers kSwitch, which makes it the master. What
/// is not answered is sent again. No exchange of messages over a radio that loses some can make two robots
/// start surely together, so each beats while it runs, and stops when it does not hear the other: alone it
/// drives less than speed times (patience + delay).
class Carrier {
 public:
  Carrier(const TransportTask& task, const CarrierTimes& times, CarrierId id, const CarrierHabits& habits);

  /// Begins at time 0. All functions append what the robot sends.
  void begin(std::vector<Message>& out);
  void hear(const Message& message, double now, std::vector<Message>& out);
  /// To be called at `alarm()`.
  void wake(double now, std::vector<Message>& out);
  double alarm() const;  ///< [s] when it wants to be woken; infinity: never

  bool master() const { return master_; }
  bool running() const { return state_ == State::kRunning; }
  bool ended() const { return state_ == State::kEnded; }
  bool outOfContact() const { return out_of_contact_; }
  StopReason reason() const { return reason_; }
  std::uint32_t step() const { return step_; }
  double speed() const { return running() ? rate_ : 0.0; }  ///< [m/s] along the path
  PartPlace placeAt(double now) const;
  int timeouts() const { return timeouts_; }  ///< losses of contact
  int aborts() const { return aborts_; }      ///< runs that it broke off

 private:
  enum class State : std::uint8_t {
    kAwaitStart,
    kAwaitVelocity,
    kAwaitRuntime,
    kArmed,
    kRunning,
    kAwaitDone,
    kEnded
  };

  void say(Message message, std::vector<Message>& out);
  void wait(State state, double now);
  void askForStep(double now, std::vector<Message>& out);
  void answerStart(const Message& message, double now, std::vector<Message>& out);
  void lead(MessageKind kind, SwitchCause cause, double now, std::vector<Message>& out);
  double masterSpeed() const;
  bool enterPart();
  void follow(double master_speed, double now, std::vector<Message>& out);
  void takeOver(SwitchCause cause, double now, std::vector<Message>& out);
  void arm(double begin, double duration, double target);
  void hearRuntime(const Message& message, double now, std::vector<Message>& out);
  void hearSwitch(const Message& message, double now, std::vector<Message>& out);
  void startOrHold(double now, std::vector<Message>& out);
  void halt(double now);
  void finishRun(double now, std::vector<Message>& out);
  void breakOff(double now, std::vector<Message>& out);
  void beat(double now, std::vector<Message>& out);
  void stillWaiting(double now, std::vector<Message>& out);
  void endWith(StopReason reason, std::vector<Message>& out);
  bool arrived() const;
  double lastMoment() const { return heard_beat_ + times_.patience + times_.delay; }
  double resendPeriod() const;

  const TransportTask* task_;
  CarrierTimes times_;
  CarrierId id_;
  bool master_;
  CarrierHabits habits_;
  double sign_;  // of the direction of travel: travelSign
  State state_ = State::kAwaitStart;
  StopReason reason_ = StopReason::kNone;
  std::uint32_t step_ = 0;
  int hop_ = 0;
  PartPlace own_;    // while it runs: where the run began
  PartPlace other_;  // as the other last told
  double speed_ = 0.0;
  double rate_ = 0.0;
  double target_ = 0.0;
  double begin_ = 0.0;
  double end_ = 0.0;
  double next_beat_ = 0.0;
  double heard_beat_ = 0.0;
  double heard_ = 0.0;
  double waits_from_ = 0.0;
  double next_resend_ = 0.0;
  Message last_;  // what it sends again
  bool out_of_contact_ = false;
  int timeouts_ = 0;
  int aborts_ = 0;
};

}  // namespace fulbito
