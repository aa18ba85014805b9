#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>

#include "tournament/results/results.hpp"

namespace fulbito {

/// The outcome of adding a match to a store.
enum class Added : std::uint8_t {
  kNew,   ///< the match is stored
  kSame,  ///< the store has the match with this result (`sameResult`); nothing changed
  /// The store has the match with another result; nothing changed. As equal matches have equal results, a
  /// team or the machine is not deterministic, or the identity misses an input.
  kDifferent
};

/// Hash of a `MatchId` for maps: the identity is a hash itself.
struct WordOfId {
  std::size_t operator()(const MatchId& id) const { return id.words[0]; }
};

/// A store of finished matches. Safe to use from several threads.
class MatchStore {
 public:
  virtual ~MatchStore() = default;
  /// The match in its stored form, if the store has it.
  virtual std::optional<MatchRow> find(const MatchId& id) const = 0;
  /// Stores a finished match in its stored form (`storedForm`). After kNew or kSame it survives a power
  /// failure. Errors: kIo naming the file; earlier matches stay intact.
  virtual Result<Added> add(const MatchRow& row) = 0;
};

/// A store in memory.
class MatchMemory final : public MatchStore {
 public:
  MatchMemory();
  ~MatchMemory() override;
  std::optional<MatchRow> find(const MatchId& id) const override;
  /// Never fails.
  Result<Added> add(const MatchRow& row) override;
  /// As `add`, for a row in its stored form.
  Added take(MatchRow&& row);
  std::size_t size() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace fulbito
