#pragma once

#include <memory>
#include <optional>
#include <string>

#include "tournament/store/match_store.hpp"

namespace fulbito {

/// A log of matches in a file: one line of JSON per match (docs/results-format.md), appended and synced one
/// by one. If the program or the machine dies while writing, an incomplete line remains. Opening the log for
/// writing cuts it off; reading skips it.
class MatchLog final : public MatchStore {
 public:
  /// Opens the log for appending, or creates it, and locks it against other writers. Errors: kIo; kBadInput
  /// naming the line that is damaged or repeats a match with another result; kUsage when another run has
  /// locked it.
  static Result<std::unique_ptr<MatchLog>> open(const std::string& file);
  ~MatchLog() override;
  std::optional<MatchRow> find(const MatchId& id) const override;
  /// After an error, all further calls that would write return the same error, and earlier rows can still be
  /// found. Open the log again to continue.
  Result<Added> add(const MatchRow& row) override;
  /// Number of matches in the log.
  std::size_t size() const;
  /// Whether `open` cut off an incomplete last line.
  bool wasTorn() const;

 private:
  struct Impl;
  explicit MatchLog(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace fulbito
