#pragma once

#include <functional>
#include <memory>

#include "case-file/response.h"

namespace ravnoves::studies {

/// Makes one for each thread.
using MakeResponse = std::function<std::unique_ptr<Response>()>;

}  // namespace ravnoves::studies
