#include "replays/render/canvas.hpp"
