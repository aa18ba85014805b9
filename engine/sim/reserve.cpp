#include "engine/sim/reserve.hpp"

#include <vector>

#include <box2d/b2_body.h>
#include <box2d/b2_circle_shape.h>
#include <box2d/b2_world.h>

namespace fulbito {

void reserveContacts(b2World& world, std::size_t bodies) {
  // In a crowd, a body's enlarged box overlaps about this many others.
  constexpr std::size_t kPairsPerBody = 48;
  std::size_t discs = 2;
  while (discs * (discs - 1) / 2 < kPairsPerBody * bodies) ++discs;

  b2BodyDef def;
  def.type = b2_dynamicBody;
  b2CircleShape disc;
  disc.m_radius = 0.1f;
  std::vector<b2Body*> crowd(discs);
  for (b2Body*& body : crowd) {
    body = world.CreateBody(&def);
    body->CreateFixture(&disc, 1.0f);
  }
  world.Step(0.0f, 1, 1);  // finds the pairs without moving anything
  for (b2Body* body : crowd) world.DestroyBody(body);
}

}  // namespace fulbito
