#include "replays/render/bar_chart.hpp"
