#include "python/bindings/episode_values.hpp"

#include <cstring>
#include <vector>

#include "python/bindings/arrays.hpp"
#include "python/bindings/errors.hpp"

namespace fulbito::python {

namespace nb = nanobind;

StateTuple tupleOf(const EpisodeState& state) {
  std::optional<std::uint64_t> seed;
  std::string text;
  if (state.start) {
    seed = state.start->seed;
    text = state.start->text;
  }
  return {state.seed, state.episodes, seed, text,
          nb::bytes(state.actions.data(), state.actions.size() * sizeof(float))};
}

EpisodeState stateOf(const StateTuple& state) {
  const auto& [seed, episodes, start, text, actions] = state;
  if (actions.size() % sizeof(float) != 0)
    raise(ErrorCode::kUsage, "the state is not one of this environment");
  EpisodeState wanted{seed, episodes, std::nullopt, std::vector<float>(actions.size() / sizeof(float))};
  if (start) wanted.start = EpisodeStart{*start, text};
  if (actions.size() > 0) std::memcpy(wanted.actions.data(), actions.data(), actions.size());
  return wanted;
}

ShapeDict dictOf(const EpisodeShape& shape) {
  ShapeDict values;
  values["agents"] = shape.agents;
  values["observation"] = shape.observation;
  values["bound"] = shape.bound;
  values["action"] = shape.action;
  values["choices"] = shape.choices;
  values["state"] = shape.state;
  values["terms"] = shape.terms;
  values["figures"] = shape.figures;
  return values;
}

nb::ndarray<nb::numpy, std::uint8_t> pixelsOf(const Canvas& canvas) {
  const auto width = static_cast<std::size_t>(canvas.width()),
             height = static_cast<std::size_t>(canvas.height());
  std::vector<std::uint8_t> pixels;
  pixels.reserve(3 * width * height);
  for (int y = 0; y < canvas.height(); ++y) {
    for (const std::uint32_t colour : canvas.row(y)) {
      for (const int shift : {16, 8, 0}) pixels.push_back(static_cast<std::uint8_t>(colour >> shift));
    }
  }
  return arrayOf(std::move(pixels), {height, width, 3});
}

}  // namespace fulbito::python
