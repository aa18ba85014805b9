#include "tournament/formats/perfect_matching.hpp"

#include <algorithm>
#include <numeric>

namespace fulbito {

OpenMeetings::OpenMeetings(std::size_t size) : size_(size), open_(size * size, true) {
  for (std::size_t i = 0; i < size; ++i) close(i, i);
}

PerfectMatching::PerfectMatching(const OpenMeetings& open, std::size_t sum)
    : open_(open), mate_(open.size(), kNone), settled_(open.size()) {
  const std::size_t size = open.size();
  for (std::size_t a = 0; a < size; ++a) {
    for (std::size_t k = 0; k < size && mate_[a] == kNone; ++k) {
      const std::size_t b = (sum % size + size - a + k) % size;
      if (mate_[b] == kNone && open_.has(a, b)) join(a, b);
    }
  }
  for (std::size_t a = 0; a < mate_.size(); ++a) {
    if (mate_[a] == kNone) augment(a);
  }
}

bool PerfectMatching::exists() const { return std::find(mate_.begin(), mate_.end(), kNone) == mate_.end(); }

void PerfectMatching::join(std::size_t a, std::size_t b) {
  mate_[a] = b;
  mate_[b] = a;
}

bool PerfectMatching::settle(std::size_t a, std::size_t b) {
  if (!open_.has(a, b)) return false;
  const std::size_t left = mate_[a], right = mate_[b];
  join(a, b);
  settled_[a] = settled_[b] = true;
  if (left == b) return true;
  if (open_.has(left, right)) {
    join(left, right);
    return true;
  }
  mate_[left] = mate_[right] = kNone;
  if (augment(left)) return true;
  settled_[a] = settled_[b] = false;
  join(a, left);
  join(b, right);
  return false;
}

/// Pairs one more entrant by an augmenting path from `root` to another unpaired entrant.
bool PerfectMatching::augment(std::size_t root) {
  std::size_t v = pathFrom(root);
  if (v == kNone) return false;
  while (v != kNone) {
    const std::size_t before = parent_[v], next = mate_[before];
    join(v, before);
    v = next;
  }
  return true;
}

/// Breadth-first search for an augmenting path. Returns its end, or kNone; `parent_` leads from the end back
/// to `root`.
std::size_t PerfectMatching::pathFrom(std::size_t root) {
  base_.resize(mate_.size());
  std::iota(base_.begin(), base_.end(), std::size_t{0});
  parent_.assign(mate_.size(), kNone);
  even_.assign(mate_.size(), false);
  even_[root] = true;
  queue_.assign(1, root);
  for (std::size_t i = 0; i < queue_.size(); ++i) {
    const std::size_t v = queue_[i];
    for (std::size_t to = 0; to < mate_.size(); ++to) {
      if (settled_[to] || !open_.has(v, to) || base_[v] == base_[to] || mate_[v] == to) continue;
      if (to == root || (mate_[to] != kNone && parent_[mate_[to]] != kNone)) {
        contract(v, to);
      } else if (parent_[to] == kNone) {
        if (visit(v, to) != kNone) return to;
      }
    }
  }
  return kNone;
}

/// Visits `to` from v, and then the opponent of `to`. Returns `to` if it has no opponent, since the path ends
/// there.
std::size_t PerfectMatching::visit(std::size_t v, std::size_t to) {
  parent_[to] = v;
  if (mate_[to] == kNone) return to;
  even_[mate_[to]] = true;
  queue_.push_back(mate_[to]);
  return kNone;
}

/// The edge from v to `to` closes an odd cycle (blossom): contracts it to one vertex at even distance.
void PerfectMatching::contract(std::size_t v, std::size_t to) {
  const std::size_t base = commonBase(v, to);
  std::vector<bool> in_blossom(mate_.size());
  markPath(v, base, to, in_blossom);
  markPath(to, base, v, in_blossom);
  for (std::size_t i = 0; i < mate_.size(); ++i) {
    if (!in_blossom[base_[i]]) continue;
    base_[i] = base;
    if (even_[i]) continue;
    even_[i] = true;
    queue_.push_back(i);
  }
}

/// Marks the blossoms from v up to `base`, and sets the predecessors that lead round the cycle the other way.
void PerfectMatching::markPath(std::size_t v, std::size_t base, std::size_t child,
                               std::vector<bool>& in_blossom) {
  while (base_[v] != base) {
    in_blossom[base_[v]] = in_blossom[base_[mate_[v]]] = true;
    parent_[v] = child;
    child = mate_[v];
    v = parent_[mate_[v]];
  }
}

/// The first blossom that is on the paths from both vertices back to the root.
std::size_t PerfectMatching::commonBase(std::size_t a, std::size_t b) const {
  std::vector<bool> passed(mate_.size());
  for (;;) {
    a = base_[a];
    passed[a] = true;
    if (mate_[a] == kNone) break;
    a = parent_[mate_[a]];
  }
  b = base_[b];
  while (!passed[b]) b = base_[parent_[mate_[b]]];
  return b;
}

}  // namespace fulbito
