#include "experiments/papers/transport/rod_constraint.hpp"

#include <cmath>

#include <catch2/catch.hpp>

#include "engine/core/math/random.hpp"
#include "fulbito/detail/math.hpp"
#include "tests/support/test_stream.hpp"

namespace fulbito {
namespace {

/// A line in the paper's form: a reference point, a slope, and the distance from the point.
struct PaperLine {
  Vec2 at;
  double slope;
  double s;

  Vec2 point() const { return at + math::unit(slope) * s; }
};

/// An arc in the paper's form: a centre, a radius, and the angle of the robot about the centre. Its speed is
/// r times the rate of the angle.
struct PaperArc {
  Vec2 centre;
  double radius;
  double angle;

  Vec2 point() const { return centre + math::unit(angle) * radius; }
};

PartPlace placeOn(std::size_t part) { return {part, 0.0}; }

Arc partOf(const PaperLine& line) { return {{line.point(), line.slope}, 0.0, 1.0}; }
Arc partOf(const PaperArc& arc) {
  return {{arc.point(), math::wrapAngle(arc.angle + math::kPi / 2)}, 1.0 / arc.radius, 1.0};
}

// The relation of the speeds when each robot is at the beginning of its part.
double relation(const Arc& master, const Arc& slave, double master_speed) {
  const PartPath path({master, slave});
  const RodView view = viewRod(path, placeOn(0), {1, path.from(1)});
  return slaveSpeed(master_speed, view.lead, view.follower);
}

struct Draws {
  Rng random{20, test::kTestStream};

  Vec2 point() { return {random.uniform(-2.0, 2.0), random.uniform(-2.0, 2.0)}; }
  double angle() { return random.uniform(-3.1, 3.1); }
  PaperLine line() { return {point(), angle(), random.uniform(-2.0, 2.0)}; }
  PaperArc arc() { return {point(), random.uniform(0.2, 2.0), angle()}; }
};

// (4) of the paper: v_c left = v_s right, with the printed and the corrected left side.
double right4(const PaperArc& c, const PaperLine& l) {
  const Vec2 d = c.centre - l.at;
  return c.radius * math::cos(l.slope - c.angle) - l.s + dot(math::unit(l.slope), d);
}
double printedLeft4(const PaperArc& c, const PaperLine& l) {
  const Vec2 d = c.centre - l.at;
  return math::cos(c.angle) * d.y + math::sin(c.angle) * d.x;
}
double correctedLeft4(const PaperArc& c, const PaperLine& l) {
  const Vec2 d = c.centre - l.at;
  return math::cos(c.angle) * d.y - math::sin(c.angle) * d.x - l.s * math::sin(l.slope - c.angle);
}

// The rate of the distance between two points that move along their parts, by central differences.
double stretch(const Arc& a, double va, const Arc& b, double vb) {
  constexpr double kTime = 1e-5;
  const auto apart = [&](double t) {
    return distance(poseAt(a, va * t).position, poseAt(b, vb * t).position);
  };
  return (apart(kTime) - apart(-kTime)) / (2 * kTime);
}

constexpr double kSpeed = 0.08;

}  // namespace

TEST_CASE("the one speed relation keeps the distance, whatever the parts are", "[unit]") {
  Draws draw;
  for (int i = 0; i < 300; ++i) {
    const Arc a = i % 3 == 0 ? partOf(draw.line()) : partOf(draw.arc());
    const Arc b = i % 2 == 0 ? partOf(draw.line()) : partOf(draw.arc());
    const double slave = relation(a, b, kSpeed);
    if (std::abs(slave) > 1.0) continue;
    CHECK(stretch(a, kSpeed, b, slave) == Approx(0.0).margin(1e-7));
  }
}

TEST_CASE("line and line: (7) of Lee, Lee & Lee is the relation", "[unit]") {
  Draws draw;
  for (int i = 0; i < 100; ++i) {
    const PaperLine one = draw.line(), two = draw.line();
    const Vec2 d = one.at - two.at;
    const double left = one.s - two.s * math::cos(one.slope - two.slope) + dot(math::unit(one.slope), d);
    const double right = -two.s + one.s * math::cos(one.slope - two.slope) + dot(math::unit(two.slope), d);
    CHECK(relation(partOf(one), partOf(two), kSpeed) == Approx(kSpeed * left / right).epsilon(1e-9));
  }
}

TEST_CASE("arc and arc: (10) of Lee, Lee & Lee is the relation", "[unit]") {
  Draws draw;
  for (int i = 0; i < 100; ++i) {
    const PaperArc one = draw.arc(), two = draw.arc();
    const Vec2 d = one.centre - two.centre;
    const double twist = math::sin(one.angle - two.angle);
    const double left = math::cos(one.angle) * d.y - math::sin(one.angle) * d.x + two.radius * twist;
    const double right = math::cos(two.angle) * d.y - math::sin(two.angle) * d.x + one.radius * twist;
    CHECK(relation(partOf(one), partOf(two), kSpeed) == Approx(kSpeed * left / right).epsilon(1e-9));
  }
}

TEST_CASE("line and arc: (4) of Lee, Lee & Lee with a sign and a term corrected is the relation", "[unit]") {
  Draws draw;
  for (int i = 0; i < 100; ++i) {
    const PaperArc arc = draw.arc();
    const PaperLine line = draw.line();
    const double wanted = kSpeed * correctedLeft4(arc, line) / right4(arc, line);
    CHECK(relation(partOf(arc), partOf(line), kSpeed) == Approx(wanted).epsilon(1e-9));
  }
}

TEST_CASE("line and arc: (3) and (4) as printed stretch the rod", "[unit]") {
  Draws draw;
  int right = 0;
  for (int i = 0; i < 100; ++i) {
    const PaperArc arc = draw.arc();
    const PaperLine line = draw.line();
    const double printed = kSpeed * printedLeft4(arc, line) / right4(arc, line);
    right += std::abs(stretch(partOf(arc), kSpeed, partOf(line), printed)) < 1e-3 ? 1 : 0;
  }
  CHECK(right <= 3);
  // The first arc of the S path: the follower at 3.5 m on the line, the lead 60 degrees along the arc.
  const PaperArc arc{{4.0, 0.25}, 0.25, -math::kPi / 6};
  const PaperLine line{{0.0, 0.0}, 0.0, 3.5};
  CHECK(correctedLeft4(arc, line) / right4(arc, line) == Approx(0.65108).margin(1e-5));
  CHECK(printedLeft4(arc, line) / right4(arc, line) == Approx(-2.48915).margin(1e-5));
}

TEST_CASE("the slave has no speed where the rod is across its way", "[unit]") {
  CHECK(std::isinf(slaveSpeed(0.08, 0.5, 0.0)));
  CHECK(slaveSpeed(0.08, -0.5, 0.0) < 0.0);
  CHECK(slaveSpeed(0.08, 0.0, 0.0) == 0.0);
  CHECK(slaveSpeed(0.08, 0.5, -0.4) == Approx(-0.1));
}

TEST_CASE("Newton's steps bring the slave to a rod's length, five millimetres each", "[unit]") {
  const PartPath path({{{{0.0, 0.0}, 0.0}, 0.0, 2.0}});
  const Vec2 other{2.0, 0.6};
  const double wanted = 2.0 - 0.64;  // 0.64^2 + 0.6^2 = 0.877^2
  const double rod = std::sqrt(0.64 * 0.64 + 0.36);
  CHECK(onRod(path, other, {0, wanted + 0.004}, rod) == Approx(wanted).margin(1e-9));
  CHECK(onRod(path, other, {0, wanted - 0.100}, rod) == Approx(wanted - 0.085).margin(1e-12));
}

}  // namespace fulbito
