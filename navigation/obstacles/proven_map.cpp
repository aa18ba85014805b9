#include "navigation/obstacles/proven_map.hpp"

#include <algorithm>
#include <cmath>

#include "fulbito/detail/math.hpp"

namespace fulbito {
namespace {

constexpr double kBand = 0.0035;  // [m] twice the error of a smoothed range
constexpr float kFree = 3.0f;     // evidence of a farther echo against a cell; an echo at the cell weighs 1
constexpr float kSilent = 0.4f;   // evidence of silence: surfaces seen at an angle are silent too
constexpr double kBlind = 0.05;   // [m] silence and far echoes clear no cells nearer to the sensor
constexpr double kSharp = 0.9;    // share of the cone in which a reading clears cells
constexpr double kAslant =
    0.82;  // cosine of 35 degrees; surfaces reflect up to 30, and a cell's direction is not exact
constexpr float kExplained = 3.0f;   // lead in evidence with which the best cell of an arc explains the echo
constexpr float kUnneeded = 0.1f;    // weight of the other cells of such an arc
constexpr double kNear = 0.12;       // [m] only nearer readings can make a cell certain
constexpr double kMiddle = 0.8;      // share of the cone in which they can
constexpr double kArc = 0.08;        // [m] nearer arcs are shorter, and their cells weigh more
constexpr double kMostWeight = 4.0;  // greatest such weight
constexpr float kLeast = -2.0f, kFarMost = 5.0f, kMost = 12.0f;
constexpr float kTurning = 0.2f;  // weight of a new direction in a cell's mean direction

int directionOf(Vec2 way) {
  return static_cast<int>(std::floor(math::angleOf(way) / (math::kPi / 16) + 0.5)) & 31;
}

}  // namespace

/// One reading and the values that all of its cells share.
struct ProvenMap::Call {
  const SmoothRange& reading;
  double tan_half;
  double free;        ///< [m] cells up to this distance are free
  double most;        ///< [m] cells between `free` and this distance are on the arc
  float share;        ///< weight of the reading, 0 ... 1
  float best = 0.0f;  ///< greatest evidence of the cells on the arc
  std::uint32_t from = 0;

  double off(Vec2 to) const { return std::abs(cross(reading.axis, to)) / (dot(reading.axis, to) * tan_half); }
};

void ProvenMap::reset() {
  placed_ = false;
  std::fill(cells_.begin(), cells_.end(), Cell{});
}

int ProvenMap::cellOf(double coordinate) const {
  constexpr double kFarthest = 1e6;  // cells, far beyond any field
  return static_cast<int>(std::clamp(std::floor(coordinate / cell_), -kFarthest, kFarthest));
}

void ProvenMap::centre(Vec2 position, Tick now) {
  now_ = now;
  const int x = cellOf(position.x) - kSize / 2, y = cellOf(position.y) - kSize / 2;
  if (!placed_ || std::abs(x - x_) >= kSize || std::abs(y - y_) >= kSize) {
    std::fill(cells_.begin(), cells_.end(), Cell{});
  } else {
    const int right = x > x_ ? x_ + kSize : x, top = y > y_ ? y_ + kSize : y;
    for (int i = 0; i < kStride; ++i) {
      for (int column = right; column < right + std::abs(x - x_); ++column) cells_[indexOf(column, i)] = {};
      for (int row = top; row < top + std::abs(y - y_); ++row) cells_[indexOf(i, row)] = {};
    }
  }
  x_ = x, y_ = y, placed_ = true;
}

template <typename Work>
void ProvenMap::forCone(const Call& call, const Work& work) {
  const SmoothRange& reading = call.reading;
  const Vec2 end = reading.axis * call.most, aside = perp(reading.axis) * (call.most * call.tan_half);
  const Vec2 first = reading.apex + end + aside, second = reading.apex + end - aside;
  const auto [left, right] = std::minmax({reading.apex.x, first.x, second.x});
  const auto [low, high] = std::minmax({reading.apex.y, first.y, second.y});
  for (int y = std::max(cellOf(low), y_); y <= std::min(cellOf(high), y_ + kSize - 1); ++y) {
    for (int x = std::max(cellOf(left), x_); x <= std::min(cellOf(right), x_ + kSize - 1); ++x) {
      const Vec2 to = middle(x, y) - reading.apex;
      const double along = dot(to, reading.axis);
      if (along <= 0.0 || std::abs(cross(reading.axis, to)) > along * call.tan_half) continue;
      const double square = squaredNorm(to);
      if (square <= call.most * call.most) work(cells_[indexOf(x, y)], to, std::sqrt(square));
    }
  }
}

void ProvenMap::takeIn(const SmoothRange& reading, double share) {
  const double free = std::max(0.0, reading.heard ? reading.range - kBand : reading.range);
  Call call{reading, math::tan(reading.half_cone), free,
            reading.heard ? reading.range + kBand : reading.range, static_cast<float>(share)};
  call.from = 1u << directionOf(-reading.axis);
  forCone(call, [&](Cell& cell, Vec2 to, double far) {
    if (far < call.free) {
      clear(call, cell, to, far);
    } else {
      call.best = std::max(call.best, cell.evidence);
    }
  });
  if (!reading.heard) return;
  forCone(call, [&](Cell& cell, Vec2 to, double far) {
    if (far >= call.free) raise(call, cell, to);
  });
}

void ProvenMap::clear(const Call& call, Cell& cell, Vec2 to, double far) const {
  const bool hears_near = call.reading.heard && call.free < kBlind;
  if (call.off(to) > kSharp || (far <= kBlind && !hears_near)) return;
  const Vec2 toward{static_cast<double>(cell.x), static_cast<double>(cell.y)};
  if (cell.evidence > kCertain && -dot(to, toward) < kAslant * far * norm(toward)) return;
  cell.evidence = std::max(kLeast, cell.evidence - call.share * (call.reading.heard ? kFree : kSilent));
  if (cell.evidence < 0.0f) cell.seen |= call.from;
}

void ProvenMap::raise(const Call& call, Cell& cell, Vec2 to) const {
  const double off = call.off(to), range = call.reading.range;
  const double nearness = std::clamp(kArc / std::max(0.01, range), 1.0, kMostWeight);
  float weight = call.share * static_cast<float>((1.0 - off * off) * nearness);
  if (call.best > kExplained && cell.evidence < call.best - kExplained) weight *= kUnneeded;
  const float most = range < kNear && off < kMiddle ? kMost : kFarMost;
  cell.evidence = std::max(cell.evidence, std::min(most, cell.evidence + weight));
  const Vec2 back = unitOr(-to, -call.reading.axis);
  cell.x += kTurning * weight * (static_cast<float>(back.x) - cell.x);
  cell.y += kTurning * weight * (static_cast<float>(back.y) - cell.y);
  cell.tick = static_cast<std::int32_t>(now_);
  if (cell.evidence > kOccupied) cell.seen = 0;
}

void ProvenMap::clearBody(const NavigationScene& scene) {
  const Pose2& pose = scene.self.pose;
  const Vec2 ahead = math::unit(pose.heading);
  const double reach = scene.robot->circumradius();
  for (int y = cellOf(pose.position.y - reach); y <= cellOf(pose.position.y + reach); ++y) {
    for (int x = cellOf(pose.position.x - reach); x <= cellOf(pose.position.x + reach); ++x) {
      const Vec2 p = intoFrame(ahead, middle(x, y) - pose.position);
      if (std::abs(p.x) < scene.robot->length / 2 && std::abs(p.y) < scene.robot->width / 2)
        cells_[indexOf(x, y)] = {kLeast, 0.0f, 0.0f, 0, 0xffffffff};
    }
  }
}

std::uint32_t ProvenMap::about(Vec2 toward) {
  constexpr int kBeside = 2;  // sectors to each side, within 28 degrees, as surfaces reflect up to 30
  const int at = directionOf(toward);
  std::uint32_t mask = 0;
  for (int i = -kBeside; i <= kBeside; ++i) mask |= 1u << ((at + i) & 31);
  return mask;
}

}  // namespace fulbito
