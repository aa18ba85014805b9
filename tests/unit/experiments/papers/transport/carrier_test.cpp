#include "experiments/papers/transport/carrier.hpp"

#include <catch2/catch.hpp>

#include "experiments/papers/transport/path_file.hpp"

namespace fulbito {
namespace {

/// Both robots of the S path. The test delivers their messages.
struct Scene {
  TransportTask task = builtInTransport("s-path");
  CarrierTimes times;
  Carrier lead{task, times, CarrierId::kLead, {}};
  Carrier follower{task, times, CarrierId::kFollower, {}};
  std::vector<Message> out;

  Message only() {
    REQUIRE(out.size() == 1);
    const Message message = out[0];
    out.clear();
    return message;
  }
  Message start() {
    follower.begin(out);
    return only();
  }
  Message answer(Carrier& to, const Message& message, double now = 0.0) {
    to.hear(message, now, out);
    return only();
  }
};

}  // namespace

TEST_CASE("a step is START, VELOCITY, RUNTIME, both run, DONE, START", "[unit]") {
  Scene s;
  const Message start = s.start();
  CHECK(start.kind == MessageKind::kStart);
  CHECK(start.step == 1);
  const Message velocity = s.answer(s.lead, start);
  CHECK(velocity.kind == MessageKind::kVelocity);
  CHECK(velocity.speed == Approx(0.08));
  const Message runtime = s.answer(s.follower, velocity);
  CHECK(runtime.kind == MessageKind::kRuntime);
  CHECK(runtime.duration == Approx(0.05));
  const Message beat = s.answer(s.lead, runtime);
  CHECK(beat.kind == MessageKind::kBeat);
  s.follower.hear(beat, 0.0, s.out);
  s.lead.wake(0.0, s.out);
  s.follower.wake(0.0, s.out);
  CHECK(s.lead.running());
  CHECK(s.follower.running());
  s.out.clear();
  for (double t = 0.001; t < 0.05; t += 0.001) {  // beats of both robots
    Message from_lead = beat;
    s.lead.hear(from_lead, t, s.out);
    s.follower.hear(from_lead, t, s.out);
  }
  s.lead.wake(0.05, s.out);
  const Message done = s.only();
  CHECK(done.kind == MessageKind::kDone);
  s.follower.wake(0.05, s.out);
  CHECK(s.out.empty());
  const Message next = s.answer(s.follower, done, 0.05);
  CHECK(next.kind == MessageKind::kStart);
  CHECK(next.step == 2);
  CHECK(next.place.q == Approx(0.004));
}

TEST_CASE("old and repeated messages change nothing", "[unit]") {
  Scene s;
  const Message start = s.start();
  const Message velocity = s.answer(s.lead, start);
  s.lead.hear(start, 0.001, s.out);  // the same kStart again
  CHECK(s.out.empty());
  const Message runtime = s.answer(s.follower, velocity);
  s.follower.hear(velocity, 0.001, s.out);
  CHECK(s.out.empty());
  Message old = runtime;
  old.step = 0;
  s.lead.hear(old, 0.001, s.out);
  CHECK(s.out.empty());
}

TEST_CASE("what is not answered is sent again, then contact is lost", "[unit]") {
  Scene s;
  const Message start = s.start();
  double now = 0.0;
  int sent = 0;
  while (now < 1.0) {
    now = s.follower.alarm();
    s.follower.wake(now, s.out);
    for (const Message& message : s.out) {
      CHECK(message.kind == MessageKind::kStart);
      CHECK(message.step == start.step);
      ++sent;
    }
    s.out.clear();
  }
  CHECK(sent > 10);
  CHECK(s.follower.outOfContact());
  CHECK(s.follower.timeouts() == 1);
}

TEST_CASE("a robot that hears no beat stops within its patience", "[unit]") {
  Scene s;
  const Message velocity = s.answer(s.lead, s.start());
  const Message runtime = s.answer(s.follower, velocity);
  s.answer(s.lead, runtime);
  s.lead.wake(0.0, s.out);
  REQUIRE(s.lead.running());
  while (s.lead.running()) s.lead.wake(s.lead.alarm(), s.out);
  CHECK(s.lead.aborts() == 1);
  CHECK(s.lead.placeAt(1.0).q - 0.8 == Approx(0.08 * s.times.patience));
  // The follower has not heard that the lead is ready, so it does not start.
  s.out.clear();
  s.follower.wake(s.follower.alarm(), s.out);
  CHECK_FALSE(s.follower.running());
  CHECK(s.only().kind == MessageKind::kStart);
}

TEST_CASE("a slave that cannot follow becomes master, the master slave", "[unit]") {
  Scene s;
  // Shortly before the first exchange of roles: the follower would need more than 10 cm/s.
  s.task.lead = 8.108;
  s.task.follower = onRod(s.task.path, s.task.path.pose(8.108).position, {0, 0.34}, 0.8);
  s.lead = Carrier(s.task, s.times, CarrierId::kLead, {});
  s.follower = Carrier(s.task, s.times, CarrierId::kFollower, {});
  const Message velocity = s.answer(s.lead, s.start());
  const Message change = s.answer(s.follower, velocity);
  CHECK(change.kind == MessageKind::kSwitch);
  CHECK(change.cause == SwitchCause::kSpeed);
  CHECK(change.hop == 1);
  CHECK(s.follower.master());
  const Message runtime = s.answer(s.lead, change);
  CHECK(runtime.kind == MessageKind::kRuntime);
  CHECK_FALSE(s.lead.master());
}

}  // namespace fulbito
