#pragma once

#include <functional>
#include <span>
#include <utility>
#include <vector>

#include <box2d/b2_world_callbacks.h>

#include "engine/sim/contacts/squeeze.hpp"
#include "engine/sim/surface.hpp"
#include "fulbito/world.hpp"

namespace fulbito {

/// Listens to Box2D's contacts: sets friction and restitution of each pair and the face along which boxes
/// push, and sums the impulses of a tick.
/// Bodies are numbered: walls, robots, balls, obstacles.
class ContactLog final : public b2ContactListener {
 public:
  /// A ball that hit a wall in the last physics step.
  struct WallHit {
    std::size_t ball;  // index of the ball
    Vec2 normal;       // unit
  };

  /// @param bodies  identity of each body, by number
  /// @param walls  unit vectors into the field, by number of the walls' fixtures
  /// @param squeeze  with no balls added
  ContactLog(std::vector<BodyId> bodies, std::vector<Surface> surfaces, std::vector<Vec2> walls,
             Squeeze squeeze);

  /// Sets a function to call within the engine's step, once it has solved all contacts that touched at its
  /// start.
  /// Bodies that touch nothing may not have moved yet.
  void onSolved(std::function<void()> call) { on_solved_ = std::move(call); }

  /// The record of bodies that press on the balls. Add the balls in order of their index.
  Squeeze& squeeze() { return squeeze_; }

  void startTick(Tick tick);
  void startStep() { wall_hits_.clear(); }
  /// Before each step of the engine, of which a physics step may have several.
  void startPart() { solved_ = false, unsolved_ = 0; }
  /// Sorts the tick's events.
  void finishTick();

  std::span<const ContactEvent> events() const { return events_; }
  std::span<const WallHit> wallHits() const { return wall_hits_; }
  /// Whether the engine's last step solved any contact: without one, no velocity has changed.
  bool solved() const { return solved_; }

  void BeginContact(b2Contact* contact) override;
  void PreSolve(b2Contact* contact, const b2Manifold* before) override;
  void PostSolve(b2Contact* contact, const b2ContactImpulse* impulse) override;

 private:
  struct Pair {
    Tick touched = -2;     // last tick of contact after an event
    Tick event_tick = -2;  // last tick with an event
    std::size_t event = 0;
    // [Box2D units per s] of the body that touches a ball, before the engine solved the contact
    float surface_speed = 0.0f;
  };

  Pair& pairAt(std::size_t a, std::size_t b) { return pairs_[a * bodies_.size() + b]; }
  bool isBall(std::size_t number) const { return bodies_[number].kind == BodyKind::kBall; }
  void stopBouncing(b2Contact& contact, const b2Manifold& before) const;
  void lookAtSurface(b2Contact& contact);
  float surfaceSpeed(b2Contact& contact, b2Vec2 point) const;
  void press(b2Contact& contact, b2Vec2 point, const Pair& pair);
  void record(b2Contact& contact, const b2ContactImpulse& impulse);

  std::vector<BodyId> bodies_;
  std::vector<Surface> surfaces_;
  std::vector<Vec2> walls_;
  std::vector<Pair> pairs_;  // by number of the first body times count plus number of the second
  std::vector<ContactEvent> events_;
  std::vector<WallHit> wall_hits_;
  Squeeze squeeze_;
  Tick tick_ = 0;
  bool solved_ = false;
  int unsolved_ = 0;  // contacts that wait for the solver
  std::function<void()> on_solved_;
};

}  // namespace fulbito
