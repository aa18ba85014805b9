// A team whose functions throw, each when its parameter asks for it.
#include <stdexcept>

#include "fulbito/team.hpp"

namespace {

class Throwing : public fulbito::team::Team {
 public:
  Throwing() : Team("throwing") {
    choice("where", where_, {"nowhere", "begin", "decide", "place", "stopped", "ended", "exercise"}, "");
    flag("odd", odd_, "throw what is no std::exception");
  }
  void begin(const fulbito::team::Info&) override { maybe(1); }
  fulbito::team::Commands decide(const fulbito::team::Observation& seen) override {
    if (seen.tick % 2 == 0) maybe(2);
    fulbito::team::Commands commands;
    commands.wheels(0, 1.0, 2.0);
    return commands;
  }
  std::optional<fulbito::team::Placement> place(const fulbito::team::PlacementRequest&) override {
    maybe(3);
    return std::nullopt;
  }
  void stopped(const fulbito::team::Stop&) override { maybe(4); }
  void ended(const fulbito::team::End&) override { maybe(5); }
  std::optional<fulbito::team::ExerciseReply> exercise(const fulbito::team::Observation&,
                                                       const fulbito::team::Exercise&) override {
    maybe(6);
    return std::nullopt;
  }

 private:
  void maybe(int where) const {
    if (where != where_) return;
    if (odd_) throw 42;
    throw std::runtime_error("out of ideas");
  }
  int where_ = 0;
  bool odd_ = false;
};

}  // namespace

FULBITO_TEAM(Throwing)
