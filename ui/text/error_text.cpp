#include "text/error_text.h"

#include "case-file/input_error.h"
#include "text/message_text.h"

namespace ravnoves {

QString errorText(const std::exception& error) {
    const auto* input = dynamic_cast<const InputError*>(&error);
    return input == nullptr ? QString::fromUtf8(error.what()) : messageText(input->message());
}

}  // namespace ravnoves
