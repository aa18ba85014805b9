#include "navigation/obstacles/echo_map.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>

#include "fulbito/detail/math.hpp"

namespace fulbito {
/// One reading in the world frame.
struct EchoMap::Call {
  Vec2 apex;
  Vec2 axis;
  std::array<Vec2, 3> triangle;  ///< triangle that contains the cone
  double sin2;                   ///< square of the sine of the half cone
  /// [m^2] square of the distance up to which the reading shows cells to be free
  double free2;
  double most2;  ///< [m^2] square of the greatest distance of the echo's cells
  bool heard;
  bool clears_near;  ///< the echo is so near that cells near the sonar may be cleared
  float free_weight;
};

namespace {

/// The part of a triangle on the line at height `y`; empty if `low` > `high`.
struct Chord {
  double low = 1e300, high = -1e300;
};

Chord chordAt(const std::array<Vec2, 3>& triangle, double y) {
  Chord chord;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec2 a = triangle[i], b = triangle[(i + 1) % 3];
    if ((a.y > y) == (b.y > y)) continue;
    const double x = a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x);
    chord.low = std::min(chord.low, x);
    chord.high = std::max(chord.high, x);
  }
  return chord;
}

}  // namespace

EchoMap::EchoMap(const Settings& settings)
    : settings_(settings),
      size_(static_cast<int>(std::ceil(2.0 * settings.window / settings.cell))),
      stride_(static_cast<int>(std::bit_ceil(static_cast<unsigned>(size_)))),
      cells_(static_cast<std::size_t>(stride_) * static_cast<std::size_t>(stride_)) {}

void EchoMap::reset() {
  placed_ = false;
  std::fill(cells_.begin(), cells_.end(), Cell{});
}

EchoMap::Cell& EchoMap::at(int x, int y) {
  const int mask = stride_ - 1;
  return cells_[static_cast<std::size_t>(y & mask) * static_cast<std::size_t>(stride_) +
                static_cast<std::size_t>(x & mask)];
}

const EchoMap::Cell& EchoMap::at(int x, int y) const { return const_cast<EchoMap*>(this)->at(x, y); }

int EchoMap::cellOf(double coordinate) const {
  constexpr double kFarthest = 1e6;  // cells, far beyond any field
  return static_cast<int>(std::clamp(std::floor(coordinate / settings_.cell), -kFarthest, kFarthest));
}

/// Moves the grid with the robot. Cells that enter the grid are unknown.
void EchoMap::centre(Vec2 position) {
  const int x = cellOf(position.x) - size_ / 2, y = cellOf(position.y) - size_ / 2;
  if (!placed_ || std::abs(x - x_) >= size_ || std::abs(y - y_) >= size_) {
    std::fill(cells_.begin(), cells_.end(), Cell{});
  } else {
    const int right = x > x_ ? x_ + size_ : x, top = y > y_ ? y_ + size_ : y;
    for (int column = right; column < right + std::abs(x - x_); ++column) {
      for (int row = 0; row < stride_; ++row) at(column, row) = {};
    }
    for (int row = top; row < top + std::abs(y - y_); ++row) {
      for (int column = 0; column < stride_; ++column) at(column, row) = {};
    }
  }
  x_ = x, y_ = y, placed_ = true;
}

void EchoMap::update(const NavigationScene& scene) {
  now_ = scene.tick;
  memory_ticks_ = static_cast<Tick>(settings_.memory / scene.dt);
  centre(scene.self.pose.position);
  for (const RangeReading& reading : scene.ranges) takeIn(reading, scene.self.pose);
  clearBody(scene);
}

void EchoMap::takeIn(const RangeReading& reading, const Pose2& pose) {
  const Vec2 ahead = math::unit(pose.heading);
  const math::SinCos edge = math::sinCos(reading.half_cone);
  const double nearest = std::max(0.0, reading.range - settings_.band);
  const double most = reading.heard ? reading.range + settings_.cell : nearest;
  Call call;
  call.apex = pose.position + outOfFrame(ahead, reading.mount.position);
  call.axis = outOfFrame(ahead, math::unit(reading.mount.heading));
  const Vec2 end = call.axis * most, aside = perp(call.axis) * (most * edge.sin / edge.cos);
  call.triangle = {call.apex, call.apex + end + aside, call.apex + end - aside};
  call.sin2 = edge.sin * edge.sin;
  call.free2 = nearest * nearest;
  call.most2 = most * most;
  call.heard = reading.heard;
  call.clears_near = reading.heard && nearest < settings_.near;
  call.free_weight = static_cast<float>(reading.heard ? settings_.free_weight : settings_.silent_weight);
  const auto [low, high] = std::minmax({call.triangle[0].y, call.triangle[1].y, call.triangle[2].y});
  for (int y = std::max(cellOf(low), y_); y <= std::min(cellOf(high), y_ + size_ - 1); ++y) {
    const Chord chord = chordAt(call.triangle, middle(0, y).y);
    const int last = std::min(cellOf(chord.high), x_ + size_ - 1);
    for (int x = std::max(cellOf(chord.low), x_); x <= last; ++x)
      weigh(call, at(x, y), middle(x, y) - call.apex);
  }
}

void EchoMap::weigh(const Call& call, Cell& cell, Vec2 to) const {
  const auto limit = static_cast<float>(settings_.most);
  const double square = squaredNorm(to);
  if (square < call.free2) {
    if (call.clears_near || square > settings_.near * settings_.near)
      cell.evidence = std::max(cell.evidence - call.free_weight, -limit);
  } else if (call.heard && square <= call.most2) {
    const double across = cross(call.axis, to), off_axis = across * across / (square * call.sin2);
    cell.evidence = std::min(cell.evidence + static_cast<float>(std::max(0.0, 1.0 - off_axis)), limit);
    cell.tick = static_cast<std::int32_t>(now_);
  }
}

/// Clears the cells of the robot's body, since nothing else can be there.
void EchoMap::clearBody(const NavigationScene& scene) {
  const Pose2& pose = scene.self.pose;
  const Vec2 ahead = math::unit(pose.heading);
  const double reach = scene.robot->circumradius();
  for (int y = cellOf(pose.position.y - reach); y <= cellOf(pose.position.y + reach); ++y) {
    for (int x = cellOf(pose.position.x - reach); x <= cellOf(pose.position.x + reach); ++x) {
      const Vec2 p = intoFrame(ahead, middle(x, y) - pose.position);
      if (std::abs(p.x) < scene.robot->length / 2 && std::abs(p.y) < scene.robot->width / 2) at(x, y) = {};
    }
  }
}

bool EchoMap::isOccupied(const Cell& cell) const {
  return static_cast<double>(cell.evidence) > settings_.threshold && now_ - cell.tick <= memory_ticks_;
}

template <typename Work>
void EchoMap::forOccupied(const Work& work) const {
  const int mask = stride_ - 1;
  const auto threshold = static_cast<float>(settings_.threshold);
  for (int y = y_; y < y_ + size_; ++y) {
    const Cell* row = &cells_[static_cast<std::size_t>(y & mask) * static_cast<std::size_t>(stride_)];
    for (int x = x_; x < x_ + size_; ++x) {
      // Nearly all cells fail this first test, which is cheap.
      const Cell& cell = row[x & mask];
      if (cell.evidence > threshold && isOccupied(cell)) work(middle(x, y));
    }
  }
}

void EchoMap::scan(const SectorCircle& circle, const Pose2& pose, double range,
                   std::span<SectorHit> hits) const {
  for (SectorHit& hit : hits) hit = {std::numeric_limits<double>::infinity(), {}};
  const Vec2 ahead = math::unit(pose.heading);
  forOccupied([&](Vec2 place) {
    const Vec2 p = intoFrame(ahead, place - pose.position);
    const double far = norm(p);
    if (!(far > 0.0 && far <= range)) return;
    // A cell covers all sectors in which it is seen: up to half a diagonal to each side.
    const double bearing = math::angleOf(p), half = math::atan2(0.7 * settings_.cell, far);
    const int last = circle.sectorOf(bearing - half);
    for (int i = circle.sectorOf(bearing + half);; i = circle.wrap(i + 1)) {
      SectorHit& hit = hits[static_cast<std::size_t>(i)];
      if (far < hit.distance) hit = {far, p};
      if (i == last) break;
    }
  });
}

void EchoMap::appendDiscs(std::vector<DiscObstacle>& discs) const {
  const double radius = kDiscCells * settings_.cell / 2;
  const int low_x = (x_ >= 0 ? x_ : x_ - kDiscCells + 1) / kDiscCells * kDiscCells;
  const int low_y = (y_ >= 0 ? y_ : y_ - kDiscCells + 1) / kDiscCells * kDiscCells;
  for (int y = low_y + kDiscCells; y + kDiscCells <= y_ + size_; y += kDiscCells) {
    for (int x = low_x + kDiscCells; x + kDiscCells <= x_ + size_; x += kDiscCells) {
      Vec2 sum{};
      int count = 0;
      for (int i = 0; i < kDiscCells * kDiscCells; ++i) {
        const int u = x + i % kDiscCells, v = y + i / kDiscCells;
        if (!isOccupied(at(u, v))) continue;
        sum += middle(u, v), ++count;
      }
      if (count > 0) discs.push_back({sum / count, radius, {}});
    }
  }
}

}  // namespace fulbito
