#pragma once

#include <QString>
#include <functional>
#include <vector>

#include "case-file/case_file.h"

namespace ravnoves {

/// What a new case may begin with.
struct NewCase {
    QString scene;          ///< its word in case files
    QString title;          ///< for lists
    QString listed;         ///< with its kind, for menus: "Preset: TMZ-650D"
    QString question = {};  ///< that an example answers; only examples have one
    /// Reads or writes it, without a path: it never overwrites its origin.
    std::function<CaseFile()> make;
};

/// All of them, scene by scene in the order of the navigation, each from the empty one, which has
/// round numbers to be replaced by the user's own, over the engines of papers to the cases of
/// resources/examples.
std::vector<NewCase> newCases();

}  // namespace ravnoves
