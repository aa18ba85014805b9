#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>

#include "tournament/results/results.hpp"

namespace fulbito {

/// What became of a match that was added to a store.
enum class Added : std::uint8_t {
  kNew,   ///< it is kept
  kSame,  ///< it was there with this result (`sameResult`); nothing changed
  /// It was there with another result; nothing changed. Equal matches have equal results, so a team or the
  /// machine is not deterministic, or the identity misses something.
  kDifferent
};

/// Hash of an identity for maps: it is one already.
struct WordOfId {
  std::size_t operator()(const MatchId& id) const { return id.words[0]; }
};

/// Where finished matches are kept. Safe to use from several threads.
class MatchStore {
 public:
  virtual ~MatchStore() = default;
  /// The match, if it is there, in its stored form.
  virtual std::optional<MatchRow> find(const MatchId& id) const = 0;
  /// Keeps a finished match in its stored form (`storedForm`). After kNew or kSame, not even a power failure
  /// loses it. Errors: kIo naming the file; what was kept before stays whole.
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
