#pragma once

#include <nlohmann/json.hpp>

#include "case-file/json_fwd.h"  // IWYU pragma: export
