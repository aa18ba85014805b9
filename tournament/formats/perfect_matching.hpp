#pragma once

#include <cstddef>
#include <vector>

namespace fulbito {

/// The meetings of two entrants that are still possible.
class OpenMeetings {
 public:
  /// Starts with all meetings of `size` entrants.
  explicit OpenMeetings(std::size_t size);

  std::size_t size() const { return size_; }
  bool has(std::size_t a, std::size_t b) const { return open_[a * size_ + b]; }
  void close(std::size_t a, std::size_t b) { open_[a * size_ + b] = open_[b * size_ + a] = false; }

 private:
  std::size_t size_;
  std::vector<bool> open_;
};

/// A pairing of all entrants by possible meetings. The caller settles pairs one after the other; each keeps a
/// pairing of all others possible. Method: augmenting paths with blossoms (J. Edmonds, Paths, trees, and
/// flowers, 1965). Whether a pair can be settled does not depend on which pairing the method finds.
class PerfectMatching {
 public:
  /// `open` must outlive this object. Entrants whose numbers add up to `sum`, modulo the number of entrants,
  /// are paired first, so that different sums give different pairings.
  explicit PerfectMatching(const OpenMeetings& open, std::size_t sum = 0);

  /// Whether all entrants can be paired.
  bool exists() const;
  /// The opponent of each entrant in the pairing, by entrant. Valid only if the pairing exists.
  const std::vector<std::size_t>& opponents() const { return mate_; }
  /// Settles A and B as a pair if they may meet and the others can still be paired; otherwise nothing
  /// changes. Requires that A and B are not settled yet, and that the pairing exists.
  bool settle(std::size_t a, std::size_t b);

 private:
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

  bool augment(std::size_t root);
  std::size_t pathFrom(std::size_t root);
  std::size_t visit(std::size_t v, std::size_t to);
  void contract(std::size_t v, std::size_t to);
  void markPath(std::size_t v, std::size_t base, std::size_t child, std::vector<bool>& in_blossom);
  std::size_t commonBase(std::size_t a, std::size_t b) const;
  void join(std::size_t a, std::size_t b);

  const OpenMeetings& open_;
  std::vector<std::size_t> mate_;
  std::vector<bool> settled_;
  // State of one search, by vertex: its blossom, its predecessor, whether its distance from the root is even.
  std::vector<std::size_t> base_, parent_, queue_;
  std::vector<bool> even_;
};

}  // namespace fulbito
