#pragma once

#include <cstdint>
#include <vector>

#include "experiments/papers/transport/message.hpp"
#include "experiments/papers/transport/radio.hpp"
#include "experiments/papers/transport/step_plan.hpp"
#include "experiments/papers/transport/transport_task.hpp"

namespace fulbito {

/// Times of the exchange of messages, equal for both robots.
struct CarrierTimes {
  double step = 0.05;       ///< [s] greatest duration of a run
  double beat = 0.001;      ///< [s] between two beats
  double patience = 0.005;  ///< [s] a robot stops after this time plus the delay without a message
  double delay = 0.0;       ///< [s] greatest delay of a message
  double margin = 0.0;      ///< [s] between the arrival of kRuntime and the start of the run
  double timeout = 0.25;    ///< [s] time without a message that counts as loss of contact
  double silence = 30.0;    ///< [s] time without a message after which a robot gives up
};

/// Additions of both robots to the printed algorithm.
struct CarrierHabits {
  bool project = true;  ///< a slave ends each run at a rod's length from the master's end
  bool slow = true;     ///< after two idle exchanges of roles the master waits for the slave
};

/// One of the two robots: a state machine with messages and its own clock as inputs. It knows the path and
/// its own place exactly, and drives along the path at the speed that it sets. Both clocks agree.
///
/// In a step, the slave sends kStart, the master answers kVelocity, the slave plans and answers kRuntime,
/// both run, and the master sends kDone. A slave that cannot follow answers kSwitch, which makes it the
/// master. Messages without an answer are sent again. Over a lossy radio no exchange can guarantee that both
/// robots start together. So each robot sends beats while it runs and stops if it does not hear the other's.
/// Alone it drives less than speed times (patience + delay).
class Carrier {
 public:
  Carrier(const TransportTask& task, const CarrierTimes& times, CarrierId id, const CarrierHabits& habits);

  /// Begins at time 0. All functions append the messages that the robot sends.
  void begin(std::vector<Message>& out);
  void hear(const Message& message, double now, std::vector<Message>& out);
  /// Must be called at the time `alarm()`.
  void wake(double now, std::vector<Message>& out);
  double alarm() const;  ///< [s] time of the next call of `wake`; infinity: none

  bool master() const { return master_; }
  bool running() const { return state_ == State::kRunning; }
  bool ended() const { return state_ == State::kEnded; }
  bool outOfContact() const { return out_of_contact_; }
  StopReason reason() const { return reason_; }
  std::uint32_t step() const { return step_; }
  double speed() const { return running() ? rate_ : 0.0; }  ///< [m/s] along the path
  PartPlace placeAt(double now) const;
  int timeouts() const { return timeouts_; }  ///< losses of contact
  int aborts() const { return aborts_; }      ///< runs that the robot broke off

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
  double sign_;  // direction of travel, see travelSign
  State state_ = State::kAwaitStart;
  StopReason reason_ = StopReason::kNone;
  std::uint32_t step_ = 0;
  int hop_ = 0;
  PartPlace own_;    // during a run: where it began
  PartPlace other_;  // last known place of the other robot
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
  Message last_;  // message to repeat
  bool out_of_contact_ = false;
  int timeouts_ = 0;
  int aborts_ = 0;
};

}  // namespace fulbito
