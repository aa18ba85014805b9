#include "replays/render/field_picture.hpp"
