#include "text/error_text.h"

#include <QCoreApplication>
#include <new>

#include "case-file/input_error.h"
#include "text/field_names.h"
#include "text/message_text.h"

namespace ravnoves {

namespace {
bool byPointer = false;
}

void namePlacesByPointer() {
    byPointer = true;
}

QString errorText(const std::exception& error) {
    const auto* input = dynamic_cast<const InputError*>(&error);
    const auto* rejected = dynamic_cast<const RejectedInput*>(&error);
    return input == nullptr      ? QString::fromUtf8(error.what())
           : byPointer           ? messageText(input->message())
           : rejected != nullptr ? rejected->said()
                                 : FieldNames().errorText(*input);
}

QString errorText(const std::exception_ptr& thrown) {
    try {
        std::rethrow_exception(thrown);
    } catch (const std::bad_alloc&) {
        return QCoreApplication::translate("Errors", "There is not enough memory for this.");
    } catch (const std::exception& error) {
        return errorText(error);
    } catch (...) {
        return QCoreApplication::translate("Errors", "The computation failed.");
    }
}

}  // namespace ravnoves
