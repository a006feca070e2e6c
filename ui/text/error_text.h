#pragma once

#include <QString>
#include <exception>

namespace ravnoves {

/// An InputError of core as text, in the language of the program: place, rule and value. The places
/// of a case are named by the labels of its scene where a model rejects it (SceneModel::explain()),
/// else by their keys. The system's messages are unchanged.
QString errorText(const std::exception& error);
/// From now on places are named by their pointers, as by the command line: for scripts that run the
/// program without its window.
void namePlacesByPointer();
/// The same of whatever was thrown in a thread or a slot that nothing may leave.
QString errorText(const std::exception_ptr& thrown);

}  // namespace ravnoves
