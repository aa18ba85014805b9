#include "tests/unit/render/samples.hpp"
