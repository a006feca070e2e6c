#pragma once

#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

#include "case-file/message.h"

/// What sentences of the scenes of a workshop are made of.
namespace ravnoves::shop {

// Numbers with as many decimals as one measures.
inline Number in_grams(double mass) {
    return {mass / units::gram, units::gram, -2};
}
inline Number in_gram_millimetres(double unbalance) {
    return {unbalance / units::gram_mm, units::gram_mm, -1};
}

inline Message two_sentences(Message first, Message second) {
    return {Text{"%1 %2"}, std::move(first), std::move(second)};
}

inline std::vector<Message> both(std::vector<Message> first, std::vector<Message> second) {
    std::move(second.begin(), second.end(), std::back_inserter(first));
    return first;
}

}  // namespace ravnoves::shop
