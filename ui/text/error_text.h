#pragma once

#include <QString>
#include <exception>

namespace ravnoves {

/// What an InputError of core says, in the language of the program: place, what is allowed there
/// and what was found. The places of a case are as text: by the labels of its scene where a model
/// rejects it (SceneModel::explain()), else by their keys. What the system says stays as it is.
QString errorText(const std::exception& error);
/// From now on places are said by their pointers, as the command line does: for who runs the
/// program without its window, in a script.
void sayPlacesByPointer();
/// The same of whatever was thrown in a thread or a slot that nothing may leave.
QString errorText(const std::exception_ptr& thrown);

}  // namespace ravnoves
