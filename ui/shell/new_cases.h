#pragma once

#include <QString>
#include <functional>
#include <vector>

#include "case-file/case_file.h"

namespace ravnoves {

/// What a new case may begin with.
struct NewCase {
    enum class Kind {
        Empty,    ///< round numbers, to be replaced by the user's own
        Preset,   ///< an engine of a paper
        Example,  ///< a case of resources/examples
    };
    Kind kind;
    QString scene;          ///< its word in case files
    QString title;          ///< for menus and lists
    QString question = {};  ///< of an example: the question that it answers
    /// Reads or writes it, without a path: it never overwrites its origin.
    std::function<CaseFile()> make;
};

/// Its title with its kind: "Preset: TMZ-650D".
QString listed(const NewCase& each);

/// All of them, scene by scene in the order of the navigation, each from the empty one to the
/// examples.
std::vector<NewCase> newCases();

/// The examples among them, in the same order.
std::vector<NewCase> newExamples();

}  // namespace ravnoves
