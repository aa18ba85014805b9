#pragma once

#include <memory>
#include <optional>
#include <string>

#include "tournament/store/match_store.hpp"

namespace fulbito {

/// A log of matches in a file: a line of JSON per match (docs/results-format.md), appended and synced one by
/// one. The line of a match that was being written when the program or the machine died is cut off when the
/// log is opened to write; it is left out when it is read.
class MatchLog final : public MatchStore {
 public:
  /// Opens the log to append, or creates it, and locks it against other writers. Errors: kIo; kBadInput
  /// naming the line that is damaged or repeats a match with another result; kUsage when another run writes
  /// it.
  static Result<std::unique_ptr<MatchLog>> open(const std::string& file);
  ~MatchLog() override;
  std::optional<MatchRow> find(const MatchId& id) const override;
  /// After an error, all further calls that would write return the same error, and what was kept before can
  /// still be found: open the log again to go on.
  Result<Added> add(const MatchRow& row) override;
  /// Matches in the log.
  std::size_t size() const;
  /// Whether `open` cut off a torn line.
  bool wasTorn() const;

 private:
  struct Impl;
  explicit MatchLog(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace fulbito
