#include "tournament/identity/repeatable.hpp"

#include "match/check/repeats.hpp"
#include "match/check/situations.hpp"

namespace fulbito {
namespace {

constexpr std::size_t kEvery = 4;  // checks every fourth situation, because each starts the team four times

}  // namespace

Result<bool> repeatsItself(const TeamChoice& team) {
  const auto situations = checkSituations(TeamId::kBlue, kDefaultMatchSeed, true);
  if (!situations) return tl::unexpected<Error>(situations.error());
  AllRepeats findings;
  for (std::size_t i = 0; i < situations->size(); i += kEvery) {
    if (auto done = repeatSituation((*situations)[i], team, findings); !done) {
      return tl::unexpected<Error>(done.error());
    }
  }
  return findings.again.different == 0 && findings.again.failure.empty();
}

}  // namespace fulbito
