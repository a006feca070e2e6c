#pragma once

#include <string>

#include "case-file/input_error.h"

namespace ravnoves::test {

/// What an action is rejected with; "no error" where it is not.
std::string error_of(const auto& action) {
    try {
        action();
    } catch (const InputError& error) {
        return error.what();
    }
    return "no error";
}

}  // namespace ravnoves::test
