#include "apps/navigation/compare_map.hpp"

#include <fmt/format.h>

#include "apps/common/console.hpp"
#include "apps/common/outputs.hpp"
#include "apps/common/progress.hpp"
#include "engine/core/system/output_file.hpp"

namespace fulbito::app {

int compareMap(const CompareOptions& options) {
  const std::int64_t begin = now();
  MapConfig config = options.map;
  config.base = options.config;
  auto map = planMap(config);
  if (!map) return report(map.error());
  const Products products{{"map.csv", "suite,"}, {"map.json", kObjectBeginning}};
  if (auto folder = prepareProducts(options.out, products); !folder) return report(folder.error());
  {
    ProgressBar bar("map");
    const auto progress = [&](std::size_t done, std::size_t total) { return bar.update(done, total); };
    if (auto ran = runMap(*map, progress); !ran) return report(ran.error());
  }
  const double seconds = static_cast<double>(now() - begin) * 1e-9;
  const std::string json = mapJson(*map, seconds);
  printOut(options.json ? json : mapReport(*map));
  const auto pictures = writeMapPictures(*map, options.out);
  if (!pictures) return report(pictures.error());
  for (const auto& [name, text] : {std::pair{"map.csv", mapCsv(*map)}, std::pair{"map.json", json}}) {
    if (auto written = writeFile(options.out + "/" + name, text); !written) return report(written.error());
  }
  note("\n{} trials in {:.1f} s; map.json, map.csv, {} are in {}\n", map->comparison.records.size(), seconds,
       fmt::join(*pictures, ", "), options.out);
  return kOk;
}

}  // namespace fulbito::app
