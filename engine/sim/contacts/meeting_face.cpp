#include "engine/sim/contacts/meeting_face.hpp"

#include <algorithm>
#include <limits>
#include <span>
#include <utility>

#include <box2d/b2_body.h>
#include <box2d/b2_collision.h>
#include <box2d/b2_contact.h>
#include <box2d/b2_fixture.h>
#include <box2d/b2_polygon_shape.h>

namespace fulbito {
namespace {

struct PlacedPolygon {
  const b2PolygonShape& shape;
  const b2Transform& at;
};

bool isPolygon(const b2Fixture& fixture) { return fixture.GetType() == b2Shape::e_polygon; }

PlacedPolygon placed(b2Fixture& fixture) {
  return {static_cast<const b2PolygonShape&>(*fixture.GetShape()), fixture.GetBody()->GetTransform()};
}

// Distance of the other polygon from the line of the face that it is farthest from; negative if they overlap.
float separation(const PlacedPolygon& faces, const PlacedPolygon& other) {
  const b2Transform to_faces = b2MulT(faces.at, other.at);
  float most = -std::numeric_limits<float>::max();
  for (int face = 0; face < faces.shape.m_count; ++face) {
    float least = std::numeric_limits<float>::max();
    for (const b2Vec2& corner :
         std::span(other.shape.m_vertices, static_cast<std::size_t>(other.shape.m_count)))
      least = std::min(
          least, b2Dot(faces.shape.m_normals[face], b2Mul(to_faces, corner) - faces.shape.m_vertices[face]));
    most = std::max(most, least);
  }
  return most;
}

void startFrom(const b2Manifold& before, b2ManifoldPoint& point) {
  point.normalImpulse = point.tangentImpulse = 0.0f;
  for (const b2ManifoldPoint& old : std::span(before.points, static_cast<std::size_t>(before.pointCount))) {
    if (old.id.key != point.id.key) continue;
    point.normalImpulse = old.normalImpulse;
    point.tangentImpulse = old.tangentImpulse;
  }
}

}  // namespace

void chooseMeetingFace(b2Contact& contact, const b2Manifold& before) {
  b2Fixture &first = *contact.GetFixtureA(), &second = *contact.GetFixtureB();
  if (!isPolygon(first) || !isPolygon(second)) return;
  if (contact.GetManifold()->type == b2Manifold::e_faceB) return;  // better by more than the tolerance
  const PlacedPolygon a = placed(first), b = placed(second);
  if (separation(a, b) >= separation(b, a)) return;
  b2Manifold swapped;
  b2CollidePolygons(&swapped, &b.shape, b.at, &a.shape, a.at);
  if (swapped.pointCount == 0) return;
  swapped.type = b2Manifold::e_faceB;  // of the contact's order; for the call, it was the first one's
  for (b2ManifoldPoint& point : std::span(swapped.points, static_cast<std::size_t>(swapped.pointCount))) {
    std::swap(point.id.cf.indexA, point.id.cf.indexB);
    std::swap(point.id.cf.typeA, point.id.cf.typeB);
    startFrom(before, point);
  }
  *contact.GetManifold() = swapped;
}

}  // namespace fulbito
