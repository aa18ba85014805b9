#include "navigation/methods/paths/tangent_graph_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fulbito/detail/math.hpp"
#include "navigation/geometry/wall_lines.hpp"

namespace fulbito {
namespace {

constexpr double kTouch = 1e-9;  // [m] a path may enter a disc that it touches this far
constexpr double kTurn = 2.0 * math::kPi;
constexpr double kSameAngle = 1e-9;  // [rad] arcs this close to a whole turn are rounding errors
constexpr double kMostPieces = 2000.0;
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr std::uint32_t kNobody = std::numeric_limits<std::uint32_t>::max();

/// Angle [rad] in [0, 2 pi) of a turn from heading `from` to heading `to` in the direction `side`.
double sweepBetween(double from, double to, double side) {
  double sweep = side * (to - from);
  if (sweep < 0.0) sweep += kTurn;
  if (sweep < 0.0) sweep += kTurn;
  if (sweep >= kTurn) sweep -= kTurn;
  return sweep > kTurn - kSameAngle ? 0.0 : sweep;
}

double sideOf(double signed_radius) { return signed_radius < 0.0 ? -1.0 : 1.0; }

/// Number of pieces of at most `spacing` [m] for a segment. It is bounded, since a goal may be anywhere.
double pieceCount(double length, double spacing) {
  return std::min(std::floor(length / spacing) + 1.0, kMostPieces);
}

bool later(double estimate_a, std::uint32_t id_a, double estimate_b, std::uint32_t id_b) {
  return estimate_a != estimate_b ? estimate_a > estimate_b : id_a > id_b;
}

}  // namespace

TangentGraph::TangentGraph(std::size_t reserved_circles) {
  const std::size_t ports = 2 * reserved_circles + 2;
  ports_.reserve(ports);
  penalties_.reserve(ports);
  tangents_.reserve(ports * ports);
  made_.reserve(ports);
  arrivals_.reserve(ports);
  blockers_.reserve(reserved_circles * (reserved_circles + 8));
  blockers_begin_.reserve(reserved_circles + 1);
  queue_.reserve(4 * ports * ports);
  chain_.reserve(ports);
  passes_.reserve(ports);
}

bool TangentGraph::search(Vec2 start, Vec2 goal, std::span<const Circle> circles, const FieldGeometry* bounds,
                          double wall_margin, SidePreference preference) {
  place(start, goal, circles);
  wall_count_ = 0;
  if (bounds != nullptr) placeWalls(*bounds, wall_margin);
  findBlockers();
  prefer(preference);
  length_ = start == goal ? 0.0 : kInfinity;
  if (start == goal) return true;

  const auto order = [](const Entry& a, const Entry& b) {
    return later(a.estimate, a.tangent, b.estimate, b.tangent);
  };
  expand(stride_ - 2, kNobody);
  while (!queue_.empty()) {
    std::pop_heap(queue_.begin(), queue_.end(), order);
    const Entry entry = queue_.back();
    queue_.pop_back();
    Tangent& tangent = tangents_[entry.tangent];
    if (tangent.state != Tangent::State::kOpen || entry.cost > tangent.cost) continue;
    tangent.state = Tangent::State::kClosed;
    const std::size_t from = entry.tangent / stride_, to = entry.tangent % stride_;
    if (!tangentFree(from, to, tangent)) continue;
    if (to == stride_ - 1) {
      trace(entry.tangent);
      return true;
    }
    if (dominated(to, entry.tangent)) continue;
    tangent.next_arrival = arrivals_[to];
    arrivals_[to] = entry.tangent;
    expand(to, entry.tangent);
  }
  return false;
}

void TangentGraph::place(Vec2 start, Vec2 goal, std::span<const Circle> circles) {
  start_ = start;
  goal_ = goal;
  count_ = circles.size();
  stride_ = 2 * count_ + 2;
  ports_.clear();
  for (const Circle& c : circles) {
    const double room = std::min(distance(c.centre, start), distance(c.centre, goal)) - kTouch;
    const double radius = std::max(0.0, std::min(c.radius, room));
    ports_.push_back({c.centre, radius});
    ports_.push_back({c.centre, -radius});
  }
  ports_.push_back({start, 0.0});
  ports_.push_back({goal, 0.0});
  if (tangents_.size() < stride_ * stride_) tangents_.resize(stride_ * stride_);
  made_.assign(stride_, 0);
  arrivals_.assign(stride_, kNobody);
  queue_.clear();
  passes_.clear();
}

void TangentGraph::placeWalls(const FieldGeometry& bounds, double margin) {
  for (const WallLine& line : wallLines(bounds)) {
    const Vec2 outward = line.outward;
    const double offset = std::max({line.clearance - margin, dot(outward, start_), dot(outward, goal_)});
    walls_[wall_count_++] = {outward, offset, math::angleOf(outward)};
  }
}

// The ends of an arc are known to be free. So an arc meets another disc or a wall only if it passes the
// middle of the closed stretch, and it is enough to store the angle of the middle.
void TangentGraph::findBlockers() {
  blockers_.clear();
  blockers_begin_.clear();
  for (std::size_t i = 0; i < count_; ++i) {
    blockers_begin_.push_back(blockers_.size());
    const Vec2 centre = ports_[2 * i].centre;
    const double radius = ports_[2 * i].signed_radius;
    for (std::size_t k = 0; k < count_; ++k) {
      const Vec2 d = ports_[2 * k].centre - centre;
      const double other = ports_[2 * k].signed_radius, reach = radius + other - kTouch,
                   inside = radius - other;
      if (k == i || squaredNorm(d) >= reach * std::abs(reach)) continue;
      if (inside >= 0.0 && squaredNorm(d) <= inside * inside) continue;
      blockers_.push_back(math::angleOf(d));
    }
    for (std::size_t w = 0; w < wall_count_; ++w) {
      if (dot(walls_[w].outward, centre) + radius > walls_[w].offset + kTouch) {
        blockers_.push_back(walls_[w].angle);
      }
    }
  }
  blockers_begin_.push_back(blockers_.size());
}

void TangentGraph::prefer(const SidePreference& preference) {
  penalties_.assign(stride_, 0.0);
  for (const CirclePass& pass : preference.passes) {
    if (pass.circle < count_) penalties_[2 * pass.circle + (pass.side > 0 ? 1 : 0)] = preference.penalty;
  }
}

void TangentGraph::makeTangents(std::size_t from) {
  made_[from] = 1;
  const Port a = ports_[from];
  for (std::size_t to = 0; to < stride_; ++to) {
    Tangent& tangent = tangents_[from * stride_ + to];
    tangent.state = Tangent::State::kNone;
    tangent.cost = kInfinity;
    if (to / 2 == from / 2 && to != stride_ - 1) continue;
    if (to == stride_ - 2) continue;
    const Port b = ports_[to];
    // With the travel direction u, b.centre - a.centre = length u + k perp(u).
    const Vec2 d = b.centre - a.centre;
    const double k = b.signed_radius - a.signed_radius, square = squaredNorm(d);
    if (square <= k * k || square < 1e-300) continue;
    tangent.length = std::sqrt(square - k * k);
    tangent.direction = (d * tangent.length - perp(d) * k) / square;
    tangent.heading = math::angleOf(tangent.direction);
    tangent.state = Tangent::State::kOpen;
  }
}

void TangentGraph::expand(std::size_t from, std::uint32_t arrival) {
  if (!made_[from]) makeTangents(from);
  const bool first = arrival == kNobody;
  const double heading = first ? 0.0 : tangents_[arrival].heading;
  const double cost = first ? 0.0 : tangents_[arrival].cost;
  const double radius = std::abs(ports_[from].signed_radius), side = sideOf(ports_[from].signed_radius);
  const double free = first ? kInfinity : freeSweep(from, heading);
  for (std::size_t to = 0; to < stride_; ++to) {
    const auto id = static_cast<std::uint32_t>(from * stride_ + to);
    Tangent& tangent = tangents_[id];
    if (tangent.state != Tangent::State::kOpen) continue;
    const double sweep = first ? 0.0 : sweepBetween(heading, tangent.heading, side);
    const double reached = cost + radius * sweep + tangent.length + penalties_[to];
    if (sweep > free || reached >= tangent.cost) continue;
    tangent.cost = reached;
    tangent.parent = arrival;
    const Vec2 end = contact(to, tangent.direction);
    queue_.push_back({reached + distance(end, goal_), reached, id});
    std::push_heap(queue_.begin(), queue_.end(), [](const Entry& a, const Entry& b) {
      return later(a.estimate, a.tangent, b.estimate, b.tangent);
    });
  }
}

// An arrival is dominated if an earlier arrival at the same circle can roll on to its place in time. The
// earlier one then has every continuation that the new one has.
bool TangentGraph::dominated(std::size_t port, std::uint32_t arrival) const {
  const Tangent& fresh = tangents_[arrival];
  const double radius = std::abs(ports_[port].signed_radius), side = sideOf(ports_[port].signed_radius);
  for (std::uint32_t id = arrivals_[port]; id != kNobody; id = tangents_[id].next_arrival) {
    const Tangent& earlier = tangents_[id];
    const double sweep = sweepBetween(earlier.heading, fresh.heading, side);
    if (earlier.cost + radius * sweep <= fresh.cost && sweep <= freeSweep(port, earlier.heading)) return true;
  }
  return false;
}

bool TangentGraph::tangentFree(std::size_t from, std::size_t to, const Tangent& tangent) const {
  const Vec2 direction = tangent.direction;
  const Vec2 a = contact(from, direction), b = contact(to, direction);
  for (std::size_t w = 0; w < wall_count_; ++w) {
    const Wall& wall = walls_[w];
    if (std::max(dot(wall.outward, a), dot(wall.outward, b)) > wall.offset + kTouch) return false;
  }
  for (std::size_t i = 0; i < count_; ++i) {
    if (i == from / 2 || i == to / 2) continue;
    const Vec2 to_centre = ports_[2 * i].centre - a;
    const double radius = ports_[2 * i].signed_radius - kTouch;
    const double along = std::clamp(dot(to_centre, direction), 0.0, tangent.length);
    if (radius > 0.0 && squaredNorm(to_centre - direction * along) < radius * radius) return false;
  }
  return true;
}

double TangentGraph::freeSweep(std::size_t port, double heading) const {
  const double side = sideOf(ports_[port].signed_radius);
  double least = kInfinity;
  for (std::size_t i = blockers_begin_[port / 2]; i < blockers_begin_[port / 2 + 1]; ++i) {
    const double at = math::wrapAngle(blockers_[i] + side * (math::kPi / 2));
    least = std::min(least, sweepBetween(heading, at, side));
  }
  return least;
}

Vec2 TangentGraph::contact(std::size_t port, Vec2 direction) const {
  return ports_[port].centre - perp(direction) * ports_[port].signed_radius;
}

void TangentGraph::trace(std::uint32_t last) {
  chain_.clear();
  for (std::uint32_t id = last; id != kNobody; id = tangents_[id].parent) chain_.push_back(id);
  std::reverse(chain_.begin(), chain_.end());
  length_ = 0.0;
  for (std::size_t i = 0; i < chain_.size(); ++i) {
    const Tangent& tangent = tangents_[chain_[i]];
    length_ += tangent.length;
    if (i + 1 == chain_.size()) break;
    const Tangent& next = tangents_[chain_[i + 1]];
    const std::size_t port = chain_[i] % stride_;
    const double side = sideOf(ports_[port].signed_radius), radius = std::abs(ports_[port].signed_radius);
    const double sweep = sweepBetween(tangent.heading, next.heading, side);
    length_ += radius * sweep;
    passes_.push_back({port / 2, side > 0.0 ? 1 : -1, radius, contact(port, tangent.direction),
                       contact(port, next.direction), sweep});
  }
}

void TangentGraph::sample(double spacing, std::vector<Vec2>& out) const {
  out.clear();
  if (!(length_ < kInfinity)) return;
  const auto straight = [&](Vec2 to) {
    const Vec2 from = out.back();
    const double pieces = pieceCount(distance(from, to), spacing);
    for (int i = 1; i < pieces; ++i) out.push_back(from + (to - from) * (i / pieces));
    out.push_back(to);
  };
  out.push_back(start_);
  for (const CirclePass& pass : passes_) {
    straight(pass.entry);
    const Vec2 centre = ports_[2 * pass.circle].centre;
    const double pieces = pieceCount(pass.radius * pass.sweep, spacing);
    const Vec2 step = math::unit(static_cast<double>(pass.side) * pass.sweep / pieces);
    Vec2 spoke = pass.entry - centre;
    for (int i = 1; i < pieces; ++i) {
      spoke = outOfFrame(spoke, step);
      out.push_back(centre + spoke);
    }
    out.push_back(pass.exit);
  }
  straight(goal_);
}

}  // namespace fulbito
