#include "case-file/whole_number.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace ravnoves {

int whole_number(const Word& word) {
    int number = 0;
    std::from_chars(word.word.data(), word.word.data() + word.word.size(), number);
    return number;
}

bool allows_whole(const Field& field, double value) {
    return field.range.contains(value) && std::floor(value) == value &&
           (field.words.empty() ||
            std::any_of(field.words.begin(), field.words.end(),
                        [&](const Word& word) { return whole_number(word) == value; }));
}

Message whole_number_rule(const Field& field) {
    if (field.words.empty()) {
        return field.range.whole_number_message();
    }
    return {CORE_TEXT("core", "must be %1 or %2"), field.words.front().word,
            field.words.back().word};
}

}  // namespace ravnoves
